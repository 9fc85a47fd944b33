#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Makes one HTML file of demo/PN_subdivision_3, with the package in it as WebAssembly, and the library for JavaScript in
# build/page/library. Installs what is missing from Debian and npm.
#
#   scripts/build_page.sh [--offline] [--url ADDRESS] [--separate] [OUTPUT.html]      default: build/page/pn_subdivision_3.html
#
# --offline: nothing is installed; --url: where the package is to be found, which the page then links to; --separate:
# script and style are files beside the page, for servers with a strict content policy
set -euo pipefail
cd "$(dirname "$0")/.."

offline=no
options=()
while [[ ${1:-} == --* ]]; do
  case $1 in
    --offline) offline=yes ;;
    --url) options+=(--url "$2"); shift ;;
    --separate) options+=(--separate) ;;
    *) echo "usage: $0 [--offline] [--url ADDRESS] [--separate] [OUTPUT.html]" >&2; exit 2 ;;
  esac
  shift
done
demo=demo/PN_subdivision_3
build=build/page
output=$(realpath -m "${1:-$build/pn_subdivision_3.html}")

if [[ $offline == no ]]; then
  scripts/install_dependencies.sh --page
  if [[ ! $demo/node_modules/.package-lock.json -nt $demo/package-lock.json ]]; then
    # esbuild's script only checks its binary, a package of its own
    npm ci --prefix "$demo" --ignore-scripts --no-audit --no-fund
    touch "$demo/node_modules/.package-lock.json"
  fi
fi

# CGAL, Boost and Eigen without the other headers of this system, which are not those of WebAssembly
headers=$build/headers
mkdir -p "$headers"
for folder in /usr/include/CGAL /usr/include/boost /usr/include/eigen3/Eigen; do
  ln -sfn "$folder" "$headers/$(basename "$folder")"
done

export NODE_PATH=/usr/share/nodejs # where Debian has what emscripten's optimizer needs
export CCACHE_DISABLE=1
emcmake cmake -S $demo/modeler -B $build/modeler -G Ninja -DCMAKE_BUILD_TYPE=Release \
  "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG" -DPN_HEADERS="$PWD/$headers" >/dev/null
nice cmake --build $build/modeler --parallel "$(nproc)"

(cd $demo && node_modules/.bin/tsc --noEmit)
mkdir -p "$(dirname "$output")"
node $demo/build.mjs $build/modeler "$output" "${options[@]}"
node $demo/build_library.mjs $build/modeler $build/library
