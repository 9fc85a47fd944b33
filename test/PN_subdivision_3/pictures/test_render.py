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

    def test_hidden_control_edges_are_faint(self) -> None:
        """All edges of a smaller cube inside the surface."""
        small = (MESHES / "cube.off").read_text().splitlines()
        corners = [" ".join(str(0.6 * float(x)) for x in line.split()) for line in small[2:10]]
        (self.folder / "small.off").write_text("\n".join(small[:2] + corners + small[10:]))
        rows = self.draw("--view", "front", "--control", self.folder / "small.off", MESHES / "cube.off")
        edge = [r - b for row in rows for r, g, b in row if r > b + 8]
        self.assertGreater(len(edge), TILE)  # most of a square
        self.assertLess(max(edge), 130)  # solid: 166

    def test_stl(self) -> None:
        triangle = "\n".join(f"vertex {p}" for p in ("0 0 0", "1 0 0", "0 0 1"))
        stl = f"solid a\nfacet normal 0 1 0\nouter loop\n{triangle}\nendloop\nendfacet\nendsolid\n"
        (self.folder / "a.stl").write_text(stl)
        self.draw(self.folder / "a.stl")

    def test_texture_coordinates_of_ply_do_not_move_points(self) -> None:
        """Two squares with the same ones and a seam across each: VTK joins points of both."""
        vertices = "".join(f"{x} 0 {z}\n" for at in (0, 5) for x, z in ((at, 0), (at + 1, 0), (at + 1, 1), (at, 1)))
        header = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
        faces, texture = ("3 0 1 2", "3 0 2 3", "3 4 5 6", "3 4 6 7"), ("6 0 0 1 0 1 1", "6 .1 0 .9 1 0 1") * 2
        lists = "element face 4\nproperty list uchar int vertex_indices\n"
        (self.folder / "a.ply").write_text(f"{header}{lists}end_header\n{vertices}" + "\n".join(faces) + "\n")
        (self.folder / "b.ply").write_text(
            f"{header}{lists}property list uchar float texcoord\nend_header\n{vertices}"
            + "".join(f"{f} {t}\n" for f, t in zip(faces, texture)))
        self.assertEqual(*(self.draw("--view", "front", "--caption", "", self.folder / name)
                           for name in ("a.ply", "b.ply")))

    def test_a_checker_on_two_materials(self) -> None:
        square = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        one, two = "f 1/1 2/2 3/3\n", "f 1/1 3/3 4/4\n"
        pictures = []
        for name, faces in (("a.obj", one + two), ("b.obj", f"usemtl a\n{one}usemtl b\n{two}")):
            (self.folder / name).write_text(square + faces)
            pictures.append(self.draw("--view", "front", "--caption", "", "--checker", 3, self.folder / name))
        self.assertEqual(*pictures)

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

    def test_a_tile_of_its_own_zoom(self) -> None:
        ball = MESHES / "sphere_triangles.ply"
        both = self.draw("--zoom", 0.5, "--zoom", 2, "--shift", "0,0", "--shift=0.5,0", "--caption", "", "--caption", "", ball, ball)
        for i, zoom, shift in ((0, 0.5, "0,0"), (1, 2, "0.5,0")):
            alone = self.draw("--zoom", zoom, f"--shift={shift}", "--caption", "", ball)
            blue, expected = ([[b > r + 15 for r, g, b in row] for row in rows]
                              for rows in ([row[i * TILE:(i + 1) * TILE] for row in both], alone))
            self.assertLess(sum(a != b for x, y in zip(blue, expected) for a, b in zip(x, y)), TILE // 4)

    def test_captions_tell_triangles_and_distance(self) -> None:
        """A cube and one of 11/10 its size, whose corners are 0.1/2.2 of their diagonal from the smaller cube."""
        lines = (MESHES / "cube.off").read_text().splitlines()
        corners = [" ".join(str(1.1 * float(x)) for x in line.split()) for line in lines[2:10]]
        (self.folder / "larger.off").write_text("\n".join(lines[:2] + corners + lines[10:]))
        told, typed = (self.draw("--truth", self.folder / "larger.off", "--caption", words, MESHES / "cube.off")
                       for words in ("{triangles}, {distance}", "12, 4.5"))
        self.assertEqual(told, typed)

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
