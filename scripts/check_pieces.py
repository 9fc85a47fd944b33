#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Refinement in pieces at full size, with what it has to keep: the file is that of the whole surface, the memory of
a process with 50 million quads in 64 pieces is at most 300 MB, the time at most 1.25 of that of refining and
writing the whole, and two ranks take at most 0.6 of the time of one. Takes some minutes, 8 GB of disk and, for
the whole surface, 12 GB of memory. Exit code 1 if something is not kept. Two ranks need MPI in the command, and two idle cores.
"""

import argparse
import filecmp
import os
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

from control_meshes.mesh import Mesh, grid_quads
from control_meshes.output import as_text
from refinery import COMMAND, Usage, measured


def control_mesh() -> Mesh:
    """192 quads, 50 million after nine rounds"""
    return Mesh([(float(i), float(j), (i * 7 + j * 5) % 9 / 5) for j in range(17) for i in range(13)], list(grid_quads(13, 17)))


def with_attributes(mesh: Mesh) -> str:
    """With colors, numbers of faces, and texture coordinates with seams."""
    header, body = as_text(mesh, "control.ply").split("property list", 1)
    head, faces = header.split("element face")
    rows = body.split("end_header\n")[1].splitlines()
    lines = [head + "".join(f"property uchar {c}\n" for c in ("red", "green", "blue")) + f"element face{faces}"
             "property list uchar int vertex_indices\nproperty int part\nproperty list uchar float texcoord\nend_header"]
    count = len(mesh.points)
    lines += [f"{row} {v * 37 % 256} {255 - v % 200} 7" for v, row in enumerate(rows[:count])]
    for number, (row, face) in enumerate(zip(rows[count:], mesh.faces)):
        texture = " ".join(f"{v % 13 + (20 if number % 24 < 12 else 0)} {v // 13}" for v in face)
        lines.append(f"{row} {number % 3} {2 * len(face)} {texture}")
    return "\n".join(lines) + "\n"


class Check:
    def __init__(self, command: Path, work: Path) -> None:
        self.command, self.work, self.is_kept = command.resolve(), work, True

    def run(self, name: str, control: str, result: str, levels: int, *words: Any, launcher: tuple[str, ...] = ()) -> Usage:
        os.sync()
        usage = measured(*launcher, self.command, "surface", self.work / control, self.work / result,
                         "--scheme", "catmull-clark", "--levels", levels, "--quiet", *words)
        print(f"{name}: {usage.seconds:.2f} s, {usage.megabytes:.0f} MB", flush=True)
        return usage

    def keep(self, text: str, is_kept: bool) -> None:
        print(f"{'kept' if is_kept else 'NOT KEPT'}: {text}", flush=True)
        self.is_kept &= is_kept

    def same(self, first: str, second: str) -> None:
        self.keep(f"{second} is {first}", filecmp.cmp(self.work / first, self.work / second, shallow=False))

    def all_of(self, control: str, levels: int, with_whole: bool, at_full_size: bool) -> None:
        pieces = self.run("pieces", control, "pieces.ply", levels, "--pieces", 64)
        if at_full_size:
            self.keep("at most 300 MB", pieces.megabytes <= 300)
        if with_whole:
            whole = self.run("whole", control, "whole.ply", levels)
            if at_full_size:
                self.keep("at most 1.25 of the time of the whole", pieces.seconds <= 1.25 * whole.seconds)
            self.same("whole.ply", "pieces.ply")
            (self.work / "whole.ply").unlink()
        if shutil.which("mpirun"):
            ranks = self.run("ranks", control, "ranks.ply", levels, "--pieces", 64,
                             launcher=("mpirun", "--oversubscribe", "-n", "2"))
            if at_full_size:
                self.keep("two ranks in at most 0.6 of the time", ranks.seconds <= 0.6 * pieces.seconds)
            self.same("pieces.ply", "ranks.ply")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=Path, default=COMMAND)
    parser.add_argument("--folder", type=Path, help="for large files")
    parser.add_argument("--levels", type=int, default=9)
    parser.add_argument("--without-whole", action="store_true")
    options = parser.parse_args()
    os.environ |= {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    with tempfile.TemporaryDirectory(dir=options.folder) as work:
        check = Check(options.command, Path(work))
        (check.work / "control.off").write_text(as_text(control_mesh(), "control.off"))
        (check.work / "attributes.ply").write_text(with_attributes(control_mesh()))
        check.all_of("control.off", options.levels, not options.without_whole, True)
        check.all_of("attributes.ply", options.levels - 2 if options.levels > 3 else options.levels, True, False)
    return 0 if check.is_kept else 1


if __name__ == "__main__":
    sys.exit(main())
