# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The numbers of each figure, from the meshes that scripts/make_paper_figures.sh has refined."""

from collections.abc import Callable, Iterable, Iterator
from itertools import product
from math import acos, cos, degrees, hypot, pi, sin
from pathlib import Path
from statistics import median

from control_meshes.star import BEZIER_HEIGHTS

from .refined import Refined, Vec

Numbers = Iterator[tuple[str, float]]
RINGS = 4  # of figure 6


def unevenness(values: Iterable[float]) -> float:
    """How far the values spread, relative to their middle."""
    values = list(values)
    return 2 * (max(values) - min(values)) / (max(values) + min(values))


def radius(p: Vec) -> float:
    return hypot(p[0], p[1])


def angle(a: Vec, b: Vec) -> float:
    return degrees(acos(min(1.0, sum(x * y for x, y in zip(a, b)))))


def off_circle(p: Vec, three: list[Vec]) -> float:
    """The distance from the circle through three points, relative to its radius."""
    a, b, c = three
    u, v = _minus(b, a), _minus(c, a)
    axis = _cross(u, v)
    middle = _cross(_minus(_times(v, _dot(u, u)), _times(u, _dot(v, v))), axis)
    center = _plus(a, _times(middle, 0.5 / _dot(axis, axis)))
    size = hypot(*_minus(a, center))
    height = _dot(_minus(p, center), axis) / hypot(*axis)
    across = _minus(_minus(p, center), _times(axis, height / hypot(*axis)))
    return hypot(height, hypot(*across) - size) / size


def _minus(a: Vec, b: Vec) -> Vec:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _plus(a: Vec, b: Vec) -> Vec:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def _times(a: Vec, s: float) -> Vec:
    return (a[0] * s, a[1] * s, a[2] * s)


def _dot(a: Vec, b: Vec) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Vec, b: Vec) -> Vec:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def rings_6(folder: Path) -> Numbers:
    """Rings m of the surface: point-normal, and linear from the control points of level m."""
    for m in range(RINGS):
        bent, flat = (Refined(folder / f"{kind}_{m}.ply") for kind in ("PN", "linear"))
        layer = bent.layers(0, 8)
        ring = [v for v, distance in layer.items() if 4 < distance < 8]
        normals = [bent.normal_from_faces(v) for v in ring]
        yield f"6_apart_{m}", max(angle(n, flat.normal_from_faces(v)) for v, n in zip(ring, normals))
        total = [sum(n[i] for n in normals) for i in range(3)]
        mean = _times((total[0], total[1], total[2]), 1 / hypot(*total))
        yield f"6_spread_{m}", max(angle(n, mean) for n in normals)


def cross_8(folder: Path) -> Numbers:
    """The ends of the five open arms, and their outer three quarters of a cube, beside cylinders."""
    for path in sorted(folder.glob("cross_*.ply")):
        mesh = Refined(path)
        off = {v: abs(hypot(p[i - 2], p[i - 1]) / 0.5 ** 0.5 - 1)
               for v, p in enumerate(mesh.points) for i in range(3)
               if abs(p[i]) > 2.75 and (i < 2 or p[i] < 0)}
        name = path.stem.removeprefix("cross_").replace("-", "_")
        yield f"8_arm_{name}", max(off.values())
        yield f"8_end_{name}", max(d for v, d in off.items() if mesh.is_border(v))


def local_9(folder: Path) -> Numbers:
    """Gaussian curvature on the second to fourth ring of vertices after five rounds."""
    for row, panel in product("123", "abcde"):
        mesh = Refined(folder / f"{row}{panel}.ply")
        values = [mesh.values["gaussian_curvature"][v]
                  for v, layer in mesh.layers(0, 4).items() if layer > 1]
        yield f"9_{row}{panel}_min", min(values)
        yield f"9_{row}{panel}_max", max(values)
    yield "9_bezier", curvature_of_bezier()


def curvature_of_bezier() -> float:
    """In the middle of the patch z = sum heights[i][j] B_i(x / 3) B_j(y / 3)."""
    by = ((1 / 8, 3 / 8, 3 / 8, 1 / 8), (-1 / 4, -1 / 4, 1 / 4, 1 / 4), (1 / 3, -1 / 3, -1 / 3, 1 / 3))

    def z(x: int, y: int) -> float:
        return sum(a * b * h for a, row in zip(by[x], BEZIER_HEIGHTS) for b, h in zip(by[y], row))

    slope = 1 + z(1, 0) ** 2 + z(0, 1) ** 2
    return (z(2, 0) * z(0, 2) - z(1, 1) ** 2) / slope ** 2


def grid_10(folder: Path) -> Numbers:
    for path in sorted(folder.glob("grid_*.ply")):
        heights = Refined(path).values["z"]
        yield f"10_{path.stem}", max(heights) - min(heights)


def ring_11(folder: Path) -> Numbers:
    for name in ("ring_linear", "ring_PN"):
        mesh = Refined(folder / f"{name}.ply")
        meridian = mesh.line_over(0, 8)
        parallels = [min(mesh.lines_through(v), key=lambda line: len(line & meridian))
                     for v in meridian]
        yield f"11_{name}", max(unevenness(radius(mesh.points[v]) for v in line)
                                for line in parallels)


def wheel_12(folder: Path) -> Numbers:
    linear, bent, tori = (Refined(folder / f"wheel_{name}.ply").points
                          for name in ("linear", "PN", "tori"))
    for name, points in (("linear", linear), ("PN", bent), ("tori", tori)):
        middle = [radius(p) for p in points if abs(p[2]) < 1e-9]
        yield f"12_rim_{name}", unevenness(r for r in middle if r > 2.6)
        yield f"12_hub_{name}", unevenness(r for r in middle if r < 0.8)
        tube = [hypot(radius(p) - 2.6, p[2]) for p in points if radius(p) > 2.6]
        yield f"12_tube_{name}", unevenness(tube)
    yield "12_z", max(abs(p[2] - q[2]) for p, q in zip(linear, bent))


def models_13(folder: Path) -> Numbers:
    for kind in ("linear", "PN"):
        bell = Refined(folder / f"bell_{kind}.ply")
        yield f"13_bell_{kind}", unevenness(radius(p) for v, p in enumerate(bell.points)
                                            if bell.is_border(v))
        inner = [p for p in Refined(folder / f"hole_{kind}.ply").points if radius(p) < 1]
        lowest = min(abs(p[2]) for p in inner)
        yield f"13_hole_{kind}", unevenness(radius(p) for p in inner
                                            if abs(p[2]) < 1.001 * lowest)
    mesh = Refined(folder / "cyclide.ply")

    def off(control: list[int]) -> float:
        three = [mesh.points[v] for v in control[::2]]
        return max(off_circle(mesh.points[v], three)
                   for v in mesh.line_over(control[0], control[1]))

    for name, row in (("outer", 0), ("inner", 3)):
        yield f"13_cyclide_{name}", off([6 * row + i for i in range(6)])
    across = [off([6 * j + i for j in range(6)]) for i in range(6)]
    yield "13_cyclide_across_exact", max(across[0], across[3])
    yield "13_cyclide_across", max(across)
    yield "13_cyclide", max(off_cyclide(p, 5.0, 4.8, 1.4, 2.5) for p in mesh.points)


def off_cyclide(p: Vec, a: float, b: float, c: float, d: float) -> float:
    """The distance to first order, relative to the tube's mean radius d."""
    x, y, z = p
    s = x * x + y * y + z * z - d * d + b * b
    value = s * s - 4 * (a * x - c * d) ** 2 - 4 * b * b * y * y
    slope = (4 * s * x - 8 * a * (a * x - c * d), 4 * s * y - 8 * b * b * y, 4 * s * z)
    return abs(value) / hypot(*slope) / d


def oscillation(mesh: Refined, v: int) -> float:
    """How far the Gaussian curvature spreads on the second ring of vertices around one."""
    values = [mesh.values["gaussian_curvature"][w]
              for w, layer in mesh.layers(v, 2).items() if layer == 2]
    return max(values) - min(values)


def extraordinary(number: str, folder: Path, control_vertices: int, regular: int) -> Numbers:
    """Only vertices at which the modified schemes differ in the paper, of more edges than regular."""
    for name in ("linear", "modified", "PN_modified", "PN_modified_1", "PN"):
        mesh = Refined(folder / f"{name}.ply")
        hubs = [v for v in range(control_vertices)
                if len(mesh.neighbors[v]) > regular and not mesh.is_border(v)]
        yield f"{number}_vertices", len(hubs)
        yield f"{number}_{name}", median(oscillation(mesh, v) for v in hubs)


def spoon_14(folder: Path) -> Numbers:
    return extraordinary("14", folder, 116, 4)


def head_15(folder: Path) -> Numbers:
    return extraordinary("15", folder, 304, 6)


def torus_17(folder: Path) -> Numbers:
    for n in (4, 8):
        mesh = Refined(folder / f"torus_{n}.ply")
        circles: list[tuple[set[int], Callable[[Vec], float]]] = []
        for i in range(n):
            t = 2 * pi * i / n
            circles.append((mesh.line_over(i, n + i),
                            lambda p, t=t: abs(hypot(p[0] * cos(t) + p[1] * sin(t) - 2, p[2]) - 1)
                            + abs(p[1] * cos(t) - p[0] * sin(t))))
        for row, size in ((0, 3.0), (n // 2, 1.0)):
            circles.append((mesh.line_over(n * row, n * row + 1),
                            lambda p, size=size: abs(radius(p) - size) + abs(p[2])))
        yield f"17_circles_{n}", max(off(mesh.points[v]) for line, off in circles for v in line)
        yield f"17_surface_{n}", max(abs(hypot(radius(p) - 2, p[2]) - 1) for p in mesh.points)


OF_FIGURE: dict[int, Callable[[Path], Numbers]] = {
    6: rings_6, 8: cross_8, 9: local_9, 10: grid_10, 11: ring_11, 12: wheel_12, 13: models_13, 14: spoon_14,
    15: head_15, 17: torus_17}
