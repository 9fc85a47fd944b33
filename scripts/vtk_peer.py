#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The filters of VTK, told line by line what to do as benchmark/PN_subdivision_3/peers is."""

import resource
import sys
import time
from pathlib import Path

import vtk

from mesh_pictures.files import read_mesh

FILTERS = {
    "vtk/filter/loop": vtk.vtkLoopSubdivisionFilter,
    "vtk/filter/butterfly": vtk.vtkButterflySubdivisionFilter,
}


def run(job: str, mesh: vtk.vtkPolyData, rounds: int) -> str:
    subdivide = FILTERS[job]()
    subdivide.SetInputData(mesh)
    subdivide.SetNumberOfSubdivisions(rounds)
    faults = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    begin = time.perf_counter()
    subdivide.Update()
    seconds = time.perf_counter() - begin
    faults = resource.getrusage(resource.RUSAGE_SELF).ru_minflt - faults
    return f"{subdivide.GetOutput().GetNumberOfCells()} {seconds} {faults}"


def main() -> None:
    if sys.argv[1:] == ["--list"]:
        print("\n".join(FILTERS))
        return
    if sys.argv[1:] == ["--libraries"]:
        print("VTK", vtk.vtkVersion().GetVTKVersion())
        return
    held, mesh = "", None
    for line in sys.stdin:
        job, file, rounds, _ = line.split()
        if file != held:
            held, mesh = file, read_mesh(Path(file))
        print(run(job, mesh, int(rounds)), flush=True)


if __name__ == "__main__":
    main()
