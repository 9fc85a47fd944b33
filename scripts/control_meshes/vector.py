# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Vectors as tuples, and correctly rounded functions that do not depend on the machine's libm."""

from decimal import Decimal, getcontext
from functools import cache
from math import sqrt

getcontext().prec = 50

Vec = tuple[float, float, float]


def add(a: Vec, b: Vec) -> Vec:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a: Vec, b: Vec) -> Vec:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(a: Vec, s: float) -> Vec:
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a: Vec, b: Vec) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vec, b: Vec) -> Vec:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a: Vec) -> float:
    return sqrt(dot(a, a))


def mean(points: list[Vec]) -> Vec:
    total = (0.0, 0.0, 0.0)
    for p in points:
        total = add(total, p)
    return scaled(total, 1 / len(points))


def lerp(a: float, b: float, t: float) -> float:
    return a + (b - a) * t


def with_length(a: Vec, wanted: float = 1.0) -> Vec:
    """The vector of this direction and length, each coordinate correctly rounded."""
    exact = [Decimal(x) for x in a]
    norm = (exact[0] ** 2 + exact[1] ** 2 + exact[2] ** 2).sqrt()
    x, y, z = (float(Decimal(wanted) * c / norm) for c in exact)
    return (x, y, z)


@cache
def cos_sin(angle: float) -> tuple[Decimal, Decimal]:
    """Cosine and sine to 40 digits, from their power series."""
    x = Decimal(angle)
    sums = [Decimal(0), Decimal(0)]
    term, k = Decimal(1), 0
    while abs(term) > Decimal("1e-45") or k < 2:
        sums[k % 2] += term if k % 4 < 2 else -term
        k += 1
        term = term * x / k
    return sums[0], sums[1]


def cos(angle: float) -> float:
    return float(cos_sin(angle)[0])


def sin(angle: float) -> float:
    return float(cos_sin(angle)[1])


def exp(x: float) -> float:
    return float(Decimal(x).exp())
