#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Peak memory and time of the command with borders, creases and limits, beside those without.

  compare_memory.py PN_SUBDIVIDE [--limit QUOTIENT]

A tube of 64 x 61 quads is refined to a million faces, smooth, with its border a curve, and with a crease in each case;
limits are sought of a tube of 400 x 500 quads, and of the same with two quads joined, about which alone a level has to be
refined; the same of a torus, and with a hole, by sqrt(3). Fails where a quotient of memory exceeds QUOTIENT."""

import argparse
import math
import os
import sys
import tempfile


def write_tube(name, rings, segments, joined=False):
    with open(name, "w") as f:
        for i in range(rings + 1):
            for j in range(segments):
                angle = 2 * math.pi * j / segments
                f.write(f"v {math.cos(angle)!r} {math.sin(angle)!r} {4 * i / rings!r}\n")
        vertex = lambda i, j: i * segments + j % segments + 1
        middle = rings // 2
        for i in range(rings):
            for j in range(segments):
                face = [vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)]
                if joined and i == middle and j == 1:
                    continue
                if joined and i == middle and j == 0:
                    face = [vertex(i, 0), vertex(i, 1), vertex(i, 2), vertex(i + 1, 2), vertex(i + 1, 1), vertex(i + 1, 0)]
                f.write("f " + " ".join(map(str, face)) + "\n")


def write_torus(name, rings, segments, hole=False):
    """Of triangles."""
    with open(name, "w") as f:
        for i in range(rings):
            for j in range(segments):
                a, b = 2 * math.pi * i / rings, 2 * math.pi * j / segments
                f.write(f"v {(3 + math.cos(b)) * math.cos(a)!r} {(3 + math.cos(b)) * math.sin(a)!r} {math.sin(b)!r}\n")
        vertex = lambda i, j: i % rings * segments + j % segments + 1
        for i in range(rings):
            for j in range(segments):
                if not (hole and i == j == 5):
                    f.write(f"f {vertex(i, j)} {vertex(i + 1, j)} {vertex(i + 1, j + 1)}\n"
                            f"f {vertex(i, j)} {vertex(i + 1, j + 1)} {vertex(i, j + 1)}\n")


def write_ring(name, rings, segments):
    first = rings // 2 * segments
    with open(name, "w") as f:
        edges = (f"{first + j} {first + (j + 1) % segments}" for j in range(segments))
        f.write("\n\n" + " ".join(edges) + "\n")


def measured(command):
    """Megabytes and seconds of the processor of a run."""
    process = os.spawnv(os.P_NOWAIT, command[0], command)
    _, status, usage = os.wait4(process, 0)
    if status != 0:
        sys.exit("failed: " + " ".join(command))
    return usage.ru_maxrss / 1024, usage.ru_utime + usage.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("--limit", type=float, default=math.inf)
    options = parser.parse_args()
    worst = 0
    with tempfile.TemporaryDirectory() as folder:
        name = lambda file: os.path.join(folder, file)
        write_tube(name("tube.obj"), 64, 61)
        write_tube(name("large.obj"), 400, 500)
        write_tube(name("joined.obj"), 400, 500, True)
        write_ring(name("ring.selection.txt"), 64, 61)
        write_torus(name("torus.obj"), 400, 500)
        write_torus(name("hole.obj"), 400, 500, True)
        limits = ["--levels", "0", "--limit", "--border", "curve"]
        sqrt3_limits = ["--levels", "0", "--limit", "--scheme", "sqrt3"]
        for title, input, arguments, is_first in (
                ("smooth", "tube.obj", ["--levels", "4"], True),
                ("border", "tube.obj", ["--levels", "4", "--border", "curve"], False),
                ("crease", "tube.obj", ["--levels", "4", "--sharp", name("ring.selection.txt")], False),
                ("smooth, obj", "tube.obj", ["--levels", "4"], True),
                ("both, obj", "tube.obj", ["--levels", "4", "--border", "curve", "--sharp", name("ring.selection.txt")], False),
                ("limits", "large.obj", limits, True),
                ("limits, two quads joined", "joined.obj", limits, False),
                ("limits, sqrt(3)", "torus.obj", sqrt3_limits, True),
                ("limits, sqrt(3), a hole", "hole.obj", sqrt3_limits, False)):
            output = name("out.obj" if "obj" in title else "out.ply")
            megabytes, seconds = measured([options.command, name(input), output, "--quiet", *arguments])
            if is_first:
                first = megabytes, seconds
            worst = max(worst, megabytes / first[0])
            print(f"{title:26} {megabytes:6.0f} MB {megabytes / first[0]:5.2f}   "
                  f"{seconds:6.2f} s {seconds / first[1]:5.2f}")
    sys.exit(1 if worst > options.limit else 0)


if __name__ == "__main__":
    main()
