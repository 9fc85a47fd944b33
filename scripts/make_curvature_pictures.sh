#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws doc/PN_subdivision_3/fig/curvature_MESH.png for two models of data/: the Gaussian curvature of
# the surfaces by Catmull-Clark and modified Catmull-Clark subdivision, linear and point-normal, in the
# same colors. The control normals are estimated. And curvature_transfer.png, see draw_policies().
#
#   scripts/make_curvature_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

refine() { # mesh, rounds, output, scheme, options
  "$command" surface "data/meshes/$1" "$work/$3.vtp" --levels "$2" --curvature gaussian --quiet \
             --scheme "${@:4}"
}

draw() { # mesh, rounds, curvature at the ends of the colors, view, options of the picture
  refine "$1" "$2" linear catmull-clark --linear
  refine "$1" "$2" modified modified-catmull-clark --linear
  refine "$1" "$2" PN catmull-clark
  refine "$1" "$2" PN_modified modified-catmull-clark
  scripts/render.py --output "$folder/curvature_${1%.*}.png" --columns 4 --tile 300 --same-view \
                    --shading averaged --scalars gaussian_curvature --range "$3" --view="$4" "${@:5}" \
                    --caption "linear" --caption "modified linear" --caption "PN" \
                    --caption "PN-modified" "$work"/{linear,modified,PN,PN_modified}.vtp
}

# the point-normal schemes with their policies, and the one with transfer of curvature
draw_policies() { # as draw()
  refine "$1" "$2" PN catmull-clark
  refine "$1" "$2" PN_modified modified-catmull-clark
  refine "$1" "$2" first_2 modified-catmull-clark --first-round 2
  refine "$1" "$2" transfer ct-catmull-clark
  scripts/render.py --output "$folder/curvature_transfer.png" --columns 4 --tile 300 --same-view \
                    --shading averaged --scalars gaussian_curvature --range "$3" --view="$4" "${@:5}" \
                    --caption "PN" --caption "PN-modified" --caption "first round plain" \
                    --caption "transfer" "$work"/{PN,PN_modified,first_2,transfer}.vtp
}

draw_policies cylinder_cap_8.ply 5 0.05 35,50 --cubic
draw spoon.obj 4 30 -40,60 --cubic --zoom 2 --shift=-0.44,-0.2
draw head.obj 4 1000 -35,10 --cubic
