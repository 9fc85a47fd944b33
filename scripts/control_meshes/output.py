# Copyright (c) 2026  PN_subdivision_3 developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Meshes as text: PLY where there are normals, OFF or OBJ where there are none."""

from collections.abc import Callable
from pathlib import PurePath

from .mesh import Mesh


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


def _obj(mesh: Mesh) -> list[str]:
    return ([f"v {_numbers(p)}" for p in mesh.points]
            + ["f " + " ".join(str(v + 1) for v in f) for f in mesh.faces])
