#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Peak memory and time of the command with borders, creases and limits, beside those without.

  compare_memory.py PN_SUBDIVIDE [--limit QUOTIENT]

A tube of 64 x 61 quads is refined to a million faces, smooth, with its border a curve, and with a crease in each case;
limits are sought of a tube of 400 x 500 quads, and of the same with two quads joined, about which alone a level has to be
refined; the same of a torus, and with a hole, by sqrt(3). Fails where a quotient of memory exceeds QUOTIENT."""

import argparse
import math
import sys
import tempfile
from pathlib import Path

from control_meshes.files import as_text
from control_meshes.mesh import Mesh, grid_quads
from refinery import measured
from speed_comparison import control_meshes

CREASE = 64 // 2 * 61  # its first vertex


def tube(rings: int, segments: int, is_joined: bool = False) -> Mesh:
    angles = [2 * math.pi * j / segments for j in range(segments)]
    points = [(math.cos(a), math.sin(a), 4 * i / rings) for i in range(rings + 1) for a in angles]
    faces = list(grid_quads(segments, rings + 1, "columns"))
    if is_joined:
        k = rings // 2 * segments
        (a, b, c, d), (_, e, f, _) = faces[k:k + 2]
        faces[k:k + 2] = [(a, b, e, f, c, d)]
    return Mesh(points, faces)


def torus(rings: int, segments: int, has_hole: bool = False) -> Mesh:
    """Of triangles; the hole has four sides."""
    mesh = control_meshes.tube(rings, segments, "triangles")
    if has_hole:
        k = 2 * (5 * segments + 5)
        del mesh.faces[k:k + 2]
    return mesh


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", type=Path)
    parser.add_argument("--limit", type=float, default=math.inf)
    options = parser.parse_args()
    worst = 0.0
    with tempfile.TemporaryDirectory() as work:
        folder = Path(work)
        for name, mesh in (("tube", tube(64, 61)), ("large", tube(400, 500)), ("joined", tube(400, 500, True)),
                           ("torus", torus(400, 500)), ("hole", torus(400, 500, True))):
            (folder / f"{name}.obj").write_text(as_text(mesh, f"{name}.obj"))
        crease = folder / "crease.selection.txt"
        crease.write_text("\n\n" + " ".join(f"{CREASE + j} {CREASE + (j + 1) % 61}" for j in range(61)) + "\n")
        limits = "--levels 0 --limit --border curve"
        sqrt3_limits = "--levels 0 --limit --scheme sqrt3"
        for title, mesh, arguments, is_first in (
                ("smooth", "tube", "--levels 4", True),
                ("border", "tube", "--levels 4 --border curve", False),
                ("crease", "tube", f"--levels 4 --sharp {crease}", False),
                ("smooth, obj", "tube", "--levels 4", True),
                ("both, obj", "tube", f"--levels 4 --border curve --sharp {crease}", False),
                ("limits", "large", limits, True),
                ("limits, two quads joined", "joined", limits, False),
                ("limits, sqrt(3)", "torus", sqrt3_limits, True),
                ("limits, sqrt(3), a hole", "hole", sqrt3_limits, False)):
            output = folder / ("out.obj" if "obj" in title else "out.ply")
            usage = measured(options.command.resolve(), folder / f"{mesh}.obj", output, "--quiet", *arguments.split())
            if is_first:
                first = usage
            worst = max(worst, usage.megabytes / first.megabytes)
            print(f"{title:26} {usage.megabytes:6.0f} MB {usage.megabytes / first.megabytes:5.2f}   "
                  f"{usage.processor:6.2f} s {usage.processor / first.processor:5.2f}")
    return 1 if worst > options.limit else 0


if __name__ == "__main__":
    sys.exit(main())
