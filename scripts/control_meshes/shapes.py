# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Small shapes that are not samplings: blocks, torus, wheel, mixed polygons."""

from collections.abc import Callable, Sequence
from itertools import product
from math import sqrt
from random import Random

from .domain import TWO_PI
from .mesh import Face, Mesh, grid_quads
from .modelling import Cell, boundary_of_cells
from .vector import Vec, add, cos, cross, dot, length, lerp, mean, scaled, sin, sub, with_length

NO_NORMAL: Vec = (0.0, 0.0, 0.0)


def block(size: Vec, cells: Cell) -> tuple[Mesh, list[tuple[Cell, Cell]]]:
    """A box about the origin, its sides cut into cells."""
    def place(node: Cell) -> Vec:
        x, y, z = (s * (n / c - 0.5) for s, n, c in zip(size, node, cells))
        return (x, y, z)
    return boundary_of_cells(product(*map(range, cells)), place)


def cube() -> Mesh:
    return block((2.0, 2.0, 2.0), (1, 1, 1))[0]


def cube_on_sphere() -> Mesh:
    """With the normals of the unit sphere through its corners."""
    corners = cube()
    points = [with_length(p) for p in corners.points]
    return Mesh(points, corners.faces, list(points), ["sphere 0 0 0 1"])


def creased(size: Vec, cells: Cell) -> Mesh:
    """A box whose vertices all carry the normal of one side, also those on edges and corners:
    the top and the bottom win, then front and back. So normals turn by 90 degrees along one edge
    of the mesh, and by 180 where the box is one cell thick."""
    mesh, origin = block(size, cells)
    mesh.normals = [NO_NORMAL] * len(mesh.points)
    for axis in range(3):
        for f, (_, side) in zip(mesh.faces, origin):
            if side[axis]:
                for v in f:
                    mesh.normals[v] = (float(side[0]), float(side[1]), float(side[2]))
    return mesh


def egg_with_missing_normals() -> Mesh:
    """A rounded block whose normals are given but for one whole region and some lone vertices."""
    random = Random(9)
    mesh, _ = block((2.0, 2.0, 2.0), (5, 5, 5))
    axes = (1.0, 1.25, 1.6)
    mesh.normals = []
    for i, p in enumerate(mesh.points):
        x, y, z = with_length(p)
        mesh.points[i] = (x * axes[0], y * axes[1], z * axes[2])
        missing = x > 0.45 or random.random() < 0.12
        normal = with_length((x / axes[0], y / axes[1], z / axes[2]))
        mesh.normals.append(NO_NORMAL if missing else normal)
    return mesh


def torus(around: int, across: int, radius: float, tube: float) -> Mesh:
    """Quads on an unevenly divided torus about the z-axis, with its normals."""
    random = Random(7)
    u = [(i + lerp(-0.3, 0.3, random.random())) * TWO_PI / around for i in range(around)]
    v = [(i + lerp(-0.3, 0.3, random.random())) * TWO_PI / across for i in range(across)]
    normals = [with_length((cos(a) * cos(b), sin(a) * cos(b), sin(b))) for a, b in product(u, v)]
    points = [(cos(a) * (radius + tube * cos(b)), sin(a) * (radius + tube * cos(b)), tube * sin(b))
              for a, b in product(u, v)]

    faces = [(a, d, c, b) for a, b, c, d in grid_quads(across, around, "columns rows")]
    return Mesh(points, faces, normals, [f"torus 0 0 0 0 0 1 {radius!r} {tube!r}"])


def wheel(spokes: int) -> Mesh:
    """Genus spokes + 1."""
    shells = ((0.45, 0.25, 0.45), (1.1, 0.2, 0.4), (2.3, 0.09, 0.25), (2.8, 0.13, 0.4))
    return wheel_of_shells(spokes, shells, 1)[0]


def wheel_of_shells(spokes: int, shells: Sequence[Vec], gap: int) -> tuple[Mesh, list[Cell]]:
    """Hub, spokes and rim: quads, and the node of each point. Nodes and cells are (angle, layer, shell); of three angles one
    is a spoke, and in the gap there are only spokes. Shells have a radius, half the width of a spoke there, relative to the
    distance of spokes, and half a height."""
    cells = [(i, 0, j) for i, j in product(range(3 * spokes), range(len(shells) - 1)) if j != gap or i % 3 == 0]
    nodes: list[Cell] = []

    def place(node: Cell) -> Vec:
        nodes.append(node)
        radius, half_width, half_height = shells[node[2]]
        turn = node[0] // 3 + (-half_width, half_width, 0.5)[node[0] % 3]
        angle = turn * TWO_PI / spokes
        return (radius * cos(angle), radius * sin(angle), half_height * (2 * node[1] - 1))

    return boundary_of_cells(cells, place, period=3 * spokes)[0], nodes


def mixed_polygons() -> Mesh:
    """Triangles to hexagons in five components, four with borders, and a vertex of no face."""
    parts = [_tiling_with_hole(), _moved(_open_dodecahedron(), (7.5, -1.0, 0.0)),
             _moved(_truncated_octahedron(), (7.5, 2.4, 0.0)),
             Mesh([(-4.9, 2.9, 0.0), (-3.4, 2.4, 0.3), (-3.6, 3.9, 0.0), (-4.7, 4.2, -0.4)],
                  [(0, 1, 2, 3)]),
             Mesh([(-7.0, 0.0, 0.0), (-6.0, -0.2, 0.2), (-6.3, 0.8, 0.0), (-7.1, 1.1, 0.5)],
                  [(0, 1, 2), (0, 2, 3)]),
             Mesh([(5.5, -3.0, 0.0)], [])]
    result = Mesh([], [])
    for part in parts:
        first = len(result.points)
        result.points += part.points
        result.faces += [tuple(v + first for v in f) for f in part.faces]
    return result


def _moved(mesh: Mesh, by: Vec) -> Mesh:
    return Mesh([add(p, by) for p in mesh.points], mesh.faces)


def _tiling_with_hole() -> Mesh:
    """Hexagons, squares and triangles on a wavy sheet; one hexagon is missing, and some
    triangles are joined to a square and make pentagons."""
    points: list[Vec] = []
    faces: list[Face] = []
    pitch = 1 + sqrt(3)

    def vertex(p: Vec) -> int:
        for i, q in enumerate(points):
            if length(sub(p, q)) < 0.1:
                return i
        points.append(p)
        return len(points) - 1

    for i, j in product(range(3), range(2)):
        centre = ((i + 0.5 * j - 1.25) * pitch, (j - 0.5) * pitch * sqrt(3) / 2, 0.0)
        _add_tiles_around(centre, vertex, faces, hole=(i, j) == (1, 1))
    wavy = [(x, y, 0.3 * sin(0.8 * x) * cos(0.6 * y)) for x, y, _ in points]
    return Mesh(wavy, _with_pentagons(list(dict.fromkeys(faces))))


def _add_tiles_around(centre: Vec, vertex: Callable[[Vec], int], faces: list[Face],
                      hole: bool) -> None:
    """A hexagon, the squares on its sides and the triangles on its corners."""
    def corner(k: int) -> Vec:
        return add(centre, (cos((2 * k + 1) * TWO_PI / 12), sin((2 * k + 1) * TWO_PI / 12), 0.0))

    def outward(k: int) -> Vec:
        return (cos(2 * k * TWO_PI / 12), sin(2 * k * TWO_PI / 12), 0.0)

    tiles = [] if hole else [[corner(k) for k in range(6)]]
    for k in range(6):
        a, b = corner(k - 1), corner(k)
        tiles.append([a, add(a, outward(k)), add(b, outward(k)), b])
        tiles.append([b, add(b, outward(k)), add(b, outward(k + 1))])
    for tile in tiles:
        f = tuple(vertex(p) for p in tile)
        faces.append(f[f.index(min(f)):] + f[:f.index(min(f))])


def _with_pentagons(faces: list[Face]) -> list[Face]:
    """Joins every third triangle to a square at one of its edges."""
    owner = {e: f for f in faces for e in zip(f, f[1:] + f[:1])}
    result = dict.fromkeys(faces)
    for triangle in [f for f in faces if len(f) == 3][::3]:
        a, b, c = triangle
        square = owner.get((b, a))
        if square in result and len(square) == 4:
            i = square.index(a)
            del result[triangle], result[square]
            result[(c, a) + (square[i:] + square[:i])[1:3] + (b,)] = None
    return list(result)


def _open_dodecahedron() -> Mesh:
    mesh = _hull_of_planar_faces(_dodecahedron_points((1 + sqrt(5)) / 2))
    return Mesh(mesh.points, mesh.faces[:-1])


def _dodecahedron_points(phi: float) -> list[Vec]:
    points: list[Vec] = list(product((-1.0, 1.0), repeat=3))
    for a, b in product((-1 / phi, 1 / phi), (-phi, phi)):
        points += [(0.0, a, b), (a, b, 0.0), (b, 0.0, a)]
    return points


def _truncated_octahedron() -> Mesh:
    points: list[Vec] = []
    for a, b in product((-0.6, 0.6), (-1.2, 1.2)):
        points += [(0.0, a, b), (a, b, 0.0), (b, 0.0, a), (0.0, b, a), (b, a, 0.0), (a, 0.0, b)]
    return _hull_of_planar_faces(points)


def _hull_of_planar_faces(points: list[Vec]) -> Mesh:
    """A convex polyhedron about the origin; coplanar points make one face."""
    planes: dict[tuple[int, ...], Vec] = {}
    n = len(points)
    for a, b, c in product(range(n), repeat=3):
        if not a < b < c:
            continue
        normal = cross(sub(points[b], points[a]), sub(points[c], points[a]))
        heights = [dot(normal, sub(p, points[a])) for p in points]
        flat = tuple(v for v in range(n) if abs(heights[v]) < 1e-9)
        if max(heights) < 1e-9 or min(heights) > -1e-9:
            planes.setdefault(flat, normal if max(heights) < 1e-9 else scaled(normal, -1.0))
    return Mesh(points, [_around(points, flat, normal) for flat, normal in planes.items()])


def _around(points: list[Vec], flat: tuple[int, ...], normal: Vec) -> Face:
    """The corners of a convex face in counter-clockwise order about its normal."""
    centre = mean([points[v] for v in flat])
    ordered = [flat[0]]
    while len(ordered) < len(flat):
        spoke = sub(points[ordered[-1]], centre)
        ahead = [v for v in flat if v not in ordered
                 and dot(cross(spoke, sub(points[v], centre)), normal) > 0]
        ordered.append(max(ahead, key=lambda v: dot(spoke, sub(points[v], centre))))
    return tuple(ordered)
