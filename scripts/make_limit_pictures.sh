#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws doc/PN_subdivision_3/fig/surface_normals.png: a point-normal surface on its limit, shaded by the
# limits of its control normals and by the normals of the surface; and tessellation.png, triangles to a tolerance beside
# uniform rounds.
#
#   scripts/make_limit_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

refine() { # output, options
  "$command" surface data/meshes/creature.obj "$work/$1.ply" --levels 4 --scheme catmull-clark \
             --normals estimate --limit --quiet "${@:2}"
}

refine control --output-normals control
refine surface --output-normals surface

scripts/render.py --output "$folder/surface_normals.png" --columns 2 --tile 420 --same-view \
                  --shading smooth --view=35,20 --caption "control normals" \
                  --caption "surface normals" "$work"/{control,surface}.ply

draw() { # name, mesh, part of the diagonal, rounds, what is sharp
  local options=(--scheme catmull-clark --normals estimate --sharp "$5" --quiet)
  "$command" surface "data/meshes/$2" "$work/$1.ply" --chord "$3" "${options[@]}"
  "$command" surface "data/meshes/$2" "$work/$1_uniform.ply" --levels "$4" --limit "${options[@]}"
}

draw sphere cube_on_sphere.ply 0.22% 4 none
draw head head.obj 0.1% 3 angle:30
draw housing parts/bearing_housing.obj 0.05% 2 angle:30

scripts/render.py --output "$folder/tessellation.png" --columns 3 --tile 380 --shading flat --edges \
                  --view=35,30 --caption "sphere, to 0.2 %" --caption "head, to 0.1 %" \
                  --caption "housing, to 0.05 %" --caption "4 uniform rounds" \
                  --caption "3 uniform rounds" --caption "2 uniform rounds" \
                  "$work"/{sphere,head,housing}.ply "$work"/{sphere,head,housing}_uniform.ply
