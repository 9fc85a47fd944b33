#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws the figures of the manual's section on control normals: points_alone.png, a sphere, a cap and a
# cylinder without normals; rims.png, the neck of a head; roundness.png, what is not round. The linear scheme, then the point-normal one
# with angle-weighted normals, then with those of the default. Colors are mean curvatures: that of a
# sphere or cylinder is one color.
#
#   scripts/make_normal_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

python3 - "$work" <<'PY'
import sys
from math import cos, pi, sin, sqrt
from random import Random

random = Random(3)


def write(name, points, faces):
    with open(f"{sys.argv[1]}/{name}.off", "w") as file:
        print(f"OFF\n{len(points)} {len(faces)} 0", file=file)
        for p in points:
            print(*p, file=file)
        for face in faces:
            print(len(face), *face, file=file)


def uneven(n, amount):
    steps = [1 + random.uniform(-amount, amount) for _ in range(n)]
    return [sum(steps[:i]) / sum(steps) for i in range(n + 1)]


def cells(nu, nv, index):
    """Quads of a grid, cut into triangles along either diagonal."""
    for j in range(nv):
        for i in range(nu):
            a, b, c, d = index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)
            yield from (([a, b, c], [a, c, d]) if random.random() < 0.5 else ([a, b, d], [b, c, d]))


def scaled(p, length):
    size = sqrt(sum(x * x for x in p))
    return tuple(length * x / size for x in p)


# A cube whose sides are grids, thrown on the sphere with every point a little off its place.
n = 4
corners, faces = {}, []
for axis in range(3):
    for end in (-1, 1):
        def index(i, j, axis=axis, end=end):
            p = [0, 0, 0]
            p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = end * n, (2 * i - n) * end, 2 * j - n
            return corners.setdefault(tuple(p), len(corners))
        faces += cells(n, n, index)
sphere = [scaled([x + random.uniform(-0.45, 0.45) for x in p], 1) for p in corners]
write("sphere", sphere, faces)

# a part of the sphere above a square
nu, nv = 7, 6
cap = []
for j in range(nv + 1):
    for i in range(nu + 1):
        x = 1.5 * (i + random.uniform(-0.3, 0.3) * (0 < i < nu)) / nu - 0.75
        y = 1.5 * (j + random.uniform(-0.3, 0.3) * (0 < j < nv)) / nv - 0.75
        p = scaled((x, y, 0.8), 1)
        cap.append((p[0], p[1], p[2] - 0.8))
write("cap", cap, list(cells(nu, nv, lambda i, j: j * (nu + 1) + i)))

# parallels and rulings
nu, nv = 11, 4
u, v = uneven(nu, 0.45), uneven(nv, 0.5)
tube = [(0.7 * cos(2 * pi * s), 0.7 * sin(2 * pi * s), 1.8 * t - 0.9) for t in v for s in u[:nu]]
write("cylinder", tube, list(cells(nu, nv, lambda i, j: j * nu + i % nu)))
PY

refine() { # scheme, control mesh, rounds, name
  local options=(--scheme "$1" --levels "$3" --curvature mean --quiet)
  "$command" surface "$2" "$work/$4_linear.vtp" "${options[@]}" --linear
  "$command" surface "$2" "$work/$4_angle.vtp" "${options[@]}" --normals angle
  "$command" surface "$2" "$work/$4_estimate.vtp" "${options[@]}" --normals estimate
}

captions=(--caption "linear" --caption "PN, angle weights" --caption "PN, coherent")
meshes=() all_captions=()
for shape in sphere cap cylinder; do
  refine loop "$work/$shape.off" 4 "$shape"
  for kind in linear angle estimate; do
    meshes+=("$work/${shape}_$kind.vtp")
  done
  all_captions+=("${captions[@]}")
done
scripts/render.py --output "$folder/points_alone.png" --columns 3 --tile 450 --shading averaged \
                  --same-view --view=35,25 --scalars mean_curvature --range 1.6 \
                  "${all_captions[@]}" "${meshes[@]}"

refine catmull-clark data/meshes/head.obj 4 head
scripts/render.py --output "$folder/rims.png" --columns 3 --tile 450 --shading averaged --same-view \
                  --view=-35,-15 --scalars mean_curvature --range 40 --cubic "${captions[@]}" \
                  "$work"/head_{linear,angle,estimate}.vtp

meshes=() all_captions=()
for shape in creature.obj spoon.obj; do
  name=${shape%.obj}
  options=(--scheme catmull-clark --levels 4 --quiet)
  "$command" surface "data/meshes/$shape" "$work/${name}_linear.ply" "${options[@]}" --linear
  "$command" surface "data/meshes/$shape" "$work/${name}_1.ply" "${options[@]}" --normals reciprocal
  "$command" surface "data/meshes/$shape" "$work/${name}_points.ply" "${options[@]}"
  meshes+=("$work/${name}"_{linear,1,points}.ply)
  all_captions+=(--caption "linear" --caption "PN, roundness 1" --caption "PN, roundness from the points")
done
scripts/render.py --output "$folder/roundness.png" --columns 3 --tile 450 --shading averaged \
                  "${all_captions[@]}" "${meshes[@]}"
