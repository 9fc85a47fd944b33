# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""A sheet of tiles, one mesh each, as a PNG."""

import struct
import zlib
from argparse import Namespace
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the renderer)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkObject
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex
from vtkmodules.vtkFiltersModeling import vtkHausdorffDistancePointSetFilter
from vtkmodules.vtkRenderingCore import (vtkLight, vtkRenderer, vtkRenderWindow, vtkTextActor,
                                         vtkWindowToImageFilter)

from . import actors
from .camera import View, fitted_view
from .files import points_of, read_mesh

GAP = 0.004
BAR_HEIGHT = 0.17  # of a tile's
SMALLEST_CAPTION = 9
ELLIPSIS = "\u2026"
COLORS = 240


def draw(options: Namespace, angles: tuple[float, float] | None) -> None:
    vtkObject.GlobalWarningDisplayOff()  # every failure has a line of its own
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # what newer versions print besides
    meshes = [read_mesh(path, options.checker is not None) for path in options.meshes]
    controls = [None if str(path) == "none" else read_mesh(path) for path in options.control]
    truth = read_mesh(options.truth) if options.truth else None
    limit = actors.scalar_limit(meshes, options.scalars, options.range) if options.scalars else 0.0
    columns = min(options.columns or int(np.ceil(np.sqrt(len(meshes)))), len(meshes))
    rows = -(-len(meshes) // columns)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    bar = round(BAR_HEIGHT * options.tile) if options.scalars else 0
    width, height = columns * options.tile, rows * options.tile + bar
    window.SetSize(width, height)
    window.AddRenderer(backdrop())
    view: View | None = None
    for i, mesh in enumerate(meshes):
        renderer = new_tile(i, columns, rows, bar / height)
        control = controls[i]
        if view is None or not options.same_view:
            seen = [*meshes, *controls] if options.same_view else [mesh, control]
            points = np.concatenate([points_of(m) for m in seen if m])
            view = fitted_view(points, angles, options.up)
        add_mesh(renderer, mesh, options, limit)
        if control:
            for actor in actors.control_edges(control):
                renderer.AddActor(actor)
            if options.control_normals:
                renderer.AddActor(actors.normal_needles(control))
        view.closer(options.zoom[i], *options.shift[i]).apply(renderer)
        window.AddRenderer(renderer)
        renderer.AddViewProp(caption(words_of(i, mesh, truth, options), options, renderer))
    if options.scalars:
        strip = vtkRenderer()
        strip.SetViewport(0, 0, 1, bar / height)
        strip.SetBackground(1.0, 1.0, 1.0)
        actors.add_scale_bar(strip, (width, bar), options.scalars, limit, options.cubic)
        window.AddRenderer(strip)
    save(window, options.output)


def backdrop() -> vtkRenderer:
    """Shows through the gaps between the tiles."""
    renderer = vtkRenderer()
    renderer.SetBackground(0.75, 0.77, 0.8)
    return renderer


def new_tile(i: int, columns: int, rows: int, below: float) -> vtkRenderer:
    """The part of the window `below` the tiles is for the scale bar."""
    row, column = divmod(i, columns)
    high, wide = (1 - below) / rows, 1 / columns
    renderer = vtkRenderer()
    renderer.SetViewport((column + GAP) * wide, 1 - (row + 1 - GAP) * high,
                         (column + 1 - GAP) * wide, 1 - (row + GAP) * high)
    renderer.SetBackground(1.0, 1.0, 1.0)
    for position, strength in (((-1, 1.2, 1.5), 0.85), ((1.5, 0.2, 1), 0.4), ((0, -1, 1), 0.35)):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetIntensity(strength)
        renderer.AddLight(light)
    return renderer


def add_mesh(renderer: vtkRenderer, mesh: vtkPolyData, options: Namespace, limit: float) -> None:
    surface = actors.surface(mesh, options.shading, options.edges, options.scalars, limit,
                              options.cubic)
    if options.checker:
        surface.SetTexture(actors.checker(mesh, options.checker))
    renderer.AddActor(surface)
    renderer.AddActor(actors.lone_vertices(mesh))
    if options.normals:
        renderer.AddActor(actors.normal_needles(mesh))


def words_of(i: int, mesh: vtkPolyData, truth: vtkPolyData | None, options: Namespace) -> str:
    faces = mesh.GetNumberOfPolys()
    if not options.caption:
        return f"{options.meshes[i].name}, {faces + mesh.GetNumberOfStrips()} faces"
    words = options.caption[i]
    if truth:
        triangles = mesh.GetPolys().GetNumberOfConnectivityIds() - 2 * faces
        words = words.replace("{triangles}", str(triangles))
        words = words.replace("{distance}", f"{100 * distance(mesh, truth) / truth.GetLength():.2g}")
    return words


def distance(a: vtkPolyData, b: vtkPolyData) -> float:
    """The largest from the vertices of either mesh to the other one."""
    measure = vtkHausdorffDistancePointSetFilter()
    measure.SetInputData(0, a)
    measure.SetInputData(1, b)
    measure.SetTargetDistanceMethodToPointToCell()
    measure.Update()
    return measure.GetHausdorffDistance()


def caption(words: str, options: Namespace, renderer: vtkRenderer) -> vtkTextActor:
    """In smaller letters where it is wider than the tile, and shortened where they become too small."""
    text = vtkTextActor()
    text.SetInput(words)
    margin = 0.03 * options.tile
    text.SetPosition(margin, 0.025 * options.tile)
    style = text.GetTextProperty()
    style.SetColor(0.1, 0.1, 0.1)
    size = max(10, options.tile // 20)
    style.SetFontSize(size)
    room = options.tile - 2 * margin
    while width_of(text, renderer) > room and size > SMALLEST_CAPTION:
        size -= 1
        style.SetFontSize(size)
    for kept in range(len(words) - 1, 0, -1):
        if width_of(text, renderer) <= room:
            break
        text.SetInput(words[:kept - kept // 2] + ELLIPSIS + words[len(words) - kept // 2:])
    return text


def width_of(text: vtkTextActor, renderer: vtkRenderer) -> float:
    box = [0.0] * 4
    text.GetBoundingBox(renderer, box)
    return box[1] - box[0]


def save(window: vtkRenderWindow, path: Path) -> None:
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    if not vtk_to_numpy(image.GetPointData().GetScalars()).any():
        raise RuntimeError("VTK drew nothing; does the virtual screen know OpenGL?")
    write_png(path, image)


def write_png(path: Path, image: vtkImageData) -> None:
    """With 240 colors at most, which makes a third of the size."""
    quantize = vtkImageQuantizeRGBToIndex()
    quantize.SetInputData(image)
    quantize.SetNumberOfColors(COLORS)
    quantize.Update()
    width, height = image.GetDimensions()[:2]
    indices = vtk_to_numpy(quantize.GetOutput().GetPointData().GetScalars())
    rows = indices.reshape(height, width)[::-1].astype(np.uint8)  # VTK counts from below
    table = quantize.GetLookupTable()
    colors = [[round(255 * c) for c in table.GetTableValue(i)[:3]]
               for i in range(table.GetNumberOfTableValues())]
    unfiltered = np.hstack([np.zeros((height, 1), np.uint8), rows])
    header = struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)
    content = (b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header)
               + _chunk(b"PLTE", bytes(c for color in colors for c in color))
               + _chunk(b"IDAT", zlib.compress(unfiltered.tobytes(), 9)) + _chunk(b"IEND", b""))
    try:
        path.write_bytes(content)
    except OSError as error:
        raise ValueError(f"{path}: cannot be written") from error


def _chunk(kind: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
