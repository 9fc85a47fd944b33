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
# limits of its control normals and by the normals of the surface.
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
