#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws doc/PN_subdivision_3/fig/SCHEME.png for each scheme: a closed mesh in the first row, the same
# mesh cut open in the second; the linear scheme on the left, the point-normal one with estimated
# control normals on the right. Surfaces are shaded by their faces, not by the refined normals; those of the
# modified schemes have the color of their Gaussian curvature, beside the unmodified scheme. And grid-catmull-clark.png,
# a torus and a surface of revolution of a few points, with the color of
# their Gaussian curvature.
#
#   scripts/make_scheme_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

# Four cubes about a corner; cut open, the arms have no ends and one of them lacks a side too.
python3 - "$work" <<'PY'
import sys
from itertools import product

cubes = {(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)}
missing = {((1, 0, 0), 0, 1), ((0, 1, 0), 1, 1), ((0, 0, 1), 2, 1), ((0, 0, 1), 0, 1)}


def outer_faces(left_out):
    """Quads (counter-clockwise from outside) of the sides of cubes that have no cube beyond."""
    for cube, axis, end in product(sorted(cubes), range(3), (0, 1)):
        beyond = tuple(x + (2 * end - 1) * (i == axis) for i, x in enumerate(cube))
        if beyond in cubes or (cube, axis, end) in left_out:
            continue
        ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
        corners = []
        for a, b in ring if end else reversed(ring):
            step = [0, 0, 0]
            step[axis], step[(axis + 1) % 3], step[(axis + 2) % 3] = end, a, b
            corners.append(tuple(x + s for x, s in zip(cube, step)))
        yield corners


def write(name, faces):
    points = sorted({p for face in faces for p in face})
    with open(f"{sys.argv[1]}/{name}.off", "w") as file:
        print(f"OFF\n{len(points)} {len(faces)} 0", file=file)
        for p in points:
            print(*p, file=file)
        for face in faces:
            print(len(face), *map(points.index, face), file=file)


for name, left_out in (("closed", set()), ("bordered", missing)):
    quads = list(outer_faces(left_out))
    write(name + "_quads", quads)
    write(name + "_triangles", [half for a, b, c, d in quads for half in ([a, b, c], [a, c, d])])
PY

draw() { # scheme, kind of faces, rounds, name
  local meshes=() controls=() captions=()
  for mesh in closed bordered; do
    local control=$work/${mesh}_$2.off
    "$command" surface "$control" "$work/$1_$mesh.ply" --scheme "$1" --levels "$3" --linear --quiet
    "$command" surface "$control" "$work/PN_$1_$mesh.ply" --scheme "$1" --levels "$3" \
               --normals reciprocal --quiet
    meshes+=("$work/$1_$mesh.ply" "$work/PN_$1_$mesh.ply")
    controls+=(--control "$control" --control "$control")
    captions+=(--caption "$4" --caption "PN-$4")
  done
  scripts/render.py --output "$folder/$1.png" --columns 2 --tile 320 --shading averaged --same-view \
                    --view=35,25 "${controls[@]}" "${captions[@]}" "${meshes[@]}"
}

draw catmull-clark quads 4 Catmull-Clark
draw doo-sabin quads 4 Doo-Sabin
draw kobbelt quads 4 Kobbelt
draw loop triangles 4 Loop
draw butterfly triangles 4 Butterfly
draw sqrt3 triangles 6 "sqrt(3)"
draw midpoint triangles 4 Midpoint
draw bilinear quads 4 Bilinear

draw_curvature() { # scheme, kind of faces, name
  local meshes=() options scheme
  for scheme in "$1" "modified-$1"; do
    for options in "--linear" "--normals reciprocal"; do
      meshes+=("$work/${#meshes[@]}.vtp")
      # shellcheck disable=SC2086  # several words
      "$command" surface "$work/closed_$2.off" "${meshes[-1]}" --scheme "$scheme" --levels 5 \
                 --curvature gaussian --quiet $options
    done
  done
  scripts/render.py --output "$folder/modified-$1.png" --columns 4 --tile 450 --same-view \
                    --shading averaged --scalars gaussian_curvature --range 12 --cubic --view=35,25 \
                    --caption "$3" --caption "PN-$3" --caption "modified $3" \
                    --caption "PN-modified $3" "${meshes[@]}"
}

draw_curvature catmull-clark quads Catmull-Clark
draw_curvature loop triangles Loop

# Points and normals of a torus, unevenly divided, and of a surface of revolution without a bottom.
python3 - "$work" <<'PY'
import sys
from math import cos, hypot, pi, sin


def write(name, rings, closed):
    """Each ring: the angle round the axis of its points, radius, height, and the normal in the half plane."""
    n, m = len(rings[0]), len(rings)
    with open(f"{sys.argv[1]}/{name}.ply", "w") as file:
        print(f"ply\nformat ascii 1.0\nelement vertex {n * m}", file=file)
        for x in ("x", "y", "z", "nx", "ny", "nz"):
            print(f"property double {x}", file=file)
        print(f"element face {n * (m - 1 + closed)}\nproperty list uchar int vertex_indices\nend_header", file=file)
        for ring in rings:
            for t, r, z, nr, nz in ring:
                print(r * cos(t), r * sin(t), z, nr * cos(t), nr * sin(t), nz, file=file)
        for i in range(m - 1 + closed):
            for j in range(n):
                k, l = (i + 1) % m, (j + 1) % n
                print(4, i * n + j, i * n + l, k * n + l, k * n + j, file=file)


turns = [0, 1.2, 3.0, 4.4]
write("torus", [[(t, 2 + cos(v), sin(v), cos(v), sin(v)) for t in turns] for v in (0, 1.4, 3.3, 4.6)], True)
rings = []
for i in range(7):
    z = i / 6
    r, slope = 1 + 0.45 * sin(6 * z), 0.45 * 6 * cos(6 * z) / 3
    size = hypot(1, slope)
    rings.append([(t, r, 3 * z, 1 / size, -slope / size) for t in (0, 0.9, 2.5, 3.4, 4.9)])
write("vase", rings, False)
PY

meshes=() controls=()
for shape in torus vase; do
  meshes+=("$work/$shape.ply")
  controls+=(--control "$work/$shape.ply" --control none --control none --control none)
  for kind in linear PN grid; do
    options=(--scheme catmull-clark --normals file)
    if [[ $kind == linear ]]; then options=(--scheme catmull-clark --linear); fi
    if [[ $kind == grid ]]; then options=(--scheme grid-catmull-clark --normals file); fi
    meshes+=("$work/${shape}_$kind.vtp")
    "$command" surface "$work/$shape.ply" "${meshes[-1]}" --levels 5 --curvature gaussian --quiet "${options[@]}"
  done
done
captions=(--caption "control mesh" --caption "linear" --caption "PN-Catmull-Clark" --caption "grid lines")
scripts/render.py --output "$folder/grid-catmull-clark.png" --columns 4 --tile 260 --shading split \
                  --scalars gaussian_curvature --range 6 --cubic --view=30,35 "${controls[@]}" \
                  "${captions[@]}" "${captions[@]}" "${meshes[@]}"
