#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws meshes of data/, or one of your own, subdivided by the linear and by the point-normal scheme.
# What that needs is installed (Debian packages) and compiled, one small program.
#
#   scripts/demo.sh [FILE [--sharp DEGREES] [OPTION OF scripts/render.py...]]
#
# FILE is PLY, OFF, OBJ or STL. Edges at which faces meet at more than DEGREES are kept sharp (180: none);
# without it the program decides.   scripts/demo.sh cow.obj --sharp 60 --up y
set -euo pipefail

file=
subdivide_options=()
render_options=()
if [[ $# -gt 0 ]]; then
  [[ $1 == /* ]] && file=$1 || file=$PWD/$1
  if [[ $1 == -* && ! -e $1 ]]; then
    echo "usage: scripts/demo.sh [FILE [--sharp DEGREES] [OPTION OF scripts/render.py...]]" >&2
    exit 2
  fi
  if [[ ! -f $file ]]; then
    echo "demo.sh: $1: there is no such file" >&2
    exit 1
  fi
  shift
  while [[ $# -gt 0 ]]; do
    if [[ $1 == --sharp && $# -gt 1 ]]; then
      subdivide_options+=(--sharp "$2")
      shift
    else
      render_options+=("$1")
    fi
    shift
  done
fi
cd "$(dirname "$0")/.."

build=build/demo
results=$build/results
program=$build/examples/PN_subdivision_3/subdivide_control_meshes
log=$build/log.txt
mkdir -p "$results"

can_draw() {
  command -v Xvfb >/dev/null && /usr/bin/python3 -c 'import importlib.util as u, sys
sys.exit(not (u.find_spec("vtkmodules") and u.find_spec("numpy")))' 2>/dev/null
}

build_program() {
  if [[ ! -e $build/build.ninja ]]; then
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" \
      -DPN_SUBDIVISION_3_TESTS=OFF -DPN_SUBDIVISION_3_TOOLS=OFF -DPN_SUBDIVISION_3_BENCHMARKS=OFF \
      -DPN_SUBDIVISION_3_INSTALL=OFF -DPN_SUBDIVISION_3_WITH_TBB=OFF -DPN_SUBDIVISION_3_WITH_MPI=OFF
  fi
  cmake --build "$build" --target subdivide_control_meshes
}

[[ -x $program ]] || scripts/install_dependencies.sh --compiler
installing=
if ! can_draw; then # while the program is compiled
  scripts/install_dependencies.sh --picture &
  installing=$!
fi
[[ -x $program ]] || echo "Compiling one program"
compiled=yes
build_program >"$log" 2>&1 || compiled=no
[[ -z $installing ]] || wait "$installing" || true
if [[ $compiled == no ]]; then
  tail -n 40 "$log" >&2
  exit 1
fi

# draw PICTURE OPTION...: exits 0 without a picture only if what draws cannot be had
draw() {
  local status=0
  scripts/render.py --output "$@" || status=$?
  if [[ $status -eq 69 ]]; then
    echo "No picture: scripts/render.py needs Python 3 with VTK and NumPy, and Xvfb" \
      "(Debian packages python3-vtk9, python3-numpy, xvfb)." >&2
  elif [[ $status -ne 0 ]]; then
    exit "$status"
  else
    echo "Picture: $PWD/$1"
  fi
}

if [[ -n $file ]]; then
  name=$(basename "$file")
  name=${name%.*}
  "$program" -o "$results" "${subdivide_options[@]}" "$file"
  control=$results/${name}_control.ply # whose edges would hide the surface if they were many
  faces=$(sed -n 's/^element face //p;/^end_header/q' "$control")
  [[ $faces -gt 600 ]] || render_options+=(--control "$control")
  draw "$results/$name.png" --columns 2 --same-view --shading split "${render_options[@]}" \
    --caption="$name, linear" --caption=point-normal \
    "$results/${name}_linear.ply" "$results/${name}_point_normal.ply"
  echo "Meshes:  $PWD/$results/${name}_linear.ply and ${name}_point_normal.ply"
  exit 0
fi

"$program" -o "$results"
names=(bearing_housing bearing_housing head cube_on_sphere creature)
titles=("part, sharp edges" "a hole of it" head cube creature)
zooms=(1 6 1 1 1)
shifts=(0,0 -0.36,-0.16 0,0 0,0 0,0)
meshes=()
options=()
for kind in linear point_normal; do
  for i in "${!names[@]}"; do
    meshes+=("$results/${names[$i]}_$kind.ply")
    options+=(--control "$results/${names[$i]}_control.ply" --caption "${titles[$i]}, ${kind/_/-}"
      --zoom "${zooms[$i]}" "--shift=${shifts[$i]}")
  done
done
draw "$build/subdivided.png" --columns 5 --tile 400 --view=-35,22 --shading split "${options[@]}" \
  "${meshes[@]}"
echo "Meshes:  $PWD/$results"
echo "The same with a mesh of your own (PLY, OFF, OBJ, STL):  scripts/demo.sh FILE"
