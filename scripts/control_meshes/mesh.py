# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""A polygon mesh as lists."""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field

from .vector import Vec, add, cross, sub

Face = tuple[int, ...]


@dataclass
class Mesh:
    """Points, faces (indices, counter-clockwise from outside) and, where there are any, normals of vertices, normals of the
    corners of faces, and the group of each face."""

    points: list[Vec]
    faces: list[Face]
    normals: list[Vec] | None = None
    comments: list[str] = field(default_factory=list)
    corner_normals: list[list[Vec]] = field(default_factory=list)
    groups: list[str] = field(default_factory=list)

    def halfedges(self) -> Iterator[tuple[int, int]]:
        for f in self.faces:
            yield from zip(f, f[1:] + f[:1])

    def border_edges(self) -> list[tuple[int, int]]:
        """Half-edges of faces whose opposite has no face."""
        present = set(self.halfedges())
        return [(a, b) for a, b in present if (b, a) not in present]

    def border_vertices(self) -> set[int]:
        return {v for edge in self.border_edges() for v in edge}

    def interior_valences(self) -> list[int]:
        neighbors: dict[int, set[int]] = defaultdict(set)
        for a, b in self.halfedges():
            neighbors[a].add(b)
            neighbors[b].add(a)
        border = self.border_vertices()
        return sorted(len(n) for v, n in neighbors.items() if v not in border)

    def components(self) -> list[list[Face]]:
        """The faces, grouped by connection through shared vertices."""
        parent = list(range(len(self.points)))

        def root(v: int) -> int:
            while parent[v] != v:
                parent[v] = parent[parent[v]]
                v = parent[v]
            return v

        for a, b in self.halfedges():
            parent[root(a)] = root(b)
        groups: dict[int, list[Face]] = defaultdict(list)
        for f in self.faces:
            groups[root(f[0])].append(f)
        return list(groups.values())

    def number_of_borders(self) -> int:
        following = dict(self.border_edges())
        loops = 0
        while following:
            loops += 1
            v, following_v = following.popitem()
            while following_v != v:
                following_v = following.pop(following_v)
        return loops

    def triangles(self) -> list[Face]:
        """The faces, each cut from its first corner."""
        return [(f[0], f[i], f[i + 1]) for f in self.faces for i in range(1, len(f) - 1)]

    def face_normal(self, f: Face) -> Vec:
        """The area vector: half its length is the area of a planar face."""
        n = (0.0, 0.0, 0.0)
        for a, b in zip(f[1:], f[2:]):
            n = add(n, cross(sub(self.points[a], self.points[f[0]]),
                             sub(self.points[b], self.points[f[0]])))
        return n


def grid_quads(columns: int, rows: int, closed: str = "") -> Iterator[Face]:
    """The quads between columns x rows points that are numbered row by row; `closed` says whether the grid closes
    across columns and rows, as in "columns"."""
    for j in range(rows if "rows" in closed else rows - 1):
        for i in range(columns if "columns" in closed else columns - 1):
            a, b = j * columns, (j + 1) % rows * columns
            k = (i + 1) % columns
            yield (a + i, a + k, b + k, b + i)
