# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Refined meshes as the command writes them (PLY, text): what is where in them."""

from collections import defaultdict
from pathlib import Path

from control_meshes.files import as_text, read_ply
from control_meshes.mesh import Face, Mesh
from control_meshes.vector import Vec, add, normalized
from refinery import Refinery

RINGS = 4
ABOVE, BESIDE, NARROWER = 0.55, 1.5, 0.6


def refined(refinery: Refinery, mesh: str | Path, options: str) -> "Refined":
    return Refined(refinery.file(mesh, options + " --ascii"))


class Refined:
    """Points, faces and what else the file has of a vertex, by its names there. The control vertices
    are the first ones, unless the scheme drops them."""

    def __init__(self, path: Path) -> None:
        self.mesh, self.values = read_ply(path.read_text())
        self.points, self.faces, self.normals = self.mesh.points, self.mesh.faces, self.mesh.normals or []
        self.faces_at: dict[int, list[Face]] = defaultdict(list)
        self.neighbors: dict[int, set[int]] = defaultdict(set)
        for f in self.faces:
            for a, b in zip(f, f[1:] + f[:1]):
                self.faces_at[a].append(f)
                self.neighbors[a].add(b)
                self.neighbors[b].add(a)

    def is_border(self, v: int) -> bool:
        return len(self.neighbors[v]) != len(self.faces_at[v])

    def straight_line(self, start: int, towards: int) -> list[int]:
        """The vertices on the way from one over a neighbor straight on: each next edge has no face
        in common with the last one. Ends at the start, at the border or where it is not four edges
        that meet."""
        line = [start, towards]
        while line[-1] != start:
            beside = {v for f in self.faces_at[line[-1]] if line[-2] in f for v in f}
            ahead = self.neighbors[line[-1]] - beside
            if len(ahead) != 1:
                break
            line.append(ahead.pop())
        return line

    def lines_through(self, start: int) -> list[set[int]]:
        """The straight lines through a vertex."""
        lines: list[set[int]] = []
        for towards in sorted(self.neighbors[start]):
            line = set(self.straight_line(start, towards))
            if line not in lines:
                lines.append(line)
        return lines

    def line_over(self, a: int, b: int) -> set[int]:
        """The straight line through both."""
        return next(line for line in self.lines_through(a) if b in line)

    def layers(self, start: int, count: int) -> dict[int, int]:
        """How many faces each vertex up to this count is away from one."""
        layer = {start: 0}
        outermost = [start]
        for distance in range(1, count + 1):
            around = {w for v in outermost for f in self.faces_at[v] for w in f}
            outermost = sorted(around - set(layer))
            layer.update(dict.fromkeys(outermost, distance))
        return layer

    def normal_from_faces(self, v: int) -> Vec:
        """The normalized sum of the area vectors of the faces."""
        total = (0.0, 0.0, 0.0)
        for f in self.faces_at[v]:
            total = add(total, self.mesh.face_normal(f))
        return normalized(total)


# --- the surface rings of figure 6, one above the other ---


def control_data(refinery: Refinery, m: int) -> Path:
    """Control points and normals of level m."""
    return refinery.file("bezier_6.ply", f"--scheme catmull-clark --levels {m} --output-normals control --ascii")


def bent(refinery: Refinery, m: int) -> Refined:
    """The point-normal surface over ring m - 1."""
    return refined(refinery, control_data(refinery, m), "--scheme catmull-clark --levels 2")


def flat(refinery: Refinery, m: int, k: int) -> Refined:
    """The linear surface of the control points of level m, k rings further."""
    return refined(refinery, control_data(refinery, m), f"--scheme catmull-clark --linear --levels {k + 2}")


def write_rings(refinery: Refinery, folder: Path) -> None:
    """(a) PN.ply, ring m of the point-normal surface over ring m - 1, with control.ply, its control points and normals;
    (b) linear.ply, for each level m the rings of the linear surface of its control points."""
    sheets = {name: Mesh([], [], []) for name in ("PN", "control", "linear")}
    for m in range(RINGS):
        _add(sheets["PN"], bent(refinery, m), 4, 8, (0.0, 0.0, m * ABOVE))
        _add(sheets["control"], Refined(control_data(refinery, m)), 0, 3, (0.0, 0.0, m * ABOVE))
        beside = BESIDE * (1 - NARROWER ** m) / (1 - NARROWER)
        for k in range(RINGS - m):
            _add(sheets["linear"], flat(refinery, m, k), 4, 8, (beside, 0.0, (m + k) * ABOVE))
    for name, sheet in sheets.items():
        path = folder / f"{name}.ply"
        path.write_text(as_text(sheet, path.name))


def _add(sheet: Mesh, mesh: Refined, inner: int, outer: int, by: Vec) -> None:
    """The faces between two layers around the first vertex, moved."""
    layer = mesh.layers(0, outer)
    faces = [f for f in mesh.faces if all(inner <= layer.get(v, -1) for v in f)]
    used = sorted({v for f in faces for v in f})
    number = {v: len(sheet.points) + i for i, v in enumerate(used)}
    sheet.points += [add(mesh.points[v], by) for v in used]
    assert sheet.normals is not None
    sheet.normals += [mesh.normals[v] if mesh.normals else mesh.normal_from_faces(v) for v in used]
    sheet.faces += [tuple(number[v] for v in f) for f in faces]
