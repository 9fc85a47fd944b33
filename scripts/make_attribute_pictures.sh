#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws doc/PN_subdivision_3/fig/checker.png: a vase with texture coordinates in two charts, before and
# after three rounds.
#
#   scripts/make_attribute_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

"$command" surface data/meshes/vase.obj "$work/vase.obj" --levels 3 --quiet

scripts/render.py --output "$folder/checker.png" --columns 2 --tile 420 --same-view --checker 24 \
                  --view=60,25 --caption "control mesh" --caption "three rounds" \
                  data/meshes/vase.obj "$work/vase.obj"
