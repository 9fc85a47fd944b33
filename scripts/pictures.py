#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Draws the pictures of the manual that scripts/pictures.toml describes.

  scripts/pictures.py [NAME...] [--command PN_SUBDIVIDE] [--output FOLDER]
  scripts/pictures.py --check [--command PN_SUBDIVIDE]    draws all in build/pictures; exit code 1 if any is out of date

NAME is a picture or a pattern of names, as 'creases_*'; without it all are drawn. A picture is left out, with the reason, if
its meshes cannot be had. Needs what scripts/render.py needs.
"""

import argparse
import fnmatch
import os
import re
import shlex
import shutil
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from control_meshes import pictured
from control_meshes.files import as_text, read_mesh
from control_meshes.mesh import Mesh
from paper_figures.refined import write_rings
from refinery import COMMAND, DATA, ROOT, Refinery, run

FIGURES = ROOT / "doc/PN_subdivision_3/fig"
CGAL_DATA = Path("/usr/share/doc/libcgal-demo/data.tar.gz")
FURNITURE = Path(os.environ.get("FURNITURE", "/usr/share/sweethome3d/furniture"))
Table = dict[str, Any]


class Missing(Exception):
    """Why meshes cannot be had."""


def put(value: Any, values: Table) -> Any:
    """With values in place of their names in braces, in all texts of a table."""
    if isinstance(value, str):
        for name, text in values.items():
            value = value.replace("{" + name + "}", str(text))
    elif isinstance(value, dict):
        return {key: put(x, values) for key, x in value.items()}
    elif isinstance(value, list):
        return [put(x, values) for x in value]
    return value


def all_pictures() -> dict[str, Table]:
    table = tomllib.loads((ROOT / "scripts/pictures.toml").read_text())
    return {put(name, row): put(picture, row) for name, picture in table.items() for row in picture.get("for", [{}])}


def tiles_of(picture: Table) -> list[Table]:
    common = {key: picture[key] for key in ("mesh", "as", "control") if key in picture}
    tiles = [dict(common | tile) for tile in picture["tiles"]]
    for tile in tiles:
        if "refine" in tile:
            tile["refine"] = f"{picture.get('refine', '')} {tile['refine']}"
    return [put(tile, row) for row in picture.get("rows", [{}]) for tile in tiles]


# --- control meshes ---


class Control_meshes:
    """Those of data/meshes where they are, others made in a folder when they are first asked for."""

    def __init__(self, command: Path, work: Path) -> None:
        self.command, self.work = command, work

    def find(self, name: str) -> Path:
        if (DATA / name).is_file():
            return DATA / name
        path = self.work / name
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            SOURCES[name.partition("/")[0]](self, path)
        return path

    def made(self, path: Path) -> None:
        path.write_text(as_text(pictured.MESHES[path.stem](), path.name))

    def readme(self, path: Path) -> None:
        """All that the commands of README.md write."""
        (path.parent / "data").symlink_to(ROOT / "data")
        for line in re.findall("(?m)^pn_subdivide (.*)", (ROOT / "README.md").read_text()):
            run(self.command.resolve(), *shlex.split(line), "--quiet", folder=path.parent)

    def cgal(self, path: Path) -> None:
        if not CGAL_DATA.exists():
            raise Missing(f"{CGAL_DATA} is missing (Debian package libcgal-demo)")
        with tarfile.open(CGAL_DATA) as archive:
            path.write_bytes(archive.extractfile(f"data/meshes/{path.name}").read())  # type: ignore[union-attr]

    def sweethome3d(self, path: Path) -> None:
        """COLLECTION/MODEL.obj"""
        if not FURNITURE.is_dir():
            raise Missing(f"{FURNITURE} is missing (Debian package sweethome3d-furniture)")
        collection = path.parent.name
        with zipfile.ZipFile(FURNITURE / f"{collection}.sh3f") as archive:
            path.write_bytes(archive.read(f"{collection.lower()}/{path.stem}/{path.name}"))

    def openscad(self, path: Path) -> None:
        """PART_SIDES.stl, with so many sides of a circle."""
        if not shutil.which("openscad"):
            raise Missing("openscad is missing (Debian package openscad)")
        part, sides = path.stem.rsplit("_", 1)
        run("openscad", "-q", "-D", f"$fn={sides}", "-o", path, ROOT / f"scripts/control_meshes/{part}.scad")

    def interpolate_samples(self, path: Path) -> None:
        run(self.example("interpolate_samples"), path.parent)

    def prescribe_normals(self, path: Path) -> None:
        folder = path.parent
        run(self.example("prescribe_normals"), DATA / "head.obj", folder)
        refinery = Refinery(self.command, folder)
        for when in ("before", "after"):  # both patches in one mesh
            left, right = (read_mesh(refinery.file(folder / f"{part}_{when}.ply", "--levels 0 --ascii")) for part in ("left", "right"))
            faces = left.faces + [tuple(len(left.points) + v for v in f) for f in right.faces]
            (folder / f"joined_{when}.ply").write_text(as_text(Mesh(left.points + right.points, faces), "joined.ply"))

    def rings(self, path: Path) -> None:
        write_rings(Refinery(self.command, path.parent), path.parent)

    def example(self, name: str) -> Path:
        """Built where the command is."""
        found = sorted(self.command.resolve().parents[2].glob(f"examples/*/{name}"))
        if not found:
            raise Missing(f"the example {name} is missing: scripts/build.sh {name} builds it")
        return found[0]


SOURCES: dict[str, Callable[[Control_meshes, Path], None]] = {
    "made": Control_meshes.made, "readme": Control_meshes.readme, "cgal": Control_meshes.cgal,
    "sweethome3d": Control_meshes.sweethome3d, "openscad": Control_meshes.openscad,
    "interpolate_samples": Control_meshes.interpolate_samples,
    "prescribe_normals": Control_meshes.prescribe_normals, "rings": Control_meshes.rings}


# --- drawing ---


class Drawing:
    """A picture; the meshes that are refined for it are in a folder of its own."""

    def __init__(self, control_meshes: Control_meshes, work: Path) -> None:
        self.control_meshes = control_meshes
        self.refinery = Refinery(control_meshes.command, work)

    def mesh(self, tile: Table) -> Path:
        result = self.control_meshes.find(tile["mesh"])
        if "refine" in tile:
            result = self.refinery.file(result, tile["refine"], tile.get("as", "vtp" if "--curvature" in tile["refine"] else "ply"))
        if not tile.get("every_second"):
            return result
        half = result.with_stem(result.stem + "_half")
        half.write_text(re.sub(r".*piece_\d*[13579]\.vtp.*\n", "", result.read_text()))
        return half

    def control(self, tile: Table) -> Path | str:
        match tile.get("control"):
            case None:
                return "none"
            case True:
                return self.control_meshes.find(tile["mesh"])
            case str(name):
                return self.control_meshes.find(name)
            case other:
                return self.mesh({"mesh": tile["mesh"]} | other)

    def draw(self, picture: Table, output: Path) -> None:
        tiles = tiles_of(picture)
        meshes = [self.mesh(tile) for tile in tiles]
        options = shlex.split(picture["draw"])
        if any("control" in tile for tile in tiles):
            options += [word for tile in tiles for word in ("--control", str(self.control(tile)))]
        for name, default in (("zoom", "1"), ("shift", "0,0")):
            if any(name in tile for tile in tiles):
                options += [f"--{name}={tile.get(name, default)}" for tile in tiles]
        if "truth" in picture:
            options += ["--truth", str(self.control_meshes.find(picture["truth"]))]
        options += [word for tile in tiles if "caption" in tile for word in ("--caption", tile["caption"])]
        output.parent.mkdir(parents=True, exist_ok=True)
        status = subprocess.run(["scripts/render.py", "--output", output, *options, *meshes], cwd=ROOT).returncode
        if status != 0:
            sys.exit(status)


def draw(names: list[str], command: Path, folder: Path) -> None:
    """All whose names match one; without names all."""
    chosen = {name: picture for name, picture in all_pictures().items()
              if not names or any(fnmatch.fnmatchcase(name, n) for n in names)}
    unknown = [n for n in names if not fnmatch.filter(chosen, n)]
    if unknown:
        sys.exit(f"pictures.py: no picture is named {', '.join(unknown)}")
    with tempfile.TemporaryDirectory() as work:
        control_meshes = Control_meshes(command, Path(work))
        for name, picture in chosen.items():
            try:
                with tempfile.TemporaryDirectory(dir=work) as refined:
                    Drawing(control_meshes, Path(refined)).draw(picture, folder.resolve() / f"{name}.png")
            except Missing as reason:
                print(f"left out: {name}: {reason}", file=sys.stderr)


def is_out_of_date(command: Path) -> bool:
    """Whether any picture, or number of the paper's figures, is not that of the present code; drawings (SVG) have tests."""
    drawn = ROOT / "build/pictures"
    shutil.rmtree(drawn, ignore_errors=True)
    draw([], command, drawn)
    commands = [["scripts/make_paper_figures.py", "--build", command.resolve().parents[2], "--check"]]
    commands += [["/usr/bin/python3", "-B", "scripts/compare_figures.py", path, FIGURES / path.relative_to(drawn)]
                 for path in sorted(drawn.rglob("*.png"))]
    return any([subprocess.run(words, cwd=ROOT).returncode != 0 for words in commands])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--command", type=Path, default=COMMAND, help="pn_subdivide")
    parser.add_argument("--output", type=Path, default=FIGURES, metavar="FOLDER")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    if arguments.check:
        sys.exit(is_out_of_date(arguments.command))
    draw(arguments.names, arguments.command, arguments.output)


if __name__ == "__main__":
    main()
