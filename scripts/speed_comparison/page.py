# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The tables of the page on speed, and its chart: cost a face against size."""

import math
from pathlib import Path

from .measurements import Median, Medians, Run

TITLES = {
    "catmull-clark": "Catmull-Clark",
    "loop": "Loop",
    "doo-sabin": "Doo-Sabin",
    "sqrt3": "&radic;3",
    "butterfly": "Butterfly",
    "kobbelt": "Kobbelt",
}
NAMES = {
    "pn/surface-mesh": "**this package, PN, `Surface_mesh`**",
    "pn-linear/surface-mesh": "this package, linear, `Surface_mesh`",
    "pn/polyhedron": "this package, PN, `Polyhedron_3`",
    "pn-linear/polyhedron": "this package, linear, `Polyhedron_3`",
    "cgal/surface-mesh": "CGAL, `Surface_mesh`",
    "cgal/polyhedron": "CGAL, `Polyhedron_3`",
    "opensubdiv/last-level": "OpenSubdiv, last level reduced",
    "opensubdiv/full-topology": "OpenSubdiv, full topology",
    "openmesh/mesh": "OpenMesh",
    "vtk/filter": "VTK",
    "floor/fresh": "*floor: the bytes of the result with normals, to fresh memory*",
    "floor/again": "*the same, to memory in use*",
    "pn/refiner": "`Surface_refiner`, PN",
    "pn-linear/refiner": "`Surface_refiner`, linear",
    "opensubdiv/stencils": "OpenSubdiv, table of stencils, `float`",
}
DETAILED = ("catmull-clark", "loop")  # the ratios and the chart have all
# CGAL has no interpolatory scheme for quads: Kobbelt's is beside its Catmull-Clark
BESIDE = {"kobbelt": "catmull-clark"}


def size_name(size: int) -> str:
    return f"{size // 1_000_000} M" if size >= 1_000_000 else f"{size // 1000} k"


def number(x: float) -> str:
    return f"{x:.0f}" if x >= 100 else f"{x:.1f}" if x >= 10 else f"{x:.2f}"


def table(header: list[str], rows: list[list[str]]) -> list[str]:
    lines = [header, ["---"] + ["---:"] * (len(header) - 1)] + rows
    return ["| " + " | ".join(line) + " |" for line in lines] + [""]


class Page:
    def __init__(self, medians: Medians):
        self.medians = medians
        self.schemes = [s for s in TITLES if any(r.scheme == s for r in medians)]
        self.detailed = [s for s in self.schemes if s in DETAILED]
        self.sizes = sorted({r.size for r in medians if (r.kind, r.process) == ("regular", "warm")})

    def find(self, scheme: str, job: str, size: int, threads: int = 1, kind: str = "regular",
             process: str = "warm") -> Median | None:
        m = self.medians.get(Run(scheme, kind, size, process, job, threads))
        beside = BESIDE.get(scheme, "")
        if m is None and beside and job.startswith("cgal/"):
            return self.find(beside, job, size, threads, kind, process)
        return m

    def tables_of_meshes(self, size: int) -> list[str]:
        """regular and other control meshes, fresh processes and huge pages"""
        columns = (("regular", "warm"), ("irregular", "warm"), ("real", "warm"),
                   ("regular", "fresh"), ("regular", "huge"))
        lines = []
        for scheme in self.detailed:
            rows = []
            for job in NAMES:
                found = [self.find(scheme, job, size, 1, *c) for c in columns]
                if any(found):
                    rows.append([NAMES[job]] + [number(m.ns_per_face()) if m else "" for m in found])
            lines += [f"### {TITLES[scheme]}", ""]
            lines += table(["", "regular", "irregular", "real", "regular, fresh process", "regular, huge pages"], rows)
        return lines

    def table_of_ratios(self) -> list[str]:
        """point-normal subdivision to CGAL's linear functions"""
        rows = []
        for scheme in self.schemes:
            for threads in (1, 2):
                row = [TITLES[scheme] + (", 2 threads" if threads == 2 else "")]
                for size in self.sizes:
                    pn = self.find(scheme, "pn/surface-mesh", size, threads)
                    other = self.find(scheme, "cgal/surface-mesh", size)
                    row.append(f"{pn.ns_per_face() / other.ns_per_face():.2f}" if pn and other else "")
                if any(row[1:]):
                    rows.append(row)
        return table([""] + [f"{size_name(s)}, / CGAL" for s in self.sizes], rows)

    def lines(self) -> list[str]:
        lines = ["", "## Ratios", ""] + self.table_of_ratios()
        size = max((r.size for r in self.medians if r.kind == "irregular"), default=self.sizes[-1])
        lines += ["## Whole jobs", "", f"Nanoseconds a refined face, about {size_name(size)} faces, one thread; the chart has other sizes. "
                  "A `Surface_refiner` and tables of stencils get all control points again.", ""]
        return lines + self.tables_of_meshes(size)


BEGIN, END = "<!-- begin of the tables -->", "<!-- end of the tables -->"


def write(page: Path, medians: Medians, machine: list[str]) -> None:
    """puts the tables between the marks of the page"""
    before, rest = page.read_text().split(BEGIN)
    after = rest.split(END)[1]
    lines = [BEGIN, ""] + [f"- {line}" for line in machine] + Page(medians).lines() + [END]
    page.write_text(before + "\n".join(lines) + after)


# --- the chart: a panel for each scheme, both axes logarithmic, as SVG ---

# job, threads, name, color, dashes
SERIES = (
    ("pn/surface-mesh", 1, "this package, point-normal", "#c1121f", ""),
    ("pn/surface-mesh", 2, "this package, point-normal, 2 threads", "#c1121f", "7 4"),
    ("pn-linear/surface-mesh", 1, "this package, linear", "#f08a24", ""),
    ("cgal/surface-mesh", 1, "CGAL, Surface_mesh", "#1d4e89", ""),
    ("cgal/polyhedron", 1, "CGAL, Polyhedron_3", "#1d4e89", "2 4"),
    ("opensubdiv/last-level", 1, "OpenSubdiv, last level reduced", "#2a9134", ""),
    ("opensubdiv/full-topology", 1, "OpenSubdiv, full topology", "#2a9134", "7 4"),
    ("openmesh/mesh", 1, "OpenMesh", "#7b4fa6", ""),
    ("vtk/filter", 1, "VTK", "#8a6d3b", ""),
    ("floor/fresh", 1, "floor: writing the result to fresh memory", "#444444", "2 4"),
)
PANEL_WIDTH, PANEL_HEIGHT = 270, 230
LEFT, TOP, GAP_X, GAP_Y = 56, 40, 52, 62
COLUMNS = 3
LOW, HIGH = 15, 3000  # ns a face


def text(x: float, y: float, words: str, more: str = "") -> str:
    words = words.replace("&radic;", "\u221a")
    return f'<text x="{x:.1f}" y="{y:.1f}" {more}>{words}</text>'


class Panel:
    def __init__(self, page: Page, scheme: str, x: float, y: float):
        self.page, self.scheme, self.x, self.y = page, scheme, x, y
        self.first, self.last = page.sizes[0] / 1.5, page.sizes[-1] * 1.5

    def at(self, size: float, cost: float) -> tuple[float, float]:
        across = math.log(size / self.first) / math.log(self.last / self.first)
        up = math.log(cost / LOW) / math.log(HIGH / LOW)
        return self.x + PANEL_WIDTH * across, self.y + PANEL_HEIGHT * (1 - up)

    def frame(self) -> list[str]:
        lines = [f'<rect x="{self.x}" y="{self.y}" width="{PANEL_WIDTH}" height="{PANEL_HEIGHT}" '
                 'fill="none" stroke="#888"/>',
                 text(self.x + PANEL_WIDTH / 2, self.y - 8, TITLES[self.scheme],
                      'text-anchor="middle" font-weight="bold"')]
        for cost in (20, 50, 100, 200, 500, 1000, 2000):
            _, y = self.at(self.first, cost)
            lines.append(f'<line x1="{self.x}" x2="{self.x + PANEL_WIDTH}" y1="{y:.1f}" y2="{y:.1f}" '
                         'stroke="#e2e2e2"/>')
            lines.append(text(self.x - 5, y + 4, str(cost), 'text-anchor="end"'))
        for size in self.page.sizes:
            x, _ = self.at(size, LOW)
            lines.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{self.y}" '
                         f'y2="{self.y + PANEL_HEIGHT}" stroke="#e2e2e2"/>')
            lines.append(text(x, self.y + PANEL_HEIGHT + 15, size_name(size), 'text-anchor="middle"'))
        return lines

    def curves(self) -> list[str]:
        lines = []
        for job, threads, _, color, dashes in SERIES:
            found = [self.page.find(self.scheme, job, size, threads) for size in self.page.sizes]
            points = [self.at(m.faces, min(max(m.ns_per_face(), LOW), HIGH)) for m in found if m]
            if points:
                path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
                lines.append(f'<polyline points="{path}" {line_style(color, dashes)}/>')
                lines += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.4" fill="{color}"/>'
                          for x, y in points]
        return lines


def line_style(color: str, dashes: str) -> str:
    return (f'fill="none" stroke="{color}" stroke-width="2"' +
            (f' stroke-dasharray="{dashes}"' if dashes else ""))


def legend(y: float, width: float) -> list[str]:
    lines = []
    per_column = math.ceil(len(SERIES) / COLUMNS)
    for i, (_, _, name, color, dashes) in enumerate(SERIES):
        x = LEFT + i // per_column * (width - LEFT) / COLUMNS
        row = y + 19 * (i % per_column)
        lines.append(f'<line x1="{x:.1f}" x2="{x + 34:.1f}" y1="{row}" y2="{row}" '
                     f'{line_style(color, dashes)}/>')
        lines.append(text(x + 41, row + 4, name))
    return lines


def write_chart(file: Path, medians: Medians) -> None:
    page = Page(medians)
    rows = math.ceil(len(page.schemes) / COLUMNS)
    width = LEFT + COLUMNS * PANEL_WIDTH + (COLUMNS - 1) * GAP_X + 14
    below = TOP + rows * PANEL_HEIGHT + (rows - 1) * GAP_Y + 52
    height = below + 19 * math.ceil(len(SERIES) / COLUMNS) + 6
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
             'font-family="sans-serif" font-size="12" fill="#222">',
             f'<rect width="{width}" height="{height}" fill="white"/>',
             text(LEFT, 16, "nanoseconds a refined face, against the number of refined faces; one "
                            "thread unless said otherwise")]
    for i, scheme in enumerate(page.schemes):
        panel = Panel(page, scheme, LEFT + i % COLUMNS * (PANEL_WIDTH + GAP_X),
                      TOP + 10 + i // COLUMNS * (PANEL_HEIGHT + GAP_Y))
        lines += panel.frame() + panel.curves()
    lines += legend(below, width)
    file.write_text("\n".join(lines + ["</svg>"]) + "\n")
