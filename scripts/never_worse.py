#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""How many of some meshes swell or fold more than by the linear scheme, refined twice with normals and roundness read off
their points; exit code 1 if they are more than the manual says (volume beyond linear by 0.05 on 4 % of the closed ones, by
0.12 on none; folds beyond 1.1 linear + 4 on 5 %, beyond 1.4 linear + 20 on none).

  never_worse.py PN_SUBDIVIDE MESH... [-- OPTION...]      further options of the command, such as --normals reciprocal
"""

import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path


def change(ratio: float) -> float:
    return abs(math.log(ratio)) if ratio > 0 else math.inf


def check(command: str, mesh: str, options: list, folder: str):
    """what --check finds; nothing of a mesh that is refused"""
    report = Path(folder) / "report.json"
    run = [command, mesh, str(Path(folder) / "refined.ply"), "--levels", "2", "--check", "--quiet", "--normals", "estimate",
           "--sharp", "none"]
    done = subprocess.run([*run, *options, "--report", str(report)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode == 0:
        return json.loads(report.read_text())["check"]
    print(f"left out: {done.stderr.strip().splitlines()[0] if done.stderr.strip() else mesh}")
    return None


def main(arguments: list) -> int:
    end = arguments.index("--") if "--" in arguments else len(arguments)
    command, meshes, options = arguments[0], arguments[1:end], arguments[end + 1:]
    closed = swollen = much_swollen = all_meshes = folded = much_folded = 0
    with tempfile.TemporaryDirectory() as folder:
        for mesh in meshes:
            c = check(command, mesh, options, folder)
            if c is None:
                continue
            all_meshes += 1
            folds, linear = c["edges_folded_by_90_degrees"], c["linear_edges_folded_by_90_degrees"]
            folded += folds > 1.1 * linear + 4
            much_folded += folds > 1.4 * linear + 20
            line = f"{Path(mesh).name}: folds {folds} (linear {linear})"
            if c.get("volume") is not None:
                closed += 1
                excess = change(c["volume"]) - change(c["linear_volume"]) if c["linear_volume"] > 0 else 0
                swollen += excess > 0.05
                much_swollen += excess > 0.12
                line += f", volume {c['volume']:.3f} (linear {c['linear_volume']:.3f})"
            if folds > 1.1 * linear + 4 or c.get("swollen"):
                print(line)
    print(f"{all_meshes} meshes, {closed} closed: volume beyond linear by 0.05 on {swollen}, by 0.12 on {much_swollen};"
          f" folds beyond 1.1 linear + 4 on {folded}, beyond 1.4 linear + 20 on {much_folded}")
    fails = swollen > 0.04 * closed or much_swollen > 0 or folded > 0.05 * all_meshes or much_folded > 0
    return 1 if fails else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
