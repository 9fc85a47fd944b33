# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Meshes as text: PLY where there are normals, OFF or OBJ where there are none, OBJ with a normal per
corner and a group per surface for parts, with texture coordinates and a group per chart for textured
meshes."""

from collections.abc import Callable, Sequence
from pathlib import PurePath

from .mesh import Mesh
from .part import Part
from .textured import TexturedMesh


def as_text(mesh: Mesh, name: str) -> str:
    writers: dict[str, Callable[[Mesh], list[str]]] = {".ply": _ply, ".off": _off, ".obj": _obj}
    return "\n".join(writers[PurePath(name).suffix](mesh)) + "\n"


def _numbers(values: tuple[float, ...]) -> str:
    return " ".join(f"{x + 0.0:.17g}" for x in values)


def _ply(mesh: Mesh) -> list[str]:
    normals = mesh.normals or [()] * len(mesh.points)
    names = ["x", "y", "z"] + (["nx", "ny", "nz"] if mesh.normals else [])
    return (["ply", "format ascii 1.0"]
            + [f"comment {c}" for c in mesh.comments]
            + [f"element vertex {len(mesh.points)}"]
            + [f"property double {n}" for n in names]
            + [f"element face {len(mesh.faces)}", "property list uchar int vertex_indices",
               "end_header"]
            + [_numbers((*p, *n)) for p, n in zip(mesh.points, normals)]
            + [" ".join(map(str, (len(f), *f))) for f in mesh.faces])


def _off(mesh: Mesh) -> list[str]:
    return (["OFF", f"{len(mesh.points)} {len(mesh.faces)} 0"]
            + [_numbers(p) for p in mesh.points]
            + [" ".join(map(str, (len(f), *f))) for f in mesh.faces])


def selection_text(part: Part) -> str:
    """The creases in CGAL's format of selections: no vertices, no faces, edges as pairs."""
    return "\n\n" + " ".join(f"{a} {b}" for a, b in part.creases()) + "\n"


def _obj(mesh: Mesh) -> list[str]:
    if isinstance(mesh, Part):
        shapes = dict.fromkeys(f"# group {s.name} is {s.shape()}" for s in mesh.surfaces)
        return [*shapes, *_obj_in_groups(mesh, [s.name for s in mesh.surfaces], mesh.corner_normals(), "vn", "//")]
    if isinstance(mesh, TexturedMesh):
        return _obj_in_groups(mesh, mesh.charts, mesh.texture, "vt", "/")
    return ([f"v {_numbers(p)}" for p in mesh.points]
            + ["f " + " ".join(str(v + 1) for v in f) for f in mesh.faces])


def _obj_in_groups(mesh: Mesh, groups: Sequence[str], corners: Sequence[Sequence[tuple[float, ...]]], kind: str,
                   separator: str) -> list[str]:
    """A group of each face, and a normal or texture point of each corner."""
    number: dict[tuple[float, ...], int] = {}
    faces: list[str] = []
    last = None
    for f, group, at_corners in zip(mesh.faces, groups, corners):
        if group != last:
            faces.append(f"g {group}")
            last = group
        numbers = [number.setdefault(c, len(number) + 1) for c in at_corners]
        faces.append("f " + " ".join(f"{v + 1}{separator}{n}" for v, n in zip(f, numbers)))
    return ([f"v {_numbers(p)}" for p in mesh.points]
            + [f"{kind} {_numbers(c)}" for c in number] + faces)
