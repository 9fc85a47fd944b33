#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws doc/PN_subdivision_3/fig/teaser.png: the control meshes of a cube, a bolt and a head, and what linear and
# point-normal subdivision make of them.
#
#   scripts/make_teaser_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

cat > "$work/cube.obj" <<'CUBE'
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
CUBE
part=data/meshes/parts/bolt

refine() { # name, options of the part, options of all
  "$command" surface "$work/cube.obj" "$work/cube_$1.ply" --scheme catmull-clark --levels 5 --quiet "${@:2}"
  "$command" surface "$part.obj" "$work/part_$1.$extension" --scheme catmull-clark --levels 4 --quiet \
             --sharp "$part.selection.txt" "${@:2}" 2> "$work/warnings" ||
    { cat "$work/warnings" >&2; return 1; }
  "$command" surface data/meshes/head.obj "$work/head_$1.ply" --levels 3 --quiet "${@:2}"
}
extension=off refine linear --linear
extension=obj refine PN

scripts/render.py --output "$folder/teaser.png" --columns 3 --tile 280 --shading split --view=30,30 \
                  --control "$work/cube.obj" --control "$part.obj" --control data/meshes/head.obj \
                  --control "$work/cube.obj" --control none --control none \
                  --control "$work/cube.obj" --control none --control none \
                  --caption "control meshes" --caption "" --caption "" \
                  --caption "linear" --caption "linear" --caption "linear" \
                  --caption "point-normal: a sphere" \
                  --caption "point-normal: cylinder, ball, planes" --caption "point-normal" \
                  "$work/cube.obj" "$part.obj" data/meshes/head.obj \
                  "$work/cube_linear.ply" "$work/part_linear.off" "$work/head_linear.ply" \
                  "$work/cube_PN.ply" "$work/part_PN.obj" "$work/head_PN.ply"
