# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""What is drawn of a mesh: its surface, edges, normals, lone vertices, colors and their scale."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import (vtkActor, vtkActor2D, vtkColorTransferFunction, vtkPolyDataMapper,
                                         vtkPolyDataMapper2D, vtkProperty, vtkRenderer, vtkTextActor, vtkTexture)

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
STEPS = 200  # of the scale
TICKS = (-1.0, -0.5, 0.0, 0.5, 1.0)
INK = (0.1, 0.1, 0.1)
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


# --- the scale of the colors, in a strip of its own below the tiles ---


def add_scale_bar(renderer: vtkRenderer, size: tuple[int, int], name: str, limit: float,
                  cubic: bool) -> None:
    """From -limit to limit across the middle of the strip, with a title above and ticks below."""
    width, height = size
    length = min(0.6 * width, 12 * height)
    left, low, high = (width - length) / 2, 0.42 * height, 0.62 * height
    font = round(0.3 * height)
    renderer.AddActor2D(_band(left, length, low, high))
    title = name.replace("_", " ").capitalize()
    renderer.AddActor2D(_text(title, width / 2, 0.66 * height, font))
    for tick in TICKS:
        x = left + length * (tick + 1) / 2
        renderer.AddActor2D(_line(x, 0.34 * height, low))
        value = limit * (tick**3 if cubic else tick)
        number = f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"
        renderer.AddActor2D(_text(number.replace("-", "\u2212"), x, 0.02 * height,
                                  font))


def _band(left: float, length: float, low: float, high: float) -> vtkActor2D:
    table = colors(1.0)
    corners: list[tuple[float, float, float]] = []
    shades = np.empty((STEPS, 3), np.uint8)
    for i in range(STEPS):
        x, following = (left + length * k / STEPS for k in (i, i + 1))
        corners += [(x, low, 0), (following, low, 0), (following, high, 0), (x, high, 0)]
        shades[i] = [round(255 * c) for c in table.GetColor(2 * (i + 0.5) / STEPS - 1)]
    data = poly_data(corners, polys=[range(4 * i, 4 * i + 4) for i in range(STEPS)])
    data.GetCellData().SetScalars(numpy_to_vtk(shades, deep=True))
    return _flat(data)


def _line(x: float, low: float, high: float) -> vtkActor2D:
    actor = _flat(poly_data([(x, low, 0), (x, high, 0)], lines=[(0, 1)]))
    actor.GetProperty().SetColor(*INK)
    actor.GetProperty().SetLineWidth(2)
    return actor


def _flat(data: vtkPolyData) -> vtkActor2D:
    mapper = vtkPolyDataMapper2D()
    mapper.SetInputData(data)
    actor = vtkActor2D()
    actor.SetMapper(mapper)
    return actor


def _text(text: str, x: float, y: float, font_size: int) -> vtkTextActor:
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.SetPosition(x, y)
    style = actor.GetTextProperty()
    style.SetFontSize(font_size)
    style.SetColor(*INK)
    style.SetJustificationToCentered()
    return actor
