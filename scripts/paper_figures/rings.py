# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The surface rings of figure 6, one above the other."""

from pathlib import Path

from .refined import Face, Refined, Vec

RINGS = 4
ABOVE, BESIDE, NARROWER = 0.55, 1.5, 0.6


def write_rings(folder: Path) -> None:
    """(a) ring m of the point-normal surface over ring m - 1, with its control points and normals;
    (b) for each level m the rings of the linear surface of its control points."""
    bent, control, stacks = _Sheet(), _Sheet(), _Sheet()
    for m in range(RINGS):
        bent.add(Refined(folder / f"PN_{m}.ply"), 4, 8, (0.0, 0.0, m * ABOVE))
        control.add(Refined(folder / f"control_{m}.ply"), 0, 3,
                    (0.0, 0.0, m * ABOVE))
        beside = BESIDE * (1 - NARROWER ** m) / (1 - NARROWER)
        for k in range(RINGS - m):
            stacks.add(Refined(folder / f"linear_{m}_{k}.ply"), 4, 8,
                       (beside, 0.0, (m + k) * ABOVE))
    for name, sheet in (("rings_PN", bent), ("rings_control", control), ("rings_linear", stacks)):
        sheet.write(folder / f"{name}.ply")


class _Sheet:
    def __init__(self) -> None:
        self.rows: list[str] = []
        self.faces: list[Face] = []

    def add(self, mesh: Refined, inner: int, outer: int, by: Vec) -> None:
        """The faces between two layers around the first vertex, moved."""
        layer = mesh.layers(0, outer)
        faces = [f for f in mesh.faces if all(inner <= layer.get(v, -1) for v in f)]
        used = sorted({v for f in faces for v in f})
        number = {v: len(self.rows) + i for i, v in enumerate(used)}
        for v in used:
            p = [a + b for a, b in zip(mesh.points[v], by)]
            n = mesh.normals[v] if mesh.normals else mesh.normal_from_faces(v)
            self.rows.append(" ".join(map(repr, (*p, *n))))
        self.faces += [tuple(number[v] for v in f) for f in faces]

    def write(self, path: Path) -> None:
        names = ("x", "y", "z", "nx", "ny", "nz")
        path.write_text("\n".join(
            ["ply", "format ascii 1.0", f"element vertex {len(self.rows)}",
             *(f"property double {n}" for n in names), f"element face {len(self.faces)}",
             "property list uchar int vertex_indices", "end_header", *self.rows,
             *(" ".join(map(str, (len(f), *f))) for f in self.faces)]) + "\n")
