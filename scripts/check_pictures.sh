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
#   scripts/check_pictures.sh [BUILD]      BUILD is build/release by default; needs what scripts/demo.sh
#                                          needs, and the examples
set -euo pipefail
cd "$(dirname "$0")/.."

build=${1:-build/release}
drawn=build/pictures
rm -rf "$drawn"
scripts/pictures.py --command "$build/src/pn_subdivide/pn_subdivide" --output "$drawn"

stale=0
scripts/make_paper_figures.py --build "$build" --check >/dev/null || stale=1
for picture in "$drawn"/*.png "$drawn"/paper/*.png; do
  /usr/bin/python3 -B scripts/compare_figures.py "$picture" "doc/PN_subdivision_3/fig/${picture#"$drawn"/}" || stale=1
done
[[ $stale -eq 0 ]] && echo "All pictures are what the present code draws."
exit "$stale"
