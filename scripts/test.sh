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
# The unit tests of the headers are compiled by clang++ where it is found (build/units), all else by g++
# (build/others), both without optimization.
# --full: everything, optimized and by g++, beside the unit tests by clang++: every scheme with every number type,
#   every header alone, the benchmarks (build/release).
# --strict: a test that is left out because something is missing is an error, but for that of the page.
set -euo pipefail
cd "$(dirname "$0")/.."

presets=(units others)
strict=()
for option; do
  case $option in
    --full) presets=(units release) ;;
    --strict) strict=(--strict) ;;
    *) sed -n '/^#   scripts/p' "$0" >&2; exit 2 ;;
  esac
done

scripts/install_dependencies.sh --manual # which has tests, too
for preset in "${presets[@]}"; do
  scripts/build.sh --preset "$preset"
done
if [[ ${presets[1]} == release ]]; then
  scripts/build.sh pn_benchmarks
fi

failed=()
for preset in "${presets[@]}"; do
  ctest --preset "$preset" --parallel "$(nproc)" --no-tests=error || failed+=("$preset")
done
scripts/left_out.sh "${strict[@]}" "${presets[@]/#/build/}" || failed+=("what is left out")
if [[ ${#failed[@]} -gt 0 ]]; then
  (IFS=,; echo "scripts/test.sh has failed: ${failed[*]}" >&2)
  exit 1
fi
