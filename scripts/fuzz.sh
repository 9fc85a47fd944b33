#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Builds the fuzz targets (clang++, libFuzzer, address and undefined-behaviour sanitizers) and runs each.
#
#   scripts/fuzz.sh [SECONDS [TARGET...]]     60 seconds, fuzz_api and fuzz_command
#
# A night: scripts/fuzz.sh 28800. What is found on the way is kept in build/fuzz/corpus/ and read by the next run;
# an input that fails is written to build/fuzz/, and build/fuzz/.../TARGET FILE runs it again. Inputs worth keeping
# belong into test/PN_subdivision_3/fuzz/corpus/ (make them small: TARGET -merge=1 FOLDER FOUND).
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-60}
targets=("${@:2}")
[[ ${#targets[@]} -gt 0 ]] || targets=(fuzz_api fuzz_command)

scripts/build.sh --preset fuzz "${targets[@]}"

status=0
for target in "${targets[@]}"; do
  found=build/fuzz/corpus/$target
  mkdir -p "$found"
  echo "== $target, $seconds seconds"
  build/fuzz/test/PN_subdivision_3/fuzz/"$target" "$found" "test/PN_subdivision_3/fuzz/corpus/${target#fuzz_}" \
    -max_total_time="$seconds" -max_len=4096 -timeout=20 -rss_limit_mb=3000 -print_final_stats=1 \
    -artifact_prefix=build/fuzz/"$target"- >build/fuzz/"$target".log 2>&1 || status=$?
  grep -E "^(stat::number_of_executed_units|SUMMARY|fuzz_|==.*ERROR)|Test unit written" build/fuzz/"$target".log || true
done
exit "$status"
