# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Control meshes for the tests, and formulas that take nothing from the package."""

import numpy as np

CUBE = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], float)
QUADS = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
OCTAHEDRON = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
TRIANGLES = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
CUBE_EDGES = np.unique(np.sort(np.stack([QUADS, np.roll(QUADS, -1, 1)], -1).reshape(-1, 2)), axis=0)


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def grid(points):
    """Of an array (k, l, 3): points and quads."""
    number = np.arange(points.shape[0] * points.shape[1]).reshape(points.shape[:2])
    quads = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], -1)
    return points.reshape(-1, 3), quads.reshape(-1, 4)


def plane(k=4):
    return grid(np.stack(np.meshgrid(np.arange(k, dtype=float), np.arange(k, dtype=float), [0.0], indexing="ij"), -1)[:, :, 0])


def torus(k, m, large=3.0, small=1.0):
    """Points, quads and normals."""
    u, v = np.meshgrid(*(2 * np.pi * np.arange(n) / n for n in (k, m)), indexing="ij")
    normals = np.stack([np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)], -1)
    points = small * normals + large * np.stack([np.cos(u), np.sin(u), 0 * u], -1)
    number = np.arange(k * m).reshape(k, m)
    quads = np.stack([number, np.roll(number, -1, 0), np.roll(np.roll(number, -1, 0), -1, 1), np.roll(number, -1, 1)], -1)
    return points.reshape(-1, 3), quads.reshape(-1, 4), normals.reshape(-1, 3)


def distance_from_torus(points, large=3.0, small=1.0):
    return np.abs(np.hypot(np.hypot(points[:, 0], points[:, 1]) - large, points[:, 2]) - small)


def prism(sides=8, height=2.0):
    """A cylinder of radius 1 with flat ends: points, a list of polygons, and the edges between sides and ends."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([np.cos(angle), np.sin(angle)], 1)
    points = np.concatenate([np.insert(ring, 2, z, axis=1) for z in (0.0, height)])
    side = [[i, (i + 1) % sides, sides + (i + 1) % sides, sides + i] for i in range(sides)]
    rims = [[b + i, b + (i + 1) % sides] for b in (0, sides) for i in range(sides)]
    return points, side + [list(range(sides))[::-1], list(range(sides, 2 * sides))], np.array(rims)


def open_cylinder(sides=8, rows=3):
    points, polygons, _ = prism(sides)
    u = 2 * np.pi * np.arange(sides) / sides
    points = np.concatenate([np.stack([np.cos(u), np.sin(u), np.full(sides, float(z))], 1) for z in range(rows)])
    return points, np.array([[r * sides + i, r * sides + (i + 1) % sides, (r + 1) * sides + (i + 1) % sides, (r + 1) * sides + i]
                             for r in range(rows - 1) for i in range(sides)])


def radius(points):
    """The distance from the axis of a prism."""
    return np.hypot(points[:, 0], points[:, 1])


def neighbors(faces, n):
    """Of each vertex of a closed mesh: its faces and the ends of its edges."""
    around = [(set(), set()) for _ in range(n)]
    for f, face in enumerate(faces):
        for i, v in enumerate(face):
            around[v][0].add(f)
            around[v][1].update((face[i - 1], face[(i + 1) % len(face)]))
    return around


def catmull_clark(points, quads):
    """One round by the rules of Catmull and Clark on a closed mesh: the points in any order."""
    centers = points[quads].mean(1)
    moved = []
    for p, (faces, ends) in zip(points, neighbors(quads.tolist(), len(points))):
        n = len(faces)
        middles = np.mean([(p + points[e]) / 2 for e in ends], axis=0)
        moved.append((np.mean(centers[list(faces)], axis=0) + 2 * middles + (n - 3) * p) / n)
    edges = {}
    for f, quad in enumerate(quads.tolist()):
        for i in range(4):
            edges.setdefault(frozenset((quad[i], quad[i - 1])), []).append(f)
    on_edges = [np.mean([*points[list(edge)], *centers[faces]], axis=0) for edge, faces in edges.items()]
    return np.concatenate([moved, on_edges, centers])


def catmull_clark_limit(points, quads):
    """Of the vertices of a closed mesh by the limit mask of Halstead, Kass and DeRose (1993)."""
    result = []
    for v, (faces, ends) in enumerate(neighbors(quads.tolist(), len(points))):
        n = len(faces)
        opposite = [points[q[(q.index(v) + 2) % 4]] for q in (quads[f].tolist() for f in faces)]
        result.append((n * n * points[v] + 4 * sum(points[e] for e in ends) + sum(opposite)) / (n * (n + 5)))
    return np.array(result)


def in_order(points):
    rounded = np.round(points, 10) + 0.0
    return points[np.lexsort(rounded.T)]


def same_bits(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
