# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""A coarse head of pure quads, open at the neck."""

from math import sqrt

from .mesh import Mesh
from .modelling import DOWN, FRONT, LEFT, RIGHT, Block, Cell
from .vector import Vec

# Where the block is cut: columns across the face, layers from face to nape, rows up to the crown.
COLUMNS = (-1.0, -0.78, -0.26, 0.0, 0.26, 0.78, 1.0)
LAYERS = (-1.0, -0.5, 0.0, 0.5, 1.0)
ROWS = (-1.0, -0.78, -0.52, -0.3, 0.02, 0.28, 0.62, 1.0)


def head() -> Mesh:
    """Looks along -y; symmetric about x = 0."""
    model = Block(6, 4, 7, _place)
    _throat(model)
    _nose(model)
    _mouth(model)
    for side, sign, column in ((LEFT, -1, 1), (RIGHT, 1, 4)):
        _eye(model, sign, column)
        _ear(model, sign, side)
    return _open_at_the_neck(model)


def _place(node: Cell) -> Vec:
    """The block as an ellipsoid with a narrow jaw and a flat face."""
    x, y, z = COLUMNS[node[0]], LAYERS[node[1]], ROWS[node[2]]
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
