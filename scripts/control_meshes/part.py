# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Control meshes of mechanical parts: every face belongs to a plane, cylinder or sphere, which also
gives the normals at its corners."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from decimal import Decimal

from .mesh import Face, Mesh
from .vector import Vec, add, cos_sin, dot, mean, scaled, sub, with_length

PI = Decimal("3.14159265358979323846264338327950288419716939937511")


@dataclass(frozen=True)
class Surface(ABC):
    """What a group of faces is a part of, named as in the files."""

    name: str

    @abstractmethod
    def normal(self, p: Vec) -> Vec:
        """The unit normal at p, away from the material."""

    @abstractmethod
    def shape(self) -> str:
        """Kind and numbers, as `--verify` takes them where it knows the kind."""


@dataclass(frozen=True)
class Plane(Surface):
    point: Vec
    direction: Vec

    def normal(self, p: Vec) -> Vec:
        return self.direction

    def shape(self) -> str:
        return "plane:" + _numbers(*self.point, *self.direction)


@dataclass(frozen=True)
class Cylinder(Surface):
    """With `sign` -1 the material is outside: a hole or a fillet."""

    point: Vec
    direction: Vec  # unit
    radius: float
    sign: int = 1

    def normal(self, p: Vec) -> Vec:
        across = sub(p, self.point)
        across = sub(across, scaled(self.direction, dot(across, self.direction)))
        return with_length(scaled(across, self.sign))

    def shape(self) -> str:
        return "cylinder:" + _numbers(*self.point, *self.direction, self.radius)


@dataclass(frozen=True)
class Ball(Surface):
    center: Vec
    radius: float
    sign: int = 1

    def normal(self, p: Vec) -> Vec:
        return with_length(scaled(sub(p, self.center), self.sign))

    def shape(self) -> str:
        return "sphere:" + _numbers(*self.center, self.radius)


def _numbers(*values: float) -> str:
    return ",".join(f"{x + 0.0:.17g}" for x in values)


@dataclass
class Part(Mesh):
    """A mesh with a surface per face. Edges between different surfaces are its creases, also where
    the surfaces are tangent."""

    surfaces: list[Surface] = field(default_factory=list)
    index: dict[Vec, int] = field(default_factory=dict)

    @staticmethod
    def empty() -> "Part":
        return Part([], [])

    def vertex(self, p: Vec) -> int:
        if p not in self.index:
            self.index[p] = len(self.points)
            self.points.append(p)
        return self.index[p]

    def face(self, surface: Surface, corners: Sequence[Vec]) -> None:
        """Adds a face; its corners are turned so that it looks along the surface's normal."""
        f: Face = tuple(self.vertex(p) for p in corners)
        if dot(self.face_normal(f), surface.normal(mean(list(corners)))) < 0:
            f = f[::-1]
        self.faces.append(f)
        self.surfaces.append(surface)

    def strip(self, surfaces: Surface | Sequence[Surface], first: Sequence[Vec],
              second: Sequence[Vec], closed: bool = False) -> None:
        """Quads between two polygons, one for each pair of sides; a surface for all or for each."""
        ends = list(zip(first, second))
        sides = list(zip(ends, ends[1:] + ends[:1])) if closed else list(zip(ends, ends[1:]))
        each = [surfaces] * len(sides) if isinstance(surfaces, Surface) else surfaces
        for surface, ((a, b), (c, d)) in zip(each, sides, strict=True):
            self.face(surface, (a, c, d, b))

    def tube(self, surface: Surface, rings: Sequence[Sequence[Vec]]) -> None:
        """Closed strips from each ring to the next."""
        for lower, upper in zip(rings, rings[1:]):
            self.strip(surface, lower, upper, closed=True)

    def creases(self) -> list[tuple[int, int]]:
        surface_of = {h: s for f, s in zip(self.faces, self.surfaces)
                      for h in zip(f, f[1:] + f[:1])}
        return sorted((a, b) for (a, b), s in surface_of.items()
                      if a < b and s != surface_of.get((b, a), s))

    def corner_normals(self) -> list[list[Vec]]:
        return [[s.normal(self.points[v]) for v in f] for f, s in zip(self.faces, self.surfaces)]


def turn(part: int | float, whole: int) -> Decimal:
    """The angle of `part` of `whole` equal parts of a turn."""
    return 2 * PI * Decimal(part) / whole


def at(center: Vec, radius: float, angle: Decimal) -> Vec:
    """A point of a horizontal circle, each coordinate correctly rounded."""
    c, s = (round(x, 40) for x in cos_sin(angle))
    return (float(Decimal(center[0]) + Decimal(radius) * c),
            float(Decimal(center[1]) + Decimal(radius) * s), center[2])


def circle(center: Vec, radius: float, angles: Iterable[Decimal]) -> list[Vec]:
    return [at(center, radius, a) for a in angles]


def even(count: int) -> list[Decimal]:
    return [turn(k, count) for k in range(count)]


def raised(points: Iterable[Vec], z: float) -> list[Vec]:
    return [(x, y, z) for x, y, _ in points]


def moved(points: Iterable[Vec], by: Vec) -> list[Vec]:
    return [add(p, by) for p in points]
