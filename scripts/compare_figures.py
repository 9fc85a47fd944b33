#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Tells whether figures are what the present code draws.

  compare_figures.py DRAWN.svg COMMITTED.svg    texts must be equal, numbers nearly
  compare_figures.py DRAWN.png COMMITTED.png    colors must be nearly equal; needs VTK (Debian package python3-vtk9)

The exit code is 1 if they differ. Numbers may differ by half a unit of the drawing, which holds on
other processors too; of a picture's pixels one in a thousand may differ by more than a shade.
"""

import re
import sys
from pathlib import Path

NUMBER = re.compile(r"(?<![\w#])-?\d+\.?\d*(?!\w)")
TOLERANCE = 0.5
SHADE = 8
SHARE_OF_PIXELS = 1e-3


def difference_of_drawings(drawn: str, committed: str) -> str:
    for number, (a, b) in enumerate(zip(drawn.splitlines(), committed.splitlines()), 1):
        if NUMBER.sub("#", a) != NUMBER.sub("#", b):
            return f"line {number} has another text"
        for x, y in zip(map(float, NUMBER.findall(a)), map(float, NUMBER.findall(b))):
            if abs(x - y) > TOLERANCE:
                return f"line {number} has {y:g} instead of {x:g}"
    if len(drawn.splitlines()) != len(committed.splitlines()):
        return "another number of lines"
    return ""


def colors(path: Path):
    """An array of the lines, pixels and channels of a PNG file."""
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).astype(numpy.int16)


def difference_of_pictures(drawn: Path, committed: Path) -> str:
    a, b = colors(drawn), colors(committed)
    if a.shape != b.shape:
        return "another size"
    share = (abs(a - b).max(axis=2) > SHADE).mean()
    return f"{share:.1%} of the pixels differ" if share > SHARE_OF_PIXELS else ""


def main() -> int:
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    drawn, committed = map(Path, sys.argv[1:])
    if committed.suffix == ".svg":
        difference = difference_of_drawings(drawn.read_text(), committed.read_text())
    else:
        difference = difference_of_pictures(drawn, committed)
    if difference:
        print(f"{committed} is not what the present code draws ({drawn}): {difference}")
    return 1 if difference else 0


if __name__ == "__main__":
    sys.exit(main())
