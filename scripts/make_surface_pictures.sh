#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws the pictures of the manual's page on surfaces of tessellated parts: a part of data/, and others of CGAL's data, which
# Debian's package libcgal-demo has.
#
#   scripts/make_surface_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

housing=data/meshes/parts/bearing_housing.obj
draw_housing() { # with the normals and creases of the file left out
  local common=(--scheme catmull-clark --levels 4 --quiet)
  "$command" "$housing" "$work/linear.off" "${common[@]}" --drop-attributes --linear --sharp angle:30
  "$command" "$housing" "$work/PN.obj" "${common[@]}" --normals estimate --sharp angle:30
  "$command" "$housing" "$work/surfaces.obj" "${common[@]}" --sharp surfaces
  scripts/render.py --output "$folder/surfaces_housing.png" --columns 4 --tile 320 --same-view \
                    --shading split --view=30,40 --caption "as it comes" \
                    --caption "linear, 30 degrees" --caption "PN, 30 degrees" \
                    --caption "PN, surfaces" "$housing" "$work"/{linear.off,PN.obj,surfaces.obj}
}

draw_housing

archive=/usr/share/doc/libcgal-demo/data.tar.gz
if [[ ! -f $archive ]]; then
  echo "left out: $archive is missing (Debian package libcgal-demo)" >&2
  exit 0
fi
tar -xzf "$archive" -C "$work" data/meshes/{joint,couplingdown}.off

refine() { # part, output, options
  "$command" surface "$work/data/meshes/$1.off" "$2" --scheme loop --levels 3 --curvature mean \
             --quiet "${@:3}" 2> "$work/warnings" || { cat "$work/warnings" >&2; return 1; }
}

draw() { # part, view, range of curvature, further options of render.py
  refine "$1" "$work/linear.vtp" --linear --sharp angle:30
  refine "$1" "$work/PN.vtp" --sharp angle:30
  refine "$1" "$work/surfaces.vtp" --sharp surfaces
  scripts/render.py --output "$folder/surfaces_$1.png" --columns 3 --tile 450 --same-view \
                    --shading split --scalars mean_curvature --range "$3" --view="$2" "${@:4}" \
                    --caption "linear, 30 degrees" --caption "PN, 30 degrees" \
                    --caption "PN, surfaces" "$work"/{linear,PN,surfaces}.vtp
}

draw joint 30,30 5
draw couplingdown 30,40 50 --cubic
