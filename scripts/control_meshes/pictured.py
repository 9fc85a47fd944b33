# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Control meshes of pictures that are not in data/: they are made when scripts/pictures.py draws, need not be
the same to the last bit everywhere, and may be noisy."""

from collections.abc import Callable, Iterable, Iterator
from functools import cache, partial
from itertools import product
from math import cos, hypot, pi, radians, sin, sqrt, tan
from random import Random

from .mesh import Face, Mesh, grid_quads
from .vector import Vec, add, normalized, scaled


# --- of schemes ---


# of a cube: the step to the neighbor, and the corners counter-clockwise
SIDES: dict[Vec, tuple[Vec, Vec, Vec, Vec]] = {
    (-1, 0, 0): ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)),
    (1, 0, 0): ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)),
    (0, -1, 0): ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)),
    (0, 1, 0): ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)),
    (0, 0, -1): ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)),
    (0, 0, 1): ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
}


def four_cubes(is_open: bool, is_triangulated: bool) -> Mesh:
    """About a corner; cut open, the arms have no ends and one of them lacks a side too."""
    missing = {((1, 0, 0), (1, 0, 0)), ((0, 1, 0), (0, 1, 0)), ((0, 0, 1), (0, 0, 1)), ((0, 0, 1), (1, 0, 0))}
    cubes: list[Vec] = [(0, 0, 0), (0, 0, 1), (0, 1, 0), (1, 0, 0)]
    points: dict[Vec, int] = {}
    faces: list[Face] = []
    for cube, (side, corners) in product(cubes, SIDES.items()):
        if add(cube, side) in cubes or (is_open and (cube, side) in missing):
            continue
        a, b, c, d = (points.setdefault(add(cube, corner), len(points)) for corner in corners)
        if not is_triangulated:
            faces.append((a, b, c, d))
        else:
            faces += [(a, b, c), (a, c, d)] if sum(side) > 0 else [(a, b, d), (b, c, d)]
    return Mesh(list(points), faces)


def _of_revolution(rings: Iterable[list[tuple[float, float, float, float, float]]], closed: str) -> Mesh:
    """Each ring: the angle of its points, radius, height, and the normal in the half plane."""
    samples = [((r * cos(t), r * sin(t), z), (nr * cos(t), nr * sin(t), nz)) for ring in rings for t, r, z, nr, nz in ring]
    columns = 4 if "rows" in closed else 5
    return Mesh([p for p, _ in samples], list(grid_quads(columns, len(samples) // columns, closed)), [n for _, n in samples])


def uneven_torus() -> Mesh:
    return _of_revolution(([(t, 2 + cos(v), sin(v), cos(v), sin(v)) for t in (0, 1.2, 3.0, 4.4)]
                           for v in (0, 1.4, 3.3, 4.6)), "columns rows")


def uneven_vase() -> Mesh:
    """Without a bottom."""
    rings = []
    for i in range(7):
        z = i / 6
        r, slope = 1 + 0.45 * sin(6 * z), 0.45 * 6 * cos(6 * z) / 3
        size = hypot(1, slope)
        rings.append([(t, r, 3 * z, 1 / size, -slope / size) for t in (0, 0.9, 2.5, 3.4, 4.9)])
    return _of_revolution(rings, "columns")


# --- of points alone ---


def _cut(quads: Iterable[Face], random: Random) -> Iterator[Face]:
    """Into triangles, along either diagonal."""
    for a, b, c, d in quads:
        yield from ((a, b, c), (a, c, d)) if random.random() < 0.5 else ((a, b, d), (b, c, d))


@cache
def points_alone() -> dict[str, Mesh]:
    random = Random(3)
    return {"sphere": _sphere(random), "cap": _cap(random), "cylinder": _cylinder(random)}


def _sphere(random: Random) -> Mesh:
    """A cube whose sides are grids, thrown on the sphere with every point a little off its place."""
    n = 4
    corners: dict[Vec, int] = {}
    faces: list[Face] = []
    for axis in range(3):
        for end in (-1, 1):
            side = []
            for j in range(n + 1):
                for i in range(n + 1):
                    p = [0.0, 0.0, 0.0]
                    p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = end * n, (2 * i - n) * end, 2 * j - n
                    side.append((p[0], p[1], p[2]))
            quads = [tuple(corners.setdefault(side[v], len(corners)) for v in f) for f in grid_quads(n + 1, n + 1)]
            faces += _cut(quads, random)
    return Mesh([normalized(_shaken(p, 0.45, random)) for p in corners], faces)


def _shaken(p: Vec, amount: float, random: Random) -> Vec:
    x, y, z = (x + random.uniform(-amount, amount) for x in p)
    return (x, y, z)


def _cap(random: Random) -> Mesh:
    """A part of the sphere above a square."""
    nu, nv = 7, 6
    points = []
    for j in range(nv + 1):
        for i in range(nu + 1):
            x = 1.5 * (i + random.uniform(-0.3, 0.3) * (0 < i < nu)) / nu - 0.75
            y = 1.5 * (j + random.uniform(-0.3, 0.3) * (0 < j < nv)) / nv - 0.75
            points.append(add(normalized((x, y, 0.8)), (0.0, 0.0, -0.8)))
    return Mesh(points, list(_cut(grid_quads(nu + 1, nv + 1), random)))


def _cylinder(random: Random) -> Mesh:
    """Parallels and rulings."""
    nu, nv = 11, 4

    def uneven(n: int, amount: float) -> list[float]:
        steps = [1 + random.uniform(-amount, amount) for _ in range(n)]
        return [sum(steps[:i]) / sum(steps) for i in range(n + 1)]

    u, v = uneven(nu, 0.45), uneven(nv, 0.5)
    points = [(0.7 * cos(2 * pi * s), 0.7 * sin(2 * pi * s), 1.8 * t - 0.9) for t in v for s in u[:nu]]
    return Mesh(points, list(_cut(grid_quads(nu, nv + 1, "columns"), random)))


def chamfered_pin() -> Mesh:
    """A prism of twelve sides with flat ends."""
    n, profile = 12, [(0.75, 0.0), (1.0, 0.3), (1.0, 2.7), (0.75, 3.0)]
    points = [(r * cos(2 * pi * i / n), r * sin(2 * pi * i / n), z) for r, z in profile for i in range(n)]
    ends = [tuple(range(n - 1, -1, -1)), tuple(range(len(points) - n, len(points)))]
    return Mesh(points, [*grid_quads(n, len(profile), "columns"), *ends])


# --- of noisy normals ---


def noisy_torus(noise: float, reversed_vertex: int | None = None, uneven: float = 0.0) -> Mesh:
    """Its normals are turned by so many degrees of noise. Quads, or triangles if the points are uneven."""
    rows, columns = 32, 16
    random, layout = Random(1), Random(2)
    points, normals = [], []
    for i in range(rows * columns):
        u, v = (2 * pi * (j + layout.uniform(-uneven, uneven)) / n for j, n in ((i // columns, rows), (i % columns, columns)))
        n = (cos(u) * cos(v), sin(u) * cos(v), sin(v))
        points.append(((2 + 0.8 * cos(v)) * cos(u), (2 + 0.8 * cos(v)) * sin(u), 0.8 * sin(v)))
        x, y, z = (x + tan(radians(noise)) * random.gauss(0, sqrt(0.5)) for x in n)
        normals.append(scaled(normalized((x, y, z)), -1 if i == reversed_vertex else 1))
    quads = [(a, d, c, b) for a, b, c, d in grid_quads(columns, rows, "columns rows")]
    return Mesh(points, list(_cut(quads, layout)) if uneven else quads, normals)


MESHES: dict[str, Callable[[], Mesh]] = {
    "closed_quads": partial(four_cubes, False, False), "closed_triangles": partial(four_cubes, False, True),
    "bordered_quads": partial(four_cubes, True, False), "bordered_triangles": partial(four_cubes, True, True),
    "uneven_torus": uneven_torus, "uneven_vase": uneven_vase,
    "sphere": lambda: points_alone()["sphere"], "cap": lambda: points_alone()["cap"],
    "cylinder": lambda: points_alone()["cylinder"], "chamfered_pin": chamfered_pin,
    "torus_exact": partial(noisy_torus, 0), "torus_noise_2": partial(noisy_torus, 2),
    "torus_noise_5": partial(noisy_torus, 5), "torus_reversed": partial(noisy_torus, 0, 2 + 26 * 16),
    "torus_triangles": partial(noisy_torus, 5, None, 0.35)}
