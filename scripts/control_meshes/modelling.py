# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Box modelling: quad meshes from blocks of cells and from extruded groups of faces."""

from collections.abc import Callable, Iterable
from itertools import product

from .mesh import Face, Mesh
from .vector import Vec, add, cos, mean, sin, sub

Cell = tuple[int, int, int]
X, Y, Z = range(3)
LEFT, RIGHT = (-1, 0, 0), (1, 0, 0)
FRONT, BACK = (0, -1, 0), (0, 1, 0)
DOWN, UP = (0, 0, -1), (0, 0, 1)
# The six sides of a cell: the step to the neighbour, and the corners counter-clockwise.
SIDES: dict[Cell, tuple[Cell, Cell, Cell, Cell]] = {
    (-1, 0, 0): ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)),
    (1, 0, 0): ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)),
    (0, -1, 0): ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)),
    (0, 1, 0): ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)),
    (0, 0, -1): ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)),
    (0, 0, 1): ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
}


def _plus(a: Cell, b: Cell) -> Cell:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def boundary_of_cells(cells: Iterable[Cell], place: Callable[[Cell], Vec],
                      period: int = 0) -> tuple[Mesh, list[tuple[Cell, Cell]]]:
    """The quads around a set of cells, and for each quad its cell and side. With a period the
    first coordinate closes around."""
    def wrap(c: Cell) -> Cell:
        return (c[0] % period, c[1], c[2]) if period else c

    filled = {wrap(c) for c in cells}
    index: dict[Cell, int] = {}
    faces: list[Face] = []
    origin: list[tuple[Cell, Cell]] = []
    for cell, (side, corners) in product(sorted(filled), SIDES.items()):
        if wrap(_plus(cell, side)) not in filled:
            nodes = [wrap(_plus(cell, c)) for c in corners]
            faces.append(tuple(index.setdefault(n, len(index)) for n in nodes))
            origin.append((cell, side))
    return Mesh([place(n) for n in index], faces), origin


class Model:
    """A quad mesh that grows by extrusion. A region is a list of face indices; extruding keeps
    the indices, so the same list names the moved faces afterwards."""

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh

    def vertices(self, region: list[int]) -> list[int]:
        return sorted({v for i in region for v in self.mesh.faces[i]})

    def centre(self, region: list[int]) -> Vec:
        return mean([self.mesh.points[v] for v in self.vertices(region)])

    def facing(self, side: Cell, among: Iterable[int]) -> int:
        """Which of the faces looks most into the direction of the side."""
        def amount(i: int) -> float:
            n = self.mesh.face_normal(self.mesh.faces[i])
            return n[0] * side[0] + n[1] * side[1] + n[2] * side[2]
        return max(among, key=amount)

    def extrude(self, region: list[int], step: Vec, grow: Vec = (1.0, 1.0, 1.0)) -> list[int]:
        """Lifts the region by `step`, scales it about its centre, and puts walls around.
        Returns the indices of the walls."""
        mesh, inside = self.mesh, set(region)
        edges = {e: i for i in region for e in _edges(mesh.faces[i])}
        rim = [e for e in edges if (e[1], e[0]) not in edges]
        copy = {a: len(mesh.points) + i for i, (a, _) in enumerate(rim)}
        mesh.points += [mesh.points[a] for a, _ in rim]
        for i in inside:
            mesh.faces[i] = tuple(copy.get(v, v) for v in mesh.faces[i])
        walls = list(range(len(mesh.faces), len(mesh.faces) + len(rim)))
        mesh.faces += [(a, b, copy[b], copy[a]) for a, b in rim]
        self.move(region, step, grow)
        return walls

    def move(self, region: list[int], step: Vec, grow: Vec = (1.0, 1.0, 1.0)) -> None:
        centre = self.centre(region)
        for v in self.vertices(region):
            d = sub(self.mesh.points[v], centre)
            self.mesh.points[v] = add(add(centre, step),
                                      (d[0] * grow[0], d[1] * grow[1], d[2] * grow[2]))

    def turn(self, region: list[int], first: int, second: int, angle: float) -> None:
        """Turns the region about its centre, from the first axis towards the second."""
        centre, c, s = self.centre(region), cos(angle), sin(angle)
        for v in self.vertices(region):
            d = list(sub(self.mesh.points[v], centre))
            a, b = d[first], d[second]
            d[first], d[second] = c * a - s * b, s * a + c * b
            self.mesh.points[v] = add(centre, (d[0], d[1], d[2]))


class Block(Model):
    """A model that begins as a block of cells."""

    def __init__(self, nx: int, ny: int, nz: int, place: Callable[[Cell], Vec]) -> None:
        cells = product(range(nx), range(ny), range(nz))
        mesh, self._origin = boundary_of_cells(cells, place)
        super().__init__(mesh)

    def side(self, side: Cell, wanted: Callable[[Cell], bool] = lambda cell: True) -> list[int]:
        """The block's faces on one side whose cells are wanted."""
        return [i for i, (cell, s) in enumerate(self._origin) if s == side and wanted(cell)]


def _edges(f: Face) -> list[tuple[int, int]]:
    return list(zip(f, f[1:] + f[:1]))
