#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# The package elsewhere: its headers with C++20, with clang++ and with CGAL 6; everything with CGAL 6; and cross compiled
# for aarch64, where a short program is run by qemu and its results are compared with those of this machine, bit for bit.
#
#   scripts/check_portability.sh [c++20|clang|cgal6|aarch64|all]
#   scripts/check_portability.sh cgal6 REGEX      only the sources whose paths match, as 'src/|examples/'
#   scripts/check_portability.sh cgal6 --changed REV --seconds N
#                                               all public headers, and of the sources that have changed since REV as many as
#                                               N seconds allow; it says how many were not checked
#
# Debian packages: clang, g++-aarch64-linux-gnu, qemu-user (scripts/install_dependencies.sh does not install the
# last two). The headers of CGAL 6 are fetched from Debian's mirror, that of apt here or DEBIAN_MIRROR, or CGAL6=FOLDER
# has what that package unpacks. Every header alone, with g++ and clang++: the targets pn_headers_alone of the presets.
set -euo pipefail
cd "$(dirname "$0")/.."

what=${1:-all}
chosen=${2:-}
with_headers=no
[[ -n $chosen ]] || with_headers=yes
seconds=
if [[ $chosen == --changed ]]; then
  seconds=$5
  with_headers=yes
  chosen=$(git diff --name-only --diff-filter=d "$3" -- '*.cpp' | sed 's:.*/::; s/[.]/\\./g' | paste -sd '|')
  chosen="/(${chosen:-none})\\.o\$"
fi
folder=build/portability
mkdir -p "$folder"
headers=(include/CGAL/*.h include/CGAL/PN_*/*.h)
warnings=(-Wall -Wextra -Wpedantic -Wshadow -Werror)

# all public headers in one source
all_headers()
{
  for header in "${headers[@]}"; do echo "#include <${header#include/}>"; done | sort -u
  echo "int main() {}"
}

compile_headers()
{
  all_headers >"$folder/headers.cpp"
  echo "== $*"
  "$@" -fsyntax-only "${warnings[@]}" -frounding-math -DNOMINMAX -Iinclude -isystem /usr/include/eigen3 "$folder/headers.cpp"
}

# sources BUILD REGEX: the objects of what CMake compiles in that folder, but for paths that match
sources()
{
  ninja -C "$1" -t targets all | sed -n 's/\.o: CXX_COMPILER.*/.o/p' | grep -vE "$2" | grep -E "$chosen"
}

# check_sources BUILD REGEX: these are checked, not translated, until the time is over, if there is a limit; what is wrong in those
# that were checked counts
check_sources()
{
  local objects object left=0 status=0 rest=$((seconds > SECONDS ? seconds - SECONDS : 0))
  mapfile -t objects < <(sources "$1" "$2")
  echo "== clang++: ${#objects[@]} sources of $1${seconds:+, as many as $rest seconds allow}"
  [[ ${#objects[@]} -gt 0 ]] || return 0
  if [[ -z $seconds ]]; then
    ninja -C "$1" -k 0 --quiet "${objects[@]}"
    return
  fi
  if [[ $rest -gt 0 ]]; then
    timeout --signal=INT "$rest" ninja -C "$1" -k 0 --quiet "${objects[@]}" | tee "$1.out" || status=$?
    ! grep -q '^FAILED' "$1.out" || status=1
  fi
  for object in "${objects[@]}"; do [[ -e $1/$object ]] || left=$((left + 1)); done
  echo "-- $left of ${#objects[@]} sources never checked"
  [[ $status -eq 0 || $status -eq 124 ]]
}

# What is compiled neither by CMake nor here, and CMake's reasons.
name_what_is_left_out()
{
  grep -hE "left out|skipped \(" "$@" || true
  find src examples test demo benchmark -name '*.cpp' | sort | while read -r source; do
    [[ $source == */bits.cpp ]] || grep -qsF "/$source\"" "${@/%.txt//compile_commands.json}" "${1%.txt}"/test/PN_subdivision_3/joined/*.cpp ||
      echo "-- left out: $source"
  done
  echo "-- left out: demo/PN_subdivision_3/modeler/bindings.cpp, which needs emscripten"
}

# Command, examples, tests, benchmarks, fuzz targets and the page's module, as CMake compiles them where CGAL is 6.
everything_with_cgal6()
{
  local build=$folder/everything modeler=$folder/modeler status=0 joined=ON
  [[ -z $chosen ]] || joined=OFF # tests have their own names
  local options=(-G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
               "-DCMAKE_CXX_COMPILER_LAUNCHER=$PWD/cmake/PN_check_only.sh"
               "-DCMAKE_CXX_LINK_EXECUTABLE=<CMAKE_COMMAND> -E touch <TARGET>") # tests wait for the command
  cmake -S . -B "$build" "${options[@]}" "-DCGAL_DIR=$(echo "$1"/usr/lib/*/cmake/CGAL)" -DPN_SUBDIVISION_3_DEVELOPER=ON -DPN_TEST_FULL=ON "-DPN_TEST_JOINED=$joined" -DCMAKE_UNITY_BUILD=OFF \
    -DPN_SUBDIVISION_3_FUZZ=ON -DPN_SUBDIVISION_3_INSTALL=OFF -DPN_SUBDIVISION_3_WITH_MPI=AUTO >"$build.txt" || return 1
  cmake -S demo/PN_subdivision_3/modeler -B "$modeler" "${options[@]}" "-DPN_HEADERS=$1/usr/include;/usr/include/eigen3" \
    "-DCMAKE_CXX_FLAGS=${warnings[*]}" >"$modeler.txt" || return 1
  name_what_is_left_out "$build.txt" "$modeler.txt"
  local never='/headers_alone/|/empty\.cpp' demo='/src/pn_subdivide/|/bindings\.cpp'
  check_sources "$build" "$never" || status=1
  check_sources "$modeler" "$demo" || status=1
  return $status
}

# Nothing is installed, and the system's package lists stay as they are: apt works in a folder of its own.
fetch_cgal6()
(
  set -e
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  mirror=${DEBIAN_MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep -E '/debian/?$' | head -n 1)}
  mkdir -p "$1" "$scratch/state/lists/partial" "$scratch/cache/archives/partial"
  : >"$scratch/status"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] ${mirror:-http://deb.debian.org/debian} trixie main" >"$scratch/sources.list"
  own=(-o Dir::Etc::sourcelist="$scratch/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State="$scratch/state"
       -o Dir::State::status="$scratch/status" -o Dir::Cache="$scratch/cache" -o APT::Sandbox::User=)
  apt-get -qq "${own[@]}" update
  (cd "$scratch" && apt-get -qq "${own[@]}" download libcgal-dev)
  dpkg-deb -x "$scratch"/libcgal-dev_*.deb "$1"
)

cgal6()
{
  local newer=${CGAL6:-$PWD/$folder/cgal6} status=0
  [[ -e $newer/usr/include/CGAL/version.h ]] || fetch_cgal6 "$newer" || return 1
  if [[ $with_headers == yes ]]; then
    for compiler in g++ clang++; do
      compile_headers "$compiler" -std=c++17 -isystem "$newer/usr/include" test/PN_subdivision_3/portability/bits.cpp || status=1
    done
  fi
  everything_with_cgal6 "$newer" || status=1
  return $status
}

# Headers of libraries that are the same on every machine; those of GMP and MPFR are not.
independent_headers()
{
  mkdir -p "$folder/include"
  for library in CGAL boost eigen3; do ln -sfn "/usr/include/$library" "$folder/include/$library"; done
}

aarch64()
{
  independent_headers
  local options=(-std=c++17 -O2 -DNDEBUG -DNOMINMAX -DCGAL_DISABLE_GMP=1 -DCGAL_DO_NOT_USE_BOOST_MP=1 -frounding-math
                 -ffp-contract=off -Iinclude -isystem "$folder/include" -isystem "$folder/include/eigen3")
  local source=test/PN_subdivision_3/portability/bits.cpp
  echo "== aarch64"
  g++ "${options[@]}" "$source" -o "$folder/bits_here"
  aarch64-linux-gnu-g++ "${options[@]}" "${warnings[@]}" -Wno-psabi -static "$source" -o "$folder/bits_aarch64"
  "$folder/bits_here" >"$folder/here.txt"
  qemu-aarch64 "$folder/bits_aarch64" >"$folder/aarch64.txt"
  diff "$folder/here.txt" "$folder/aarch64.txt" && echo "$(wc -l <"$folder/here.txt") digests are the same"
}

case $what in
  c++20) compile_headers g++ -std=c++20 ;;
  clang) compile_headers clang++ -std=c++17 && compile_headers clang++ -std=c++20 ;;
  aarch64) aarch64 ;;
  cgal6) cgal6 ;;
  all)
    compile_headers g++ -std=c++20
    for standard in 17 20; do compile_headers clang++ -std=c++$standard; done
    cgal6
    aarch64
    ;;
  *) sed -n '/^#   scripts/p' "$0"; exit 2 ;;
esac
