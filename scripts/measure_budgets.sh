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
#   scripts/measure_budgets.sh [--command] [REPETITIONS [CALL...]]
#
# One source, benchmark/PN_subdivision_3/compile_time/call.cpp, is compiled for each call of the table below and for CGAL's own
# Catmull-Clark subdivision by turns (g++ -O2, or $CXX), 5 times unless told otherwise: medians of the user time over that of CGAL's
# own, and the memory of the compiler; with the headers alone, and as a program linked to the libraries.
# --command: also the processor time of compiling the command and what it is linked with, from nothing, one at a time.
# Speed of the package itself is measured by scripts/compare_speed.py, memory by scripts/compare_memory.py.
set -euo pipefail
cd "$(dirname "$0")/.."

# name | headers | call
table() {
  cat <<'TABLE'
plain            | PN_subdivision_3.h       | PN::CatmullClark_subdivision(mesh, params::number_of_iterations(2).vertex_normal_map(normals))
creases          | PN_subdivision_3.h PN_subdivision_3/schemes/Any_scheme.h | PN::subdivide(mesh, PN::Any_scheme(PN::CatmullClark_scheme()), params::number_of_iterations(2).vertex_normal_map(normals).edge_is_constrained_map(sharp))
attributes       | PN_subdivision_3.h PN_subdivision_3/schemes/Any_scheme.h | PN::subdivide(mesh, PN::Any_scheme(PN::CatmullClark_scheme()), PN::parameters::attributes(PN::parameters::vertex_attribute(colors)).number_of_iterations(2).vertex_normal_map(normals).edge_is_constrained_map(sharp))
limit            | PN_subdivision_limit_3.h | PN::limit_points(mesh, PN::CatmullClark_scheme(), PN::parameters::limit_point_map(points))
limit_edges      | PN_subdivision_limit_3.h | PN::limit_points(mesh, PN::CatmullClark_scheme(), PN::parameters::limit_point_map(points).edge_is_constrained_map(sharp))
tessellate       | PN_limit_surface_3/tessellate.h | PN::tessellate(mesh, PN::CatmullClark_scheme(), 0.01, result)
tessellate_edges | PN_limit_surface_3/tessellate.h | PN::tessellate(mesh, PN::CatmullClark_scheme(), 0.01, result, params::edge_is_constrained_map(sharp))
fit              | PN_fitting_3.h           | PN::interpolate_limit_points(mesh, PN::CatmullClark_scheme(), params::number_of_iterations(2))
recognize        | PN_recognition_3.h       | PN::recognize_surfaces(mesh, surfaces)
TABLE
}

command=no
if [[ ${1:-} == --command ]]; then
  command=yes
  shift
fi
repetitions=${1:-5}
[[ $repetitions =~ ^[1-9][0-9]*$ ]] || { sed -n '/^#   scripts/p' "$0" >&2; exit 2; }
chosen=" ${*:2} "
compiler=${CXX:-g++}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

compile() { # NAME HEADERS CALL OPTION...: the user time and the memory in kB
  # shellcheck disable=SC2086  # several headers
  { printf '#include <CGAL/%s>\n' $2; echo "#define PN_CALL $3"; echo "#include \"$PWD/benchmark/PN_subdivision_3/compile_time/call.cpp\""; } >"$work/$1.cpp"
  /usr/bin/time -f '%U %M' -o "$work/time" "$compiler" -std=c++17 -O2 -DNDEBUG -w -Iinclude -isystem /usr/include/eigen3 -c "$work/$1.cpp" -o "$work/$1.o" "${@:4}"
  tail -1 "$work/time"
}

median() { sort -g | awk '{ x[NR] = $1 } END { print (x[int((NR + 1) / 2)] + x[int(NR / 2) + 1]) / 2 }'; }

own() {
  compile own subdivision_method_3.h 'CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh, params::number_of_iterations(2))'
}

own >/dev/null # what is read from disk the first time
mapfile -t rows < <(table)
for ((i = 0; i < repetitions; ++i)); do
  read -r base _ < <(own)
  echo "$base" >>"$work/own.times"
  for row in "${rows[@]}"; do
    IFS='|' read -r name header call <<<"$row"
    name=${name// /}
    [[ $chosen == "  " || $chosen == *" $name "* ]] || continue
    for kind in alone linked; do
      option=()
      [[ $kind == alone ]] || option=(-DCGAL_PN_SUBDIVISION_3_{DOUBLE,LIMITS,FITTING,RECOGNITION})
      read -r user memory < <(compile "$name" "$header" "$call" "${option[@]}")
      awk "BEGIN { print $user / $base, $memory / 1e6 }" >>"$work/$name.$kind"
    done
  done
done
echo "CGAL's own: $(median <"$work/own.times") s of the user (medians of $repetitions, $compiler -O2); the others over it:"
for row in "${rows[@]}"; do
  name=${row%% *}
  [[ -e $work/$name.alone ]] || continue
  printf '%-17s headers alone %.2f (%.2f GB), linked %.2f (%.2f GB)\n' "$name" "$(cut -d' ' -f1 "$work/$name.alone" | median)" \
    "$(cut -d' ' -f2 "$work/$name.alone" | median)" "$(cut -d' ' -f1 "$work/$name.linked" | median)" "$(cut -d' ' -f2 "$work/$name.linked" | median)"
done

if [[ $command == yes ]]; then
  cmake -S . -B "$work/command" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER= \
    -DPN_SUBDIVISION_3_TESTS=OFF -DPN_SUBDIVISION_3_EXAMPLES=OFF -DPN_SUBDIVISION_3_BENCHMARKS=OFF >"$work/log"
  TIMEFORMAT='compiling the command, processor time: %U s of the user, %S s of the system'
  time ninja -C "$work/command" -j1 pn_subdivide >"$work/log"
fi
