# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Cost a face against size: a panel for each scheme, both axes logarithmic, as SVG."""

import math
from pathlib import Path

from .measurements import Medians
from .page import Page, TITLES, size_name

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


def write(file: Path, medians: Medians) -> None:
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
