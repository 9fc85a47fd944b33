# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Mechanical parts of planes, cylinders and spheres, coarse, with creases between them."""

from decimal import Decimal

from .part import Ball, Cylinder, Part, Plane, at, circle, even, moved, raised, turn
from .vector import Vec

ORIGIN: Vec = (0.0, 0.0, 0.0)
UP: Vec = (0.0, 0.0, 1.0)
DOWN: Vec = (0.0, 0.0, -1.0)
UNEVEN = [turn(k, 100) for k in (0, 11, 29, 40, 55, 72, 84)]


def capped_cylinder() -> Part:
    part = Part.empty()
    rim = circle(ORIGIN, 1.0, UNEVEN)
    part.tube(Cylinder("side", ORIGIN, UP, 1.0), [rim, raised(rim, 0.8), raised(rim, 2.0)])
    part.face(Plane("bottom", ORIGIN, DOWN), rim)
    part.face(Plane("top", (0.0, 0.0, 2.0), UP), raised(rim, 2.0))
    return part


def _parallel(center: Vec, radius: float, degrees: float, angles: list[Decimal]) -> list[Vec]:
    """The circle of a sphere at this latitude."""
    r, z, _ = at((0.0, center[2], 0.0), radius, turn(degrees, 360))
    return circle((center[0], center[1], z), r, angles)


def _dome(part: Part, ball: Ball, latitudes: list[float], angles: list[Decimal]) -> list[Vec]:
    """A sphere from its first latitude to its last, which a polygon closes; returns the rim."""
    rings = [_parallel(ball.center, ball.radius, d, angles) for d in latitudes]
    part.tube(ball, rings)
    part.face(ball, rings[-1])
    return rings[0]


def half_ball() -> Part:
    part = Part.empty()
    rim = _dome(part, Ball("dome", ORIGIN, 1.5), [0.0, 32.0, 64.0], UNEVEN)
    part.face(Plane("base", ORIGIN, DOWN), rim)
    return part


def lens() -> Part:
    """Two caps of 30 degrees and 60 degrees that meet in a circle."""
    part = Part.empty()
    angles = even(8)
    rim = circle(ORIGIN, 1.0, angles)
    for name, slope, end in (("front", 60.0, 1), ("back", 30.0, -1)):
        c, s, _ = at(ORIGIN, 1.0, turn(slope, 360))
        ball = Ball(name, (0.0, 0.0, -end * s / c), 1 / c)
        upper = [_parallel(ball.center, ball.radius, end * (slope + (90 - slope) * share), angles)
                 for share in (0.45, 0.75)]
        part.tube(ball, [rim, *upper])
        part.face(ball, upper[-1])
    return part


def washer() -> Part:
    part = Part.empty()
    inner, outer = circle(ORIGIN, 1.0, even(8)), circle(ORIGIN, 2.0, even(8))
    height = 0.4
    top = (0.0, 0.0, height)
    part.strip(Plane("bottom", ORIGIN, DOWN), inner, outer, closed=True)
    part.strip(Plane("top", top, UP), raised(inner, height), raised(outer, height), closed=True)
    part.strip(Cylinder("outside", ORIGIN, UP, 2.0), outer, raised(outer, height), closed=True)
    part.strip(Cylinder("hole", ORIGIN, UP, 1.0, -1), inner, raised(inner, height), closed=True)
    return part


def _square(center: Vec, half: float, steps: int) -> list[Vec]:
    """The boundary of a square from the middle of its right side on, `steps` points to half a side."""
    up = [(half, half * k / steps) for k in range(steps)]
    over = [(half * k / steps, half) for k in range(steps, -steps, -1)]
    down = [(-half, half * k / steps) for k in range(steps, -steps, -1)]
    back = [(half * k / steps, -half) for k in range(-steps, steps)]
    right = [(half, half * k / steps) for k in range(-steps, 0)]
    return [(center[0] + x, center[1] + y, center[2]) for x, y in up + over + down + back + right]


class Plate:
    """A flat plate of square cells between z = 0 and a height, each with a round hole or boss."""

    def __init__(self, part: Part, height: float) -> None:
        self.part, self.height = part, height
        self.below = Plane("bottom", ORIGIN, DOWN)
        self.above = Plane("top", (0.0, 0.0, height), UP)
        self.outline: dict[tuple[Vec, Vec], None] = {}

    def cell(self, center: Vec, half: float, steps: int, below: float, above: float) -> None:
        """A cell with circles of these radii in its two sides."""
        square = _square(center, half, steps)
        angles = even(len(square))
        self.part.strip(self.below, circle(center, below, angles), square, closed=True)
        self.part.strip(self.above, circle((*center[:2], self.height), above, angles),
                        raised(square, self.height), closed=True)
        for a, b in zip(square, square[1:] + square[:1]):
            if (b, a) in self.outline:
                del self.outline[b, a]
            else:
                self.outline[a, b] = None

    def hole(self, name: str, center: Vec, half: float, steps: int, radius: float) -> None:
        self.cell(center, half, steps, radius, radius)
        rim = circle(center, radius, even(8 * steps))
        self.part.strip(Cylinder(name, center, UP, radius, -1), rim, raised(rim, self.height),
                        closed=True)

    def walls(self) -> None:
        """The sides of the whole plate."""
        for a, b in self.outline:
            out = (float(b[1] > a[1]) - float(b[1] < a[1]), float(b[0] < a[0]) - float(b[0] > a[0]),
                   0.0)
            name = {(1, 0): "right", (-1, 0): "left", (0, 1): "back", (0, -1): "front"}[
                int(out[0]), int(out[1])]
            level = (max(abs(a[0]), abs(b[0])) * out[0], max(abs(a[1]), abs(b[1])) * out[1], 0.0)
            self.part.strip(Plane(name, level, out), [a, b], raised([a, b], self.height))


def plate_with_holes() -> Part:
    part = Part.empty()
    plate = Plate(part, 0.6)
    plate.hole("left_hole", (-2.0, 0.0, 0.0), 2.0, 1, 0.8)
    plate.hole("right_hole", (2.0, 0.0, 0.0), 2.0, 1, 1.0)
    plate.walls()
    return part


def bearing_housing() -> Part:
    """A plate with four bolt holes, a boss with a bore, and a spherical seat in the boss."""
    part = Part.empty()
    plate = Plate(part, 1.0)
    for x, y in ((4.5, 1.5), (-4.5, 1.5), (-4.5, -1.5), (4.5, -1.5)):
        name = ("left" if x < 0 else "right") + ("_front" if y < 0 else "_back") + "_hole"
        plate.hole(name, (x, y, 0.0), 1.5, 1, 0.7)
    plate.cell(ORIGIN, 3.0, 2, 1.0, 1.9)
    plate.walls()
    angles = even(16)
    boss = circle(ORIGIN, 1.9, angles)
    part.tube(Cylinder("boss", ORIGIN, UP, 1.9), [raised(boss, z) for z in (1.0, 2.5, 4.0)])
    center = (0.0, 0.0, 4.0)
    seat = Ball("seat", center, 1.5, -1)
    mouth = circle(center, 1.5, angles)
    part.strip(Plane("rim", center, UP), mouth, raised(boss, 4.0), closed=True)
    depth = float((Decimal("1.25")).sqrt())
    bore = circle((0.0, 0.0, 4.0 - depth), 1.0, angles)
    part.tube(seat, [mouth, _parallel(center, 1.5, -25.0, angles), bore])
    part.tube(Cylinder("bore", ORIGIN, UP, 1.0, -1), [bore, raised(bore, 1.4), raised(bore, 0.0)])
    return part


def d_section() -> Part:
    """A shaft with a flat, as motors have them."""
    part = Part.empty()
    arc = circle(ORIGIN, 1.0, [turn(d, 360) for d in (-130, -85, -30, 20, 85, 130)])
    outline = [*arc, (arc[0][0], 0.0, 0.0)]
    side = Cylinder("shaft", ORIGIN, UP, 1.0)
    flat = Plane("flat", outline[-1], (-1.0, 0.0, 0.0))
    heights = (0.0, 1.0, 2.5)
    for low, high in zip(heights, heights[1:]):
        part.strip([side] * 5 + [flat] * 2, raised(outline, low), raised(outline, high), closed=True)
    part.face(Plane("bottom", ORIGIN, DOWN), outline)
    part.face(Plane("top", (0.0, 0.0, 2.5), UP), raised(outline, 2.5))
    return part


def bolt() -> Part:
    """A hexagonal head, a shank and a round end."""
    part = Part.empty()
    corners = circle(ORIGIN, 1.5, even(6))
    middles = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, 0.0)
               for a, b in zip(corners, corners[1:] + corners[:1])]
    hexagon = [p for pair in zip(corners, middles) for p in pair]
    walls = [Plane(f"side_{k}", middles[k], at(ORIGIN, 1.0, turn(2 * k + 1, 12)))
             for k in range(6) for _ in range(2)]
    part.strip(walls, hexagon, raised(hexagon, 1.0), closed=True)
    part.face(Plane("head", ORIGIN, DOWN), hexagon)
    shank = circle(ORIGIN, 0.75, even(12))
    part.strip(Plane("seat", (0.0, 0.0, 1.0), UP), raised(shank, 1.0), raised(hexagon, 1.0),
               closed=True)
    part.tube(Cylinder("shank", ORIGIN, UP, 0.75), [raised(shank, z) for z in (1.0, 2.2, 3.6)])
    end = Ball("end", (0.0, 0.0, 3.6), 0.75)
    rings = [_parallel(end.center, 0.75, d, even(12)) for d in (30.0, 60.0)]
    part.tube(end, [raised(shank, 3.6), *rings])
    part.face(end, rings[-1])
    return part


def bracket() -> Part:
    """An angle of constant thickness with a fillet inside and a rounded edge outside; the planes
    are tangent to the cylinders."""
    part = Part.empty()
    quarter = [turn(d, 360) for d in (270, 240, 210, 180)]
    along = (0.0, 1.0, 0.0)

    def arc(x: float, z: float, radius: float) -> list[Vec]:
        return [(px, 0.0, pz) for px, pz, _ in circle((x, z, 0.0), radius, quarter)]

    outer = [(6.0, 0.0, 0.0), (3.5, 0.0, 0.0), *arc(1.0, 1.0, 1.0), (0.0, 0.0, 3.5), (0.0, 0.0, 6.0)]
    inner = [(6.0, 0.0, 1.0), (4.5, 0.0, 1.0), *arc(3.0, 3.0, 2.0), (1.0, 0.0, 4.5), (1.0, 0.0, 6.0)]
    below, behind = Plane("base", ORIGIN, DOWN), Plane("back", ORIGIN, (-1.0, 0.0, 0.0))
    edge = Cylinder("edge", (1.0, 0.0, 1.0), along, 1.0)
    floor = Plane("floor", (0.0, 0.0, 1.0), UP)
    wall = Plane("wall", (1.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    fillet = Cylinder("fillet", (3.0, 0.0, 3.0), along, 2.0, -1)
    for start in (0.0, 2.0):
        near, far = (0.0, start, 0.0), (0.0, start + 2.0, 0.0)
        part.strip([below] * 2 + [edge] * 3 + [behind] * 2, moved(outer, near), moved(outer, far))
        part.strip([floor] * 2 + [fillet] * 3 + [wall] * 2, moved(inner, near), moved(inner, far))
        for end, surface in ((0, Plane("foot", (6.0, 0.0, 0.0), (1.0, 0.0, 0.0))),
                             (-1, Plane("head", (0.0, 0.0, 6.0), UP))):
            part.strip(surface, moved([outer[end], inner[end]], near),
                       moved([outer[end], inner[end]], far))
    part.strip(Plane("front", ORIGIN, (0.0, -1.0, 0.0)), outer, inner)
    away = (0.0, 4.0, 0.0)
    part.strip(Plane("rear", away, (0.0, 1.0, 0.0)), moved(outer, away), moved(inner, away))
    return part
