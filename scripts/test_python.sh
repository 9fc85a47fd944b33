#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Builds the module pn_subdivision for Python (in build/python, without optimization) and runs its tests, by Debian's Python.
#
#   scripts/test_python.sh [--offline] [--command PN_SUBDIVIDE] [--wheel FILE]
#
# --offline: nothing is installed; --command: a build of the command of these sources, whose bits are compared;
# --wheel: tests this wheel, and builds nothing
set -euo pipefail
cd "$(dirname "$0")/.."

offline=no
command=build/tests/src/pn_subdivide/pn_subdivide
wheel=
while [[ $# -gt 0 ]]; do
  case $1 in
    --offline) offline=yes ;;
    --command) command=$2; shift ;;
    --wheel) wheel=$2; shift ;;
    *) echo "usage: $0 [--offline] [--command PN_SUBDIVIDE] [--wheel FILE]" >&2; exit 2 ;;
  esac
  shift
done
[[ $offline == yes ]] || scripts/install_dependencies.sh --python

python=/usr/bin/python3 # for which Debian has the packages
if [[ -n $wheel ]]; then
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  $python -m pip install --quiet --no-index --no-deps --target "$folder" "$wheel"
else
  folder=$PWD/build/python
  compiler=c++
  ! command -v clang++ >/dev/null || compiler=clang++
  cmake -S python -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER=$compiler -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" -DPN_SUBDIVISION_3_DEVELOPER=ON -DPython_EXECUTABLE=$python
  cmake --build "$folder" --target pn_python
fi
if [[ -x $command ]]; then
  PN_SUBDIVIDE=$(realpath "$command")
  export PN_SUBDIVIDE
fi
tests=$PWD/python/tests
cd "$folder" # not where the sources of the module are
PYTHONPATH=$folder $python -B -m pytest -q -p no:cacheprovider "$tests"
