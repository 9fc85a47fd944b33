# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Uneven, irregular samplings of a surface, with interior vertices of every valence from 3 to 12.

Each of these ten vertices is a *hub*: a centre in a ring of as many points as its valence, with
room around, so that the Delaunay triangulation must join the centre to exactly the ring.
"""

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

from .domain import TWO_PI, Domain
from .mesh import Face, Mesh
from .vector import Vec, cos, cross, dot, lerp, sub

VALENCES = range(3, 13)
LEAST_CORNER_SINE = 0.2


@dataclass
class Sampling:
    """Parameters and faces; the first len(VALENCES) vertices are the centres of the hubs."""

    domain: Domain
    parameters: list[Vec]
    faces: list[Face]

    def mesh(self, comment: str) -> Mesh:
        pairs = [self.domain.point_and_normal(p) for p in self.parameters]
        return Mesh([p for p, _ in pairs], self.faces, [n for _, n in pairs], [comment])

    def face_is_good(self, f: Face) -> bool:
        p = [self.parameters[v] for v in f]
        return all(self.domain.corner_sine(p[i - 2], p[i - 1], p[i]) > LEAST_CORNER_SINE
                   for i in range(len(p)))


def triangulated_sampling(domain: Domain, random: Random, hub_radius: float,
                          spacing: Callable[[Vec], float]) -> Sampling:
    """Hubs, border points and scattered points (as far apart as `spacing` says), triangulated."""
    centres = _scatter_hubs(domain, random, hub_radius)
    border = domain.on_border(random, 1.6 * hub_radius)
    rings = [p for valence, c in zip(VALENCES, centres)
             for p in _ring(domain, random, c, valence, hub_radius)]
    rooms = [(c, _room(valence, hub_radius)) for valence, c in zip(VALENCES, centres)]
    points = centres + border + rings
    for _ in range(3000):
        p = domain.sample(random, 0.8 * hub_radius if border else 0.0)
        if (all(domain.distance(p, q) > spacing(p) for q in points)
                and all(domain.distance(p, c) > room for c, room in rooms)):
            points.append(p)
    return Sampling(domain, points, _delaunay(domain, points))


def _room(valence: int, radius: float) -> float:
    """Reach of the circles through the centre and two neighbours on the ring, and a bit more."""
    return 1.1 * radius / cos(1.1 * TWO_PI / 2 / valence)


def _scatter_hubs(domain: Domain, random: Random, radius: float) -> list[Vec]:
    centres: list[Vec] = []
    for _ in range(10000):
        p = domain.sample(random, 1.8 * radius)
        room = _room(VALENCES[len(centres)], radius)
        if all(domain.distance(p, c) > radius + max(room, _room(valence, radius))
               for valence, c in zip(VALENCES, centres)):
            centres.append(p)
            if len(centres) == len(VALENCES):
                return centres
    raise ValueError("no room for all hubs: make them smaller")


def _ring(domain: Domain, random: Random, centre: Vec, valence: int, radius: float) -> list[Vec]:
    turn = random.random()
    return [domain.step(centre, (turn + i + lerp(-0.05, 0.05, random.random())) * TWO_PI / valence,
                        radius * lerp(0.97, 1.03, random.random())) for i in range(valence)]


def _delaunay(domain: Domain, parameters: list[Vec]) -> list[Face]:
    images = [domain.on_sphere(p) for p in parameters]
    faces = _convex_hull(images + domain.beyond_border())
    return sorted(f for f in faces if max(f) < len(parameters))


def _convex_hull(points: list[Vec]) -> list[Face]:
    """Incremental; the points are on the unit sphere and in general position."""
    faces: list[Face] = [(0, 1, 2), (0, 2, 1)]
    for i in range(3, len(points)):
        seen = [f for f in faces if _volume(points, f, i) > 0]
        edges = {e for f in seen for e in zip(f, f[1:] + f[:1])}
        horizon = sorted(e for e in edges if (e[1], e[0]) not in edges)
        hidden = set(seen)
        faces = [f for f in faces if f not in hidden] + [(a, b, i) for a, b in horizon]
    return [f[f.index(min(f)):] + f[:f.index(min(f))] for f in faces]


def _volume(points: list[Vec], f: Face, i: int) -> float:
    a, b, c = (points[v] for v in f)
    return dot(cross(sub(b, a), sub(c, a)), sub(points[i], a))


def shake(s: Sampling, random: Random, amount: float) -> None:
    """Moves vertices at random (`amount` times their shortest edge) as long as faces stay good."""
    around: list[list[Face]] = [[] for _ in s.parameters]
    for f in s.faces:
        for v in f:
            around[v].append(f)
    for v, old in enumerate(s.parameters):
        neighbours = {w for f in around[v] for w in f} - {v}
        shortest = min(s.domain.distance(old, s.parameters[w]) for w in neighbours)
        s.parameters[v] = s.domain.step(old, TWO_PI * random.random(),
                                        amount * shortest * random.random())
        if not all(s.face_is_good(f) for f in around[v]):
            s.parameters[v] = old


def split_into_quads(s: Sampling) -> Sampling:
    """A quad for each corner, as Catmull-Clark does: old vertices keep their valences."""
    parameters = list(s.parameters)
    edge_point: dict[tuple[int, int], int] = {}
    faces: list[Face] = []
    for f in s.faces:
        centre = len(parameters)
        parameters.append(s.domain.middle([s.parameters[v] for v in f]))
        for a, b in zip(f, f[1:] + f[:1]):
            key = (min(a, b), max(a, b))
            if key not in edge_point:
                edge_point[key] = len(parameters)
                parameters.append(s.domain.middle([s.parameters[v] for v in key]))
        ends = [edge_point[min(a, b), max(a, b)] for a, b in zip(f, f[1:] + f[:1])]
        faces += [(v, after, centre, before) for v, after, before in zip(f, ends, ends[-1:] + ends)]
    return Sampling(s.domain, parameters, faces)


def merge_faces(s: Sampling, random: Random, most_corners: int, share: float) -> None:
    """Removes that share of the edges that can go: hubs keep theirs, faces stay convex."""
    valence = Mesh(s.parameters, s.faces).valences()
    owner = {e: i for i, f in enumerate(s.faces) for e in zip(f, f[1:] + f[:1])}
    faces: list[Face | None] = list(s.faces)
    for a, b in sorted(e for e in owner if e[0] < e[1]):
        left, right = owner[a, b], owner.get((b, a))
        if random.random() > share or right is None or min(a, b) < len(VALENCES):
            continue
        merged = _union(faces[left], faces[right], a, b)
        if (min(valence[a], valence[b]) < 4 or len(set(merged)) < len(merged)
                or len(merged) > most_corners or not s.face_is_good(merged)):
            continue
        faces[left], faces[right] = merged, None
        owner.update({e: left for e in zip(merged, merged[1:] + merged[:1])})
        valence[a] -= 1
        valence[b] -= 1
    s.faces = [f for f in faces if f]


def _union(left: Face, right: Face, a: int, b: int) -> Face:
    """The face around both, where the left one has the edge ab and the right one ba."""
    i, j = left.index(b), right.index(a)
    return left[i:] + left[:i] + (right[j:] + right[:j])[1:-1]


def split_quads(s: Sampling, random: Random, share: float) -> None:
    """Cuts that share of the quads into two triangles."""
    faces: list[Face] = []
    for f in s.faces:
        cut = [(f[0], f[1], f[2]), (f[0], f[2], f[3])] if len(f) == 4 else []
        wanted = cut and random.random() < share and min(f) >= len(VALENCES)
        faces += cut if wanted and all(map(s.face_is_good, cut)) else [f]
    s.faces = faces


def cut_away(s: Sampling, keep: Callable[[Vec], bool]) -> None:
    """Drops the faces whose middle is not to be kept, then what would leave bow-ties, then
    the vertices that are left without a face."""
    faces = [f for f in s.faces if keep(s.domain.middle([s.parameters[v] for v in f]))]
    while pinched := _pinched_vertices(faces):
        faces = [f for f in faces if not pinched & set(f)]
    used = sorted({v for f in faces for v in f})
    index = {v: i for i, v in enumerate(used)}
    s.parameters = [s.parameters[v] for v in used]
    s.faces = [tuple(index[v] for v in f) for f in faces]


def _pinched_vertices(faces: list[Face]) -> set[int]:
    edges = {e for f in faces for e in zip(f, f[1:] + f[:1])}
    starts = [a for a, b in edges if (b, a) not in edges]
    return {v for v in starts if starts.count(v) > 1}
