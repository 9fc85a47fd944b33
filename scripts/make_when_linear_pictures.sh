#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Draws pictures of the manual's page on where the linear scheme is better, colored by the mean curvature. noise.png: a torus of
# even quads with its normals, turned by noise of 2 and 5 degrees, by Catmull-Clark subdivision: linear, point-normal, with
# roundness 1/2; one of its normals reversed. smooth.png: noise of 5 degrees, as given and smoothed, and the linear scheme, on this
# torus and on one of uneven triangles, by Loop subdivision.
#
#   scripts/make_when_linear_pictures.sh [PN_SUBDIVIDE [FOLDER]]
set -euo pipefail
source "$(dirname "$0")/figure_setup.sh"

python3 - "$work" <<'PY'
import sys
from math import cos, pi, radians, sin, sqrt, tan
from random import Random

N, M = 32, 16


def write(name, noise, reversed_vertex=None, uneven=0.0):
    """Quads, or triangles if the points are uneven, along either diagonal."""
    random, layout = Random(1), Random(2)
    rows = []
    for i in range(N * M):
        u, v = (2 * pi * (j + layout.uniform(-uneven, uneven)) / n for j, n in ((i // M, N), (i % M, M)))
        n = [cos(u) * cos(v), sin(u) * cos(v), sin(v)]
        p = [(2 + 0.8 * cos(v)) * cos(u), (2 + 0.8 * cos(v)) * sin(u), 0.8 * sin(v)]
        n = [x + tan(radians(noise)) * random.gauss(0, sqrt(0.5)) for x in n]
        length = sqrt(sum(x * x for x in n)) * (-1 if i == reversed_vertex else 1)
        rows.append(p + [x / length for x in n])
    with open(f"{sys.argv[1]}/{name}.ply", "w") as file:
        print(f"ply\nformat ascii 1.0\nelement vertex {N * M}", file=file)
        for name in ("x", "y", "z", "nx", "ny", "nz"):
            print(f"property double {name}", file=file)
        print(f"element face {N * M * (2 if uneven else 1)}\nproperty list uchar int vertex_indices\nend_header", file=file)
        for row in rows:
            print(*row, file=file)
        for i in range(N):
            for j in range(M):
                k, l = (i + 1) % N, (j + 1) % M
                a, b, c, d = i * M + j, k * M + j, k * M + l, i * M + l
                if not uneven:
                    print(4, a, b, c, d, file=file)
                elif layout.random() < 0.5:
                    print(3, a, b, c, "\n3", a, c, d, file=file)
                else:
                    print(3, a, b, d, "\n3", b, c, d, file=file)


write("exact", 0)
write("noise_2", 2)
write("noise_5", 5)
write("reversed", 0, 2 + 26 * M)
write("triangles", 5, uneven=0.35)
PY

refine() { # control mesh, result, options
  local scheme=catmull-clark
  if [[ $1 == triangles ]]; then scheme=loop; fi
  "$command" surface "$work/$1.ply" "$work/$2.vtp" --levels 3 --scheme $scheme --curvature mean --quiet "${@:3}"
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

refine noise_5 smooth_5 --normals smooth
for kind in file smooth; do
  refine triangles "triangles_$kind" --normals $kind
done
refine triangles triangles_linear --linear
captions=(--caption "linear" --caption "PN, noise of 5 degrees" --caption "PN, smoothed")
scripts/render.py --output "$folder/smooth.png" --columns 3 --tile 300 --same-view --shading averaged \
                  --scalars mean_curvature --range 2 --view=20,50 "${captions[@]}" "${captions[@]}" \
                  "$work"/{linear,PN_5,smooth_5}.vtp "$work"/triangles_{linear,file,smooth}.vtp
