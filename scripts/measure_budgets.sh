#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Measures what scripts/check_budgets.py cannot count: times of compiling. By hand, on an idle machine.
#
#   scripts/measure_budgets.sh [--command] [REPETITIONS]
#
# Two minimal programs, one of CGAL's own Catmull-Clark subdivision and one of this package's, are compiled by turns
# (g++ -O2, or $CXX), 5 times unless told otherwise: medians of the user time, and of the ratios; the second one also linked to
# PN_subdivision_3_double, which is compiled before and not counted.
# --command: also the processor time of compiling the command and what it is linked with, from nothing, one at a time.
# Speed of the package itself is measured by scripts/compare_speed.py, memory by scripts/compare_memory.py.
set -euo pipefail
cd "$(dirname "$0")/.."

command=no
if [[ ${1:-} == --command ]]; then
  command=yes
  shift
fi
repetitions=${1:-5}
[[ $repetitions =~ ^[1-9][0-9]*$ ]] || { sed -n '/^#   scripts/p' "$0" >&2; exit 2; }
compiler=${CXX:-g++}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
TIMEFORMAT=%U

compile_time() { # PROGRAM OPTION...
  local source=benchmark/PN_subdivision_3/compile_time/$1.cpp
  { time "$compiler" -std=c++17 -O2 -DNDEBUG -Iinclude "$source" -o "$work/$1" "${@:2}" -lmpfr -lgmp >&3 2>&4; } 3>&1 4>&2 2>&1
  "$work/$1"
}

median() { sort -g | awk '{ x[NR] = $1 } END { print (x[int((NR + 1) / 2)] + x[int(NR / 2) + 1]) / 2 }'; }

for source in src/PN_subdivision_3_double/*.cpp; do
  "$compiler" -std=c++17 -O2 -DNDEBUG -Iinclude -c "$source" -o "$work/$(basename "$source" .cpp).o"
done
ar rcs "$work/double.a" "$work"/*.o

compile_time linear >/dev/null # what is read from disk the first time
for ((i = 0; i < repetitions; ++i)); do
  linear=$(compile_time linear)
  point_normal=$(compile_time point_normal)
  linked=$(compile_time point_normal -DCGAL_PN_SUBDIVISION_3_DOUBLE "$work/double.a")
  echo "$linear $point_normal $(awk "BEGIN { print $point_normal / $linear, $linked / $linear }")"
done >"$work/times"
echo "compiling a minimal program, user time: linear $(cut -d' ' -f1 "$work/times" | median) s," \
  "point-normal $(cut -d' ' -f2 "$work/times" | median) s, ratio $(cut -d' ' -f3 "$work/times" | median)," \
  "linked to PN_subdivision_3_double $(cut -d' ' -f4 "$work/times" | median)" \
  "(medians of $repetitions, $compiler)"

if [[ $command == yes ]]; then
  cmake -S . -B "$work/command" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER= \
    -DPN_SUBDIVISION_3_TESTS=OFF -DPN_SUBDIVISION_3_EXAMPLES=OFF -DPN_SUBDIVISION_3_BENCHMARKS=OFF >"$work/log"
  TIMEFORMAT='compiling the command, processor time: %U s of the user, %S s of the system'
  time ninja -C "$work/command" -j1 pn_subdivide >"$work/log"
fi
