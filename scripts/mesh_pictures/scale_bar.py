# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The scale of the colors, in a strip of its own below the tiles."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import (vtkActor2D, vtkPolyDataMapper2D, vtkRenderer,
                                         vtkTextActor)

from .actors import colors
from .files import poly_data

STEPS = 200
TICKS = (-1.0, -0.5, 0.0, 0.5, 1.0)
INK = (0.1, 0.1, 0.1)


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
