# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""A sheet of tiles, one mesh each, as a PNG."""

from argparse import Namespace
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the renderer)
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkLight, vtkRenderer, vtkRenderWindow, vtkTextActor,
                                         vtkWindowToImageFilter)

from . import actors
from .camera import View, fitted_view
from .files import points_of, read_mesh

GAP = 0.004
ROOM_FOR_BAR = 1.08


def draw(options: Namespace, angles: tuple[float, float] | None) -> None:
    vtkObject.GlobalWarningDisplayOff()  # every failure has a line of its own
    meshes = [read_mesh(path, options.checker is not None) for path in options.meshes]
    controls = [read_mesh(path) for path in options.control]
    if len(controls) == 1:
        controls *= len(meshes)
    limit = actors.scalar_limit(meshes, options.scalars, options.range) if options.scalars else 0.0
    columns = min(options.columns or square_columns(len(meshes)), len(meshes))
    rows = -(-len(meshes) // columns)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(columns * options.tile, rows * options.tile)
    window.AddRenderer(backdrop())
    view: View | None = None
    for i, mesh in enumerate(meshes):
        renderer = new_tile(i, columns, rows)
        control = controls[i] if controls else None
        if view is None or not options.same_view:
            seen = [*meshes, *controls] if options.same_view else [mesh, control]
            points = np.concatenate([points_of(m) for m in seen if m])
            view = fitted_view(points, angles, options.up)
            view.half_size *= ROOM_FOR_BAR if options.scalars else 1.0
        add_mesh(renderer, mesh, options, limit)
        if control:
            renderer.AddActor(actors.control_edges(control))
        renderer.AddViewProp(caption(i, mesh, options))
        view.apply(renderer)
        window.AddRenderer(renderer)
    save(window, options.output)


def square_columns(count: int) -> int:
    return int(np.ceil(np.sqrt(count)))


def backdrop() -> vtkRenderer:
    """Shows through the gaps between the tiles."""
    renderer = vtkRenderer()
    renderer.SetBackground(0.75, 0.77, 0.8)
    return renderer


def new_tile(i: int, columns: int, rows: int) -> vtkRenderer:
    row, column = divmod(i, columns)
    renderer = vtkRenderer()
    renderer.SetViewport(column / columns + GAP / columns, 1 - (row + 1) / rows + GAP / rows,
                         (column + 1) / columns - GAP / columns, 1 - row / rows - GAP / rows)
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetBackground2(0.86, 0.89, 0.93)
    renderer.GradientBackgroundOn()
    for position, strength in (((-1, 1.2, 1.5), 0.85), ((1.5, 0.2, 1), 0.4), ((0, -1, 1), 0.35)):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetIntensity(strength)
        renderer.AddLight(light)
    return renderer


def add_mesh(renderer: vtkRenderer, mesh: vtkPolyData, options: Namespace, limit: float) -> None:
    surface = actors.surface(mesh, options.shading, options.edges, options.scalars, limit)
    if options.checker:
        surface.SetTexture(actors.checker(mesh, options.checker))
    renderer.AddActor(surface)
    renderer.AddActor(actors.lone_vertices(mesh))
    if options.normals:
        renderer.AddActor(actors.normal_needles(mesh))
    if options.scalars:
        renderer.AddActor2D(actors.colour_bar(options.scalars, limit, caption_size(options)))


def caption(i: int, mesh: vtkPolyData, options: Namespace) -> vtkTextActor:
    count = mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips()
    text = vtkTextActor()
    text.SetInput(options.caption[i] if options.caption
                  else f"{options.meshes[i].name}, {count} faces")
    text.SetPosition(0.03 * options.tile, 0.025 * options.tile)
    style = text.GetTextProperty()
    style.SetFontSize(caption_size(options))
    style.SetColor(0.1, 0.1, 0.1)
    return text


def caption_size(options: Namespace) -> int:
    return max(10, options.tile // 30)


def save(window: vtkRenderWindow, path: Path) -> None:
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    if writer.GetErrorCode():
        raise ValueError(f"{path}: cannot be written")
