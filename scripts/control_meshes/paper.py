# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The control meshes of the figures of Yang's paper, as it describes them; where it does not, one that
shows the same."""

from collections.abc import Callable
from itertools import product
from math import sqrt

from .domain import TWO_PI
from .mesh import Face, Mesh, grid_quads
from .modelling import Cell, boundary_of_cells
from .shapes import NO_NORMAL, wheel_of_shells
from .vector import Vec, add, cos, cross, scaled, sin, with_length

Sample = tuple[Vec, Vec]


def _grid(columns: int, rows: int, sample: Callable[[int, int], Sample], closed: str = "",
          comment: str = "") -> Mesh:
    """A grid of quads, closed as by grid_quads()."""
    samples = [sample(i, j) for j, i in product(range(rows), range(columns))]
    return Mesh([p for p, _ in samples], list(grid_quads(columns, rows, closed)), [n for _, n in samples],
                [comment] if comment else [])


def _around(angle: float) -> Vec:
    return (cos(angle), sin(angle), 0.0)


def cylinder() -> Mesh:
    """Figure 3: uneven quads, whose parallels are not flat and whose rulings are not straight."""
    def sample(i: int, j: int) -> Sample:
        angle = TWO_PI * ((0.0, 0.13, 0.35, 0.5, 0.77)[i] + 0.025 * (j % 2))
        n = with_length(_around(angle))
        return (n[0], n[1], (-1.6, -0.75, 0.45, 1.5)[j] + 0.12 * (i % 2)), n
    return _grid(5, 4, sample, "columns", "cylinder 0 0 0 0 0 1 1")


def tetrahedron() -> Mesh:
    """Figure 4: the regular one, with the normals of the sphere through its vertices."""
    points = [with_length(p) for p in
              ((1.0, 1.0, 1.0), (-1.0, -1.0, 1.0), (-1.0, 1.0, -1.0), (1.0, -1.0, -1.0))]
    return Mesh(points, [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)], list(points),
                ["sphere 0 0 0 1"])


def cross_of_cubes() -> Mesh:
    """Figures 7 and 8: six arms of three cubes each; all but the upper one are open at the end."""
    cells = {(0, 0, 0)}
    for axis, sign, k in product(range(3), (-1, 1), (1, 2, 3)):
        cells.add(tuple(sign * k * (a == axis) for a in range(3)))  # type: ignore[arg-type]

    def place(node: Cell) -> Vec:
        x, y, z = (c - 0.5 for c in node)
        return (x, y, z)

    mesh, origin = boundary_of_cells(cells, place)
    ends = {((-3, 0, 0), (-1, 0, 0)), ((3, 0, 0), (1, 0, 0)), ((0, -3, 0), (0, -1, 0)),
            ((0, 3, 0), (0, 1, 0)), ((0, 0, -3), (0, 0, -1))}
    return Mesh(mesh.points, [f for f, o in zip(mesh.faces, origin) if o not in ends])


def waves() -> Mesh:
    """Figure 10 (a): a flat grid whose columns have two normals in turn."""
    normals = [with_length((-1.0, 0.0, 1.0)), with_length((1.0, 0.0, 1.0))]
    return _flat_grid(14, lambda i, j: normals[i % 2])


def bumps() -> Mesh:
    """Figure 10 (b): a flat grid with four normals, which are repeated row by row."""
    normals = [with_length(n) for n in
               ((-1.0, -1.0, sqrt(2)), (1.0, -1.0, sqrt(2)), (-1.0, 1.0, sqrt(2)),
                (1.0, 1.0, sqrt(2)))]
    return _flat_grid(14, lambda i, j: normals[(14 * j + i) % 4])


def _flat_grid(size: int, normal: Callable[[int, int], Vec]) -> Mesh:
    return _grid(size, size, lambda i, j: ((float(i), float(j), 0.0), normal(i, j)))


SEGMENTS, SIDES, RING_RADIUS, TUBE = 8, 6, 2.0, 0.8


def _ring(normal: Callable[[int, int, Vec], Vec]) -> Mesh:
    """A hexagon turned about the z-axis; normals are handles."""
    def sample(i: int, j: int) -> Sample:
        out, turn = _around(TWO_PI * i / SEGMENTS), TWO_PI * (j + 0.5) / SIDES
        p = scaled(out, RING_RADIUS + TUBE * cos(turn))
        return (p[0], p[1], TUBE * sin(turn)), normal(i, j, out)
    mesh = _grid(SEGMENTS, SIDES, sample, "columns rows")
    mesh.normals_are_handles = True
    return mesh


def ring() -> Mesh:
    """Figure 11 (b): normals away from the axis."""
    return _ring(lambda i, j, out: with_length(out))


def edited_ring() -> Mesh:
    """Figure 11 (c): the same away from the tube's middle, every second segment turned about the
    vertical by 60 degrees to either side."""
    def normal(i: int, j: int, out: Vec) -> Vec:
        turn = TWO_PI * (j + 0.5) / SIDES
        angle = TWO_PI * i / SEGMENTS + (1 if i % 2 else -1) * TWO_PI / 6
        side = scaled(_around(angle), cos(turn))
        return with_length((side[0], side[1], sin(turn)))
    return _ring(normal)


SPOKES = 5
HUB, RIM = (0.45, 0.8, 1.1), (2.3, 2.6, 2.9)


def _wheel(normal: Callable[[Vec, float], Vec]) -> Mesh:
    """Figure 12: hub and rim are two cells wide, and each is divided at the same angles throughout.
    Normals are made of the point and the side of the spoke on which it is: -1, 1, or 0 where it is on none."""
    half_widths, half_heights = (0.22,) * 3 + (0.11,) * 3, (0.4, 0.5, 0.4, 0.28, 0.4, 0.28)
    mesh, nodes = wheel_of_shells(SPOKES, list(zip(HUB + RIM, half_widths, half_heights)), 2)
    mesh.normals = [normal(p, (-1, 1, 0)[i % 3] if shell in (2, 3) else 0) for p, (i, _, shell) in zip(mesh.points, nodes)]
    mesh.normals_are_handles = True
    return mesh


def wheel() -> Mesh:
    """Figure 12 (b): normals (x, y, 0), normalized."""
    return _wheel(lambda p, side: with_length((p[0], p[1], 0.0)))


def wheel_of_tori() -> Mesh:
    """Figure 12 (c): normals away from the circles in the middle of hub and rim, and at the ends of the
    spokes away from the spoke."""
    def normal(p: Vec, side: float) -> Vec:
        radius = sqrt(p[0] * p[0] + p[1] * p[1])
        if side:
            return with_length((-side * p[1] / radius, side * p[0] / radius, 1 if p[2] > 0 else -1))
        inner, middle, outer = HUB if radius < 1.5 else RIM
        across = (radius - middle) / radius
        return with_length((p[0] * across, p[1] * across, p[2]))
    return _wheel(normal)


def bell() -> Mesh:
    """Figure 13 (a): five quads meet in the top vertex, which has no normal; all other normals are
    horizontal."""
    around = 10
    profile = ((0.8, 2.6), (1.0, 1.5), (0.7, 0.7), (1.3, 0.1), (2.0, 0.0))
    points, normals = [(0.0, 0.0, 3.0)], [NO_NORMAL]
    for (radius, height), i in product(profile, range(around)):
        n = with_length(_around(TWO_PI * i / around))
        points.append((radius * n[0], radius * n[1], height))
        normals.append(n)

    def at(ring: int, i: int) -> int:
        return 1 + around * ring + i % around

    faces: list[Face] = [(0, at(0, i - 1), at(0, i), at(0, i + 1)) for i in range(1, around, 2)]
    faces += [(at(r + 1, i), at(r + 1, i + 1), at(r, i + 1), at(r, i))
              for r, i in product(range(len(profile) - 1), range(around))]
    return Mesh(points, faces, normals, normals_are_handles=True)


def cuboid_with_hole() -> Mesh:
    """Figure 13 (b): three by three cells without the middle one. All normals are
    horizontal: those of the hole point away from the axis, those of the sides away from the side; there
    are none at the corners."""
    def place(node: Cell) -> Vec:
        return (node[0] - 1.5, node[1] - 1.5, 0.9 * (node[2] - 0.5))

    mesh, _ = boundary_of_cells([(i, j, 0) for i, j in product(range(3), range(3))
                                 if (i, j) != (1, 1)], place)

    def normal(p: Vec) -> Vec:
        outside = [abs(c) > 1 for c in p[:2]]
        if all(outside):
            return NO_NORMAL
        if not any(outside):
            return with_length((p[0], p[1], 0.0))
        return with_length((p[0] * outside[0], p[1] * outside[1], 0.0))

    mesh.normals = [normal(p) for p in mesh.points]
    mesh.normals_are_handles = True
    return mesh


def cyclide() -> Mesh:
    """Figure 13 (c): 6 x 6 points of a Dupin cyclide with a = 5, b = 4.8, c = 1.4, d = 2.5."""
    a, b, c, d = 5.0, 4.8, 1.4, 2.5

    def sample(i: int, j: int) -> Sample:
        s, t = TWO_PI * i / 6, TWO_PI * j / 6
        cs, ss, ct, st = cos(s), sin(s), cos(t), sin(t)
        w = a - c * cs * ct
        p = ((d * (c - a * cs * ct) + b * b * cs) / w, b * ss * (a - d * ct) / w,
             b * st * (c * cs - d) / w)
        # the derivatives of p w less p times those of w
        by_s = add((d * a * ss * ct - b * b * ss, b * cs * (a - d * ct), -b * st * c * ss),
                   scaled(p, -c * ss * ct))
        by_t = add((d * a * cs * st, b * ss * d * st, b * ct * (c * cs - d)),
                   scaled(p, -c * cs * st))
        return p, with_length(cross(by_s, by_t))

    return _grid(6, 6, sample, "columns rows", f"Dupin cyclide {a!r} {b!r} {c!r} {d!r}")


def torus(n: int) -> Mesh:
    """Figure 17: n x n points of a torus, among them those of the largest circle."""
    def sample(i: int, j: int) -> Sample:
        out, turn = _around(TWO_PI * i / n), TWO_PI * j / n
        normal = with_length((out[0] * cos(turn), out[1] * cos(turn), sin(turn)))
        return add(scaled(out, 2.0), normal), normal
    return _grid(n, n, sample, "columns rows", "torus 0 0 0 0 0 1 2.0 1.0")
