#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""How far what the command makes of coarse parts of openscad is from their true surfaces; exit code 1 if a bar is missed:
by --levels 2 the largest and the mean distance are at most a tenth of the file's, by --part at most the larger of its chord
and a quarter of the file's; no edge turns by more than 150 degrees if none of the file does. Parts called cut_... are cut
between the circles of their cones; their facets are narrow and wide ones, and an eighth is enough there.

  check_parts.py PN_SUBDIVIDE [PART...] [--sides N...]

Distances are in diagonals of the part, from vertices and from middles of edges and triangles.
"""

import argparse
import math
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from control_meshes.files import read_mesh
from control_meshes.vector import cross, dot, length, sub

CHORD = 2e-4  # of --part


class Solid:
    """Text for openscad; the distance of a point, negative inside, and beside edges perhaps less than the true one."""

    def __init__(self, text: str, distance: Callable):
        self.text, self.distance = text, distance

    def __add__(self, other: "Solid") -> "Solid":
        return Solid(f"union() {{ {self.text} {other.text} }}", lambda p: min(self.distance(p), other.distance(p)))

    def __sub__(self, other: "Solid") -> "Solid":
        return Solid(f"difference() {{ {self.text} {other.text} }}", lambda p: max(self.distance(p), -other.distance(p)))

    def at(self, x: float, y: float, z: float) -> "Solid":
        return Solid(f"translate([{x}, {y}, {z}]) {self.text}", lambda p: self.distance(sub(p, (x, y, z))))

    def about(self, axis: str, degrees: float) -> "Solid":
        k, t = "xyz".index(axis), math.radians(degrees)
        i, j = (k + 1) % 3, (k + 2) % 3

        def distance(p):
            q = list(p)
            q[i] = math.cos(t) * p[i] + math.sin(t) * p[j]
            q[j] = math.cos(t) * p[j] - math.sin(t) * p[i]
            return self.distance(q)

        return Solid(f"rotate([{', '.join(str(degrees if a == axis else 0) for a in 'xyz')}]) {self.text}", distance)


def box(*size: float) -> Solid:
    return Solid(f"cube({list(size)});", lambda p: max(max(-x, x - s) for x, s in zip(p, size)))


def ball(radius: float) -> Solid:
    return Solid(f"sphere({radius});", lambda p: length(p) - radius)


def cone(below: float, above: float, height: float) -> Solid:
    slope = (above - below) / height
    return Solid(f"cylinder(r1 = {below}, r2 = {above}, h = {height});",
                 lambda p: max((math.hypot(p[0], p[1]) - below - slope * p[2]) / math.hypot(1, slope), -p[2], p[2] - height))


def rod(radius: float, height: float) -> Solid:
    return cone(radius, radius, height)


def turned(flat: Solid) -> Solid:
    """of what is drawn in the plane"""
    return Solid(f"rotate_extrude() {flat.text}", lambda p: flat.distance((math.hypot(p[0], p[1]), p[2], 0)))


def square(width: float, height: float) -> Solid:
    return Solid(f"square([{width}, {height}]);", lambda p: max(-p[0], p[0] - width, -p[1], p[1] - height))


def circle(radius: float) -> Solid:
    return Solid(f"circle({radius});", lambda p: math.hypot(p[0], p[1]) - radius)


def countersunk(hole: Solid) -> Solid:
    return box(50, 30, 8) - hole.at(10, 15, 0) - hole.at(25, 15, 0) - hole.at(40, 15, 0)


def sink(above: float) -> Solid:
    """for a screw, drawn higher than the plate"""
    return rod(2.5, 10).at(0, 0, -1) + cone(2.5, 5.5 + above, 3 + above).at(0, 0, 5)


RIB = Solid("translate([0, 13, 0]) rotate([-90, 0, 0]) linear_extrude(4) polygon([[0, 0], [15, 0], [0, -15]]);",
            lambda p: max(-p[0], -p[2], (p[0] + p[2] - 15) / math.sqrt(2), 13 - p[1], p[1] - 17)).at(4, 0, 4)
PARTS = {
    "plate": box(60, 40, 6) - rod(3, 8).at(8, 8, -1) - rod(3, 8).at(52, 8, -1) - rod(3, 8).at(8, 32, -1) -
             rod(3, 8).at(52, 32, -1) - rod(8, 8).at(30, 20, -1) - rod(11, 8).at(30, 20, 3),
    "turned": turned(square(5, 30) + square(12, 6) + square(9, 5).at(0, 12, 0) + (square(2, 2).at(5, 6, 0) - circle(2).at(7, 8, 0))),
    "countersunk": countersunk(sink(0)),
    "ball": ball(10).at(0, 0, 20) + rod(4, 15) + rod(12, 4) - rod(1.5, 4).at(0, 0, -1),
    "shaft": rod(10, 20) + rod(7, 25).at(0, 0, 20) + cone(7, 6, 1).at(0, 0, 45) + rod(5, 14).at(0, 0, 46) -
             box(3, 4, 15).at(-1.5, 4, 50),
    "bracket": box(40, 30, 4) + box(4, 30, 30) + RIB - rod(2.5, 6).at(28, 7, -1) - rod(2.5, 6).at(28, 23, -1) -
               rod(4, 6).about("y", 90).at(-1, 15, 20),
    "cut_countersunk": countersunk(sink(0.1)),
    "cut_inclined": box(50, 30, 12) - (rod(3, 60).at(0, 0, -30) + cone(3, 15, 12).at(0, 0, -4)).about("x", 20).at(25, 15, 12),
    "cut_edge": box(50, 30, 8) - sink(0.1).at(25, 4, 0),
}


def folds(points: list, triangles: list) -> int:
    normals: dict = {}
    for t in triangles:
        normal = cross(sub(points[t[1]], points[t[0]]), sub(points[t[2]], points[t[0]]))
        for edge in zip(t, (*t[1:], t[0])):
            normals[edge] = normal
    cosine = math.cos(math.radians(150))
    return sum(a < b and dot(n, normals[b, a]) < cosine * length(n) * length(normals[b, a]) for (a, b), n in normals.items())


def measured(mesh: Path, solid: Solid) -> tuple[float, float, int]:
    """the largest and the mean distance, and folds"""
    read = read_mesh(mesh)
    points, triangles = read.points, read.triangles()
    diagonal = math.dist(*([f(p[i] for p in points) for i in range(3)] for f in (min, max)))
    at: dict = {}

    def distance(*corners: int) -> float:
        corners = tuple(sorted(corners))
        if corners not in at:
            at[corners] = abs(solid.distance([sum(x) / len(corners) for x in zip(*(points[v] for v in corners))]))
        return at[corners]

    largest = total = area = 0.0
    for a, b, c in triangles:
        of_triangle = [distance(a), distance(b), distance(c), distance(a, b), distance(b, c), distance(a, c), distance(a, b, c)]
        size = length(cross(sub(points[b], points[a]), sub(points[c], points[a])))
        largest, area = max(largest, *of_triangle), area + size
        total += size * sum(of_triangle) / len(of_triangle)
    return largest / diagonal, total / area / diagonal, folds(points, triangles)


def check(command: str, name: str, sides: int, folder: Path) -> bool:
    solid, part = PARTS[name], folder / "part.stl"
    (folder / "part.scad").write_text(f"$fn = {sides}; {solid.text}\n")
    subprocess.run(["openscad", "-q", "-o", part, folder / "part.scad"], check=True, stderr=subprocess.DEVNULL)
    found = []
    for options in ("--levels 0", "--levels 2", "--part"):
        if subprocess.run([command, part, folder / "made.off", "--quiet", *options.split()], stderr=subprocess.DEVNULL).returncode:
            print(f"{name}, {sides} sides: {options} is refused")
            return False
        found.append(measured(folder / "made.off", solid))
    (most, average, folded), two, by_part = found
    good = (two[0] <= most / (8 if name.startswith("cut_") else 10) and two[1] <= average / 10 and by_part[0] <= max(CHORD, most / 4) and
            by_part[1] <= max(CHORD, average / 4) and max(two[2], by_part[2]) <= folded)
    numbers = " | ".join(f"{a:.1e}, {b:.1e}" for a, b, _ in found)
    print(f"| {name} | {sides} | {numbers} | {two[2]}, {by_part[2]} | {'' if good else 'missed'} |", flush=True)
    return good


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", metavar="PN_SUBDIVIDE")
    parser.add_argument("parts", metavar="PART", nargs="*", choices=[*PARTS, []], help=", ".join(PARTS))
    parser.add_argument("--sides", metavar="N", nargs="+", type=int, default=[20, 24, 32, 40])
    options = parser.parse_args()
    print("| part | sides | file: largest, mean | --levels 2 | --part | folds | |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        results = [check(options.command, name, sides, Path(folder))
                   for name in options.parts or PARTS for sides in options.sides]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
