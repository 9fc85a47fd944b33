#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Who adds a test pays: compares the processor seconds that scripts/test.sh has just taken from an empty build/tests with the
# budget in scripts/seconds.txt. Machines differ, so both are in units of what a small program of CGAL's takes to compile and run here.
#
#   scripts/check_seconds.sh [--write]     exit code 1 if it is a tenth above; --write: what it took becomes the budget
set -euo pipefail
cd "$(dirname "$0")/.."

budget=scripts/seconds.txt
taken=build/tests/processor_seconds
[[ -s $taken ]] || { echo "check_seconds.sh: build/tests was not built anew by scripts/test.sh, nothing to compare"; exit 0; }

compiler=$(command -v clang++ || command -v c++)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/unit.cpp" <<'TEXT'
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>
int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh, CGAL::parameters::number_of_iterations(8));
}
TEXT
# as many at a time as there are processors, as in a build; sets unit, the seconds of processor time of one, and ratio
measure() {
  times >"$work/times" # of what this process did before
  for _ in 1 2 3; do
    for job in $(seq "$(nproc)"); do
      { "$compiler" -std=c++17 -O0 -w "$work/unit.cpp" -o "$work/$job" -lgmp && "$work/$job"; } &
    done
    wait
  done
  times >>"$work/times"
  unit=$(awk -v n="$((3 * $(nproc)))" '{ gsub(/[ms]/, " "); t = $1 * 60 + $2 + $3 * 60 + $4 } NR == 2 { before = t } NR == 4 { print (t - before) / n }' "$work/times")
  ratio=$(awk -v t="$(cat "$taken")" -v u="$unit" 'BEGIN { printf "%.0f", t / u }')
}

# the unit differs by more than a tenth from minute to minute where others use the machine: too slow three times is too slow
for _ in 1 2 3; do
  measure
  [[ ${1:-} != --write ]] || echo "$ratio" >"$budget"
  echo "scripts/test.sh: $(cat "$taken") s of processor time, $ratio times a program of CGAL's ($unit s); budget $(cat "$budget")"
  awk -v r="$ratio" -v b="$(cat "$budget")" 'BEGIN { exit r > 1.1 * b }' && exit 0
done
echo "check_seconds.sh: more than a tenth above the budget: make the tests smaller, or move what catches little to long_tests.txt" >&2
exit 1
