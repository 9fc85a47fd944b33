#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The constants of proven enclosures of limit surfaces: prints them; check_sources.py compares those of Cell_enclosure.h.

For a vertex of valence n between regular ones, of Catmull-Clark and Loop subdivision:
gamma, the largest cost of a flow along edges that carries the row of one end of a new edge into that of the other; differences of
points over edges shrink by it. sigma2, the largest half sum of |a_j a_l| d_jl^2 over the rows, with the distances d in the net;
d0, the largest of these. Both rows of a new edge lie in the ring of one vertex, and depend on its valence alone.

Any flow gives a bound; at these valences those found here are the cheapest.
"""

import collections
import math
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADER = ROOT / "include/CGAL/PN_limit_surface_3/internal/limit_surface/Cell_enclosure.h"
VALENCES = range(3, 13)


def quads(n):
    """the rows of a vertex, an edge and a face, and the edges of the ring: 0, neighbors 1..n, diagonal ones n+1..2n"""
    edges = [(0, 1 + i) for i in range(n)]
    edges += [(1 + i, n + 1 + i) for i in range(n)] + [(n + 1 + i, 1 + (i + 1) % n) for i in range(n)]
    vertex = {0: 1 - 7 / (4 * n)}
    for i in range(n):
        vertex[1 + i] = 3 / (2 * n * n)
        vertex[n + 1 + i] = 1 / (4 * n * n)
    edge = collections.Counter({0: 3 / 8, 1: 3 / 8})
    for j in (n + 1, 2 * n, 2, n):
        edge[j] += 1 / 16
    face = {0: 1 / 4, 1: 1 / 4, 2: 1 / 4, n + 1: 1 / 4}
    return edges, [vertex, edge, face], [(vertex, edge), (edge, face)]


def triangles(n):
    """the same of 0 and its neighbors 1..n"""
    edges = [(0, 1 + i) for i in range(n)] + [(1 + i, 1 + (i + 1) % n) for i in range(n)]
    alpha = 5 / 8 - (3 + 2 * math.cos(2 * math.pi / n)) ** 2 / 64
    vertex = {0: 1 - alpha, **{1 + i: alpha / n for i in range(n)}}

    def edge(i):
        return dict(collections.Counter({0: 3 / 8, 1 + i: 3 / 8, 1 + (i + 1) % n: 1 / 8, 1 + (i - 1) % n: 1 / 8}))

    return edges, [vertex, edge(0)], [(vertex, edge(0)), (edge(0), edge(1))]


def distances(edges):
    near = collections.defaultdict(list)
    for a, b in edges:
        near[a].append(b)
        near[b].append(a)
    result = {}
    for a in near:
        result[a] = {a: 0}
        queue = collections.deque([a])
        while queue:
            x = queue.popleft()
            for y in near[x]:
                if y not in result[a]:
                    result[a][y] = result[a][x] + 1
                    queue.append(y)
    return result


def cost_of_flow(a, b, distance):
    """from the surplus of row a over row b to its lack, the shortest ways first"""
    surplus = {k: a.get(k, 0) - b.get(k, 0) for k in {*a, *b}}
    ways = sorted((distance[s][t], s, t) for s in surplus for t in surplus if surplus[s] > 0 > surplus[t])
    cost = 0
    for length, source, sink in ways:
        amount = min(surplus[source], -surplus[sink])
        surplus[source] -= amount
        surplus[sink] += amount
        cost += amount * length
    return cost


def constants(ring, valence):
    """gamma, sigma2 and d0"""
    edges, rows, pairs = ring(valence)
    distance = distances(edges)
    return (max(cost_of_flow(a, b, distance) for a, b in pairs),
            max(sum(x * y * distance[i][j] ** 2 for i, x in row.items() for j, y in row.items()) / 2 for row in rows),
            max(distance[i][j] for row in rows for i in row for j in row))


def wrong():
    """What the header has of gamma that is no bound, or a worse one than need be."""
    found = []
    for name, ring in (("of_quads", quads), ("of_triangles", triangles)):
        stated = re.search(rf"{name}\[\] = {{([^}}]*)}}", HEADER.read_text())[1].split(",")
        for valence, word in zip(VALENCES, stated, strict=True):
            gamma = max(0.5, constants(ring, valence)[0])  # that of the regular vertices around
            if not -1e-12 < float(word) - gamma < 1e-4:
                found.append(f"{HEADER.relative_to(ROOT)} has {word.strip()} {name} of valence {valence}, not {gamma:.6f} rounded up")
    return found


def main():
    for name, ring in (("Catmull-Clark", quads), ("Loop", triangles)):
        print(name)
        for n in VALENCES:
            gamma, sigma2, d0 = constants(ring, n)
            print(f"  {n:2}  gamma {gamma:.6f}  sigma2 {sigma2:.6f}  d0 {d0}")


if __name__ == "__main__":
    main()
