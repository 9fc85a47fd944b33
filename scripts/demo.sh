#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Installs what is missing, builds in Release, subdivides the control meshes of data/ and draws them.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh --picture
scripts/build.sh subdivide_control_meshes
if cmake --build build/release --target help | grep '^pn_subdivide:' >/dev/null; then # needs CLI11
  scripts/build.sh pn_subdivide
fi

rm -rf build/demo
mkdir -p build/demo
build/release/examples/PN_subdivision_3/subdivide_control_meshes data/meshes build/demo

meshes=(build/demo/*.ply)
command=build/release/src/pn_subdivide/pn_subdivide
if [[ -x $command ]]; then
  for mesh in "${meshes[@]}"; do # VTP, for ParaView and VTK
    "$command" surface "$mesh" "${mesh%.ply}.vtp" --scheme catmull-clark --levels 0 --quiet
  done
fi

# each result with the edges of its control mesh
picture=build/demo/subdivided.png
controls=()
for mesh in "${meshes[@]}"; do
  for control in data/meshes/"$(basename "$mesh" .ply)".*; do
    [[ -e $control ]] && controls+=(--control "$control")
  done
done
[[ ${#controls[@]} -eq $((2 * ${#meshes[@]})) ]] || controls=()
if scripts/render.py --output "$picture" "${controls[@]}" "${meshes[@]}"; then
  echo "Picture: $PWD/$picture"
else
  echo "No picture: scripts/render.py needs Python 3 with VTK and Xvfb" \
       "(Debian packages python3-vtk9 and xvfb)." >&2
fi
echo "Meshes:  $PWD/build/demo (PLY, and VTP where the command pn_subdivide is built)"
