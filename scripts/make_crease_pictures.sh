#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws doc/PN_subdivision_3/fig/creases_PART.png for each part of data/meshes/parts: Catmull-Clark
# subdivision with its creases, linear on the left, point-normal on the right, under the control mesh;
# creases_curvature.png, the Gaussian curvature of the bearing housing, and
# creases_mean_curvature.png, the mean curvature of all other parts.
#
#   scripts/make_crease_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

parts=data/meshes/parts

refine() { # part, output, options
  "$command" surface "$parts/$1.obj" "$2" --scheme catmull-clark --levels 4 --quiet \
             --sharp "$parts/$1.selection.txt" "${@:3}" 2> "$work/warnings" ||
    { cat "$work/warnings" >&2; return 1; }
}

draw() { # part, view
  refine "$1" "$work/linear.off" --linear
  refine "$1" "$work/PN.obj"
  scripts/render.py --output "$folder/creases_$1.png" --columns 3 --tile 220 --same-view \
                    --shading split --view="$2" --control "$parts/$1.obj" --control none --control none \
                    --caption "control mesh" --caption linear --caption PN \
                    "$parts/$1.obj" "$work/linear.off" "$work/PN.obj"
}

draw capped_cylinder 30,30
draw half_ball 30,30
draw lens 30,20
draw washer 30,40
draw plate_with_holes 30,45
draw d_section 150,35
draw bolt 30,20
draw bracket 40,25
draw bearing_housing 30,40

refine bearing_housing "$work/linear.vtp" --linear --curvature gaussian
refine bearing_housing "$work/PN.vtp" --curvature gaussian
scripts/render.py --output "$folder/creases_curvature.png" --columns 2 --tile 450 --same-view \
                  --shading split --scalars gaussian_curvature --range 1 --view=30,40 \
                  --caption linear --caption PN "$work"/{linear,PN}.vtp

captions=() meshes=()
for part in capped_cylinder half_ball lens washer plate_with_holes d_section bolt bracket; do
  refine "$part" "$work/$part.linear.vtp" --linear --curvature mean
  refine "$part" "$work/$part.PN.vtp" --curvature mean
  captions+=(--caption "${part//_/ }, linear" --caption "${part//_/ }, PN")
  meshes+=("$work/$part".{linear,PN}.vtp)
done
scripts/render.py --output "$folder/creases_mean_curvature.png" --columns 4 --tile 450 \
                  --shading split --scalars mean_curvature --range 1.4 --view=30,30 \
                  "${captions[@]}" "${meshes[@]}"
