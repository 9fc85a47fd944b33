#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Thirty bad inputs through CGAL, OpenMesh, OpenSubdiv and this package, as a page of the manual.

    scripts/compare_bad_input.py

Compiles benchmark/PN_subdivision_3/bad_input/peers_on_bad_input.cpp (packages libopenmesh-dev, libosd-dev), runs it with
the command in build/release, and writes doc/PN_subdivision_3/bad_input.txt.
"""

import re
from pathlib import Path

from refinery import COMMAND, ROOT, run

SOURCE = ROOT / "benchmark" / "PN_subdivision_3" / "bad_input" / "peers_on_bad_input.cpp"
WORK = ROOT / "build" / "peers"
PAGE = ROOT / "doc" / "PN_subdivision_3" / "bad_input.txt"


def version(header, name):
    match = re.search(rf"#\s*define\s+{name}\s+\"?([\w.]+)", Path("/usr/include", header).read_text())
    return match.group(1) if match else "?"


def table():
    WORK.mkdir(parents=True, exist_ok=True)
    program = WORK / "peers_on_bad_input"
    run("g++", "-std=c++17", "-O1", "-DNDEBUG", "-DNOMINMAX", "-w", "-frounding-math", f"-I{ROOT}/include",
        "-isystem", "/usr/include/eigen3", SOURCE, "-o", program, "-lOpenMeshCore", "-losdCPU", "-lgmp", "-lmpfr")
    return [line.split("\t") for line in run(program, COMMAND).splitlines()]


def page(rows):
    openmesh = int(version("OpenMesh/Core/System/config.h", "OM_VERSION"), 16)  # 0x90000
    versions = (f"CGAL {version('CGAL/version.h', 'CGAL_VERSION')}, OpenMesh {openmesh >> 16 & 15}.{openmesh >> 8 & 255}, "
                f"OpenSubdiv {version('opensubdiv/version.h', 'OPENSUBDIV_VERSION').lstrip('v').replace('_', '.')}")
    peers = rows[0][2::2]
    lines = [f"| input | {' | '.join(peers)} |", "| :-- " + "| :-: " * len(peers) + "|"]
    alike = {}
    for row in rows[1:]:
        alike.setdefault(tuple(row[2::2]), []).append(row[0])
    for verdicts, inputs in alike.items():
        cells = [f"<b>{c}</b>" if c in ("crash", "garbage", "hangs") else c for c in verdicts]
        lines.append(f"| {'; '.join(inputs)} | {' | '.join(cells)} |")
    newline = "\n"
    return f"""// written by scripts/compare_bad_input.py
namespace CGAL {{
/*!
\\page PN_subdivision_3_bad_input Bad Input, Here and Elsewhere

\\cgalAutoToc

{len(rows) - 1} inputs that are wrong or unusual, one round of Catmull-Clark (or Loop), each in a process of its own. Release builds with `NDEBUG`
of {versions}, this package, and its command with an OFF file:

- *right*: the result of the scheme; *accepts*: no oriented 2-manifold, but a finite result by the library's own rule;
- *refusal*: an exception, an error code or a null result before anything is refined, or the mesh cannot be made;
- <b>garbage</b>: coordinates that are not finite, missing elements, or a mesh where there is none, without an error;
- <b>crash</b>: ended by a signal; <b>hangs</b>: not done within 30 seconds of a processor.

CGAL and the functions of this package read a `Surface_mesh` of `add_face()`, and refuse what it refuses. Most bold entries violate a documented
precondition; an index beyond the vertices is an error of the program that builds the mesh.

{newline.join(lines)}

`scripts/compare_bad_input.py` writes this page; the inputs are in `benchmark/PN_subdivision_3/bad_input/Bad_inputs.h`.
*/
}} /* namespace CGAL */
"""


if __name__ == "__main__":
    PAGE.write_text(page(table()))
