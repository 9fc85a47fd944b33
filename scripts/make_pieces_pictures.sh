#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws doc/PN_subdivision_3/fig/pieces.png: every second piece of a refined surface, and all of them.
#
#   scripts/make_pieces_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

"$command" surface data/meshes/creature.obj "$work/all.pvtp" --levels 4 --pieces 12 --drop-attributes --quiet
sed '/piece_[0-9]*[13579]\.vtp/d' "$work/all.pvtp" > "$work/some.pvtp"

scripts/render.py --output "$folder/pieces.png" --columns 2 --tile 480 --same-view --shading smooth \
                  --view=35,20 --caption "six of twelve pieces" --caption "all of them" \
                  "$work"/{some,all}.pvtp
