#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Draws the pieces of a PVTP file twice beside each other: each in a color, and all in one.

    pn_subdivide surface data/meshes/creature.obj creature.pvtp --levels 4 --pieces 12
    xvfb-run -a scripts/draw_pieces.py creature.pvtp pieces.png

Needs VTK (Debian package python3-vtk9). The pieces are read one by one, and shaded by their own normals: what
there is of seams shows in the picture on the right.
"""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import vtk

COLORS = [(0.86, 0.55, 0.45), (0.45, 0.65, 0.86), (0.55, 0.78, 0.5), (0.9, 0.8, 0.45), (0.7, 0.55, 0.85)]
GRAY = (0.75, 0.77, 0.8)


def actor(file, color):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.GetProperty().SetInterpolationToPhong()
    result.GetProperty().SetSpecular(0.35)
    result.GetProperty().SetSpecularPower(30)
    result.GetProperty().SetColor(*color)
    return result


def scene(pieces, colors, left):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetViewport(left, 0, left + 0.5, 1)
    for i, file in enumerate(pieces):
        renderer.AddActor(actor(file, colors[i % len(colors)]))
    renderer.ResetCamera()
    camera = renderer.GetActiveCamera()
    camera.Azimuth(25)
    camera.Elevation(20)
    camera.Zoom(2)
    renderer.ResetCameraClippingRange()
    return renderer


def main(pvtp, picture):
    pieces = [Path(pvtp).parent / p.get("Source") for p in ElementTree.parse(pvtp).iter("Piece")]
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(1400, 480)
    window.SetMultiSamples(8)
    window.AddRenderer(scene(pieces, COLORS, 0))
    window.AddRenderer(scene(pieces, [GRAY], 0.5))
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
