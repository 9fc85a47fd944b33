# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The surfaces that are sampled: what scattering and triangulating must know of each."""

from abc import ABC, abstractmethod
from decimal import Decimal
from random import Random

from .vector import (Vec, add, cos, cos_sin, cross, dot, exp, length, lerp, mean, scaled, sin, sub,
                     with_length)

TWO_PI = 6.283185307179586


class Domain(ABC):
    """A surface with its own coordinates; parameters are triples (the last may be unused)."""

    @abstractmethod
    def sample(self, random: Random, margin: float) -> Vec:
        """A random parameter, about `margin` or more away from the border."""

    @abstractmethod
    def step(self, at: Vec, angle: float, distance: float) -> Vec:
        """Where one gets from `at` in the given direction."""

    def difference(self, a: Vec, b: Vec) -> Vec:
        """b - a, the short way."""
        return sub(b, a)

    @abstractmethod
    def up(self, at: Vec) -> Vec:
        """The outward direction in the space of the parameters."""

    @abstractmethod
    def on_sphere(self, at: Vec) -> Vec:
        """A conformal image on the unit sphere, where the convex hull triangulates."""

    @abstractmethod
    def point_and_normal(self, at: Vec) -> tuple[Vec, Vec]:
        """The point in space with its unit normal."""

    def beyond_border(self) -> list[Vec]:
        """For each border, the point of the unit sphere that it encloses."""
        return []

    def on_border(self, random: Random, spacing: float) -> list[Vec]:
        """Parameters along the borders."""
        return []

    def middle(self, corners: list[Vec]) -> Vec:
        """The centre of a face."""
        return add(corners[0], mean([self.difference(corners[0], c) for c in corners]))

    def distance(self, a: Vec, b: Vec) -> float:
        return length(self.difference(a, b))

    def corner_sine(self, a: Vec, b: Vec, c: Vec) -> float:
        """Sine of the exterior angle at b; positive if the corner is convex."""
        u, v = self.difference(a, b), self.difference(b, c)
        return dot(cross(u, v), self.up(b)) / (length(u) * length(v))


class Sphere(Domain):
    """The sphere about the origin, or the part of it above `lowest` (times the radius)."""

    def __init__(self, radius: float = 1.0, lowest: float = -1.0) -> None:
        self.radius = radius
        self.lowest = lowest

    def sample(self, random: Random, margin: float) -> Vec:
        while True:
            p = (lerp(-1, 1, random.random()), lerp(-1, 1, random.random()),
                 lerp(-1, 1, random.random()))
            if 0.1 < dot(p, p) < 1:
                p = with_length(p)
                if self.lowest == -1 or p[2] > self.lowest + margin:
                    return p

    def step(self, at: Vec, angle: float, distance: float) -> Vec:
        u = with_length(cross(at, (1.0, 0.0, 0.0) if abs(at[0]) < 0.6 else (0.0, 1.0, 0.0)))
        v = cross(at, u)
        return with_length(add(at, add(scaled(u, distance * cos(angle)),
                                       scaled(v, distance * sin(angle)))))

    def up(self, at: Vec) -> Vec:
        return at

    def on_sphere(self, at: Vec) -> Vec:
        return at

    def middle(self, corners: list[Vec]) -> Vec:
        return with_length(mean(corners))

    def point_and_normal(self, at: Vec) -> tuple[Vec, Vec]:
        return with_length(at, self.radius), with_length(at)


class Flat(Domain):
    """What tube and patch share: parameters (u, v, 0)."""

    def step(self, at: Vec, angle: float, distance: float) -> Vec:
        return add(at, (distance * cos(angle), distance * sin(angle), 0.0))

    def up(self, at: Vec) -> Vec:
        return (0.0, 0.0, 1.0)


class Tube(Flat):
    """The cylinder about the z-axis, open at both ends; u is the angle, v = z / radius."""

    def __init__(self, radius: float, half_length: float) -> None:
        self.radius = radius
        self.half_length = half_length

    def sample(self, random: Random, margin: float) -> Vec:
        v = (self.half_length - margin) * lerp(-1, 1, random.random())
        return (TWO_PI * random.random(), v, 0.0)

    def difference(self, a: Vec, b: Vec) -> Vec:
        u, v, _ = sub(b, a)
        while u > TWO_PI / 2:
            u -= TWO_PI
        while u < -TWO_PI / 2:
            u += TWO_PI
        return (u, v, 0.0)

    def on_sphere(self, at: Vec) -> Vec:
        """Mercator's map, backwards."""
        up = exp(at[1])
        sech, tanh = 2 / (up + 1 / up), (up - 1 / up) / (up + 1 / up)
        return (cos(at[0]) * sech, sin(at[0]) * sech, tanh)

    def beyond_border(self) -> list[Vec]:
        return [(0.0, 0.0, -1.0), (0.0, 0.0, 1.0)]

    def on_border(self, random: Random, spacing: float) -> list[Vec]:
        count = int(TWO_PI / spacing)
        return [((i + lerp(-0.25, 0.25, random.random())) * TWO_PI / count, v, 0.0)
                for v in (-self.half_length, self.half_length) for i in range(count)]

    def point_and_normal(self, at: Vec) -> tuple[Vec, Vec]:
        c, s = cos_sin(at[0])
        r = Decimal(self.radius)
        return (float(r * c), float(r * s), self.radius * at[1]), (float(c), float(s), 0.0)


class Saddle(Flat):
    """A disc-shaped patch of z = (x^2 - y^2 / 2) / 4."""

    def __init__(self, radius: float) -> None:
        self.radius = radius

    def sample(self, random: Random, margin: float) -> Vec:
        while True:
            x, y = lerp(-1, 1, random.random()), lerp(-1, 1, random.random())
            if x * x + y * y < 1:
                return ((self.radius - margin) * x, (self.radius - margin) * y, 0.0)

    def on_sphere(self, at: Vec) -> Vec:
        """Stereographic projection from the south pole, backwards."""
        x, y, square = at[0], at[1], at[0] * at[0] + at[1] * at[1]
        return (2 * x / (square + 1), 2 * y / (square + 1), (1 - square) / (square + 1))

    def beyond_border(self) -> list[Vec]:
        return [(0.0, 0.0, -1.0)]

    def on_border(self, random: Random, spacing: float) -> list[Vec]:
        count = int(TWO_PI * self.radius / spacing)
        angles = [(i + lerp(-0.25, 0.25, random.random())) * TWO_PI / count for i in range(count)]
        return [(self.radius * cos(a), self.radius * sin(a), 0.0) for a in angles]

    def point_and_normal(self, at: Vec) -> tuple[Vec, Vec]:
        x, y, _ = at
        return (x, y, (x * x - y * y / 2) / 4), with_length((-x / 2, y / 4, 1.0))
