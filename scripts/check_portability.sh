#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# The headers elsewhere: with C++20, with clang++, with CGAL 6, and cross compiled for aarch64, where a short program is
# run by qemu and its results are compared with those of this machine, bit for bit. Three minutes of one processor.
#
#   scripts/check_portability.sh [c++20|clang|cgal6|aarch64|all]
#
# Debian packages: clang, g++-aarch64-linux-gnu, qemu-user (scripts/install_dependencies.sh does not install the
# last two). The headers of CGAL 6 are fetched from Debian's mirror (scripts/fetch_cgal6_headers.sh), or CGAL6=FOLDER
# has them in usr/include. Every header alone, with g++ and clang++: the targets pn_headers_alone of the presets.
set -euo pipefail
cd "$(dirname "$0")/.."

what=${1:-all}
folder=build/portability
mkdir -p "$folder"
headers=(include/CGAL/PN_subdivision_3.h include/CGAL/PN_subdivision_curve.h include/CGAL/PN_subdivision_3/*.h)
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

cgal6()
{
  local newer=${CGAL6:-$folder/cgal6}
  [[ -e $newer/usr/include/CGAL/version.h ]] || scripts/fetch_cgal6_headers.sh "$newer"
  for compiler in g++ clang++; do compile_headers "$compiler" -std=c++17 -isystem "$newer/usr/include"; done
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
