# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Mesh files as vtkPolyData."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkPolyDataNormals
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPPolyDataReader

import control_meshes.files

# the pieces of PVTP files are not joined
READERS = {".ply": vtkPLYReader, ".obj": vtkOBJReader, ".stl": vtkSTLReader,
           ".vtp": vtkXMLPolyDataReader, ".pvtp": vtkXMLPPolyDataReader}


def read_mesh(path: Path, with_texture: bool = False) -> vtkPolyData:
    suffix = path.suffix.lower()
    if suffix == ".off":
        try:
            lists = control_meshes.files.read_mesh(path)
            mesh = poly_data(lists.points, polys=lists.faces)
            if lists.normals:
                set_normals(mesh, np.array(lists.normals))
        except (ValueError, IndexError) as error:
            raise ValueError(f"{path}: not a complete OFF file") from error
    elif suffix in READERS:
        reader = READERS[suffix]()
        reader.SetFileName(str(path))
        if hasattr(reader, "SetDuplicatePointsForFaceTexture"):  # it joins points of other charts
            reader.SetDuplicatePointsForFaceTexture(False)
        reader.Update()
        mesh = reader.GetOutput()
        if suffix == ".obj" and with_texture:
            _join_materials(mesh)
        elif suffix == ".obj" and normals_of(mesh) is None:  # it doubles points where texture coordinates differ
            mesh.GetPointData().Initialize()
            mesh = _joined(mesh)
    else:
        raise ValueError(f"{path}: only .ply, .off, .obj, .stl, .vtp and .pvtp can be drawn")
    if mesh.GetNumberOfPoints() == 0:
        raise ValueError(f"{path}: holds no mesh")
    return mesh


Cells = Sequence[Sequence[int]]


def poly_data(points: np.ndarray | list[tuple[float, float, float]], verts: Cells = (), lines: Cells = (),
              polys: Cells = ()) -> vtkPolyData:
    mesh, place = vtkPolyData(), vtkPoints()
    place.SetData(numpy_to_vtk(np.array(points, float), deep=True))
    mesh.SetPoints(place)
    for cells, put in ((verts, mesh.SetVerts), (lines, mesh.SetLines), (polys, mesh.SetPolys)):
        array = vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell), cell)
        put(array)
    return mesh


def _join_materials(mesh: vtkPolyData) -> None:
    """VTK's OBJ reader has an array of texture coordinates for each material, -1 at all other points."""
    data = mesh.GetPointData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    of_materials = [vtk_to_numpy(a) for a in arrays if a and a.GetNumberOfComponents() == 2]
    if len(of_materials) < 2:
        return
    joined = of_materials[0].copy()
    for values in of_materials[1:]:
        missing = (joined == -1).all(axis=1)
        joined[missing] = values[missing]
    array = numpy_to_vtk(joined, deep=True)
    array.SetName("TCoords")
    data.SetTCoords(array)


def _joined(mesh: vtkPolyData) -> vtkPolyData:
    """With equal points joined."""
    join = vtkCleanPolyData()
    join.SetInputData(mesh)
    join.SetTolerance(0.0)
    join.Update()
    return join.GetOutput()


def points_of(mesh: vtkPolyData) -> np.ndarray:
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)


def normals_of(mesh: vtkPolyData) -> np.ndarray | None:
    normals = mesh.GetPointData().GetNormals()
    return None if normals is None else vtk_to_numpy(normals).astype(float)


def set_normals(mesh: vtkPolyData, normals: np.ndarray) -> None:
    array = numpy_to_vtk(normals.copy(), deep=True)
    array.SetName("Normals")
    mesh.GetPointData().SetNormals(array)


def averaged_normals(mesh: vtkPolyData) -> np.ndarray:
    """Vertex normals from the faces."""
    bare = vtkPolyData()
    bare.SetPoints(mesh.GetPoints())
    bare.SetPolys(mesh.GetPolys())
    normals = vtkPolyDataNormals()
    normals.SetInputData(bare)
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    return normals_of(normals.GetOutput())


def with_split_normals(mesh: vtkPolyData, degrees: float) -> vtkPolyData:
    """The mesh with vertex normals from the faces; vertices are doubled where faces meet at more
    than the angle."""
    joined = _joined(mesh)
    joined.GetPointData().SetNormals(None)
    normals = vtkPolyDataNormals()
    normals.SetInputData(joined)
    normals.SplittingOn()
    normals.SetFeatureAngle(degrees)
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def vertices_without_face(mesh: vtkPolyData) -> np.ndarray:
    used = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
    return np.setdiff1d(np.arange(mesh.GetNumberOfPoints()), used)
