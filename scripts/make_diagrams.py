#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Draws the diagrams of the manual: what a round of each host makes of faces, the stencils of the schemes, arcs that
are recognized, and the packages with their arrows, which are those of scripts/check_layers.py.

The weights are not written down here: the command pn_subdivide refines a mesh whose vertices carry one
number each, 1 at one vertex and 0 elsewhere, by the linear scheme, and the numbers that come out are the
weights. With --check nothing is written; the exit code is 1 if a drawing would change.
"""

import argparse
import math
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import check_layers
from control_meshes.files import INDICES, ply, properties, read_ply
from control_meshes.mesh import grid_quads
from refinery import COMMAND, ROOT, run

FIG = ROOT / "doc" / "PN_subdivision_3" / "fig"
Point = tuple[float, float]
Mesh = tuple[list[Point], list[list[int]]]

COARSE, FINE, OLD, NEW, TEXT = "#b8b8b8", "#1f4e79", "#333333", "#c0392b", "#222222"
UNIT = 46  # pixels per unit of length
UNIT_OF_ARCS = 34


# --- meshes ---

def quads(columns: int, rows: int) -> Mesh:
    points = [(float(x), float(y)) for y in range(rows + 1) for x in range(columns + 1)]
    return points, [list(face) for face in grid_quads(columns + 1, rows + 1)]


def triangles(columns: int, rows: int) -> Mesh:
    height = math.sqrt(3) / 2
    points = [(x + 0.5 * (y % 2), y * height) for y in range(rows + 1) for x in range(columns + 1)]
    faces = []
    for number, (a, b, c, d) in enumerate(grid_quads(columns + 1, rows + 1)):
        faces += [[a, b, c], [a, c, d]] if number // columns % 2 else [[a, b, d], [b, c, d]]
    return points, faces


def polygon(n: int) -> Mesh:
    turn = [2 * math.pi * i / n + math.pi / 2 for i in range(n)]
    return [(1.1 * math.cos(t), 1.1 * math.sin(t)) for t in turn], [list(range(n))]


# --- weights, from the command ---

def rows_of(mesh: Mesh, scheme: str, levels: int) -> list[tuple[Point, dict[int, float]]]:
    """Point and weights of each refined vertex."""
    points, faces = mesh
    vertices = [(x, y, 0, *(int(i == j) for j in range(len(points)))) for i, (x, y) in enumerate(points)]
    of_vertices = properties([*"xyz", *(f"w{i}" for i in range(len(points)))])
    with tempfile.TemporaryDirectory() as folder:
        control, refined = Path(folder) / "control.ply", Path(folder) / "refined.ply"
        control.write_text(ply(("vertex", of_vertices, vertices), ("face", [INDICES], [(len(f), *f) for f in faces])))
        run(COMMAND, "surface", control, refined, "--scheme", scheme, "--levels", levels, "--linear", "--ascii", "--quiet")
        result, values = read_ply(refined.read_text())
    columns = [values[f"w{i}"] for i in range(len(points))]
    return [((x, y), {i: column[v] for i, column in enumerate(columns) if column[v] != 0})
            for v, (x, y, _) in enumerate(result.points)]


def exact(weight: float) -> Fraction:
    value = Fraction(weight).limit_denominator(300)
    if abs(float(value) - weight) > 1e-13:
        raise ValueError(f"the weight {weight} is no simple fraction")
    return value


def nearest(rows: list[tuple[Point, dict[int, float]]],
            place: Point) -> tuple[Point, dict[int, float]]:
    return min(rows, key=lambda row: math.dist(row[0], place))


# --- drawing ---

class Drawing:
    def __init__(self) -> None:
        self.items: list[str] = []
        self.width = self.height = 0.0

    def line(self, a: Point, b: Point, color: str, width: float, dash: str = "") -> None:
        style = f' stroke-dasharray="{dash}"' if dash else ""
        self.items.append(f'<line x1="{a[0]:.1f}" y1="{a[1]:.1f}" x2="{b[0]:.1f}" y2="{b[1]:.1f}" '
                          f'stroke="{color}" stroke-width="{width}"{style}/>')

    def dot(self, p: Point, radius: float, fill: str, stroke: str) -> None:
        self.items.append(f'<circle cx="{p[0]:.1f}" cy="{p[1]:.1f}" r="{radius}" fill="{fill}" '
                          f'stroke="{stroke}" stroke-width="1.2"/>')

    def polygon(self, points: list[Point], color: str, width: float) -> None:
        numbers = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.items.append(f'<polygon points="{numbers}" fill="none" stroke="{color}" stroke-width="{width}"/>')

    def arrow(self, a: Point, b: Point, color: str, width: float) -> None:
        length = math.dist(a, b)
        x, y = (b[0] - a[0]) / length, (b[1] - a[1]) / length
        self.line(a, (b[0] - 8 * x, b[1] - 8 * y), color, width)
        ends = [b, *((b[0] - 11 * x + s * 5 * y, b[1] - 11 * y - s * 5 * x) for s in (1, -1))]
        self.items.append(f'<polygon points="{" ".join(f"{u:.1f},{v:.1f}" for u, v in ends)}" fill="{color}"/>')

    def box(self, left: float, top: float, width: float, height: float) -> None:
        self.items.append(f'<rect x="{left:.1f}" y="{top:.1f}" width="{width:.1f}" height="{height:.1f}" rx="6" '
                          f'fill="#f2f6fa" stroke="{FINE}" stroke-width="1.4"/>')

    def text(self, p: Point, text: str, size: float = 12, color: str = TEXT, bold: bool = False) -> None:
        weight = ' font-weight="bold"' if bold else ""
        self.items.append(f'<text x="{p[0]:.1f}" y="{p[1]:.1f}" font-size="{size}" fill="{color}" '
                          f'text-anchor="middle"{weight}>{text}</text>')

    def svg(self) -> str:
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width:.0f}" height="{self.height:.0f}" '
                f'viewBox="0 0 {self.width:.0f} {self.height:.0f}" font-family="Helvetica, Arial, sans-serif">\n'
                f'<rect width="100%" height="100%" fill="white"/>\n' + "\n".join(self.items) + "\n</svg>\n")


class Frame:
    """Maps a part of the plane of a mesh to the picture; y goes up in the mesh."""

    def __init__(self, points: list[Point], left: float, top: float, unit: float = UNIT) -> None:
        xs, ys = zip(*points)
        self.unit = unit
        self.x, self.y = left - unit * min(xs), top + unit * max(ys)
        self.width, self.height = unit * (max(xs) - min(xs)), unit * (max(ys) - min(ys))

    def __call__(self, p: Point) -> Point:
        return self.x + self.unit * p[0], self.y - self.unit * p[1]


def edges_of(faces: list[list[int]]) -> list[tuple[int, int]]:
    return sorted({(min(e), max(e)) for f in faces for e in zip(f, f[1:] + f[:1])})


def stencil_panel(drawing: Drawing, left: float, top: float, title: str, mesh: Mesh, scheme: str,
                  place: Point, levels: int = 1) -> Frame:
    """The weights of the new vertex that lies next to a place, as multiples of one fraction."""
    points, faces = mesh
    _, row = nearest(rows_of(mesh, scheme, levels), place)
    weights = {i: exact(weight) for i, weight in row.items()}
    if sum(weights.values()) != 1:
        raise ValueError(f"the weights of {title} do not sum to 1")
    denominator = math.lcm(*(w.denominator for w in weights.values()))
    frame = Frame(points, left, top)
    for a, b in edges_of(faces):
        drawing.line(frame(points[a]), frame(points[b]), COARSE, 1.5)
    new = frame(place)
    if not any(math.dist(points[i], place) < 1e-9 for i in weights):
        drawing.dot(new, 5, "white", NEW)
    for i, weight in weights.items():
        p = frame(points[i])
        own = math.dist(points[i], place) < 1e-9
        drawing.dot(p, 11, "white", NEW if own else OLD)
        drawing.text((p[0], p[1] + 4), str(weight * denominator).replace("-", "\u2212"), 11)
    drawing.text((left + frame.width / 2, top + frame.height + 34), title, 12)
    drawing.text((left + frame.width / 2, top + frame.height + 51), f"1/{denominator}", 12)
    return frame


def stencils(rows: list[tuple[str, list[tuple]]]) -> Drawing:
    drawing = Drawing()
    top = 16.0
    for heading, panels in rows:
        drawing.items.append(f'<text x="14" y="{top + 4:.1f}" font-size="14" font-weight="bold" '
                             f'fill="{TEXT}">{heading}</text>')
        left, height = 34.0, 0.0
        for title, mesh, scheme, place, *levels in panels:
            frame = stencil_panel(drawing, left, top + 34, title, mesh, scheme, place, *levels)
            left += max(frame.width, 96) + 58
            height = max(height, frame.height)
        drawing.width = max(drawing.width, left - 20)
        top += height + 122
    drawing.height = top - 30
    return drawing


def quad_stencils() -> Drawing:
    two, strip, three = quads(2, 2), quads(2, 1), quads(3, 3)
    return stencils([
        ("Catmull-Clark", [
            ("face", quads(1, 1), "catmull-clark", (0.5, 0.5)),
            ("edge", strip, "catmull-clark", (1, 0.5)),
            ("vertex", two, "catmull-clark", (1, 1)),
            ("border edge", strip, "catmull-clark", (0.5, 0)),
            ("border vertex", strip, "catmull-clark", (1, 0))]),
        ("Doo-Sabin: a vertex of each corner of a face", [
            ("of a triangle", polygon(3), "doo-sabin", (0, 0.7)),
            ("of a quad", quads(1, 1), "doo-sabin", (0.2, 0.2)),
            ("of a hexagon", polygon(6), "doo-sabin", (0, 0.8))]),
        ("Kobbelt, tension 1/16", [
            ("edge", quads(3, 2), "kobbelt", (1.5, 1)),
            ("face", three, "kobbelt", (1.5, 1.5)),
            ("border edge", quads(3, 1), "kobbelt", (1.5, 0)),
            ("edge at a corner", quads(3, 1), "kobbelt", (0.5, 0))]),
    ])


def triangle_stencils() -> Drawing:
    return stencils([
        ("Loop", [
            ("edge", rhombus(), "loop", (0.5, 0)),
            ("vertex", hexagon(), "loop", (0, 0)),
            ("border edge", triangles(2, 1), "loop", (0.5, 0)),
            ("border vertex", triangles(2, 1), "loop", (1, 0))]),
        ("\u221a3", [
            ("face", polygon(3), "sqrt3", (0, 0)),
            ("vertex", hexagon(), "sqrt3", (0, 0)),
            ("border vertex, even rounds", triangles(2, 1), "sqrt3", (1, 0), 2),
            ("border edge, even rounds", triangles(3, 1), "sqrt3", (4 / 3, 0), 2)]),
        ("Butterfly, as modified by Zorin", [
            ("edge", butterfly_patch(), "butterfly", (0.5, 0)),
            ("border edge", triangles(3, 1), "butterfly", (1.5, 0)),
            ("border edge at a corner", triangles(3, 1), "butterfly", (0.5, 0))]),
    ])


def hexagon() -> Mesh:
    ring = [(math.cos(math.pi * i / 3), math.sin(math.pi * i / 3)) for i in range(6)]
    return [(0.0, 0.0), *ring], [[0, 1 + i, 1 + (i + 1) % 6] for i in range(6)]


def rhombus() -> Mesh:
    height = math.sqrt(3) / 2
    return [(0.0, 0.0), (1.0, 0.0), (0.5, height), (0.5, -height)], [[0, 1, 2], [1, 0, 3]]


def butterfly_patch() -> Mesh:
    """The two triangles at an edge, with all that touch it."""
    points, faces = triangles(6, 4)
    center = (3.0, 2 * math.sqrt(3) / 2)
    shifted = [(x - center[0], y - center[1]) for x, y in points]
    ends = {i for i, p in enumerate(shifted) if math.dist(p, (0, 0)) < 1e-9 or math.dist(p, (1, 0)) < 1e-9}
    near = [f for f in faces if ends & set(f)]
    used = sorted({v for f in near for v in f})
    return [shifted[v] for v in used], [[used.index(v) for v in f] for f in near]


# --- what the hosts make of faces ---

def middle(points: list[Point], ids) -> Point:
    ids = list(ids)
    return sum(points[i][0] for i in ids) / len(ids), sum(points[i][1] for i in ids) / len(ids)


def mixed() -> Mesh:
    points = [(0, 0), (1.4, 0), (2.8, 0.2), (0, 1.4), (1.4, 1.4), (2.9, 1.5), (0.6, 2.5), (2.1, 2.6)]
    return points, [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 6], [4, 5, 7, 6]]


def fan() -> Mesh:
    ring = [(1.45 + 1.45 * math.cos(2 * math.pi * i / 5 + 0.3), 1.35 + 1.35 * math.sin(2 * math.pi * i / 5 + 0.3))
            for i in range(5)]
    return [(1.45, 1.35), *ring], [[0, 1 + i, 1 + (i + 1) % 5] for i in range(5)]


def refined(host: str, mesh: Mesh) -> list[tuple[Point, Point]]:
    """Edges after a round; old vertices stay in the drawing."""
    points, faces = mesh
    lines = []
    sides: dict[tuple[int, int], list[int]] = {}
    for f, face in enumerate(faces):
        for e in zip(face, face[1:] + face[:1]):
            sides.setdefault((min(e), max(e)), []).append(f)
    if host in ("PQQ", "PTQ"):
        for a, b in sides:
            lines += [(points[a], middle(points, (a, b))), (middle(points, (a, b)), points[b])]
    for face in faces:
        center = middle(points, face)
        around = list(zip(face, face[1:] + face[:1]))
        if host == "PQQ":
            lines += [(center, middle(points, e)) for e in around]
        elif host == "PTQ":
            lines += [(middle(points, e), middle(points, g)) for e, g in zip(around, around[1:] + around[:1])]
        elif host == "sqrt3":
            lines += [(center, points[v]) for v in face]
        else:
            lines += [(corner(points, face, a), corner(points, face, b)) for a, b in around]
    for (a, b), sharing in sides.items():
        if host == "sqrt3":
            lines.append((points[a], points[b]) if len(sharing) == 1 else
                         (middle(points, faces[sharing[0]]), middle(points, faces[sharing[1]])))
        elif host == "DQQ" and len(sharing) == 2:
            lines += [(corner(points, faces[sharing[0]], v), corner(points, faces[sharing[1]], v))
                      for v in (a, b)]
    return lines


def corner(points: list[Point], face: list[int], vertex: int) -> Point:
    center = middle(points, face)
    return (0.58 * points[vertex][0] + 0.42 * center[0], 0.58 * points[vertex][1] + 0.42 * center[1])


def refinements() -> Drawing:
    drawing = Drawing()
    left = 24.0
    for host, title, mesh in (("PQQ", "PQQ", mixed()), ("DQQ", "DQQ", mixed()),
                              ("PTQ", "PTQ", fan()), ("sqrt3", "\u221a3", fan())):
        points, faces = mesh
        frame = Frame(points, left, 20)
        for a, b in edges_of(faces):
            drawing.line(frame(points[a]), frame(points[b]), COARSE, 4)
        lines = refined(host, mesh)
        for a, b in lines:
            drawing.line(frame(a), frame(b), FINE, 1.4)
        for p in sorted({p for line in lines for p in line}):
            drawing.dot(frame(p), 2.6, FINE, FINE)
        drawing.text((left + frame.width / 2, 172), title, 14, bold=True)
        left += frame.width + 44
    drawing.width, drawing.height = left - 20, 186
    return drawing


# --- curves ---

def rounded_plate() -> list[Point]:
    """A plate with two round corners in three steps, two sharp ones, and a round notch in six."""
    def arc(x: float, y: float, radius: float, start: int, end: int, steps: int) -> list[Point]:
        turns = [math.radians(start + (end - start) * i / steps) for i in range(steps + 1)]
        return [(round(x + radius * math.cos(t), 7), round(y + radius * math.sin(t), 7)) for t in turns]

    return arc(1, 1, 1, 180, 270, 3) + arc(5, 1, 1, 270, 360, 3) + [(6.0, 3.0)] + arc(3, 3, 1, 0, -180, 6) + [(0.0, 3.0)]


def refined_curve(points: list[Point], options: list[str]) -> list[Point]:
    with tempfile.TemporaryDirectory() as folder:
        control, result = Path(folder) / "control.txt", Path(folder) / "refined.txt"
        control.write_text("".join(f"{x!r} {y!r}\n" for x, y in points))
        run(COMMAND, "curve", control, result, "--closed", "--levels", 4, "--quiet", *options)
        rows = [line.split() for line in result.read_text().splitlines()]
    return [(float(row[0]), float(row[1])) for row in rows if row and row[0] != "#"]


def recognized_arcs() -> Drawing:
    """A drawing of lines and arcs, refined in three ways."""
    drawing, points, left = Drawing(), rounded_plate(), 24.0
    for title, options in (("linear", ["--linear"]), ("point-normal", []), ("with --sharp arcs", ["--sharp", "arcs"])):
        frame = Frame(points, left, 30, UNIT_OF_ARCS)
        drawing.polygon([frame(p) for p in points], COARSE, 1.5)
        drawing.polygon([frame(p) for p in refined_curve(points, options)], FINE, 2)
        for p in points:
            drawing.dot(frame(p), 2.4, "white", OLD)
        drawing.text((left + frame.width / 2, 64 + frame.height), title, 13)
        left += frame.width + 36
    drawing.width, drawing.height = left - 12, 82 + frame.height
    return drawing


# --- the packages ---

PACKAGES = {  # row from below, left and right end in columns, content
    "PN_subdivision_3": (0, 0, 3, "average, schemes, hosts, creases, attributes, estimates of normals, refiner, files"),
    "PN_limit_surface_3": (1, 0, 1, "limits, tessellation, curvature, pieces"),
    "PN_cgal_masks_3": (1, 2, 3, "masks and functions of CGAL"),
    "PN_curves": (2, 1, 2, "curves in the plane and in space"),
    "PN_fitting_3": (3, 0, 1, "interpolation, prescribed data; by Eigen"),
    "PN_recognition_3": (3, 1, 2, "surfaces of parts, arcs of drawings"),
    "PN_certificates_3": (3, 2, 3, "proofs that shapes are kept"),
}


def included_packages() -> dict[str, set[str]]:
    layers = check_layers.layers()
    found: dict[str, set[str]] = {name: set() for name in PACKAGES}
    for layer in layers.values():
        if layer.package in found:
            found[layer.package] |= {layers[other].package for other in layer.allowed} - {layer.package}
        elif layer.package != "umbrellas":
            raise SystemExit(f"make_diagrams.py: {layer.package} has no place in the picture of the packages")
    core = next(iter(PACKAGES))
    # all stand on the core, and an arrow to it only from those that include nothing else
    return {name: included - {core} or included for name, included in found.items()}


def packages() -> Drawing:
    drawing, column, gap, row, height = Drawing(), 272.0, 24.0, 104.0, 58.0
    drawing.width, drawing.height = 3 * column + 4 * gap, 3 * row + height + 2 * gap

    def place(name: str) -> tuple[float, float, float]:
        level, left, right, _ = PACKAGES[name]
        return gap + left * (column + gap), gap + (3 - level) * row, (right - left) * (column + gap) - gap

    for name, included in included_packages().items():
        left, top, width = place(name)
        for other in sorted(included):
            of_left, of_top, of_width = place(other)
            if of_left <= left and left + width <= of_left + of_width:  # straight down
                drawing.arrow((left + width / 2, top + height), (left + width / 2, of_top), OLD, 1.6)
            else:
                side = 1 if of_left > left else -1
                drawing.arrow((left + width * (0.5 + 0.35 * side), top + height),
                              (of_left + of_width * (0.5 - 0.35 * side), of_top), OLD, 1.6)
    for name, (*_, content) in PACKAGES.items():
        left, top, width = place(name)
        drawing.box(left, top, width, height)
        drawing.text((left + width / 2, top + 25), name, 15, FINE, bold=True)
        drawing.text((left + width / 2, top + 45), content, 13)
    return drawing


def main() -> None:
    global COMMAND
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", type=Path, default=COMMAND, help="pn_subdivide")
    parser.add_argument("--check", action="store_true", help="write nothing, compare")
    arguments = parser.parse_args()
    COMMAND = arguments.command.resolve()
    wrong = []
    for name, make in (("refinements", refinements), ("stencils_quads", quad_stencils),
                       ("stencils_triangles", triangle_stencils), ("recognized_arcs", recognized_arcs), ("packages", packages)):
        path = FIG / f"{name}.svg"
        text = make().svg()
        if not arguments.check:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            wrong.append(f"{path.relative_to(ROOT)} is not what scripts/make_diagrams.py draws")
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
