# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Two coarse models of pure quads, as a modeller would box them: a creature and a spoon."""

from .mesh import Mesh
from .modelling import BACK, DOWN, FRONT, LEFT, RIGHT, UP, Block, Cell, Model, X, Y, Z
from .star import Star
from .vector import Vec, add, cos, lerp, sin


def creature() -> Mesh:
    """Stands on z = 0 and looks along -y; symmetric about x = 0."""
    widths, depths = (0.62, 1.0, 0.98, 0.72), (0.5, 0.72, 0.66, 0.45)
    heights = (0.9, 1.35, 2.0, 2.6)

    def place(node: Cell) -> Vec:
        x, y, z = node
        belly = -0.12 if z == 1 and y == 0 else 0.0
        return ((-1, -0.38, 0.38, 1)[x] * widths[z], (y - 1) * depths[z] + belly, heights[z])

    model = Block(3, 2, 3, place)
    for side, sign, column in ((LEFT, -1, 0), (RIGHT, 1, 2)):
        _leg(model, sign, model.side(DOWN, lambda c, column=column: c[0] == column))
        _arm(model, side, sign, model.side(side, lambda c: c[2] == 2))
    _tail(model, model.side(BACK, lambda c: c[0] == 1 and c[2] == 0))
    _head(model)
    return model.mesh


def _leg(model: Model, sign: int, sole: list[int]) -> None:
    model.move(sole, (sign * 0.08, 0.0, 0.0), (1.3, 0.9, 1.0))
    model.extrude(sole, (sign * 0.04, 0.0, -0.4), (0.95, 0.9, 1.0))
    walls = model.extrude(sole, (0.0, 0.0, -0.45), (1.15, 1.0, 1.0))
    toes = [model.facing(FRONT, walls)]
    model.extrude(toes, (sign * 0.06, -0.42, -0.04), (1.25, 1.0, 0.75))


def _arm(model: Model, side: Cell, sign: int, palm: list[int]) -> None:
    model.move(palm, (0.0, 0.0, 0.02), (1.0, 0.8, 0.8))
    for out, down, grow in ((0.3, -0.1, 0.8), (0.45, -0.28, 0.9), (0.38, -0.3, 0.95)):
        model.extrude(palm, (sign * out, -0.03, down), (1.0, grow, grow))
        model.turn(palm, Z, X, sign * 0.2)
    model.extrude(palm, (sign * 0.12, -0.02, -0.1), (1.0, 1.45, 1.3))
    walls = model.extrude(palm, (sign * 0.3, -0.04, -0.25), (1.0, 0.95, 0.9))
    thumb = [model.facing(FRONT, walls)]
    model.extrude(thumb, (0.0, -0.2, 0.08), (0.6, 1.0, 0.6))
    model.extrude(palm, (sign * 0.12, 0.0, -0.1), (0.6, 0.6, 0.6))


def _tail(model: Model, tip: list[int]) -> None:
    steps = ((0.2, -0.03, 0.75), (0.35, 0.02, 0.85), (0.3, 0.16, 0.9), (0.2, 0.26, 0.85),
             (0.04, 0.2, 0.6))
    for back, up, grow in steps:
        model.extrude(tip, (0.0, back, up), (grow, grow, grow))
        model.turn(tip, Y, Z, 0.35)


def _head(model: Block) -> None:
    top = model.side(UP)
    model.extrude(top, (0.0, 0.0, 0.2), (0.72, 0.8, 1.0))
    model.extrude(top, (0.0, -0.03, 0.18), (1.75, 1.9, 1.0))
    snout_walls = model.extrude(top, (0.0, -0.05, 0.5), (1.15, 1.12, 1.0))
    model.extrude(top, (0.0, 0.0, 0.5), (0.97, 0.95, 1.0))
    model.extrude(top, (0.0, 0.02, 0.35), (0.72, 0.7, 1.0))
    middle = [i for i in snout_walls if abs(model.centre([i])[0]) < 0.1]
    snout = [model.facing(FRONT, middle)]
    model.extrude(snout, (0.0, -0.22, -0.04), (0.75, 1.0, 0.7))
    model.extrude(snout, (0.0, -0.12, 0.0), (0.7, 1.0, 0.7))
    for sign in (-1, 1):
        ear = [i for i in top if sign * model.centre([i])[0] > 0.2]
        model.extrude(ear, (sign * 0.12, 0.04, 0.28), (1.05, 0.75, 1.0))
        model.extrude(ear, (sign * 0.16, 0.02, 0.4), (1.1, 0.85, 1.0))
        model.extrude(ear, (sign * 0.1, 0.0, 0.3), (0.45, 0.5, 1.0))


def spoon() -> Mesh:
    """The bowl lies at the origin, the handle runs along +x. In the middle of the bowl, above and
    below, six edges meet."""
    star = Star(6, 2)
    above: list[Vec] = []
    for place in star.places:
        ring, angle = star.circular(place)
        x, y = ring / 2 * cos(angle), ring / 2 * sin(angle)
        above.append((1.25 * x, 0.85 * y, -0.55 * (1 - x * x - y * y)))
    points = above + [add(p, (0.0, 0.0, -0.14)) for p in above]
    count, faces, rim = len(above), star.faces(), star.rim()
    faces += [tuple(count + v for v in reversed(f)) for f in faces]
    first_wall = len(faces)
    faces += [(a, count + a, count + b, b) for a, b in zip(rim, rim[1:] + rim[:1])]
    model = Model(Mesh(points, faces))
    end = [first_wall, len(faces) - 1]
    steps = ((0.35, 0.1, 0.5), (0.45, 0.12, 0.65), (0.6, 0.08, 0.95), (0.6, 0.0, 1.1),
             (0.6, -0.08, 1.25), (0.4, -0.1, 1.3), (0.25, -0.05, 0.75))
    for along, up, grow in steps:
        model.extrude(end, (along, 0.0, up), (1.0, grow, lerp(1.0, grow, 0.3)))
    return model.mesh
