#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Makes the control meshes of data/meshes/, the same bytes each time, and data/README.md.

Needs Python 3.11 and nothing else. With --check nothing is written: the exit code is 1 if the
files differ from what would be made.
"""

import argparse
import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random

from control_meshes import models, paper, parts, shapes, star, textured
from control_meshes.domain import Domain, Saddle, Sphere, Tube
from control_meshes.mesh import Mesh, check
from control_meshes.output import as_text, selection_text
from control_meshes.part import Part
from control_meshes.sampling import (VALENCES, Sampling, cut_away, merge_faces, shake,
                                     split_into_quads, split_quads, triangulated_sampling)
from control_meshes.vector import Vec, lerp


def uneven(sparse: float, dense: float, axis: int, extent: float = 1.0) -> Callable[[Vec], float]:
    """A spacing that goes from dense to sparse along an axis."""
    return lambda p: lerp(dense, sparse, (p[axis] / extent + 1) / 2)


def sphere_triangles() -> Sampling:
    random = Random(1)
    s = triangulated_sampling(Sphere(), random, 0.24, uneven(0.5, 0.18, axis=0))
    shake(s, random, 0.3)
    return s


def sphere_cap() -> Sampling:
    random = Random(2)
    cap = Sphere(radius=2.5, lowest=-0.35)
    s = triangulated_sampling(cap, random, 0.19, uneven(0.35, 0.2, axis=1))
    cut_away(s, lambda p: p[2] > -0.25 + 0.25 * p[0] * p[1])
    shake(s, random, 0.3)
    return s


def coarse_quads(domain: Domain, seed: int, hub_radius: float, spacing: float) -> Sampling:
    random = Random(seed)
    s = triangulated_sampling(domain, random, hub_radius, lambda p: spacing)
    merge_faces(s, random, most_corners=4, share=0.6)
    s = split_into_quads(s)
    shake(s, random, 0.35)
    return s


def sphere_mixed() -> Sampling:
    random = Random(4)
    s = coarse_quads(Sphere(), 11, 0.3, 0.6)
    split_quads(s, random, 0.2)
    merge_faces(s, random, most_corners=6, share=0.15)
    return s


def cylinder_triangles() -> Sampling:
    random = Random(5)
    s = triangulated_sampling(Tube(0.75, 2.2), random, 0.34, uneven(0.6, 0.25, axis=1, extent=2.2))
    shake(s, random, 0.3)
    return s


def valences() -> Sampling:
    random = Random(8)
    s = triangulated_sampling(Saddle(2.0), random, 0.27, lambda p: 0.4)
    shake(s, random, 0.2)
    return s


@dataclass
class Entry:
    name: str
    purpose: str
    make: Callable[[], Mesh]
    hubs: bool = False


UNIT_SPHERE = "sphere 0 0 0 1"
ENTRIES = [
    Entry("sphere_triangles.ply", "uneven closed sphere", hubs=True,
          make=lambda: sphere_triangles().mesh(UNIT_SPHERE)),
    Entry("sphere_cap.ply", "uneven part of a sphere, jagged border with corners", hubs=True,
          make=lambda: sphere_cap().mesh("sphere 0 0 0 2.5")),
    Entry("sphere_quads.ply", "irregular closed sphere of quads", hubs=True,
          make=lambda: coarse_quads(Sphere(), 3, 0.3, 0.6).mesh(UNIT_SPHERE)),
    Entry("sphere_mixed.ply", "closed sphere, mostly quads, with triangles to hexagons", hubs=True,
          make=lambda: sphere_mixed().mesh(UNIT_SPHERE)),
    Entry("cylinder_triangles.ply", "uneven open tube", hubs=True,
          make=lambda: cylinder_triangles().mesh("cylinder 0 0 0 0 0 1 0.75")),
    Entry("cylinder_quads.ply", "irregular open tube of quads", hubs=True,
          make=lambda: coarse_quads(Tube(1.0, 2.5), 6, 0.36, 0.6).mesh("cylinder 0 0 0 0 0 1 1")),
    Entry("torus_quads.ply", "unevenly divided torus, all valences 4",
          make=lambda: shapes.torus(18, 10, 2.0, 0.75)),
    Entry("valences_3_to_12.ply", "saddle patch with round border, every valence inside",
          make=lambda: valences().mesh("graph z = (x^2 - y^2 / 2) / 4"), hubs=True),
    Entry("missing_normals.ply", "egg; normals are zero in one region and at some lone vertices",
          make=shapes.egg_with_missing_normals),
    Entry("creased_box.ply", "box whose normals jump by 90 degrees along its edges",
          make=lambda: shapes.creased((3.0, 2.0, 1.2), (5, 4, 3))),
    Entry("creased_plate.ply", "thin box where normals of neighbours are opposite",
          make=lambda: shapes.creased((3.0, 2.0, 0.3), (4, 3, 1))),
    Entry("mixed_borders.off", "triangles to hexagons, five components, an isolated vertex",
          make=shapes.mixed_polygons),
    Entry("cube.off", "the smallest closed quad mesh", make=shapes.cube),
    Entry("cube_on_sphere.ply", "a cube with the normals of the sphere through its corners",
          make=shapes.cube_on_sphere),
    Entry("wheel.off", "hub, five spokes and rim of quads, genus 6", make=lambda: shapes.wheel(5)),
    Entry("creature.obj", "a standing creature of quads, closed", make=models.creature),
    Entry("spoon.obj", "a spoon of quads, closed", make=models.spoon),
    Entry("head.obj", "a head of quads, open at the neck", make=models.head),
    Entry("vase.obj", "a vase with texture coordinates in two charts, open at its mouth",
          make=textured.vase),
    Entry("saddle_3.ply", "z = 2xy about its saddle point", make=lambda: star.saddle(3)),
    Entry("saddle_5.ply", "z = 2xy about its saddle point", make=lambda: star.saddle(5)),
    Entry("bezier_6.ply", "bicubic Bézier patch about its middle", make=lambda: star.bezier(6)),
    Entry("bezier_7.ply", "bicubic Bézier patch about its middle", make=lambda: star.bezier(7)),
    Entry("cylinder_cap_8.ply", "cylinder of radius 15 and height 10, with a vertex above its base",
          make=lambda: star.cylinder_cap(8)),
    Entry("parts/capped_cylinder.obj", "unevenly divided cylinder with flat ends",
          make=parts.capped_cylinder),
    Entry("parts/half_ball.obj", "half of a sphere with its base", make=parts.half_ball),
    Entry("parts/lens.obj", "caps of two spheres", make=parts.lens),
    Entry("parts/washer.obj", "two cylinders and two planes", make=parts.washer),
    Entry("parts/plate_with_holes.obj", "plate with two round holes", make=parts.plate_with_holes),
    Entry("parts/d_section.obj", "shaft with a flat", make=parts.d_section),
    Entry("parts/bolt.obj", "hexagonal head, shank and round end", make=parts.bolt),
    Entry("parts/bracket.obj", "angle with a fillet; tangent surfaces", make=parts.bracket),
    Entry("parts/bearing_housing.obj", "plate with bolt holes, boss, bore and a spherical seat",
          make=parts.bearing_housing),
    Entry("paper/cylinder.ply", "figure 3: uneven quads on a cylinder", make=paper.cylinder),
    Entry("paper/tetrahedron.ply", "figure 4: with the normals of a sphere", make=paper.tetrahedron),
    Entry("paper/cross.off", "figures 7 and 8: six arms, five of them open",
          make=paper.cross_of_cubes),
    Entry("paper/waves.ply", "figure 10: flat, normals in waves", make=paper.waves),
    Entry("paper/bumps.ply", "figure 10: flat, normals of bumps", make=paper.bumps),
    Entry("paper/ring.ply", "figure 11: ring, horizontal normals", make=paper.ring),
    Entry("paper/ring_edited.ply", "figure 11: ring, edited normals", make=paper.edited_ring),
    Entry("paper/wheel.ply", "figure 12: wheel, horizontal normals", make=paper.wheel),
    Entry("paper/wheel_tori.ply", "figure 12: wheel, normals of tori", make=paper.wheel_of_tori),
    Entry("paper/bell.ply", "figure 13: a top without normal", make=paper.bell),
    Entry("paper/cuboid_with_hole.ply", "figure 13: corners without normals",
          make=paper.cuboid_with_hole),
    Entry("paper/cyclide.ply", "figure 13: 6 x 6 points of a cyclide", make=paper.cyclide),
    Entry("paper/torus_4.ply", "figure 17: 4 x 4 points of a torus", make=lambda: paper.torus(4)),
    Entry("paper/torus_8.ply", "figure 17: 8 x 8 points of a torus", make=lambda: paper.torus(8)),
]


def made(entry: Entry) -> Mesh:
    mesh = entry.make()
    check(mesh)
    if entry.hubs and (missing := set(VALENCES) - set(mesh.interior_valences())):
        raise ValueError(f"no interior vertex has valence {sorted(missing)}")
    if entry.hubs and max(mesh.valences().values()) > max(VALENCES):
        raise ValueError("a valence is too high")
    return mesh


def readme_line(entry: Entry, mesh: Mesh) -> str:
    sides = Counter(map(len, mesh.faces))
    polygons = ", ".join(f"{count} × {corners}" for corners, count in sorted(sides.items()))
    inside = sorted(set(mesh.interior_valences()))
    known = "corners" if isinstance(mesh, Part) else "none" if mesh.normals is None else "all" if all(map(any, mesh.normals)) else "some"
    return (f"| `{entry.name}` | {entry.purpose} | {len(mesh.points)} | {polygons} | "
            f"{', '.join(map(str, inside))} | {mesh.number_of_borders()} | {known} |")


def readme(lines: list[str]) -> str:
    return "\n".join([
        "# Control meshes",
        "",
        "Made by `scripts/make_control_meshes.py`, which also checks them: oriented manifolds",
        "(closed components face outwards), no bow-ties. Do not edit the files, edit the script;",
        "`scripts/make_control_meshes.py --check` tells whether the two agree. The meshes may be",
        "used like the rest of the project. They lie in `meshes/`, where",
        "`CGAL::data_file_path(\"meshes/...\")` looks; for a CGAL source tree copy them to its",
        "`Data/data/meshes` (`cp -n`: CGAL has a `cube.off` of its own).",
        "",
        "Points and normals of spheres and cylinders are rounded from 50 digits: each coordinate",
        "is the nearest double. Their surface is given by a comment in the file, `comment sphere",
        "X Y Z R` or `comment cylinder X Y Z DX DY DZ R` (a point of the axis and its direction).",
        "A zero vector means that the vertex has no control normal.",
        "",
        "The meshes in `paper/` are those of the figures of Yang's paper; some of their normals are",
        "handles of the design that differ from those of the faces.",
        "",
        "Parts have a group per surface, which a comment in the file describes, a normal per corner",
        "and, beside them, `NAME.selection.txt` with their creases: the edges between two surfaces,",
        "also where these are tangent, in CGAL's format of selections.",
        "",
        "`vase.obj` has texture coordinates: its side and its bottom are charts with straight borders,",
        "and groups.",
        "",
        "| file | what | vertices | faces × corners | interior valences | borders | normals |",
        "|---|---|---|---|---|---|---|",
        *lines]) + "\n"


def make_all() -> dict[str, str]:
    """File names with their contents."""
    files: dict[str, str] = {}
    lines: list[str] = []
    for entry in ENTRIES:
        try:
            mesh = made(entry)
        except ValueError as error:
            raise SystemExit(f"{entry.name}: {error}") from error
        files[f"meshes/{entry.name}"] = as_text(mesh, entry.name)
        if isinstance(mesh, Part):
            files[f"meshes/{entry.name.removesuffix('.obj')}.selection.txt"] = selection_text(mesh)
        lines.append(readme_line(entry, mesh))
    return files | {"README.md": readme(lines)}


def differing(folder: Path, files: dict[str, str]) -> list[str]:
    def same(name: str) -> bool:
        path = folder / name
        return path.is_file() and path.read_bytes() == files[name].encode()
    return [name for name in files if not same(name)]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=Path,
                        default=Path(__file__).resolve().parent.parent / "data",
                        help="where the meshes go (default: the project's data)")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    arguments = parser.parse_args()
    files = make_all()
    if arguments.check:
        stale = differing(arguments.folder, files)
        for name in stale:
            print(f"{arguments.folder / name} is not what this script makes", file=sys.stderr)
        return 1 if stale else 0
    for name, text in files.items():
        (arguments.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (arguments.folder / name).write_bytes(text.encode())
    return 0


if __name__ == "__main__":
    sys.exit(main())
