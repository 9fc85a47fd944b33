#!/usr/bin/python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Draws meshes (PLY, OFF, OBJ, STL, VTP, PVTP) side by side into one PNG, without a screen.

Needs the Debian packages python3-vtk9, python3-numpy and xvfb (--no-install-recommends is enough).

  scripts/render.py -o sheet.png data/meshes/*.ply
  scripts/render.py -o pn.png --control data/meshes/creature.obj out/creature_5.ply

Meshes with normals are shaded smoothly, others flat; insides (seen from behind) are orange, and
vertices without a face are dots. The exit status is 69 if what draws is not installed.
"""

import argparse
import importlib.util
import os
import subprocess
import sys
from pathlib import Path

WORKER = "PN_SUBDIVISION_RENDER_WORKER"
NOT_INSTALLED = 69  # the exit status where what draws is missing, as in sysexits.h
VIEWS = {"front": (0, 0), "right": (90, 0), "back": (180, 0), "left": (-90, 0),
         "top": (0, 90), "bottom": (0, -90)}


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="+", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True, help="the PNG file")
    parser.add_argument("--view", default="auto", metavar="VIEW",
                        help=f"auto (three-quarter), {', '.join(VIEWS)}, or AZIMUTH,ELEVATION in "
                             "degrees from the front, which looks along +y (write --view=-35,20)")
    parser.add_argument("--up", choices="xyz", default="z", help="the upward axis (default: z)")
    parser.add_argument("--same-view", action="store_true",
                        help="one view and scale, which fits all")
    parser.add_argument("--shading", choices=("auto", "smooth", "averaged", "split", "flat"),
                        default="auto", help="averaged: by the faces alone, whatever the normals; "
                                             "split: the same, but not across sharp edges")
    parser.add_argument("--edges", action="store_true", help="draw the edges of the faces")
    parser.add_argument("--normals", action="store_true", help="draw the vertex normals")
    parser.add_argument("--control", type=Path, action="append", metavar="MESH",
                        help="draw this mesh's edges over it, faint where it hides them; once for all, or once per mesh "
                             "('none' for a mesh that has none)")
    parser.add_argument("--control-normals", action="store_true",
                        help="draw the vertex normals of these meshes too")
    parser.add_argument("--scalars", metavar="NAME",
                        help="color by this vertex array of VTP files, symmetric about 0; meshes "
                             "without it stay plain")
    parser.add_argument("--range", type=float, metavar="MAX",
                        help="the scalar at the ends of the colors (default: 90th percentile)")
    parser.add_argument("--cubic", action="store_true",
                        help="colors go by the cube root of the scalar")
    parser.add_argument("--checker", type=int, metavar="N",
                        help="draw a checker of N x N squares on the texture coordinates of OBJ files")
    parser.add_argument("--caption", action="append", default=[], metavar="TEXT",
                        help="once per mesh (default: file name and number of faces)")
    parser.add_argument("--columns", type=int, help="tiles in a row (default: nearly square)")
    parser.add_argument("--zoom", type=float, action="append", help="enlarge, past the tile's edges; once for all, or once per mesh")
    parser.add_argument("--shift", type=shift_of, action="append", metavar="RIGHT,UP",
                        help="what is to be in the middle, in halves of the picture without zoom (write --shift=-0.3,0.1); "
                             "once for all, or once per mesh")
    parser.add_argument("--truth", type=Path, metavar="MESH",
                        help="captions may have {triangles} and {distance}, the largest to this mesh in percent of its diagonal")
    parser.add_argument("--tile", type=int, default=480, help="pixels of a tile's side")
    arguments = parser.parse_args()
    check_arguments(parser, arguments)
    return arguments


def check_arguments(parser: argparse.ArgumentParser, arguments: argparse.Namespace) -> None:
    count = len(arguments.meshes)
    for name, default in (("control", Path("none")), ("zoom", 1.0), ("shift", (0.0, 0.0))):
        values = getattr(arguments, name) or [default]
        if len(values) not in (1, count):
            parser.error(f"give --{name} once, or once per mesh")
        setattr(arguments, name, values if len(values) == count else values * count)
    if len(arguments.caption) not in (0, count):
        parser.error("give --caption once per mesh")
    if min(arguments.zoom) <= 0:
        parser.error("--zoom must be positive")
    if arguments.tile < 16 or (arguments.columns is not None and arguments.columns < 1):
        parser.error("--tile must be at least 16, --columns at least 1")
    try:
        view_angles(arguments.view)
    except ValueError:
        parser.error(f"--view: '{arguments.view}' is neither a name nor AZIMUTH,ELEVATION")
    for path in [*arguments.meshes, *arguments.control, *filter(None, [arguments.truth])]:
        if not path.is_file() and not (str(path) == "none" and path in arguments.control):
            parser.error(f"{path}: no such file")


def view_angles(view: str) -> tuple[float, float] | None:
    if view == "auto":
        return None
    if view in VIEWS:
        return VIEWS[view]
    azimuth, elevation = map(float, view.split(","))
    return azimuth, elevation


def shift_of(shift: str) -> tuple[float, float]:
    try:
        right, up = map(float, shift.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{shift}' is not RIGHT,UP") from None
    return right, up


def run_under_xvfb() -> int:
    """Runs this script again, with Debian's Python, on a virtual screen of its own."""
    read_end, write_end = os.pipe()
    try:
        server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1280x1024x24",
             "-nolisten", "tcp"],
            pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    except FileNotFoundError:
        return missing("Xvfb is missing; install the package xvfb")
    os.close(write_end)
    try:
        with os.fdopen(read_end) as pipe:
            display = pipe.readline().strip()
        if not display:
            sys.exit("render.py: Xvfb did not start")
        environment = os.environ | {"DISPLAY": f":{display}", WORKER: "1"}
        command = ["/usr/bin/python3", __file__, *sys.argv[1:]]
        status = subprocess.run(command, env=environment).returncode
        if status < 0:
            sys.exit(f"render.py: VTK ended by signal {-status}; nothing was drawn")
        return status
    finally:
        server.terminate()
        server.wait()


def missing(what: str) -> int:
    print(f"render.py: {what}", file=sys.stderr)
    return NOT_INSTALLED


def main() -> int:
    arguments = parse_arguments()
    if WORKER not in os.environ:
        return run_under_xvfb()
    for module, package in (("vtkmodules", "python3-vtk9"), ("numpy", "python3-numpy")):
        if importlib.util.find_spec(module) is None:
            return missing(f"/usr/bin/python3 has no module {module}; install the package {package}")
    try:
        from mesh_pictures import sheet
        sheet.draw(arguments, view_angles(arguments.view))
    except (ImportError, RuntimeError) as error:
        sys.exit(f"render.py: VTK is installed, but does not draw: {error}")
    except ValueError as error:
        sys.exit(f"render.py: {error}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
