#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Tells which pictures of doc/PN_subdivision_3/fig (PNG) the present code draws otherwise, and leaves
# the new ones in build/pictures. The tests compare the drawings (SVG).
#
#   scripts/check_pictures.sh [PN_SUBDIVIDE]      needs what scripts/demo.sh needs
set -euo pipefail
cd "$(dirname "$0")/.."

command=${1:-build/release/src/pn_subdivide/pn_subdivide}
drawn=build/pictures
rm -rf "$drawn"
for script in scripts/make_*_pictures.sh; do
  "$script" "$command" "$drawn" >/dev/null
done

stale=0
for picture in "$drawn"/*.png; do
  scripts/compare_figures.py "$picture" "doc/PN_subdivision_3/fig/$(basename "$picture")" || stale=1
done
[[ $stale -eq 0 ]] && echo "All pictures are what the present code draws."
exit "$stale"
