#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The example subdivide_control_meshes, which scripts/demo.sh runs, on files of any origin.

  test_control_meshes.py PROGRAM
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CUBE = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def off(points: list[tuple[float, ...]], faces: list[tuple[int, ...]]) -> str:
    rows = [f"OFF\n{len(points)} {len(faces)} 0"]
    rows += [" ".join(map(str, p)) for p in points]
    rows += [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(rows) + "\n"


def triangles() -> list[tuple[int, ...]]:
    return [t for a, b, c, d in SIDES for t in ((a, b, c), (a, c, d))]


def stl() -> str:
    facets = "".join("facet normal 0 0 0\nouter loop\n"
                     + "".join("vertex {} {} {}\n".format(*CUBE[v]) for v in t)
                     + "endloop\nendfacet\n" for t in triangles())
    return f"solid cube\n{facets}endsolid cube\n"


def obj() -> str:
    return "".join("v {} {} {}\n".format(*p) for p in CUBE) + "".join(
        "f " + " ".join(str(v + 1) for v in f) + "\n" for f in SIDES)


def ply(faces: list[tuple[int, ...]]) -> str:
    return (f"ply\nformat ascii 1.0\nelement vertex {len(CUBE)}\nproperty float x\nproperty float y\n"
            f"property float z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\n"
            "end_header\n" + "".join("{} {} {}\n".format(*p) for p in CUBE)
            + "".join(" ".join(map(str, (len(f), *f))) + "\n" for f in faces))


def corners_apart() -> str:
    points = [CUBE[v] for f in SIDES for v in f]
    return off(points, [tuple(range(4 * i, 4 * i + 4)) for i in range(6)])


class Control_meshes(unittest.TestCase):
    program = ""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_on(self, name: str, text: str | None, *options: str) -> subprocess.CompletedProcess[str]:
        if text is not None:
            (self.folder / name).write_text(text)
        return subprocess.run([self.program, "-o", str(self.folder / "out"), *options,
                               str(self.folder / name)], text=True, capture_output=True)

    def result(self, name: str) -> tuple[int, int]:
        """Numbers of vertices and faces."""
        lines = (self.folder / "out" / name).read_bytes().split(b"end_header")[0].decode().split("\n")
        count = {line.split()[1]: int(line.split()[2]) for line in lines
                 if line.startswith("element")}
        self.assertFalse([line for line in lines if "property" in line and line.endswith("nx")])
        return count["vertex"], count["face"]

    def test_a_cube_in_all_formats_and_states(self) -> None:
        # a closed surface of genus 0: of the result, V - F = 2 with quads, 2V - F = 4 with triangles
        flipped = [f[::-1] if i % 2 else f for i, f in enumerate(SIDES)]
        for name, text, is_repaired in (
                ("c.off", off(CUBE, SIDES), False), ("c.obj", obj(), False), ("c.stl", stl(), False),
                ("c.ply", ply(SIDES), False), ("C.OFF", off(CUBE, SIDES), False),
                ("two words ä ß.off", off(CUBE, SIDES), False),
                ("inside_out.off", off(CUBE, [f[::-1] for f in SIDES]), False),
                ("flipped.ply", ply(flipped), True), ("apart.off", corners_apart(), True),
                ("twice.off", off(CUBE, SIDES + SIDES[:2]), True),
                ("unused.off", off(CUBE + [(9, 9, 9)], SIDES), True)):
            with self.subTest(name):
                done = self.run_on(name, text)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual("repaired" in done.stdout, is_repaired, done.stdout)
                stem = Path(name).stem
                for kind in ("linear", "point_normal"):
                    vertices, faces = self.result(f"{stem}_{kind}.ply")
                    if name.endswith("stl"):
                        self.assertEqual((2 * vertices - faces, faces), (4, 12 * 4 ** 5))
                    else:
                        self.assertEqual((vertices - faces, faces), (2, 6 * 4 ** 5))

    def test_edges_with_three_faces_are_cut(self) -> None:
        fin = off(CUBE + [(2, 2, 2)], triangles() + [(0, 1, 8)])
        done = self.run_on("fin.off", fin)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("non-manifold", done.stdout)
        self.assertEqual(self.result("fin_linear.ply")[1], 13 * 4 ** 5)

    def test_sharp_edges(self) -> None:
        for degrees, number in (("60", 12), ("95", 0), ("180", 0)):
            with self.subTest(degrees):
                done = self.run_on("cube.off", off(CUBE, SIDES), "--sharp", degrees)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(done.stdout.splitlines()[1].split()[3], str(number))

    def test_one_line_for_what_is_no_mesh(self) -> None:
        far = CUBE[:7] + [(1, 1, "nan")]
        for name, text in (("none.off", None), ("empty.off", ""), ("empty.ply", ""),
                           ("short.off", "OFF\n8 6 0\n0 0 0\n"), ("cube.txt", off(CUBE, SIDES)),
                           ("points.ply", ply([])), ("beyond.ply", ply([(0, 1, 99)])),
                           ("beyond.off", off(CUBE, [(0, 1, 99)])), ("points.off", off(CUBE, [])),
                           ("thin.off", off(CUBE, [(0, 1, 1)])), ("nan.off", off(far, SIDES)),
                           ("letters.stl", "no mesh at all"), ("letters.obj", "no mesh at all")):
            with self.subTest(name):
                done = self.run_on(name, text)
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn(f"{name}: ", done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertFalse(list((self.folder / "out").glob("*")))


if __name__ == "__main__":
    Control_meshes.program = sys.argv.pop()
    unittest.main()
