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

from control_meshes.files import as_text, read_mesh
from control_meshes.mesh import Face, Mesh, grid_quads
from control_meshes.vector import Vec
from refinery import DATA

# how many times the faces of the scheme's own degree become more in a round
GROWTH = {"catmull-clark": 4, "kobbelt": 4, "doo-sabin": 4, "loop": 4, "butterfly": 4, "sqrt3": 3}
OF_TRIANGLES = ("loop", "butterfly", "sqrt3")
ROUNDS = {scheme: 5 if scheme == "sqrt3" else 4 for scheme in GROWTH}


@dataclass(frozen=True)
class Control_mesh:
    file: Path
    rounds: int


def tube(rings: int, segments: int, kind: str) -> Mesh:
    """a closed tube whose radius varies: `quads`, `triangles` of valence 6, or `irregular` ones of
    valence 4 to 8"""
    points: list[Vec] = []
    for i in range(rings):
        for j in range(segments):
            a, b = 2 * math.pi * i / rings, 2 * math.pi * j / segments
            r = 1 + 0.2 * math.cos(3 * a) + 0.1 * math.sin(2 * b)
            x = 3 + r * math.cos(b)
            points.append((x * math.cos(a), x * math.sin(a), r * math.sin(b)))
    faces: list[Face] = []
    for number, (p, s, r, q) in enumerate(grid_quads(segments, rings, "columns rows")):
        i, j = divmod(number, segments)
        if kind == "quads":
            faces.append((p, q, r, s))
        elif kind == "triangles" or (i * 7 + j * 3) % 5 < 3:
            faces += [(p, q, r), (p, r, s)]
        else:
            faces += [(p, q, s), (q, r, s)]
    return Mesh(points, faces)


def real_mesh(scheme: str, faces_wanted: float) -> tuple[Mesh, int]:
    """the creature, and how many rounds"""
    mesh = read_mesh(DATA / "creature.obj")
    if scheme in OF_TRIANGLES:
        mesh.faces = mesh.triangles()
        first = len(mesh.faces) * GROWTH[scheme]
    else:
        first = sum(map(len, mesh.faces))  # quads after a round
    return mesh, 1 + max(0, round(math.log(faces_wanted / first, GROWTH[scheme])))


def control_mesh(folder: Path, scheme: str, kind: str, faces_wanted: int) -> Control_mesh:
    """kind: regular, irregular or real; the refined mesh has about as many faces as wanted"""
    triangles = scheme in OF_TRIANGLES
    rounds = ROUNDS[scheme]
    if kind == "real":
        mesh, rounds = real_mesh(scheme, faces_wanted)
    else:
        cells = faces_wanted / GROWTH[scheme] ** rounds
        if triangles:
            cells /= 2
        elif kind == "irregular":  # each cell is two triangles, which become six quads
            cells *= 4 / 6
        segments = max(4, round(0.9 * math.sqrt(cells)))
        shape = kind if kind == "irregular" else "triangles" if triangles else "quads"
        mesh = tube(max(4, round(cells / segments)), segments, shape)
    shape = "triangles" if triangles else "polygons"
    file = folder / f"{kind}_{shape}_{faces_wanted}_{len(mesh.faces)}.off"
    if not file.exists():
        file.write_text(as_text(mesh, file.name))
    return Control_mesh(file, rounds)
