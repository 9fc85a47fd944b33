#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws gallery.png of the manual: twelve meshes of other people, of Debian's package sweethome3d-furniture, in
# /usr/share/sweethome3d/furniture or the folder FURNITURE: control mesh, linear, point-normal, both with creases where they are given.
#
#   scripts/make_gallery_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

furniture=${FURNITURE:-/usr/share/sweethome3d/furniture}
if [[ ! -d $furniture ]]; then
  echo "left out: $furniture is missing (Debian package sweethome3d-furniture)" >&2
  exit 0
fi

tiles=() captions=()
draw() { # collection, mesh, angle of creases in degrees or none
  local folder=${1,,} name=$2 sharp=none title=$2
  if [[ $3 != none ]]; then sharp=angle:$3 title="$2, creases from $3 degrees on"; fi
  unzip -q -o -j "$furniture/$1.sh3f" "$folder/$name/$name.obj" -d "$work"
  for how in linear estimate; do
    option=(--normals estimate)
    if [[ $how == linear ]]; then option=(--linear); fi
    "$command" surface "$work/$name.obj" "$work/${name}_$how.obj" --levels 3 --scheme catmull-clark --sharp "$sharp" \
               --quiet "${option[@]}" 2> "$work/warnings" || { cat "$work/warnings" >&2; return 1; }
  done
  tiles+=("$work/$name.obj" "$work/${name}_linear.obj" "$work/${name}_estimate.obj")
  captions+=(--caption "$title" --caption linear --caption PN)
}

draw Scopia cat none
draw Scopia dog none
draw BlendSwap-CC-BY siameseCat none
draw Scopia roasted-chicken none
draw Scopia old_jar none
draw Scopia puff none
draw Scopia basin 45
draw BlendSwap-CC-0 iphone 45
draw BlendSwap-CC-0 bread 45
draw BlendSwap-CC-0 stoneLantern 30
draw BlendSwap-CC-0 rock1 none
draw BlendSwap-CC-BY simpleDesk none
scripts/render.py --output "$folder/gallery.png" --columns 6 --tile 170 --up y --view=-35,22 --shading split "${captions[@]}" "${tiles[@]}"
