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
  compare_figures.py DRAWN.png COMMITTED.png    colors must be nearly equal

The exit code is 1 if they differ. Numbers may differ by half a unit of the drawing, which holds on
other processors too; of a picture's pixels one in a thousand may differ by more than a shade.
"""

import re
import struct
import sys
import zlib
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


def unfiltered(kind: int, line: bytes, above: bytes, step: int) -> bytes:
    """A line of a PNG file, of which the differences to predicted bytes are stored."""
    if kind == 0:
        return line
    out = bytearray(line)
    for i in range(len(out)):
        left = out[i - step] if i >= step else 0
        up = above[i]
        if kind == 1:
            predicted = left
        elif kind == 2:
            predicted = up
        elif kind == 3:
            predicted = (left + up) // 2
        else:
            corner = above[i - step] if i >= step else 0
            p = left + up - corner
            predicted = min(left, up, corner, key=lambda x: abs(p - x))  # the first of equals
        out[i] = (out[i] + predicted) & 255
    return bytes(out)


def pixels(path: Path) -> tuple[int, int, bytes]:
    """Width, height and the colors of a PNG file as VTK and render.py write it: 8 bits, RGB or a palette,
    not interlaced."""
    content = path.read_bytes()
    at, data, header, palette = 8, b"", b"", b""
    while at < len(content):
        size, kind = struct.unpack(">I4s", content[at:at + 8])
        body = content[at + 8:at + 8 + size]
        if kind == b"IHDR":
            header = body
        elif kind == b"PLTE":
            palette = body
        elif kind == b"IDAT":
            data += body
        at += size + 12
    width, height, bits, color, *_, interlaced = struct.unpack(">IIBBBBB", header)
    if bits != 8 or color not in (2, 3) or interlaced:
        raise SystemExit(f"{path}: only pictures of 8 bits, RGB or with a palette, not interlaced can "
                         "be compared")
    step = 3 if color == 2 else 1
    raw, stride = zlib.decompress(data), step * width + 1
    lines = [bytes(stride - 1)]
    for start in range(0, height * stride, stride):
        lines.append(unfiltered(raw[start], raw[start + 1:start + stride], lines[-1], step))
    colors = b"".join(lines[1:])
    if palette and color == 3:
        of_index = [palette[3 * i:3 * i + 3] for i in range(len(palette) // 3)]
        colors = b"".join(map(of_index.__getitem__, colors))
    return width, height, colors


def difference_of_pictures(drawn: Path, committed: Path) -> str:
    a, b = pixels(drawn), pixels(committed)
    if a[:2] != b[:2]:
        return "another size"
    others = {i // 3 for i, (x, y) in enumerate(zip(a[2], b[2])) if abs(x - y) > SHADE}
    share = len(others) / (a[0] * a[1])
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
