#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws what the manual begins with: doc/PN_subdivision_3/fig/quick_start.png, as its quick start does, and
# package.png.
#
#   scripts/make_quick_start_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

"$command" surface data/meshes/creature.obj "$work/smooth.ply" --levels 4 --quiet
scripts/render.py --output "$folder/quick_start.png" --control data/meshes/creature.obj "$work/smooth.ply"

"$command" surface data/meshes/head.obj "$work/head.ply" --levels 4 --quiet
scripts/render.py --output "$folder/package.png" --tile 170 --view=35,20 --caption "" "$work/head.ply"
