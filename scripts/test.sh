#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Installs what is missing, builds and runs the tests, and says at the end what was left out.
#
#   scripts/test.sh [--full] [--strict]
#
# The short tier (build/tests): the unit tests, the command and its tests, by clang++ where it is found, without optimization.
#   Programs that are as they were when they passed are not run again.
# --full: everything: the long tests, too (test/PN_subdivision_3/long_tests.txt); all of it by g++, optimized, with every number
#   type, every header alone and the real command (build/release); CGAL 6; a short run of each benchmark; fuzz targets and
#   random meshes for some minutes.
# --strict: a test that is left out because something is missing is an error, but for that of the page.
set -euo pipefail
cd "$(dirname "$0")/.."

full=no
strict=()
for option; do
  case $option in
    --full) full=yes ;;
    --strict) strict=(--strict) ;;
    *) sed -n '/^#   scripts\/test/p' "$0" >&2; exit 2 ;;
  esac
done

step=0
steps=3
[[ $full == no ]] || steps=8
failed=()
presets=(tests)

say() {
  step=$((step + 1))
  echo "== $step of $steps: $* (after $SECONDS s)"
}

# attempt NAME COMMAND...: what fails is named at the end, and the rest goes on
attempt() {
  local name=$1
  shift
  "$@" || failed+=("$name")
}

run_tests() { # PRESET CTEST_OPTION...
  attempt "tests of $1" ctest --preset "$1" --parallel "$(nproc)" --no-tests=error "${@:2}"
}

say "packages"
scripts/install_dependencies.sh --manual # which has tests, too
seconds=build/tests/processor_seconds # of an empty folder, for scripts/check_seconds.sh
is_empty=no
[[ -e build/tests/build.ninja ]] || is_empty=yes
mkdir -p build/tests
rm -f "$seconds"
times >build/tests/times

say "building"
scripts/build.sh --preset tests
[[ $full == no ]] || attempt "build of the long tests" scripts/build.sh --preset tests --keep-going pn_long_tests

say "running the tests"
if [[ $full == no ]]; then
  unchanged=$(scripts/test_logs.py --unchanged build/tests)
  [[ $unchanged == '^()$' ]] || echo "As they were when they passed, and not run again: $(tr -d '^()$' <<<"$unchanged" | tr '|' ' ')"
  run_tests tests --exclude-regex "$unchanged"
  scripts/test_logs.py --record build/tests
  times >>build/tests/times
  [[ $is_empty == no ]] ||
    awk '{ gsub(/[ms]/, " ") } NR % 2 == 0 { print $1 * 60 + $2 + $3 * 60 + $4 - last; last = $1 * 60 + $2 + $3 * 60 + $4 }' \
      build/tests/times | tail -n 1 >"$seconds"
else
  attempt "long tests" ctest --test-dir build/tests --output-on-failure --parallel "$(nproc)"
  say "building all by g++, optimized"
  attempt "build by g++" scripts/build.sh --preset release --keep-going
  say "running its tests"
  presets+=(release)
  run_tests release
  say "CGAL 6"
  attempt "CGAL 6" scripts/check_portability.sh cgal6
  say "benchmarks"
  attempt benchmarks scripts/build.sh --preset release --keep-going pn_benchmarks
  for benchmark in build/release/benchmark/PN_subdivision_3/benchmark_*; do
    [[ ! -x $benchmark ]] || attempt "$(basename "$benchmark")" "$benchmark" --benchmark_min_time=0.01 >"$benchmark.out"
  done
  say "searches"
  attempt "fuzz targets" scripts/fuzz.sh 60
  PN_TEST_SEED=1 PN_TEST_SEEDS=300 GTEST_FILTER='*Random_meshes*' run_tests release -R test_scheme_suite
fi

attempt "what is left out" scripts/test_logs.py --left-out "${strict[@]}" "${presets[@]/#/build/}"
if [[ ${#failed[@]} -gt 0 ]]; then
  (IFS=,; echo "scripts/test.sh has failed: ${failed[*]}" >&2)
  exit 1
fi
echo "All tests passed, after $SECONDS s."
