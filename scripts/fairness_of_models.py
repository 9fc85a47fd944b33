#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Prints the manual's table of models refined with estimated normals: the integrals of the squared mean curvature and of its
squared gradient, of the linear scheme and of reciprocal normals, over those of angle-weighted ones (Catmull-Clark,
roundness 1).

  fairness_of_models.py PN_SUBDIVIDE MESH...      needs VTK for Python (Debian package python3-vtk9)
"""

import sys
import tempfile
from pathlib import Path

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from refinery import Refinery

FACES = 60_000  # as many rounds as stay below, from 2 to 5


def rounds(path: Path) -> int:
    lines = path.read_text().splitlines()
    if path.suffix == ".off":
        faces = int(next(x for x in lines[1:] if x.strip() and x[0] != "#").split()[1])
    else:
        faces = sum(x.startswith("f ") for x in lines)
    return max(2, min(5, next(k for k in range(9) if faces * 4 ** (k + 1) > FACES)))


def integrals(path: Path) -> tuple[float, float]:
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    triangles.Update()
    mesh = triangles.GetOutput()
    p = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    h = vtk_to_numpy(mesh.GetPointData().GetArray("mean_curvature")).astype(float)
    t = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = p[t[:, 0]], p[t[:, 1]], p[t[:, 2]]
    n = numpy.cross(b - a, c - a)
    twice = numpy.linalg.norm(n, axis=1)
    good = twice > 1e-12 * twice.max()
    t, a, b, c, n, twice = t[good], a[good], b[good], c[good], n[good], twice[good]
    n /= twice[:, None]
    area = twice / 2
    gradient = (numpy.cross(n, c - b) * h[t[:, 0]][:, None] + numpy.cross(n, a - c) * h[t[:, 1]][:, None]
                + numpy.cross(n, b - a) * h[t[:, 2]][:, None]) / twice[:, None]
    squares = (h[t] ** 2).mean(axis=1)
    return float((area * squares).sum()), float((area * (gradient**2).sum(axis=1)).sum())


def main() -> None:
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as work:
        refinery = Refinery(Path(sys.argv[1]), Path(work))
        for mesh in map(Path, sys.argv[2:]):
            found = {}
            common = f"--scheme catmull-clark --curvature mean --levels {rounds(mesh)}"
            for way, options in (("linear", "--linear"), ("angle", "--normals angle --roundness 1"),
                                 ("reciprocal", "--normals reciprocal --roundness 1")):
                found[way] = integrals(refinery.file(mesh.resolve(), f"{common} {options}", "vtp"))
            row = [found[way][k] / found["angle"][k] for k in (0, 1) for way in ("reciprocal", "linear")]
            print(f"| {mesh.stem} | " + " | ".join(f"{x:.2f}" for x in row) + " |", flush=True)


if __name__ == "__main__":
    main()
