# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The surface rings of figure 6, one above the other."""

from pathlib import Path

from control_meshes.files import as_text
from control_meshes.mesh import Mesh
from control_meshes.vector import Vec, add
from refinery import Refinery

from .refined import Refined, refined

RINGS = 4
ABOVE, BESIDE, NARROWER = 0.55, 1.5, 0.6


def control_data(refinery: Refinery, m: int) -> Path:
    """Control points and normals of level m."""
    return refinery.file("bezier_6.ply", f"--scheme catmull-clark --levels {m} --output-normals control --ascii")


def bent(refinery: Refinery, m: int) -> Refined:
    """The point-normal surface over ring m - 1."""
    return refined(refinery, control_data(refinery, m), "--scheme catmull-clark --levels 2")


def flat(refinery: Refinery, m: int, k: int) -> Refined:
    """The linear surface of the control points of level m, k rings further."""
    return refined(refinery, control_data(refinery, m), f"--scheme catmull-clark --linear --levels {k + 2}")


def write_rings(refinery: Refinery, folder: Path) -> None:
    """(a) PN.ply, ring m of the point-normal surface over ring m - 1, with control.ply, its control points and normals;
    (b) linear.ply, for each level m the rings of the linear surface of its control points."""
    sheets = {name: Mesh([], [], []) for name in ("PN", "control", "linear")}
    for m in range(RINGS):
        _add(sheets["PN"], bent(refinery, m), 4, 8, (0.0, 0.0, m * ABOVE))
        _add(sheets["control"], Refined(control_data(refinery, m)), 0, 3, (0.0, 0.0, m * ABOVE))
        beside = BESIDE * (1 - NARROWER ** m) / (1 - NARROWER)
        for k in range(RINGS - m):
            _add(sheets["linear"], flat(refinery, m, k), 4, 8, (beside, 0.0, (m + k) * ABOVE))
    for name, sheet in sheets.items():
        path = folder / f"{name}.ply"
        path.write_text(as_text(sheet, path.name))


def _add(sheet: Mesh, mesh: Refined, inner: int, outer: int, by: Vec) -> None:
    """The faces between two layers around the first vertex, moved."""
    layer = mesh.layers(0, outer)
    faces = [f for f in mesh.faces if all(inner <= layer.get(v, -1) for v in f)]
    used = sorted({v for f in faces for v in f})
    number = {v: len(sheet.points) + i for i, v in enumerate(used)}
    sheet.points += [add(mesh.points[v], by) for v in used]
    assert sheet.normals is not None
    sheet.normals += [mesh.normals[v] if mesh.normals else mesh.normal_from_faces(v) for v in used]
    sheet.faces += [tuple(number[v] for v in f) for f in faces]
