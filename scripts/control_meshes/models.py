# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Three coarse models of pure quads, as a modeller would box them: a creature, a spoon and a head."""

from math import sqrt

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
    _creature_head(model)
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


def _creature_head(model: Block) -> None:
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


# Where the block is cut: columns across the face, layers from face to nape, rows up to the crown.
HEAD_COLUMNS = (-1.0, -0.78, -0.26, 0.0, 0.26, 0.78, 1.0)
HEAD_LAYERS = (-1.0, -0.5, 0.0, 0.5, 1.0)
HEAD_ROWS = (-1.0, -0.78, -0.52, -0.3, 0.02, 0.28, 0.62, 1.0)


def head() -> Mesh:
    """Of pure quads, open at the neck. Looks along -y; symmetric about x = 0."""
    model = Block(6, 4, 7, _head_place)
    _throat(model)
    _nose(model)
    _mouth(model)
    for side, sign, column in ((LEFT, -1, 1), (RIGHT, 1, 4)):
        _eye(model, sign, column)
        _ear(model, sign, side)
    return _open_at_the_neck(model)


def _head_place(node: Cell) -> Vec:
    """The block as an ellipsoid with a narrow jaw and a flat face."""
    x, y, z = HEAD_COLUMNS[node[0]], HEAD_LAYERS[node[1]], HEAD_ROWS[node[2]]
    xx, yy, zz = x * x, y * y, z * z
    across = x * sqrt(1 - yy / 2 - zz / 2 + yy * zz / 3)
    back = y * sqrt(1 - zz / 2 - xx / 2 + zz * xx / 3)
    up = z * sqrt(1 - xx / 2 - yy / 2 + xx * yy / 3)
    low = max(0.0, -up)
    jaw = 1 - 0.3 * low * low
    return (0.76 * across * jaw, back * (0.86 if back < 0 else 1 - 0.35 * low) - 0.08 * low,
            1.12 * up)


def _front(model: Block, columns: tuple[int, ...], rows: tuple[int, ...]) -> list[int]:
    return model.side(FRONT, lambda c: c[0] in columns and c[2] in rows)


def _throat(model: Block) -> None:
    neck = model.side(DOWN, lambda c: c[0] in (1, 2, 3, 4) and c[1] in (1, 2, 3))
    model.move(neck, (0.0, 0.12, 0.08), (1.15, 0.95, 1.0))
    model.extrude(neck, (0.0, 0.06, -0.25), (0.95, 0.95, 0.3))
    model.extrude(neck, (0.0, 0.05, -0.3), (1.1, 1.1, 0.0))


def _nose(model: Block) -> None:
    tip = _front(model, (2, 3), (3,))
    bridge = _front(model, (2, 3), (3, 4))
    model.extrude(bridge, (0.0, -0.06, 0.0), (0.7, 1.0, 0.9))
    model.move(tip, (0.0, -0.1, -0.03), (1.2, 1.0, 1.0))


def _mouth(model: Block) -> None:
    chin = _front(model, (2, 3), (0,))
    model.move(chin, (0.0, -0.07, 0.0), (1.1, 1.0, 1.0))
    lips = _front(model, (2, 3), (1,))
    model.move(lips, (0.0, -0.02, 0.0), (1.5, 1.0, 0.9))
    model.extrude(lips, (0.0, -0.05, 0.0), (0.9, 1.0, 0.7))
    model.extrude(lips, (0.0, 0.07, 0.0), (0.9, 1.0, 0.2))


def _eye(model: Block, sign: int, column: int) -> None:
    brow = _front(model, (column,), (5,))
    model.move(brow, (0.0, -0.03, 0.0))
    socket = _front(model, (column,), (4,))
    model.extrude(socket, (0.0, 0.02, 0.0), (0.8, 1.0, 0.8))
    model.extrude(socket, (0.0, 0.1, 0.0), (0.85, 1.0, 0.8))
    model.extrude(socket, (0.0, -0.05, 0.0), (0.6, 1.0, 0.6))


def _ear(model: Block, sign: int, side: Cell) -> None:
    ear = model.side(side, lambda c: c[1] == 2 and c[2] in (3, 4))
    model.move(ear, (0.0, 0.0, 0.0), (1.0, 0.7, 1.0))
    model.extrude(ear, (sign * 0.06, 0.05, 0.0), (1.0, 0.9, 0.9))
    model.extrude(ear, (sign * 0.12, 0.1, 0.06), (0.5, 1.7, 1.3))
    model.extrude(ear, (0.0, 0.0, 0.0), (1.0, 0.6, 0.7))
    model.extrude(ear, (-sign * 0.05, 0.0, 0.0), (1.0, 0.7, 0.8))


def _open_at_the_neck(model: Block) -> Mesh:
    neck = set(model.side(DOWN, lambda c: c[0] in (1, 2, 3, 4) and c[1] in (1, 2, 3)))
    faces = [f for i, f in enumerate(model.mesh.faces) if i not in neck]
    used = sorted({v for f in faces for v in f})
    number = {v: i for i, v in enumerate(used)}
    points = [model.mesh.points[v] for v in used]
    return Mesh([(round(x, 4), round(y, 4), round(z, 4)) for x, y, z in points],
                [tuple(number[v] for v in f) for f in faces])
