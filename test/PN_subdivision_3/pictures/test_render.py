#!/usr/bin/python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""scripts/render.py draws, and says why where it does not. Exits 77 where what draws is not installed."""

import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
RENDER = ROOT / "scripts" / "render.py"
MESHES = ROOT / "data" / "meshes"
TILE = 96
LONG = "a caption much longer than the side of its tile, so that it does not fit"


def render(*words: object, **variables: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, str(RENDER), *map(str, words)], text=True,
                          capture_output=True, env=os.environ | variables)


def pixels(png: Path) -> list[list[tuple[int, int, int]]]:
    """The rows of a picture with a palette and unfiltered rows, as render.py writes them."""
    content, chunks = png.read_bytes(), {}
    at = 8
    while at < len(content):
        size, kind = struct.unpack(">I4s", content[at:at + 8])
        chunks[kind] = content[at + 8:at + 8 + size]
        at += 12 + size
    width, height = struct.unpack(">II", chunks[b"IHDR"][:8])
    colors, rows = chunks[b"PLTE"], zlib.decompress(chunks[b"IDAT"])
    lines = [rows[y * (width + 1) + 1:(y + 1) * (width + 1)] for y in range(height)]
    return [[tuple(colors[3 * i:3 * i + 3]) for i in line] for line in lines]


class Render(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.png = self.folder / "picture of ä.png"

    def draw(self, *words: object) -> list[list[tuple[int, int, int]]]:
        done = render("-o", self.png, "--tile", TILE, *words)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        return pixels(self.png)

    def test_surface_and_control_edges(self) -> None:
        for name in ("cube.off", "creature.obj", "sphere_triangles.ply"):
            with self.subTest(name):
                rows = self.draw("--control", MESHES / name, MESHES / name)
                inside = [c for row in rows for c in row]
                self.assertEqual(len(inside), TILE * TILE)
                blue = sum(b > r + 15 for r, g, b in inside)
                red = sum(r > b + 60 for r, g, b in inside)
                self.assertGreater(blue, TILE * TILE // 20)
                self.assertGreater(red, TILE // 2)

    def test_every_mesh_has_a_tile(self) -> None:
        rows = self.draw("--columns", 3, *[MESHES / "cube.off"] * 3)
        self.assertEqual((len(rows), len(rows[0])), (TILE, 3 * TILE))
        for tile in range(3):
            blue = sum(b > r + 15 for row in rows for r, g, b in row[tile * TILE:(tile + 1) * TILE])
            self.assertGreater(blue, TILE * TILE // 20)

    def test_shift_is_in_halves_of_the_picture(self) -> None:
        middles = []
        for shift in ("0,0", "0.5,-0.25"):
            rows = self.draw("--zoom", 0.5, f"--shift={shift}", "--caption", "", MESHES / "sphere_triangles.ply")
            blue = [(x, y) for y, row in enumerate(rows) for x, (r, g, b) in enumerate(row) if b > r + 15]
            middles.append([sum(p[i] for p in blue) / len(blue) for i in (0, 1)])
        # what is to the right comes to the middle; half of the picture without the zoom is a quarter with it
        self.assertAlmostEqual(middles[1][0] - middles[0][0], -0.5 * TILE / 4, delta=1.5)
        self.assertAlmostEqual(middles[1][1] - middles[0][1], -0.25 * TILE / 4, delta=1.5)

    def test_captions_end_before_their_tile(self) -> None:
        for caption in (LONG, "bearing housing, linear", "x" * 300):
            with self.subTest(caption):
                rows = self.draw("--caption", caption, MESHES / "cube.off")
                foot = [row[TILE - 3:TILE - 1] for row in rows[-TILE // 8:-2]]
                self.assertEqual({c for row in foot for c in row}, {(255, 255, 255)})
                self.assertTrue(any(sum(c) < 300 for row in rows[-TILE // 8:] for c in row))

    def test_a_short_caption_is_as_before(self) -> None:
        short = self.draw("--caption", "ab", MESHES / "cube.off")
        self.assertTrue(any(sum(c) < 300 for row in short[-TILE // 8:] for c in row[:TILE // 3]))

    def test_says_what_is_wrong_with_a_file(self) -> None:
        broken = self.folder / "broken.off"
        broken.write_text("OFF\n3 1 0\n0 0 0\n")
        for file, words in ((broken, "not a complete OFF"), (self.folder / "none.ply", "no such")):
            with self.subTest(file.name):
                done = render("-o", self.png, file)
                self.assertNotIn(done.returncode, (0, 69))
                self.assertIn(words, done.stderr)
                self.assertFalse(self.png.exists())

    def test_a_broken_vtk_is_not_taken_for_a_missing_one(self) -> None:
        fake = self.folder / "vtkmodules"
        fake.mkdir()
        for code, words in (("raise ImportError('libfoo.so: no such file')", "libfoo.so"),
                            ("", "vtkmodules")):
            with self.subTest(code):
                (fake / "__init__.py").write_text(code)
                done = render("-o", self.png, MESHES / "cube.off", PYTHONPATH=str(self.folder))
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(words, done.stderr)
                self.assertNotIn("install the package", done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1)
                self.assertFalse(self.png.exists())


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        trial = render("-o", Path(scratch) / "trial.png", "--tile", 16, MESHES / "cube.off")
    if trial.returncode == 69:
        print(f"left out: {trial.stderr.strip()}")
        sys.exit(77)
    unittest.main()
