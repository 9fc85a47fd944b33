#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Runs the commands of README.md as they stand, and draws what they write, of the huge file every second piece:
# doc/PN_subdivision_3/fig/readme_*.png.
#
#   scripts/make_readme_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

command=$(realpath "$command")
ln -s "$PWD/data" "$work/data"
grep '^pn_subdivide ' README.md > "$work/commands"
(
  cd "$work"
  pn_subdivide() { "$command" "$@" --quiet; }
  source ./commands
)

draw() { # name, result, options
  scripts/render.py --output "$folder/readme_$1.png" --tile 240 --caption "" "${@:3}" "$work/$2"
}
draw smooth smooth.ply --control data/meshes/creature.obj
draw sharp part.obj --shading split --view=30,40
draw curvature curvature.vtp --tile 205 --shading averaged --scalars gaussian_curvature --range 1000 --cubic
draw interpolate through.ply --control data/meshes/torus_quads.ply
sed -i '/piece_[0-9]*[13579]\.vtp/d' "$work/huge.pvtp"
draw huge huge.pvtp --view=35,20
