# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""A polygon mesh as lists, with the checks that every control mesh must pass."""

from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field

from .vector import Vec, add, cross, dot, length, sub

Face = tuple[int, ...]


@dataclass
class Mesh:
    """Points, faces (indices, counter-clockwise from outside) and, where wanted, normals."""

    points: list[Vec]
    faces: list[Face]
    normals: list[Vec] | None = None
    comments: list[str] = field(default_factory=list)
    normals_are_handles: bool = False  # and need not agree with the faces

    def halfedges(self) -> Iterator[tuple[int, int]]:
        for f in self.faces:
            yield from zip(f, f[1:] + f[:1])

    def border_edges(self) -> list[tuple[int, int]]:
        """Half-edges of faces whose opposite has no face."""
        present = set(self.halfedges())
        return [(a, b) for a, b in present if (b, a) not in present]

    def valences(self) -> dict[int, int]:
        neighbours: dict[int, set[int]] = defaultdict(set)
        for a, b in self.halfedges():
            neighbours[a].add(b)
            neighbours[b].add(a)
        return {v: len(n) for v, n in neighbours.items()}

    def interior_valences(self) -> list[int]:
        border = {v for edge in self.border_edges() for v in edge}
        return sorted(n for v, n in self.valences().items() if v not in border)

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


def check(mesh: Mesh) -> None:
    """Raises ValueError unless the mesh is an oriented 2-manifold, possibly with borders,
    whose closed components face outwards and whose faces agree with the normals."""
    _check_faces(mesh)
    _check_vertex_fans(mesh)
    _check_closed_components(mesh)
    _check_normals(mesh)


def _check_faces(mesh: Mesh) -> None:
    for i, f in enumerate(mesh.faces):
        if len(f) < 3 or len(set(f)) != len(f):
            raise ValueError(f"face {i} {f} repeats a vertex or has fewer than three")
        if not all(0 <= v < len(mesh.points) for v in f):
            raise ValueError(f"face {i} {f} names a vertex that does not exist")
        if length(mesh.face_normal(f)) == 0:
            raise ValueError(f"face {i} {f} has no area")
    edge, times = Counter(mesh.halfedges()).most_common(1)[0]
    if times > 1:
        raise ValueError(f"half-edge {edge} belongs to {times} faces")


def _check_vertex_fans(mesh: Mesh) -> None:
    """Around each vertex the faces must form one fan, closed or open: no bow-ties."""
    corners: dict[int, dict[int, int]] = defaultdict(dict)
    for f in mesh.faces:
        for before, v, after in zip(f[-1:] + f[:-1], f, f[1:] + f[:1]):
            corners[v][after] = before
    for v, turn in corners.items():
        starts = set(turn) - set(turn.values())
        if len(starts) > 1:
            raise ValueError(f"vertex {v} is a bow-tie with {len(starts)} borders")
        first = next(iter(starts or turn))
        at, faces = turn[first], 1
        while at != first and at in turn:
            at, faces = turn[at], faces + 1
        if faces != len(turn):
            raise ValueError(f"vertex {v} is a bow-tie")


def _check_closed_components(mesh: Mesh) -> None:
    border = {v for edge in mesh.border_edges() for v in edge}
    for faces in mesh.components():
        if any(v in border for f in faces for v in f):
            continue
        volume = 0.0
        for f in faces:
            volume += dot(mesh.face_normal(f), mesh.points[f[0]])
        if volume <= 0:
            raise ValueError(f"the component of vertex {faces[0][0]} is inside out")


def _check_normals(mesh: Mesh) -> None:
    if mesh.normals is None:
        return
    if len(mesh.normals) != len(mesh.points):
        raise ValueError("there must be a normal for each vertex")
    for v, n in enumerate(mesh.normals):
        if any(n) and abs(dot(n, n) - 1) > 2.0 ** -51:
            raise ValueError(f"the normal of vertex {v} is neither unit nor zero")
    if mesh.normals_are_handles:
        return
    for i, f in enumerate(mesh.faces):
        mean = (0.0, 0.0, 0.0)
        for v in f:
            mean = add(mean, mesh.normals[v])
        if any(mean) and dot(mean, mesh.face_normal(f)) < 0:
            raise ValueError(f"face {i} {f} is turned against its normals")
