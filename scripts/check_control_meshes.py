#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Checks the control meshes of data/meshes, and that data/README.md says of each what it is.

They are oriented manifolds without bow-ties, whose closed components face outwards. Normals of vertices are unit vectors, or zero
where there is none; they agree with the faces but in paper/, where some are handles of the design. Points and normals are those
of the surface that a comment names, of a mesh or of a group of faces. The selection beside a part has the edges between groups.
Exit code 1 if something is wrong.
"""

import re
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

from control_meshes.files import read_mesh
from control_meshes.mesh import Mesh
from control_meshes.vector import Vec, add, cross, dot, length, scaled, sub
from refinery import DATA

README = DATA.parent / "README.md"
ROUNDING = 4e-15  # of what is computed here
SURFACE = re.compile(r"(?:group (\w+) is )?((?:plane|cylinder|sphere)[: ].*)")


def wrong_faces(mesh: Mesh) -> Iterator[str]:
    for i, f in enumerate(mesh.faces):
        if len(set(f)) != len(f) or len(f) < 3 or min(f) < 0 or max(f) >= len(mesh.points):
            yield f"face {i} {f} repeats a vertex, has fewer than three or names one that is not there"
        elif length(mesh.face_normal(f)) == 0:
            yield f"face {i} {f} has no area"
    edge, times = Counter(mesh.halfedges()).most_common(1)[0]
    if times > 1:
        yield f"half-edge {edge} belongs to {times} faces"


def wrong_fans(mesh: Mesh) -> Iterator[str]:
    """Around each vertex the faces must form one fan, closed or open: no bow-ties."""
    corners: dict[int, dict[int, int]] = defaultdict(dict)
    for f in mesh.faces:
        for before, v, after in zip(f[-1:] + f[:-1], f, f[1:] + f[:1]):
            corners[v][after] = before
    for v, turn in corners.items():
        starts = set(turn) - set(turn.values())
        first = next(iter(starts or turn))
        at, faces = turn[first], 1
        while at != first and at in turn:
            at, faces = turn[at], faces + 1
        if faces != len(turn):
            yield f"vertex {v} is a bow-tie"


def wrong_closed_components(mesh: Mesh) -> Iterator[str]:
    border = mesh.border_vertices()
    for faces in mesh.components():
        volume = sum(dot(mesh.face_normal(f), mesh.points[f[0]]) for f in faces)
        if volume <= 0 and border.isdisjoint(v for f in faces for v in f):
            yield f"the component of vertex {faces[0][0]} is inside out"


def wrong_normals(mesh: Mesh, may_be_handles: bool) -> Iterator[str]:
    for v, n in enumerate(mesh.normals or []):
        if any(n) and abs(dot(n, n) - 1) > ROUNDING:
            yield f"the normal of vertex {v} is neither unit nor zero"
    for i, f in enumerate(mesh.faces if mesh.normals and not may_be_handles else []):
        total = (0.0, 0.0, 0.0)
        for v in f:
            total = add(total, mesh.normals[v])  # type: ignore[index]
        if any(total) and dot(total, mesh.face_normal(f)) < 0:
            yield f"face {i} {f} is turned against its normals"


def miss(surface: str, p: Vec, n: Vec) -> float:
    """The distance of a point from a surface, or of its normal from that of the surface, whichever is greater; of round ones
    in radii."""
    kind, *words = re.split("[: ,]", surface)
    x, y, z, *numbers = map(float, words)
    across = sub(p, (x, y, z))
    if kind == "plane":
        return max(abs(dot(across, n)), length(sub(n, (numbers[0], numbers[1], numbers[2]))))
    if kind == "cylinder":
        axis = numbers[0], numbers[1], numbers[2]
        across = sub(across, scaled(axis, dot(across, axis)))
    across = scaled(across, 1 / numbers[-1])
    return max(abs(length(across) - 1), length(cross(across, n)))


def wrong_surfaces(mesh: Mesh) -> Iterator[str]:
    surfaces = {found[1]: found[2] for found in map(SURFACE.fullmatch, mesh.comments) if found}
    if None in surfaces and mesh.normals:
        for v, (p, n) in enumerate(zip(mesh.points, mesh.normals)):
            if miss(surfaces[None], p, n) > ROUNDING:
                yield f"vertex {v} is not on the {surfaces[None]}"
    for f, group, normals in zip(mesh.faces, mesh.groups, mesh.corner_normals):
        for v, n in zip(f, normals):
            if miss(surfaces[group], mesh.points[v], n) > ROUNDING:
                yield f"vertex {v} is not on the {surfaces[group]} of its face in {group}"


def wrong_creases(mesh: Mesh, selection: Path) -> Iterator[str]:
    """In CGAL's format of selections: no vertices, no faces, edges as pairs."""
    group_of = {h: group for f, group in zip(mesh.faces, mesh.groups) for h in zip(f, f[1:] + f[:1])}
    creases = sorted((a, b) for (a, b), group in group_of.items() if a < b and group != group_of.get((b, a), group))
    if selection.read_text() != "\n\n" + " ".join(f"{a} {b}" for a, b in creases) + "\n":
        yield f"{selection.name} does not have the edges between groups"


def row(mesh: Mesh) -> str:
    """What the table of the README says of a mesh behind its name and purpose."""
    polygons = ", ".join(f"{count} × {corners}" for corners, count in sorted(Counter(map(len, mesh.faces)).items()))
    inside = ", ".join(map(str, sorted(set(mesh.interior_valences()))))
    known = ("corners" if mesh.corner_normals else "none" if mesh.normals is None else
             "all" if all(map(any, mesh.normals)) else "some")
    return f" {len(mesh.points)} | {polygons} | {inside} | {mesh.number_of_borders()} | {known} |"


def wrong(path: Path) -> Iterator[str]:
    mesh, name = read_mesh(path), str(path.relative_to(DATA))
    broken = [*wrong_faces(mesh), *wrong_fans(mesh)]
    yield from broken
    if broken:
        return  # what follows is of manifolds
    yield from wrong_closed_components(mesh)
    yield from wrong_normals(mesh, name.startswith("paper/"))
    yield from wrong_surfaces(mesh)
    selection = path.with_suffix(".selection.txt")
    if selection.exists():
        yield from wrong_creases(mesh, selection)
    if not re.search(rf"(?m)^\| `{re.escape(name)}` \| [^|]+ \|{re.escape(row(mesh))}$", README.read_text()):
        yield f"README.md has no row | `{name}` | WHAT IT IS |{row(mesh)}"


def main() -> None:
    found = [f"{path}: {text}" for path in sorted(DATA.rglob("*")) if path.suffix in (".ply", ".off", ".obj")
             for text in wrong(path)]
    found += [f"{README}: {name} is not there" for name in re.findall(r"(?m)^\| `(.*?)`", README.read_text())
              if not (DATA / name).is_file()]
    sys.exit("\n".join(found) or 0)


if __name__ == "__main__":
    main()
