# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Pictures as PNG files with 240 colors at most, which are a third of the size of others."""

import struct
import zlib
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex

COLORS = 240


def write_png(path: Path, image: vtkImageData) -> None:
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
