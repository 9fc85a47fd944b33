# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The numbers of each figure, from refined meshes and from what the examples print."""

import re
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import product
from math import acos, cos, degrees, hypot, pi, sin

from control_meshes.vector import Vec, add, cross, dot, scaled, sub
from refinery import Refinery

from .refined import RINGS, bent, flat, refined

Numbers = Iterator[tuple[str, float]]
MODIFIED = "--first-round 2 --tuned-valences diverging"  # of the paper


def unevenness(values: Iterable[float]) -> float:
    """How far the values spread, relative to their middle."""
    values = list(values)
    return 2 * (max(values) - min(values)) / (max(values) + min(values))


def radius(p: Vec) -> float:
    return hypot(p[0], p[1])


def angle(a: Vec, b: Vec) -> float:
    return degrees(acos(min(1.0, dot(a, b))))


def off_circle(p: Vec, three: list[Vec]) -> float:
    """The distance from the circle through three points, relative to its radius."""
    a, b, c = three
    u, v = sub(b, a), sub(c, a)
    axis = cross(u, v)
    middle = cross(sub(scaled(v, dot(u, u)), scaled(u, dot(v, v))), axis)
    center = add(a, scaled(middle, 0.5 / dot(axis, axis)))
    size = hypot(*sub(a, center))
    height = dot(sub(p, center), axis) / hypot(*axis)
    across = sub(sub(p, center), scaled(axis, height / hypot(*axis)))
    return hypot(height, hypot(*across) - size) / size


def deviation(refinery: Refinery, shape: str, mesh: str, options: str) -> float:
    """The distance from the shape over its radius."""
    line = refinery.run(mesh, refinery.folder / "verified.ply", f"{options} --verify {shape}")
    return float(re.findall(r"2\^-52: ([^)]*)\)", line)[0]) * 2.0 ** -52


def deviations(figure: int, shape: str, mesh: str, scheme: str, refinery: Refinery) -> Numbers:
    for kind, option in (("linear", " --linear"), ("PN", "")):
        yield f"{figure}_{kind}", deviation(refinery, shape, mesh, f"--scheme {scheme} --levels 5{option}")


def rings_6(refinery: Refinery) -> Numbers:
    """Rings m of the surface: point-normal, and linear from the control points of level m."""
    for m in range(RINGS):
        pn, linear = bent(refinery, m), flat(refinery, m, 0)
        layer = pn.layers(0, 8)
        ring = [v for v, distance in layer.items() if 4 < distance < 8]
        normals = [pn.normal_from_faces(v) for v in ring]
        yield f"6_apart_{m}", max(angle(n, linear.normal_from_faces(v)) for v, n in zip(ring, normals))
        total = [sum(n[i] for n in normals) for i in range(3)]
        mean = scaled((total[0], total[1], total[2]), 1 / hypot(*total))
        yield f"6_spread_{m}", max(angle(n, mean) for n in normals)


def cross_8(refinery: Refinery) -> Numbers:
    """The ends of the five open arms, and their outer three quarters of a cube, beside cylinders."""
    for scheme, (kind, option) in product(("catmull-clark", "doo-sabin", "kobbelt", "loop"),
                                          (("PN", "--normals angle"), ("linear", "--linear"))):
        triangles = " --triangulate" if scheme == "loop" else ""
        mesh = refined(refinery, "paper/cross.off", f"--scheme {scheme} --levels 5 {option}{triangles}")
        off = {v: abs(hypot(p[i - 2], p[i - 1]) / 0.5 ** 0.5 - 1)
               for v, p in enumerate(mesh.points) for i in range(3)
               if abs(p[i]) > 2.75 and (i < 2 or p[i] < 0)}
        name = f"{kind}_{scheme}".replace("-", "_")
        yield f"8_arm_{name}", max(off.values())
        yield f"8_end_{name}", max(d for v, d in off.items() if mesh.is_border(v))


def local_9(refinery: Refinery) -> Numbers:
    """Gaussian curvature on the second to fourth ring of vertices after five rounds."""
    panels = {"a": "catmull-clark --linear", "b": f"modified-catmull-clark --linear {MODIFIED}", "c": "catmull-clark",
              "d": f"modified-catmull-clark {MODIFIED}", "e": "modified-catmull-clark"}
    for (row, name), (panel, scheme) in product(enumerate(("saddle_5", "bezier_6", "cylinder_cap_8"), 1), panels.items()):
        mesh = refined(refinery, f"{name}.ply", f"--levels 5 --curvature gaussian --scheme {scheme}")
        values = [mesh.values["gaussian_curvature"][v]
                  for v, layer in mesh.layers(0, 4).items() if layer > 1]
        yield f"9_{row}{panel}_min", min(values)
        yield f"9_{row}{panel}_max", max(values)
    yield "9_bezier", curvature_of_bezier()


def curvature_of_bezier() -> float:
    """In the middle of the patch z = sum heights[i][j] B_i(x / 3) B_j(y / 3), which the meshes are made of."""
    heights = ((0.0, 0.5, 0.25, -0.25), (0.75, 2.0, 1.5, 0.25), (0.25, 2.25, 1.5, 0.75), (-0.5, 0.5, 1.0, -0.25))
    by = ((1 / 8, 3 / 8, 3 / 8, 1 / 8), (-1 / 4, -1 / 4, 1 / 4, 1 / 4), (1 / 3, -1 / 3, -1 / 3, 1 / 3))

    def z(x: int, y: int) -> float:
        return sum(a * b * h for a, row in zip(by[x], heights) for b, h in zip(by[y], row))

    slope = 1 + z(1, 0) ** 2 + z(0, 1) ** 2
    return (z(2, 0) * z(0, 2) - z(1, 1) ** 2) / slope ** 2


def grid_10(refinery: Refinery) -> Numbers:
    for (kind, option), shape in product((("", "--normals file"), ("linear_", "--linear")), ("waves", "bumps")):
        mesh = refined(refinery, f"paper/{shape}.ply", f"--scheme doo-sabin --levels 4 {option}")
        heights = mesh.values["z"]
        yield f"10_grid_{kind}{shape}", max(heights) - min(heights)


def ring_11(refinery: Refinery) -> Numbers:
    for kind, option in (("linear", "--linear"), ("PN", "--normals file")):
        mesh = refined(refinery, "paper/ring.ply", f"--scheme catmull-clark --levels 4 {option}")
        meridian = mesh.line_over(0, 8)
        parallels = [min(mesh.lines_through(v), key=lambda line: len(line & meridian))
                     for v in meridian]
        yield f"11_ring_{kind}", max(unevenness(radius(mesh.points[v]) for v in line)
                                     for line in parallels)


def wheel_12(refinery: Refinery) -> Numbers:
    linear, pn, tori = (refined(refinery, f"paper/{mesh}.ply", "--scheme catmull-clark --levels 4" + option).points
                        for mesh, option in (("wheel", " --linear"), ("wheel", " --normals file"), ("wheel_tori", " --normals file")))
    for name, points in (("linear", linear), ("PN", pn), ("tori", tori)):
        middle = [radius(p) for p in points if abs(p[2]) < 1e-9]
        yield f"12_rim_{name}", unevenness(r for r in middle if r > 2.6)
        yield f"12_hub_{name}", unevenness(r for r in middle if r < 0.8)
        tube = [hypot(radius(p) - 2.6, p[2]) for p in points if radius(p) > 2.6]
        yield f"12_tube_{name}", unevenness(tube)
    yield "12_z", max(abs(p[2] - q[2]) for p, q in zip(linear, pn))


def models_13(refinery: Refinery) -> Numbers:
    for kind, option in (("linear", " --linear"), ("PN", " --normals file")):
        bell = refined(refinery, "paper/bell.ply", "--scheme catmull-clark --levels 4" + option)
        yield f"13_bell_{kind}", unevenness(radius(p) for v, p in enumerate(bell.points)
                                            if bell.is_border(v))
        hole = refined(refinery, "paper/cuboid_with_hole.ply", "--scheme doo-sabin --levels 5" + option)
        inner = [p for p in hole.points if radius(p) < 1]
        lowest = min(abs(p[2]) for p in inner)
        yield f"13_hole_{kind}", unevenness(radius(p) for p in inner
                                            if abs(p[2]) < 1.001 * lowest)
    mesh = refined(refinery, "paper/cyclide.ply", "--scheme kobbelt --levels 5")

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


def torus_17(refinery: Refinery) -> Numbers:
    for n in (4, 8):
        mesh = refined(refinery, f"paper/torus_{n}.ply", "--scheme kobbelt --levels 5")
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


OF_REFINED: dict[int, Callable[[Refinery], Numbers]] = {
    3: partial(deviations, 3, "cylinder:0,0,0,0,0,1,1", "paper/cylinder.ply", "catmull-clark"),
    4: partial(deviations, 4, "sphere:0,0,0,1", "paper/tetrahedron.ply", "butterfly"), 6: rings_6, 8: cross_8, 9: local_9, 10: grid_10, 11: ring_11, 12: wheel_12,
    13: models_13, 17: torus_17}


# --- what the examples print ---


def arcs_1(printed: list[list[float]]) -> Numbers:
    yield from zip(("1_h0", "1_h1", "1_h2", "1_mean"), printed[0])


def circle_2(printed: list[list[float]]) -> Numbers:
    for scheme, row in zip(("6_point", "b_spline"), printed):
        yield f"2_off_{scheme}", row[1]
        yield f"2_spacing_{scheme}", row[-1]


def bottle_5(printed: list[list[float]]) -> Numbers:
    for row, values in enumerate(printed, 1):
        for rounds, value in zip((6, 8, 10), values[-3:]):
            yield f"5_{row}_{rounds}", value


def circles_16(printed: list[list[float]]) -> Numbers:
    for angle_of_turn, kept, _, largest, crossings in printed:
        yield f"16_kept_{angle_of_turn:.0f}", kept
        yield f"16_angle_{angle_of_turn:.0f}", largest
        yield f"16_crossings_{angle_of_turn:.0f}", crossings


OF_EXAMPLES: dict[int, tuple[str, Callable[[list[list[float]]], Numbers]]] = {
    1: ("average_arcs", arcs_1), 2: ("curve_circle", circle_2), 5: ("curve_bottle", bottle_5),
    16: ("curve_normal_edit", circles_16)}
