#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# The tests under tools that find what tests alone do not. Debian packages: clang, lld, llvm, valgrind,
# googletest (its sources, for the containers).
#
#   scripts/sanitize.sh [address|threads|containers|valgrind|all] [TEST...]
#
# address      address and undefined-behaviour sanitizers over the suite, clang++ at -O0; also counts for
#              scripts/coverage.py --build build/asan-ubsan. About an hour and a half on two cores.
# threads      thread sanitizer over test/PN_subdivision_3/threads/races.cpp, with a TBB of plain threads: one minute.
#              With TEST those tests of Parallel_tag, as test_kernels_parallel.
# containers   tests with the checked containers of libstdc++ (_GLIBCXX_DEBUG), with GoogleTest compiled likewise.
#              20 minutes.
# valgrind     the command on a few meshes; COMMAND=PATH is one that is built already (otherwise build/release). With
#              it 25 seconds.
#
# TEST: only these programs, as test_curves; without one all that the tool is for. JOBS: how many at a time.
set -euo pipefail
cd "$(dirname "$0")/.."

tool=${1:-all}
tests=("${@:2}")
jobs=${JOBS:-$(nproc)}
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

# Tests that make no sense here: they compile, or need a display or ranks (whose library loses memory); by their names in ctest and
# in GoogleTest.
without='pvtp_in_vtk|rejected_|headers|documented'
without_tests='*mpi*:*Mpi*:*anks*'
# Tests that forbid large files, and so the profile.
without_profile='*FullDisk*:*OutputThatCannotBeWritten*'

# configures a preset, builds the tests (or all) and runs them; a program that does not compile does not stop the others
preset()
{
  local name=$1 programs=("${@:2}") filter=() chosen built=0
  cmake --preset "$name" "${launcher[@]}" >/dev/null
  if [[ ${#programs[@]} -gt 0 ]]; then filter=(-R "^($(IFS='|'; echo "${programs[*]}"))\$"); fi
  chosen="-$without_tests:$without_profile"
  if [[ $name == tsan ]]; then chosen="*arallel*:*hread*"; fi
  cmake --build --preset "$name" -j "$jobs" ${programs[0]:+--target "${programs[@]}"} -- -k0 || built=$?
  LLVM_PROFILE_FILE=$PWD/build/$name/profiles/%4m.profraw GTEST_FILTER=$chosen \
    ctest --preset "$name" --parallel "$jobs" --no-tests=error --timeout 1500 -E "$without" "${filter[@]}"
  if [[ ${#programs[@]} -eq 0 && $name == asan-ubsan ]]; then
    LLVM_PROFILE_FILE=/dev/null GTEST_FILTER=$without_profile \
      ctest --preset "$name" --parallel "$jobs" --no-tests=error -R "^test_pn_subdivide"
  fi
  return "$built"
}

address() { preset asan-ubsan "${tests[@]}"; }

threads()
{
  if [[ ${#tests[@]} -gt 0 ]]; then
    preset tsan "${tests[@]}"
    return
  fi
  local folder=build/tsan
  mkdir -p "$folder"
  "${CXX:-clang++}" -std=c++17 -O0 -g1 -DNDEBUG -DNOMINMAX -DCGAL_LINKED_WITH_TBB -frounding-math -fsanitize=thread \
    -Itest/PN_subdivision_3/threads -Iinclude -isystem /usr/include/eigen3 \
    test/PN_subdivision_3/threads/races.cpp -o "$folder/races" -lgmp -lmpfr -lpthread
  "$folder/races"
}

containers()
{
  local compiler=${CXX:-clang++} programs=("${tests[@]}") gtest=/usr/src/googletest/googletest folder=build/containers name source
  [[ ${#programs[@]} -gt 0 ]] || programs=(test_bad_input test_surface_refiner test_curves test_creases_mesh test_pieces)
  local flags=(-std=c++17 -O0 -g1 -w -D_GLIBCXX_DEBUG -D_GLIBCXX_DEBUG_PEDANTIC -DNOMINMAX -frounding-math -Iinclude -Itest_support
               -Itest/PN_subdivision_3 -Itest/PN_subdivision_3/support -I"$gtest" -I"$gtest/include"
               -isystem /usr/include/eigen3 -DPN_DATA_DIR="\"$PWD/data/meshes\"" -DPN_TEST_REAL_MESH_DIR='""'
               -DPN_TEST_EXTRA_MESH_DIR='""')
  mkdir -p "$folder"
  "$compiler" "${flags[@]}" -c "$gtest/src/gtest-all.cc" -o "$folder/gtest-all.o"
  "$compiler" "${flags[@]}" -c "$gtest/src/gtest_main.cc" -o "$folder/gtest_main.o"
  for name in "${programs[@]}"; do
    source=$(ls test/*/*/"$name".cpp)
    local sources=("$source" "$(dirname "$source")/${name#test_}"_*.cpp test/PN_subdivision_3/reference/*.cpp)
    local objects=()
    for source in "${sources[@]}"; do
      [[ -e $source ]] || continue
      objects+=("$folder/$(basename "$source" .cpp).o")
      "$compiler" "${flags[@]}" -c "$source" -o "${objects[-1]}"
    done
    "$compiler" "${objects[@]}" "$folder"/gtest-all.o "$folder"/gtest_main.o -o "$folder/$name" -lgmp -lmpfr -lpthread
    "$folder/$name" --gtest_brief=1
  done
}

valgrind_on_command()
{
  local command=${COMMAND:-} folder
  if [[ -z $command ]]; then
    command=build/release/src/pn_subdivide/pn_subdivide
    scripts/build.sh pn_subdivide
  fi
  folder=$(mktemp -d)
  local check=(valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite)
  printf '0 0\n1 0\n1 1\n' >"$folder/polygon.txt"
  "${check[@]}" "$command" surface data/meshes/cube.off "$folder/cube.ply" --levels 2 --quiet
  "${check[@]}" "$command" surface data/meshes/creased_plate.ply "$folder/plate.obj" --quiet
  "${check[@]}" "$command" surface data/meshes/mixed_borders.off "$folder/mixed.vtp" --curvature gaussian --quiet
  "${check[@]}" "$command" curve "$folder/polygon.txt" "$folder/curve.txt" --scheme chaikin --quiet
  rm -r "$folder"
}

case $tool in
  address | threads | containers) "$tool" ;;
  valgrind) valgrind_on_command ;;
  all) address && threads && containers && valgrind_on_command ;;
  *) sed -n '/^#   scripts/,/^set/p' "$0" | sed '$d'; exit 2 ;;
esac
echo "$tool: no findings"
