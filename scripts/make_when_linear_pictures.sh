#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws noise.png of the manual's page on where the linear scheme is better: a torus of even quads with its normals, turned by
# noise of 2 and 5 degrees, by Catmull-Clark subdivision: linear, point-normal, with roundness 1/2; one of its
# normals reversed. The color is the mean curvature.
#
#   scripts/make_when_linear_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

python3 - "$work" <<'PY'
import sys
from math import cos, pi, radians, sin, sqrt, tan
from random import Random

N, M = 32, 16


def write(name, noise, reversed_vertex=None):
    random = Random(1)
    rows = []
    for i in range(N * M):
        u, v = 2 * pi * (i // M) / N, 2 * pi * (i % M) / M
        n = [cos(u) * cos(v), sin(u) * cos(v), sin(v)]
        p = [(2 + 0.8 * cos(v)) * cos(u), (2 + 0.8 * cos(v)) * sin(u), 0.8 * sin(v)]
        n = [x + tan(radians(noise)) * random.gauss(0, sqrt(0.5)) for x in n]
        length = sqrt(sum(x * x for x in n)) * (-1 if i == reversed_vertex else 1)
        rows.append(p + [x / length for x in n])
    with open(f"{sys.argv[1]}/{name}.ply", "w") as file:
        print(f"ply\nformat ascii 1.0\nelement vertex {N * M}", file=file)
        for name in ("x", "y", "z", "nx", "ny", "nz"):
            print(f"property double {name}", file=file)
        print(f"element face {N * M}\nproperty list uchar int vertex_indices\nend_header", file=file)
        for row in rows:
            print(*row, file=file)
        for i in range(N):
            for j in range(M):
                k, l = (i + 1) % N, (j + 1) % M
                print(4, i * M + j, k * M + j, k * M + l, i * M + l, file=file)


write("exact", 0)
write("noise_2", 2)
write("noise_5", 5)
write("reversed", 0, 2 + 26 * M)
PY

refine() { # control mesh, result, options
  "$command" surface "$work/$1.ply" "$work/$2.vtp" --levels 3 --scheme catmull-clark --curvature mean --quiet "${@:3}"
}
refine exact linear --linear
refine exact PN_exact --normals file
refine noise_2 PN_2 --normals file
refine noise_2 half_2 --normals file --roundness 0.5
refine noise_5 PN_5 --normals file
refine reversed PN_reversed --normals file 2> "$work/warnings" # of the normal
scripts/render.py --output "$folder/noise.png" --columns 3 --tile 360 --same-view --shading averaged \
                  --scalars mean_curvature --range 1.6 --view=20,50 \
                  --caption "linear" --caption "PN, exact normals" --caption "PN, noise of 2 degrees" \
                  --caption "the same, roundness 1/2" --caption "PN, noise of 5 degrees" --caption "one normal reversed" \
                  "$work"/{linear,PN_exact,PN_2,half_2,PN_5,PN_reversed}.vtp
