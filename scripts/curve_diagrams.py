# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The diagram of recognized arcs, for make_diagrams.py: a drawing of lines and arcs, refined in three ways."""

import math
import subprocess
import tempfile
from pathlib import Path
from typing import Callable

Point = tuple[float, float]

UNIT = 34  # pixels per unit of length
GRAY, DARK, BLUE = "#b8b8b8", "#333333", "#1f4e79"
WAYS = (("linear", ["--linear"]), ("point-normal", []), ("with --sharp arcs", ["--sharp", "arcs"]))


def rounded_plate() -> list[Point]:
    """A plate with two round corners in three steps, two sharp ones, and a round notch in six."""
    def arc(x: float, y: float, radius: float, start: int, end: int, steps: int) -> list[Point]:
        turns = [math.radians(start + (end - start) * i / steps) for i in range(steps + 1)]
        return [(round(x + radius * math.cos(t), 7), round(y + radius * math.sin(t), 7)) for t in turns]

    return arc(1, 1, 1, 180, 270, 3) + arc(5, 1, 1, 270, 360, 3) + [(6.0, 3.0)] + arc(3, 3, 1, 0, -180, 6) + [(0.0, 3.0)]


def refined(command: Path, points: list[Point], options: list[str]) -> list[Point]:
    with tempfile.TemporaryDirectory() as folder:
        control, result = Path(folder) / "control.txt", Path(folder) / "refined.txt"
        control.write_text("".join(f"{x!r} {y!r}\n" for x, y in points))
        subprocess.run([command, "curve", control, result, "--closed", "--levels", "4", "--quiet", *options], check=True)
        rows = [line.split() for line in result.read_text().splitlines()]
    return [(float(row[0]), float(row[1])) for row in rows if row and row[0] != "#"]


def draw_recognized_arcs(drawing, command: Path) -> None:  # type: ignore[no-untyped-def]
    points = rounded_plate()
    left, top = 24.0, 30.0
    for title, options in WAYS:
        place = _placed(left, top + 3 * UNIT)
        drawing.items.append(_outline([place(p) for p in points], GRAY, 1.5))
        drawing.items.append(_outline([place(p) for p in refined(command, points, options)], BLUE, 2))
        for p in points:
            drawing.dot(place(p), 2.4, "white", DARK)
        drawing.text((left + 3 * UNIT, top + 3 * UNIT + 34), title, 13)
        left += 6 * UNIT + 36
    drawing.width, drawing.height = left - 12, top + 3 * UNIT + 52


def _placed(left: float, bottom: float) -> Callable[[Point], Point]:
    return lambda p: (left + UNIT * p[0], bottom - UNIT * p[1])


def _outline(points: list[Point], color: str, width: float) -> str:
    numbers = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polygon points="{numbers}" fill="none" stroke="{color}" stroke-width="{width}"/>'
