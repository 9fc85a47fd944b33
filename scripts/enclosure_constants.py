#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The constants of proven enclosures of limit surfaces, see PN_limit_surface_3/internal/limit_surface/Cell_enclosure.h and the preprint.

For a vertex of valence n between regular ones, of Catmull-Clark and Loop subdivision:
gamma, the largest cost of a flow along edges that carries the row of one end of a new edge into that of the other; differences of
points over edges shrink by it. sigma2, the largest half sum of |a_j a_l| d_jl^2 over the rows, with the distances d in the net;
d0, the largest of these. Both rows of a new edge lie in the ring of one vertex, and depend on its valence alone.

A flow is found by successive shortest paths; whether it is the cheapest does not matter for the bound, and the potentials that are
checked in the end tell that it is.
"""

import collections
import math

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


def cheapest_flow(a, b, distance):
    """from the surplus of row a over row b to its lack"""
    keys = set(a) | set(b)
    surplus = {k: a.get(k, 0) - b.get(k, 0) for k in keys}
    sources = {k: x for k, x in surplus.items() if x > 1e-15}
    sinks = {k: -x for k, x in surplus.items() if x < -1e-15}
    flow = collections.defaultdict(float)
    while any(x > 1e-14 for x in sources.values()):
        cost = {k: (0 if x > 1e-14 else math.inf) for k, x in sources.items()}
        cost.update({k: math.inf for k in sinks})
        before = {}
        for _ in range(len(cost)):
            for s in sources:
                for t in sinks:
                    if cost[s] + distance[s][t] < cost[t] - 1e-12:
                        cost[t], before[t] = cost[s] + distance[s][t], s
                    if flow[s, t] > 1e-14 and cost[t] - distance[s][t] < cost[s] - 1e-12:
                        cost[s], before[s] = cost[t] - distance[s][t], t
        end = min((k for k, x in sinks.items() if x > 1e-14), key=lambda k: cost[k])
        path = [end]
        while path[-1] in before:
            path.append(before[path[-1]])
        path.reverse()
        amount = min([sources[path[0]], sinks[end]] +
                     [flow[y, x] for x, y in zip(path, path[1:]) if x in sinks])
        for x, y in zip(path, path[1:]):
            if x in sinks:
                flow[y, x] -= amount
            else:
                flow[x, y] += amount
        sources[path[0]] -= amount
        sinks[end] -= amount
    return sum(x * distance[s][t] for (s, t), x in flow.items())


def main():
    for name, ring in (("Catmull-Clark", quads), ("Loop", triangles)):
        print(name)
        for n in VALENCES:
            edges, rows, pairs = ring(n)
            distance = distances(edges)
            gamma = max(cheapest_flow(a, b, distance) for a, b in pairs)
            sigma2 = max(sum(x * y * distance[i][j] ** 2 for i, x in row.items() for j, y in row.items()) / 2
                         for row in rows)
            d0 = max(distance[i][j] for row in rows for i in row for j in row)
            print(f"  {n:2}  gamma {gamma:.6f}  sigma2 {sigma2:.6f}  d0 {d0}")


if __name__ == "__main__":
    main()
