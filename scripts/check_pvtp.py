#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Reads with VTK what `pn_subdivide --pieces` writes as .pvtp, and compares it with the .vtp file of the whole
surface: the same points and normals, bit for bit, under the same numbers, and the same faces.

    scripts/check_pvtp.py COMMAND CONTROL_MESH [OPTION...]

Exit code 1 if they differ. Needs VTK (Debian package python3-vtk9).
"""

import shlex
import sys
import tempfile
from pathlib import Path

from vtkmodules.util.numpy_support import vtk_to_numpy

from mesh_pictures.files import read_mesh
from refinery import Refinery


def arrays(surface):
    """Points, normals, and the faces as lists of points."""
    polys = surface.GetPolys()
    offsets = vtk_to_numpy(polys.GetOffsetsArray())
    corners = vtk_to_numpy(polys.GetConnectivityArray())
    faces = [corners[b:e].tolist() for b, e in zip(offsets[:-1], offsets[1:])]
    normals = surface.GetPointData().GetNormals()
    return (vtk_to_numpy(surface.GetPoints().GetData()),
            None if normals is None else vtk_to_numpy(normals), faces)


def differences(whole, pieces) -> list[str]:
    points, normals, faces = arrays(whole)
    piece_points, piece_normals, piece_faces = arrays(pieces)
    vertex = vtk_to_numpy(pieces.GetPointData().GetGlobalIds())
    face = vtk_to_numpy(pieces.GetCellData().GetGlobalIds())
    found = []
    if sorted(set(face.tolist())) != list(range(len(faces))) or len(face) != len(faces):
        found.append(f"{len(face)} faces, {len(set(face.tolist()))} different ones of {len(faces)}")
    if set(vertex.tolist()) != set(range(len(points))):
        found.append(f"{len(set(vertex.tolist()))} different vertices of {len(points)}")
    if found:
        return found
    if points[vertex].tobytes() != piece_points.tobytes():
        found.append("points differ")
    if (normals is None) != (piece_normals is None):
        found.append("one of them has normals")
    elif normals is not None and normals[vertex].tobytes() != piece_normals.tobytes():
        found.append("normals differ")
    for number, corners in zip(face.tolist(), piece_faces):
        if vertex[corners].tolist() != faces[number]:
            found.append(f"face {number} differs")
            break
    return found


def main() -> None:
    command, control, *options = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        refinery, mesh, common = Refinery(Path(command), Path(folder)), Path(control).resolve(), shlex.join(options)
        found = differences(read_mesh(refinery.file(mesh, common, "vtp")),
                            read_mesh(refinery.file(mesh, f"--pieces 7 {common}", "pvtp")))
    sys.exit("\n".join(found) or 0)


if __name__ == "__main__":
    main()
