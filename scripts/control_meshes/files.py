# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Meshes as text: PLY, OFF and OBJ."""

from collections.abc import Iterable
from pathlib import Path, PurePath

from .mesh import Face, Mesh
from .vector import Vec

INDICES = "list uchar int vertex_indices"


def as_text(mesh: Mesh, name: str) -> str:
    writers = {".ply": _to_ply, ".off": _to_off, ".obj": _to_obj}
    return "\n".join(writers[PurePath(name).suffix](mesh)) + "\n"


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{x + 0.0:.17g}" for x in values)


def _faces(mesh: Mesh) -> list[str]:
    return [" ".join(map(str, (len(f), *f))) for f in mesh.faces]


def ply(*elements: tuple[str, list[str], list], comments: Iterable[str] = ()) -> str:
    """Of each element the name, its properties and, as rows, their values."""
    header, rows = ["ply", "format ascii 1.0", *(f"comment {c}" for c in comments)], []
    for name, properties, values in elements:
        header += [f"element {name} {len(values)}", *(f"property {p}" for p in properties)]
        rows += [" ".join(map(str, row)) for row in values]
    return "\n".join([*header, "end_header", *rows]) + "\n"


def properties(names: Iterable[str]) -> list[str]:
    return [f"double {name}" for name in names]


def _to_ply(mesh: Mesh) -> list[str]:
    normals = mesh.normals or [()] * len(mesh.points)
    names = ["x", "y", "z"] + (["nx", "ny", "nz"] if mesh.normals else [])
    vertices = [_numbers((*p, *n)).split() for p, n in zip(mesh.points, normals)]
    return ply(("vertex", properties(names), vertices), ("face", [INDICES], [(len(f), *f) for f in mesh.faces])).splitlines()


def _to_off(mesh: Mesh) -> list[str]:
    return ["OFF", f"{len(mesh.points)} {len(mesh.faces)} 0", *map(_numbers, mesh.points), *_faces(mesh)]


def _to_obj(mesh: Mesh) -> list[str]:
    return [f"v {_numbers(p)}" for p in mesh.points] + ["f " + " ".join(str(v + 1) for v in f) for f in mesh.faces]


def read_mesh(path: Path) -> Mesh:
    """Of OBJ the normals of corners and the groups, too."""
    readers = {".ply": lambda text: read_ply(text)[0], ".off": _of_off, ".obj": _of_obj}
    return readers[path.suffix.lower()](path.read_text())


def _vector(words: list[str]) -> Vec:
    x, y, z = map(float, words[:3])
    return (x, y, z)


def _face(words: list[str]) -> Face:
    """The number of corners, the corners, and what else there is."""
    return tuple(map(int, words[1:int(words[0]) + 1]))


def read_ply(text: str) -> tuple[Mesh, dict[str, list[float]]]:
    """Also what the file has of vertices, by its names there."""
    lines = text.splitlines()
    start = lines.index("end_header") + 1
    header = [line.split() for line in lines[:start]]
    counts = {words[1]: int(words[2]) for words in header if words[0] == "element"}
    of_vertex = header[:[words[:2] for words in header].index(["element", "face"])]
    names = [words[2] for words in of_vertex if words[0] == "property"]
    end = start + counts["vertex"]
    rows = [list(map(float, line.split())) for line in lines[start:end]]
    values = {name: [row[i] for row in rows] for i, name in enumerate(names)}
    comments = [line.removeprefix("comment ") for line in lines[:start] if line.startswith("comment ")]
    normals = list(zip(values["nx"], values["ny"], values["nz"])) if "nx" in values else None
    faces = [_face(line.split()) for line in lines[end:end + counts["face"]]]
    return Mesh(list(zip(values["x"], values["y"], values["z"])), faces, normals, comments), values


def _of_off(text: str) -> Mesh:
    """OFF and NOFF; colors are skipped."""
    lines = [line.split("#")[0].split() for line in text.splitlines()]
    lines = [line for line in lines if line]
    kind = lines[0].pop(0) if lines else ""
    if kind not in ("OFF", "NOFF"):
        raise ValueError("no header")
    counts, *rows = lines if lines[0] else lines[1:]
    vertices, faces = int(counts[0]), int(counts[1])
    if len(rows) < vertices + faces:
        raise ValueError("truncated")
    return Mesh([_vector(row) for row in rows[:vertices]], [_face(row) for row in rows[vertices:vertices + faces]],
                [_vector(row[3:]) for row in rows[:vertices]] if kind == "NOFF" else None)


def _of_obj(text: str) -> Mesh:
    mesh, normals, group = Mesh([], []), [], ""
    for line in text.splitlines():
        kind, *words = line.split() or [""]
        if kind == "v":
            mesh.points.append(_vector(words))
        elif kind == "vn":
            normals.append(_vector(words))
        elif kind == "g":
            group = words[0]
        elif kind == "f":
            corners = [word.split("/") for word in words]
            mesh.faces.append(tuple(int(corner[0]) - 1 for corner in corners))
            mesh.groups.append(group)
            if len(corners[0]) == 3:
                mesh.corner_normals.append([normals[int(corner[2]) - 1] for corner in corners])
        elif kind == "#":
            mesh.comments.append(" ".join(words))
    return mesh
