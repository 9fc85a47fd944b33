# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Nets of quads around one vertex, and surfaces sampled with them."""

from collections.abc import Callable
from itertools import product

from .domain import TWO_PI
from .mesh import Face, Mesh
from .vector import Vec, add, cos, cross, scaled, sin, with_length

Place = tuple[int, int, int]
RINGS = 3


class Star:
    """As many sectors of rings x rings quads as the middle vertex, which is the first, has edges.
    The vertex (s, i, j) is i steps along edge s and j steps along edge s + 1 away from it."""

    def __init__(self, valence: int, rings: int) -> None:
        self.valence, self.rings = valence, rings
        self.places: list[Place] = [(0, 0, 0)]
        self.places += [(s, i, j) for s in range(valence) for i in range(1, rings + 1)
                        for j in range(rings + 1)]
        self._index = {place: v for v, place in enumerate(self.places)}

    def vertex(self, s: int, i: int, j: int) -> int:
        if i == 0:
            return self.vertex(s + 1, j, 0) if j else 0
        return self._index[s % self.valence, i, j]

    def faces(self) -> list[Face]:
        at, steps = self.vertex, range(self.rings)
        return [(at(s, i, j), at(s, i + 1, j), at(s, i + 1, j + 1), at(s, i, j + 1))
                for s, i, j in product(range(self.valence), steps, steps)]

    def rim(self) -> list[int]:
        """The vertices of the border, counter-clockwise."""
        last = self.rings
        return [v for s in range(self.valence) for v in
                [self.vertex(s, last, j) for j in range(last + 1)]
                + [self.vertex(s, i, last) for i in range(last - 1, 0, -1)]]

    def circular(self, place: Place) -> tuple[int, float]:
        """The number of the ring and the angle where rings are circles, evenly divided."""
        s, i, j = place
        ring = max(i, j)
        steps = j if i == ring else 2 * ring - i
        return ring, TWO_PI * (s + steps / (2 * ring or 1)) / self.valence


def _sampled(star: Star, step: float, sample: Callable[[float, float], tuple[Vec, Vec]],
             comment: str) -> Mesh:
    samples = []
    for place in star.places:
        ring, angle = star.circular(place)
        samples.append(sample(step * ring * cos(angle + 0.3), step * ring * sin(angle + 0.3)))
    return Mesh([p for p, _ in samples], star.faces(), [n for _, n in samples], [comment])


def saddle(valence: int) -> Mesh:
    """z = 2xy about its saddle point."""
    def sample(x: float, y: float) -> tuple[Vec, Vec]:
        return (x, y, 2 * x * y), with_length((-2 * y, -2 * x, 1.0))
    return _sampled(Star(valence, RINGS), 0.3, sample, "graph z = 2xy")


# Row i, column j: the height of the control point (i, j, height).
BEZIER_HEIGHTS = ((0.0, 0.5, 0.25, -0.25), (0.75, 2.0, 1.5, 0.25),
                  (0.25, 2.25, 1.5, 0.75), (-0.5, 0.5, 1.0, -0.25))


def bezier(valence: int) -> Mesh:
    """A bicubic Bezier patch about its middle."""
    def rows(t: float) -> tuple[list[float], list[float]]:
        s = 1 - t
        return ([s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t],
                [-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t])

    def combined(a: list[float], b: list[float]) -> Vec:
        total = (0.0, 0.0, 0.0)
        for i, heights in enumerate(BEZIER_HEIGHTS):
            for j, z in enumerate(heights):
                total = add(total, scaled((float(i), float(j), z), a[i] * b[j]))
        return total

    def sample(x: float, y: float) -> tuple[Vec, Vec]:
        (u, du), (v, dv) = rows(0.5 + x), rows(0.5 + y)
        return combined(u, v), with_length(cross(combined(du, v), combined(u, dv)))

    heights = " ".join(repr(z) for row in BEZIER_HEIGHTS for z in row)
    return _sampled(Star(valence, RINGS), 0.15, sample,
                    f"bicubic Bezier patch with control points (i, j, z): {heights}")


def cylinder_cap(valence: int) -> Mesh:
    """The middle vertex is above the upper base of a cylinder, with an upright normal; all others
    lie on the cylinder, with its normals."""
    star, radius, height = Star(valence, RINGS), 15.0, 10.0
    points, normals = [(0.0, 0.0, height + 2)], [(0.0, 0.0, 1.0)]
    for place in star.places[1:]:
        ring, angle = star.circular(place)
        c, s = cos(angle + 0.3), sin(angle + 0.3)
        points.append((radius * c, radius * s, height - 5 * (ring - 1)))
        normals.append(with_length((c, s, 0.0)))
    return Mesh(points, star.faces(), normals, ["cap over a cylinder of radius 15 and height 10"])
