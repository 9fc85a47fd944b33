#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Checks that the headers lie in layers. A row of the table is a layer: the folders NAME and internal/NAME of the
package's folder below include/CGAL, with what else belongs there (`.`: the package's folder), and the layers above in the table,
or packages, that it may include; nothing outside include/CGAL.

    scripts/check_layers.py [ROOT]              exit code 1 if a header includes what it may not
    scripts/check_layers.py --circles [ROOT]    prints the pairs of folders, and of layers, that include each other
"""

import argparse
import re
import sys
from collections import defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

# packages with their layers
TABLE = """
PN_subdivision_3
  base        version.h internal parameters levels |
  numbers     rational_normals.h sqrt_extension_normals.h boost_multiprecision_floats.h |
  average     | numbers
  hosts       | base numbers average
  rows        | base numbers average hosts
  concepts    | base rows
  scheme_parts  | base numbers rows concepts
  schemes     | base numbers average concepts scheme_parts hosts rows
  rounds      | base numbers average concepts scheme_parts hosts rows schemes
  normals     | base numbers average concepts scheme_parts hosts schemes
  creases     | base numbers average concepts scheme_parts hosts rows schemes rounds normals
  refinement  | base numbers average concepts scheme_parts hosts rows schemes rounds normals creases
  meshes      | base numbers average concepts scheme_parts hosts schemes rounds normals creases refinement
  attributes  attributes.h | base numbers average concepts scheme_parts hosts rows schemes rounds creases refinement meshes
  calls       subdivide.h control_mesh_io.h subdivision_methods_3.h detect_creases.h estimate_control_normals.h
              | base numbers average concepts scheme_parts hosts schemes rounds normals creases refinement meshes attributes
  refiner     Surface_refiner.h | base numbers average concepts scheme_parts hosts rows schemes rounds normals creases refinement
              meshes attributes calls
PN_cgal_masks_3
  cgal_masks  . internal | PN_subdivision_3
PN_limit_surface_3
  curvature   estimate_curvature.h | PN_subdivision_3
  limit       limit_points.h subdivide_to_limit.h | PN_subdivision_3 curvature
  pieces      Surface_piece.h refine_in_pieces.h | PN_subdivision_3 limit
  limit_surface  Face_patch.h Limit_surface.h Limit_surface_queries.h | PN_subdivision_3 limit
  tessellation   tessellate.h | PN_subdivision_3 limit limit_surface
PN_curves
  curves      . internal masks | PN_subdivision_3 limit
PN_recognition_3
  recognition . internal surfaces | base numbers average concepts hosts normals creases meshes calls curves
PN_fitting_3
  fitting     . internal interpolation | PN_subdivision_3 PN_limit_surface_3 curves
PN_certificates_3
  certificates  . internal | PN_subdivision_3 curves
umbrellas
  umbrellas   PN_subdivision_3.h PN_subdivision_curve.h PN_subdivision_limit_3.h PN_fitting_3.h PN_recognition_3.h
              PN_certificates_3.h PN_cgal_masks_3.h
              | PN_subdivision_3 PN_limit_surface_3 PN_curves PN_recognition_3 PN_fitting_3 PN_certificates_3 PN_cgal_masks_3
"""
INCLUDE = re.compile(r"^ *# *include [<\"]CGAL/(PN_[^>\"]+)", re.MULTILINE)
OUTSIDE = re.compile(r"^ *# *include \"(?!CGAL/)([^\"]+)", re.MULTILINE)  # such as test_support/
Circles = tuple[list[tuple[str, str]], list[str]]


class Layer(NamedTuple):
    package: str
    places: list[str]
    allowed: set[str]


def layers() -> dict[str, Layer]:
    """By their names, in the order of the table: whatever a layer may include comes before it."""
    result: dict[str, Layer] = {}
    package = ""
    for line in re.sub(r"\n {6,}", " ", TABLE.strip()).splitlines():
        if not line.startswith(" "):
            package = line
            continue
        (name, *places), entries = (part.split() for part in line.split("|"))
        allowed: set[str] = set()
        for entry in entries:
            of_entry = {other for other, layer in result.items() if entry in (other, layer.package)}
            if not of_entry:
                raise SystemExit(f"check_layers.py: {entry}, which {name} may include, is not above it in the table")
            allowed |= of_entry
        folder = "" if package == "umbrellas" else f"{package}/"
        result[name] = Layer(package, [str(Path(folder + place)) for place in (name, f"internal/{name}", *places)], allowed)
    return result


def headers(root: Path) -> dict[Path, list[Path]]:
    """The package's headers, and sources that headers include, below include/CGAL, with those that they include."""
    include = root / "include" / "CGAL"
    return {path.relative_to(include): [Path(name) for name in INCLUDE.findall(path.read_text())]
            for path in sorted(include.rglob("*")) if path.suffix in (".h", ".cpp")}


def layers_of_headers(root: Path) -> tuple[dict[Path, str], list[Path]]:
    """The layer of each header, and the headers that have none."""
    of_place = {place: name for name, layer in layers().items() for place in layer.places}
    found: dict[Path, str] = {}
    for header in headers(root):
        name = of_place.get(str(header)) or of_place.get(str(header.parent))
        if name:
            found[header] = name
    return found, [header for header in headers(root) if header not in found]


def check(root: Path) -> list[str]:
    table = layers()
    of_header, others = layers_of_headers(root)
    wrong = [f"{header}: belongs to no layer of the table in scripts/check_layers.py" for header in others]
    wrong += [f"{header} includes {other}, which is not installed: it is not in include/CGAL" for header in headers(root)
              for other in OUTSIDE.findall((root / "include" / "CGAL" / header).read_text())]
    for header, included in headers(root).items():
        for other in included:
            if header not in of_header or other not in of_header:
                continue
            here, there = of_header[header], of_header[other]
            if here != there and there not in table[here].allowed:
                wrong.append(f"{header} includes {other}: {here} may not include {there}")
    return wrong


def circles(root: Path, place: Callable[[Path], str] = lambda header: str(header.parent)) -> Circles:
    """The pairs of folders that include each other, and all folders from which includes lead back to them."""
    arrows: dict[str, set[str]] = defaultdict(set)
    for header, included in headers(root).items():
        arrows[place(header)] |= {place(other) for other in included} - {place(header)}
    reached = {}
    for folder in list(arrows):
        waiting, seen = [folder], set()
        while waiting:
            new = arrows[waiting.pop()] - seen
            seen |= new
            waiting += new
        reached[folder] = seen
    pairs = [(a, b) for a in sorted(arrows) for b in sorted(arrows[a]) if a < b and a in arrows[b]]
    return pairs, sorted(folder for folder in reached if folder in reached[folder])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--circles", action="store_true")
    parser.add_argument("root", nargs="?", type=Path, default=Path(__file__).resolve().parent.parent)
    arguments = parser.parse_args()
    if arguments.circles:
        of_header = layers_of_headers(arguments.root)[0]
        for what, (pairs, inside) in (("folders", circles(arguments.root)),
                                      ("layers", circles(arguments.root, lambda header: of_header[header]))):
            print(f"{len(pairs)} pairs of {what} include each other, {len(inside)} {what} lie in circles")
            print("".join(f"  {a} and {b}\n" for a, b in pairs), end="")
    else:
        sys.exit("\n".join(check(arguments.root)) or 0)


if __name__ == "__main__":
    main()
