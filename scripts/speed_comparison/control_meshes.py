# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The control meshes of the comparison, as OFF files."""

import math
from dataclasses import dataclass
from pathlib import Path

DATA = Path(__file__).resolve().parents[2] / "data" / "meshes"

# how many times the faces of the scheme's own degree become more in a round
GROWTH = {"catmull-clark": 4, "kobbelt": 4, "doo-sabin": 4, "loop": 4, "butterfly": 4, "sqrt3": 3}
OF_TRIANGLES = ("loop", "butterfly", "sqrt3")
ROUNDS = {scheme: 5 if scheme == "sqrt3" else 4 for scheme in GROWTH}

Points = list[tuple[float, ...]]
Faces = list[tuple[int, ...]]


@dataclass(frozen=True)
class Control_mesh:
    file: Path
    rounds: int


def tube(rings: int, segments: int, kind: str) -> tuple[Points, Faces]:
    """a closed tube whose radius varies: `quads`, `triangles` of valence 6, or `irregular` ones of
    valence 4 to 8"""
    points = []
    for i in range(rings):
        for j in range(segments):
            a, b = 2 * math.pi * i / rings, 2 * math.pi * j / segments
            r = 1 + 0.2 * math.cos(3 * a) + 0.1 * math.sin(2 * b)
            x = 3 + r * math.cos(b)
            points.append((x * math.cos(a), x * math.sin(a), r * math.sin(b)))
    faces: Faces = []
    for i in range(rings):
        for j in range(segments):
            k, l = (i + 1) % rings, (j + 1) % segments
            p, q, r, s = (u * segments + v for u, v in ((i, j), (k, j), (k, l), (i, l)))
            if kind == "quads":
                faces.append((p, q, r, s))
            elif kind == "triangles" or (i * 7 + j * 3) % 5 < 3:
                faces += [(p, q, r), (p, r, s)]
            else:
                faces += [(p, q, s), (q, r, s)]
    return points, faces


def read_obj(file: Path) -> tuple[Points, Faces]:
    points, faces = [], []
    for line in file.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            faces.append(tuple(int(w.split("/")[0]) - 1 for w in words[1:]))
    return points, faces


def write_off(file: Path, points: Points, faces: Faces) -> None:
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(repr, p)) for p in points]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    file.write_text("\n".join(lines) + "\n")


def real_mesh(scheme: str, faces_wanted: float) -> tuple[Points, Faces, int]:
    points, faces = read_obj(DATA / "creature.obj")
    if scheme in OF_TRIANGLES:
        faces = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]
        first = len(faces) * GROWTH[scheme]
    else:
        first = sum(map(len, faces))  # quads after a round
    rounds = 1 + max(0, round(math.log(faces_wanted / first, GROWTH[scheme])))
    return points, faces, rounds


def control_mesh(folder: Path, scheme: str, kind: str, faces_wanted: int) -> Control_mesh:
    """kind: regular, irregular or real; the refined mesh has about as many faces as wanted"""
    triangles = scheme in OF_TRIANGLES
    rounds = ROUNDS[scheme]
    if kind == "real":
        points, faces, rounds = real_mesh(scheme, faces_wanted)
    else:
        cells = faces_wanted / GROWTH[scheme] ** rounds
        if triangles:
            cells /= 2
        elif kind == "irregular":  # each cell is two triangles, which become six quads
            cells *= 4 / 6
        segments = max(4, round(0.9 * math.sqrt(cells)))
        shape = kind if kind == "irregular" else "triangles" if triangles else "quads"
        points, faces = tube(max(4, round(cells / segments)), segments, shape)
    shape = "triangles" if triangles else "polygons"
    file = folder / f"{kind}_{shape}_{faces_wanted}_{len(faces)}.off"
    if not file.exists():
        write_off(file, points, faces)
    return Control_mesh(file, rounds)
