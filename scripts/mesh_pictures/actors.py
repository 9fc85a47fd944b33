# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""What is drawn of a mesh: its surface, edges, normals, lone vertices, colors."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkPolyDataMapper,
                                         vtkProperty, vtkTexture)

try:
    from vtkmodules.vtkFiltersCore import vtkExtractEdges  # since VTK 9.2
except ImportError:
    from vtkmodules.vtkFiltersExtraction import vtkExtractEdges

from .files import (averaged_normals, normals_of, points_of, poly_data, set_normals,
                    vertices_without_face, with_split_normals)

OUTSIDE, INSIDE = (0.62, 0.71, 0.82), (0.93, 0.62, 0.32)
EDGE, CONTROL, NEEDLE = (0.15, 0.2, 0.3), (0.75, 0.1, 0.1), (0.1, 0.5, 0.2)
IN_FRONT = 66000.0  # an offset beyond all depths
SPLIT_ANGLE = 35.0  # degrees, for refined meshes
# of scalars, interpolated in CIELAB; those of pn_subdivide's --curvature
BLUE, WHITE, RED = ((r / 255, g / 255, b / 255)
                    for r, g, b in ((59, 76, 192), (242, 242, 242), (180, 4, 38)))


def surface(mesh: vtkPolyData, shading: str, edges: bool, scalars: str | None,
            limit: float, cubic: bool) -> vtkActor:
    mapper = vtkPolyDataMapper()
    shown = _with_normals(mesh, shading)
    mapper.SetInputData(shown)
    colored = scalars is not None and mesh.GetPointData().HasArray(scalars)
    if colored:
        mapper.SetLookupTable(colors(limit, cubic))
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(scalars)
        mapper.InterpolateScalarsBeforeMappingOff()
    else:
        mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    actor = vtkActor()
    actor.SetMapper(mapper)
    for color, inside in ((OUTSIDE, False), (INSIDE, True)):
        style = vtkProperty()
        style.SetColor(*color)
        if colored:  # light and shade would look like curvatures
            style.SetAmbient(0.6)
            style.SetDiffuse(0.35)
        else:
            style.SetSpecular(0.25)
            style.SetSpecularPower(30)
        style.SetEdgeVisibility(edges)
        style.SetEdgeColor(*EDGE)
        if normals_of(shown) is None:
            style.SetInterpolationToFlat()
        else:
            style.SetInterpolationToPhong()
        if inside:
            actor.SetBackfaceProperty(style)
        else:
            actor.SetProperty(style)
    return actor


def checker(mesh: vtkPolyData, squares: int) -> vtkTexture:
    """For the texture coordinates of a mesh: so many squares from 0 to 1."""
    if mesh.GetPointData().GetTCoords() is None:
        raise ValueError("--checker: not every mesh has texture coordinates")
    pixels = 64 * squares  # many, because they are blurred
    row = np.arange(pixels) * squares // pixels
    dark = (row[:, None] + row[None, :]) % 2 == 1
    colors = np.where(dark.ravel()[:, None], (70, 96, 150), (245, 240, 225)).astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(pixels, pixels, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.MipmapOn()
    texture.RepeatOn()
    return texture


def _with_normals(mesh: vtkPolyData, shading: str) -> vtkPolyData:
    """With the normals that the shading asks for; averages of the faces' where they are missing."""
    if shading == "split":
        return with_split_normals(mesh, SPLIT_ANGLE)
    given = None if shading == "averaged" else normals_of(mesh)
    result = vtkPolyData()
    result.ShallowCopy(mesh)
    if shading == "flat" or (shading == "auto" and given is None):
        result.GetPointData().SetNormals(None)
        return result
    averaged = averaged_normals(mesh)
    if given is not None:
        missing = ~given.any(axis=1)
        averaged = np.where(missing[:, None], averaged, given)
    set_normals(result, averaged)
    return result


def control_edges(mesh: vtkPolyData) -> list[vtkActor]:
    """Faint where the surface hides them."""
    extract = vtkExtractEdges()
    extract.SetInputData(mesh)
    extract.Update()
    faint = _lines_and_dots(extract.GetOutput(), CONTROL, 1.2)
    faint.GetProperty().SetOpacity(0.25)
    faint.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -IN_FRONT)
    return [faint, _lines_and_dots(extract.GetOutput(), CONTROL, 1.6)]


def normal_needles(mesh: vtkPolyData) -> vtkActor:
    normals, points = normals_of(mesh), points_of(mesh)
    if normals is None:
        return vtkActor()
    given = normals.any(axis=1)
    size = np.linalg.norm(np.ptp(points, axis=0)) * 0.05
    starts = points[given]
    ends = starts + size * normals[given]
    count = len(starts)
    needles = poly_data(np.concatenate([starts, ends]), lines=[(i, count + i) for i in range(count)])
    return _lines_and_dots(needles, NEEDLE, 1.5)


def lone_vertices(mesh: vtkPolyData) -> vtkActor:
    dots = poly_data(points_of(mesh), verts=[(int(v),) for v in vertices_without_face(mesh)])
    actor = _lines_and_dots(dots, CONTROL, 1.0)
    actor.GetProperty().SetPointSize(6)
    return actor


def _lines_and_dots(data: vtkPolyData, color: tuple[float, float, float],
                    width: float) -> vtkActor:
    data.GetPointData().Initialize()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -2.0)
    actor = vtkActor()
    actor.SetMapper(mapper)
    style = actor.GetProperty()
    style.SetColor(*color)
    style.SetLineWidth(width)
    style.LightingOff()
    return actor


def scalar_limit(meshes: list[vtkPolyData], name: str, wanted: float | None) -> float:
    """The value at the ends of the colors, one for all tiles. Meshes without scalars stay plain."""
    values = [mesh.GetPointData().GetArray(name) for mesh in meshes]
    values = [v for v in values if v is not None]
    if not values:
        raise ValueError(f"no mesh has a vertex array '{name}'")
    every = np.abs(np.concatenate([vtk_to_numpy(v) for v in values]))
    return wanted or float(np.percentile(every, 90)) or 1.0


def colors(limit: float, cubic: bool = False) -> vtkColorTransferFunction:
    """Cubic: by the cube root of the scalar, so that large and small ones have colors of their own."""
    table = vtkColorTransferFunction()
    table.SetColorSpaceToLab()
    if not cubic:
        for value, color in ((-limit, BLUE), (0.0, WHITE), (limit, RED)):
            table.AddRGBPoint(value, *color)
        return table
    even = colors(1.0)
    for t in np.linspace(-1, 1, 41):
        table.AddRGBPoint(limit * t**3, *even.GetColor(t))
    return table
