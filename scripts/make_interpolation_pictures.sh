#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws the manual's figures of interpolation, from what the examples interpolate_samples and
# prescribe_normals write: interpolation_error.png and interpolation_curvature.png, surfaces through
# samples of an ellipsoid and a torus; prescribed_nose.png and prescribed_border.png.
#
#   scripts/make_interpolation_pictures.sh [PN_SUBDIVIDE [FOLDER [EXAMPLES]]]
set -euo pipefail
examples=${3:-build/release/examples/PN_subdivision_3}
source "$(dirname "$0")/figure_setup.sh"

"$examples/interpolate_samples" "$work"
"$examples/prescribe_normals" data/meshes/head.obj "$work"

captions=(--caption "linear" --caption "PN, limit points" --caption "PN, slide")
for shape in ellipsoid torus; do
  surfaces+=("$work/${shape}"_{linear,points,slide}.vtp)
done
range=(--range 0.03 --cubic)
scripts/render.py --output "$folder/interpolation_error.png" --columns 3 --tile 300 \
                  --scalars error "${range[@]}" "${captions[@]}" "${captions[@]}" "${surfaces[@]}"
scripts/render.py --output "$folder/interpolation_curvature.png" --columns 3 --tile 300 \
                  --scalars mean_curvature --range 3 "${captions[@]}" "${captions[@]}" "${surfaces[@]}"
scripts/render.py --output "$folder/prescribed_nose.png" --columns 2 --tile 420 --same-view \
                  --shading smooth --view=75,10 --caption "before" \
                  --caption "normal at the tip turned by 35 degrees" "$work"/nose_{before,after}.ply

# both patches in one mesh
join() { # name
  /usr/bin/python3 - "$work/left_$1.ply" "$work/right_$1.ply" "$work/joined_$1.ply" <<'PYTHON'
import sys
from pathlib import Path

import vtk

append = vtk.vtkAppendPolyData()
for name in sys.argv[1:3]:
    reader = vtk.vtkPLYReader()
    reader.SetFileName(name)
    reader.Update()
    append.AddInputData(reader.GetOutput())
append.Update()
writer = vtk.vtkPLYWriter()
writer.SetFileName(sys.argv[3])
writer.SetInputData(append.GetOutput())
writer.Write()
PYTHON
}
join before
join after
scripts/render.py --output "$folder/prescribed_border.png" --columns 2 --tile 420 --same-view \
                  --shading averaged --view=20,15 --caption "two patches" \
                  --caption "with common tangent planes" "$work"/joined_{before,after}.ply
