# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""A mesh with texture coordinates: a vase whose side and bottom are charts with straight borders."""

from dataclasses import dataclass, field
from math import cos, pi, sin

from .mesh import Face, Mesh
from .vector import Vec

AROUND = 12  # four times the faces along a side of the bottom
PROFILE = [(0.8, 0.0), (1.2, 0.45), (1.3, 1.0), (0.95, 1.6), (0.6, 2.1), (0.65, 2.6), (0.95, 2.9)]
TexturePoint = tuple[float, float]


@dataclass
class TexturedMesh(Mesh):
    """Faces also have a chart and texture points, one for each corner."""

    charts: list[str] = field(default_factory=list)
    texture: list[tuple[TexturePoint, ...]] = field(default_factory=list)

    def add(self, chart: str, face: Face, texture: tuple[TexturePoint, ...]) -> None:
        self.faces.append(face)
        self.charts.append(chart)
        self.texture.append(texture)


def vase() -> TexturedMesh:
    """Rings of points about the z-axis over a square grid, whose border is the first ring. The side
    is cut along one meridian."""
    mesh = TexturedMesh([_on_ring(r, z, i) for r, z in PROFILE for i in range(AROUND)], [])
    for k in range(len(PROFILE) - 1):
        for i in range(AROUND):
            cells = ((i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1))
            mesh.add("side", tuple(AROUND * b + a % AROUND for a, b in cells),
                     tuple((a / AROUND, 0.35 + 0.1 * b) for a, b in cells))
    _add_bottom(mesh)
    return mesh


def _on_ring(radius: float, z: float, i: int) -> Vec:
    angle = 2 * pi * i / AROUND
    return (round(radius * cos(angle), 3), round(radius * sin(angle), 3), z)


def _add_bottom(mesh: TexturedMesh) -> None:
    n = AROUND // 4
    border = ([(j, 0) for j in range(n)] + [(n, j) for j in range(n)]
              + [(n - j, n) for j in range(n)] + [(0, n - j) for j in range(n)])
    number = {cell: i for i, cell in enumerate(border)}
    for j in range(1, n):
        for i in range(1, n):
            number[i, j] = len(mesh.points)
            x, y = ((2 * c - n) / n for c in (i, j))
            # the corner (0, 0) of the grid is the first point of the ring
            mesh.points.append((round(-0.8 * (x + y) / 2, 3), round(0.8 * (x - y) / 2, 3), 0.0))
    for j in range(n):
        for i in range(n):
            cells = ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))  # seen from below
            mesh.add("bottom", tuple(number[c] for c in cells),
                     tuple((0.1 * b, 0.1 * a) for a, b in cells))
