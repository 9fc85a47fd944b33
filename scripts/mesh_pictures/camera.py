# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""From where a mesh is looked at."""

from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

MARGIN = 1.16
CAPTION = 0.05  # how far up the mesh moves, in half sizes, to leave the caption room
THREE_QUARTER = [(azimuth, elevation) for elevation in (22, 50) for azimuth in (-35, 35)]
# The rows take (right, away, up) of the viewer to the file's axes.
FRAMES = {"z": np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]], float),
          "y": np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], float),
          "x": np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]], float)}


@dataclass
class View:
    """A parallel projection: the viewer's axes as rows (right, away, up), center and half size."""

    axes: np.ndarray
    center: np.ndarray
    half_size: float

    def closer(self, zoom: float, right: float, up: float) -> "View":
        """Its middle is moved by half sizes."""
        middle = self.center + self.half_size * (right * self.axes[0] + up * self.axes[2])
        return View(self.axes, middle, self.half_size / zoom)

    def apply(self, renderer: vtkRenderer) -> None:
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*self.center)
        camera.SetPosition(*(self.center - 10 * self.half_size * self.axes[1]))
        camera.SetViewUp(*self.axes[2])
        camera.SetParallelScale(self.half_size)
        renderer.ResetCameraClippingRange()


def fitted_view(points: np.ndarray, angles: tuple[float, float] | None, up: str) -> View:
    """The given view of the points, or the three-quarter view that spreads them most."""
    candidates = THREE_QUARTER if angles is None else [angles]
    axes = max((_axes(a, up) for a in candidates), key=lambda axes: round(_spread(points, axes), 3))
    across = points @ axes.T
    low, high = across.min(axis=0), across.max(axis=0)
    half = max(high[0] - low[0], high[2] - low[2]) / 2 or 1.0
    middle = (low + high) / 2 - np.array([0, 0, CAPTION * half])
    return View(axes, middle @ axes, MARGIN * half)


def _axes(angles: tuple[float, float], up: str) -> np.ndarray:
    azimuth, elevation = np.radians(angles)
    ca, sa, ce, se = np.cos(azimuth), np.sin(azimuth), np.cos(elevation), np.sin(elevation)
    right = [ca, sa, 0]
    away = [-sa * ce, ca * ce, -se]
    upward = [-sa * se, ca * se, ce]
    return np.array([right, away, upward]) @ FRAMES[up]


def _spread(points: np.ndarray, axes: np.ndarray) -> float:
    """How little the points lie on one line in the picture, from 0 to 1: the thinner of the
    two principal extents against the largest extent of all."""
    centerd = points - points.mean(axis=0)
    flat = np.linalg.svd(centerd @ axes[[0, 2]].T, compute_uv=False)
    return flat[1] / (np.linalg.norm(centerd) or 1.0)
