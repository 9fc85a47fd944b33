#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws the pictures of the manual's page on surfaces of tessellated parts: parts of CGAL's data, which Debian's package
# libcgal-demo has.
#
#   scripts/make_surface_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

archive=/usr/share/doc/libcgal-demo/data.tar.gz
if [[ ! -f $archive ]]; then
  echo "left out: the pictures of recognized surfaces: $archive is missing (Debian package libcgal-demo)" >&2
  exit 0
fi
tar -xzf "$archive" -C "$work" data/meshes/{joint,couplingdown,rotor}.off

refine() { # part, output, options
  "$command" surface "$work/data/meshes/$1.off" "$2" --scheme loop --levels 3 --quiet "${@:3}" \
             2> "$work/warnings" || { cat "$work/warnings" >&2; return 1; }
}

draw() { # part, view
  local part=$work/data/meshes/$1.off
  refine "$1" "$work/linear.off" --linear --sharp angle:30
  refine "$1" "$work/PN.obj" --sharp angle:30
  refine "$1" "$work/surfaces.obj" --sharp surfaces
  scripts/render.py --output "$folder/surfaces_$1.png" --columns 4 --tile 320 --same-view \
                    --shading split --view="$2" --caption "as it comes" --caption "linear, 30 degrees" \
                    --caption "PN, 30 degrees" --caption "PN, surfaces" \
                    "$part" "$work/linear.off" "$work/PN.obj" "$work/surfaces.obj"
}

draw joint 30,30
draw couplingdown 30,40
draw rotor 30,35
