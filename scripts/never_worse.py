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
0.12 on none; folds beyond 1.1 linear + 4 on 5 %, beyond 1.4 linear + 20 on none), or if the mean distance to FINE, a finer mesh
of the same part, is greater than the linear one; 2 if a mesh is refused, or there is none. Sharp edges are no folds.

  never_worse.py PN_SUBDIVIDE MESH... [--reference FINE] [-- OPTION...]

--reference is for one MESH. Options of the command are added to --normals estimate --sharp none, or replace these.
"""

import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

from control_meshes.files import read_mesh
from control_meshes.vector import dot, scaled, sub

OWN = {"--normals": "estimate", "--sharp": "none", "--levels": "2"}


def change(ratio: float) -> float:
    return abs(math.log(ratio)) if ratio > 0 else math.inf


def refine(command: str, mesh: str, options: list, folder: str):
    """the report of a run, and what it has written; nothing of a mesh that is refused"""
    refined, report = Path(folder) / "refined.off", Path(folder) / "report.json"
    own = [word for name, value in OWN.items() if name not in options for word in (name, value)]
    done = subprocess.run([command, mesh, str(refined), "--quiet", *own, *options, "--report", str(report)],
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode == 0:
        return json.loads(report.read_text()), refined
    print(f"refused: {done.stderr.strip().splitlines()[0] if done.stderr.strip() else mesh}")
    return None, refined


def to_segment(p, a, b) -> float:
    u, v = sub(b, a), sub(p, a)
    t = min(max(dot(u, v) / dot(u, u), 0), 1) if dot(u, u) > 0 else 0
    d = sub(v, scaled(u, t))
    return dot(d, d)


def to_triangle(p, a, b, c) -> float:
    """the squared distance"""
    u, v, w = sub(b, a), sub(c, a), sub(p, a)
    uu, uv, vv, uw, vw = dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)
    area = uu * vv - uv * uv
    if area > 0:
        s, t = (vv * uw - uv * vw) / area, (uu * vw - uv * uw) / area
        if s >= 0 and t >= 0 and s + t <= 1:
            d = sub(sub(w, scaled(u, s)), scaled(v, t))
            return dot(d, d)
    return min(to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a))


def mean_distance(path, fine: str) -> float:
    """of up to 500 vertices of a mesh from the faces of another one, in diagonals of that"""
    points = read_mesh(path).points
    points = points[::len(points) // 500 + 1]
    reference = read_mesh(Path(fine))
    corners = reference.points
    diagonal = math.dist(*([f(p[i] for p in corners) for i in range(3)] for f in (min, max)))
    balls = []
    for t in reference.triangles():
        three = [corners[v] for v in t]
        center = [sum(p[i] for p in three) / 3 for i in range(3)]
        balls.append((center, max(math.dist(center, p) for p in three), three))
    total = 0.0
    for p in points:
        near = [(math.dist(center, p), radius, three) for center, radius, three in balls]
        bound = min(d + radius for d, radius, _ in near)
        total += math.sqrt(min(to_triangle(p, *three) for d, radius, three in near if d - radius <= bound))
    return total / len(points) / diagonal


def is_farther(command: str, mesh: str, fine: str, options: list, folder: str) -> bool:
    distance = []
    for extra in ([], ["--roundness", "0"]):
        _, refined = refine(command, mesh, [*options, *extra], folder)
        distance.append(mean_distance(refined, fine))
    print(f"{Path(mesh).name}: mean distance {distance[0]:.2e} of the diagonal (linear {distance[1]:.2e})")
    return distance[0] > distance[1]


def main(arguments: list) -> int:
    end = arguments.index("--") if "--" in arguments else len(arguments)
    (command, *meshes), options = arguments[:end], arguments[end + 1:]
    fine = None
    if "--reference" in meshes:
        at = meshes.index("--reference")
        fine = meshes[at + 1]
        del meshes[at:at + 2]
    if not meshes or (fine and len(meshes) > 1):
        print("no mesh" if not meshes else "--reference is for one mesh")
        return 2
    refused = farther = False
    closed = swollen = much_swollen = all_meshes = folded = much_folded = all_folds = all_linear = 0
    with tempfile.TemporaryDirectory() as folder:
        for mesh in meshes:
            report, _ = refine(command, mesh, ["--check", *options], folder)
            refused = refused or report is None
            if report is None:
                continue
            c = report["check"]
            all_meshes += 1
            folds, linear = c["edges_folded_by_90_degrees"], c["linear_edges_folded_by_90_degrees"]
            all_folds, all_linear = all_folds + folds, all_linear + linear
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
            farther = farther or (fine is not None and is_farther(command, mesh, fine, options, folder))
    print(f"{all_meshes} meshes, {closed} closed: volume beyond linear by 0.05 on {swollen}, by 0.12 on {much_swollen};"
          f" folds beyond 1.1 linear + 4 on {folded}, beyond 1.4 linear + 20 on {much_folded},"
          f" {all_folds} in all (linear {all_linear})")
    fails = farther or swollen > 0.04 * closed or much_swollen > 0 or folded > 0.05 * all_meshes or much_folded > 0
    return 2 if refused else 1 if fails else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
