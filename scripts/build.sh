#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Configures build/release, or the folder of another preset, and builds it, or only the targets named.
#
#   scripts/build.sh [--preset NAME] [--keep-going] [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/.."

preset=release
if [[ ${1:-} == --preset ]]; then
  preset=$2
  shift 2
fi
rest=()
if [[ ${1:-} == --keep-going ]]; then
  rest=(-- -k 0)
  shift
fi

options=()
if command -v ccache >/dev/null; then
  options=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  export CCACHE_SLOPPINESS=pch_defines,time_macros # precompiled headers are cached only with these
fi
if [[ $preset == tests ]] && ! command -v clang++ >/dev/null; then
  options+=(-DCMAKE_CXX_COMPILER=c++) # takes longer
fi

cmake --preset "$preset" "${options[@]}"
targets=()
if [[ $# -gt 0 ]]; then
  targets=(--target "$@")
fi
cmake --build --preset "$preset" "${targets[@]}" "${rest[@]}"
