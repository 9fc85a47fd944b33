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

from control_meshes.files import read_ply
from control_meshes.mesh import Face
from control_meshes.vector import Vec, add, normalized
from refinery import Refinery


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
