# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Meshes as Python has them, and the control meshes that C++ makes of them."""

import dataclasses

import numpy as np

from . import _core

BORDERS = ("surface", "curve", "corners", "fixed")
ESTIMATES = ("coherent", "reciprocal", "angle")


def reals(name, values, columns=None):
    """An array; with columns one of so many."""
    try:
        rows = np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} must be numbers: {error}") from None
    if columns and (rows.ndim != 2 or rows.shape[1] != columns):
        raise ValueError(f"{name} must have the shape (n, {columns}), not {rows.shape}")
    return rows


def integers(name, values, most):
    """One-dimensional, from 0 to most - 1."""
    array = np.asarray(values)
    if array.size and array.dtype.kind not in "iu":
        raise ValueError(f"{name} must be integers, not {array.dtype}")
    array = np.ascontiguousarray(array.reshape(-1), dtype=np.int64)
    wrong = np.flatnonzero((array < 0) | (array >= most))
    if wrong.size:
        raise ValueError(f"{name}: {array[wrong[0]]} is not from 0 to {most - 1}")
    return array


def integers_and_reals(name, numbers, most, name_of_rows, rows, columns):
    """As many of both."""
    numbers, rows = integers(name, numbers, most), reals(name_of_rows, np.atleast_2d(rows), columns)
    if len(numbers) != len(rows):
        raise ValueError(f"{len(numbers)} {name} do not go with {len(rows)} {name_of_rows}")
    return numbers, rows


def choice(name, value, words):
    if value not in words:
        raise ValueError(f"{name} '{value}': it must be one of {', '.join(words)}")
    return words.index(value)


def sharp(name, given, columns, vertices):
    """Vertices and numbers of what is sharp: given alone, for ever, or as a tuple with the numbers of rounds."""
    is_tuple = isinstance(given, tuple) and len(given) == 2 and np.ndim(given[0]) == columns
    elements, rounds = given if is_tuple else (() if given is None else given, None)
    elements = integers(name, elements, vertices)
    rounds = np.full(len(elements) // columns, np.inf) if rounds is None else reals(f"the sharpness of {name}", rounds)
    if (columns * len(rounds), *rounds.shape[1:]) != elements.shape:
        raise ValueError(f"{name} must have the shape (k{', 2' * (columns - 1)}), and their sharpness the shape (k,)")
    return elements, rounds


@dataclasses.dataclass(eq=False)
class Mesh:
    """A polygon mesh with what is known of it; with creases normals and roundness are of corners. What is None is not known."""

    points: np.ndarray  # (n, 3)
    offsets: np.ndarray  # (m + 1,): the corners of face i are those from offsets[i] to offsets[i + 1]
    indices: np.ndarray  # (c,): the vertex of each corner
    normals: np.ndarray = None  # (n, 3) or (c, 3)
    roundness: np.ndarray = None  # (n,) or (c,)
    creases: np.ndarray = None  # (k, 2)
    crease_sharpness: np.ndarray = None  # (k,) rounds
    corners: np.ndarray = None  # (l,)
    corner_sharpness: np.ndarray = None  # (l,)
    uv: np.ndarray = None  # (n, 2) or (c, 2)
    attributes: dict = dataclasses.field(default_factory=dict)
    face_parents: np.ndarray = None  # (m,): the control face that each face comes from
    report: np.void = None  # what was reached, of limits and tessellations

    @property
    def faces(self):
        """An array (m, d) if all faces have d corners, else a list of arrays."""
        degrees = np.diff(self.offsets)
        if len(degrees) and (degrees == degrees[0]).all():
            return self.indices.reshape(-1, degrees[0])
        return np.split(self.indices, self.offsets[1:-1]) if len(degrees) else np.empty((0, 3), np.int64)

    def triangles(self):
        """(t, 3): the faces as fans of triangles."""
        degrees = np.diff(self.offsets) - 2
        first = np.repeat(self.offsets[:-1], degrees)
        second = first + 1 + np.arange(len(first)) - np.repeat(np.cumsum(degrees) - degrees, degrees)
        return self.indices[np.stack([first, second, second + 1], axis=1)]

    def vertex_normals(self):
        """(n, 3): the normals, or of those of corners the unit sums."""
        if self.normals is None or len(self.normals) == len(self.points):
            return self.normals
        sums = np.zeros_like(self.points)
        np.add.at(sums, self.indices, self.normals)
        length = np.linalg.norm(sums, axis=1, keepdims=True)
        return sums / np.where(length > 0, length, 1)

    def to_trimesh(self):
        """A trimesh.Trimesh of triangles()."""
        import trimesh
        return trimesh.Trimesh(self.points, self.triangles(), vertex_normals=self.vertex_normals(), process=False)

    def to_pyvista(self):
        """A pyvista.PolyData."""
        import pyvista
        return pyvista.PolyData(self.points, np.insert(self.indices, self.offsets[:-1], np.diff(self.offsets)))

    def to_meshio(self):
        """A meshio.Mesh."""
        import meshio
        degrees = np.diff(self.offsets)
        return meshio.Mesh(self.points, [({3: "triangle", 4: "quad"}.get(d, "polygon"),
                                          self.indices[self.offsets[:-1][degrees == d][:, None] + np.arange(d)])
                                         for d in np.unique(degrees)])

    def _options(self):
        """What functions take besides points and faces."""
        given = {"normals": self.normals, "roundness": self.roundness, "uv": self.uv, "attributes": self.attributes,
                 "creases": None if self.creases is None else (self.creases, self.crease_sharpness),
                 "corners": None if self.corners is None else (self.corners, self.corner_sharpness)}
        return {name: value for name, value in given.items() if value is not None}


def polygons(faces):
    """Offsets and indices of an array (m, d), of a tuple (offsets, indices), or of a list of polygons."""
    if isinstance(faces, tuple) and len(faces) == 2:
        return faces
    if isinstance(faces, np.ndarray) and faces.ndim == 2:
        return np.arange(len(faces) + 1) * faces.shape[1], faces
    try:
        return np.cumsum([0, *map(len, faces)]), np.concatenate(faces) if len(faces) else ()
    except (TypeError, ValueError):
        raise ValueError("faces must have the shape (m, 3) or (m, 4), or be a list of polygons or a tuple (offsets, indices)") from None


def control_mesh(mesh, faces, options):
    """Of points and faces, of a Mesh with what it has unless something else is given, or of a mesh of another library."""
    if faces is not None:
        return Control(mesh, faces, **options)
    if isinstance(mesh, Mesh):
        return Control(mesh.points, (mesh.offsets, mesh.indices), **{**mesh._options(), **options})
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):  # trimesh
        return Control(mesh.vertices, np.asarray(mesh.faces), **options)
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):  # meshio
        blocks = [block for block in mesh.cells if block.type in ("triangle", "quad") or block.type.startswith("polygon")]
        return Control(mesh.points, [face for block in blocks for face in np.asarray(block.data)], **options)
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):  # pyvista: the size of each face before its vertices
        flat, found = np.asarray(mesh.faces), []
        while len(flat):
            found.append(flat[1:flat[0] + 1])
            flat = flat[flat[0] + 1:]
        return Control(mesh.points, found, **options)
    raise ValueError("points need faces, unless they are a mesh: one of this module, trimesh, pyvista or meshio")


class Control(_core.Control):
    """A control mesh with all that is told of it, in C++."""

    def __init__(self, points, faces, *, scheme=None, linear=False, normals=None, roundness=None, creases=None, corners=None,
                 border="surface", uv=None, attributes=None, threads=1):
        offsets, indices = polygons(faces)
        points, offsets = reals("points", points, 3), integers("offsets of faces", offsets, 2**31)
        indices = integers("vertices of faces", indices, len(points))
        if not len(offsets) or offsets[0] != 0 or offsets[-1] != len(indices) or (np.diff(offsets) < 0).any():
            raise ValueError("the offsets of the faces must ascend from 0 to the number of their corners")
        if threads < 1 or (threads > 1 and not _core.has_threads):
            raise ValueError(f"threads {threads}: " + ("at least 1" if threads < 1 else "this module was built without TBB"))
        if scheme is None:
            scheme = "loop" if (np.diff(offsets) == 3).all() else "catmull-clark"
        super().__init__(*(scheme if isinstance(scheme, tuple) else (scheme, {})), linear, threads)
        self.add_faces(points, offsets, indices)
        angle = None
        if np.isscalar(creases):
            angle, creases = reals("creases", creases)[0], None
        self.set_sharpness(choice("border", border, BORDERS), angle, *sharp("creases", creases, 2, len(points)),
                           *sharp("corners", corners, 1, len(points)))
        self.size = len(points), len(indices)
        estimate = choice("normals", normals, ESTIMATES) if isinstance(normals, str) else 0
        if normals is not None:
            normals = None if isinstance(normals, str) else self.one_of_each("normals", reals("normals", normals, 3))
        if roundness is not None:
            roundness = reals("roundness", roundness).reshape(-1)
            roundness = self.one_of_each("roundness", np.full(len(points), roundness) if roundness.size == 1 else roundness)
        self.set_normals(normals, roundness, estimate)
        self.names = []
        for name, values in {**(attributes or {}), **({} if uv is None else {"uv": uv})}.items():
            self.carry(name, self.one_of_each(f"attribute '{name}'", np.asarray(values)))

    def one_of_each(self, name, array):
        """The array, which has a row for each vertex or corner."""
        if np.ndim(array) and len(array) in self.size:
            return array
        raise ValueError("{} must have a row for each of the {} vertices or of the {} corners of faces".format(name, *self.size))

    def carry(self, name, values):
        if values.dtype.kind not in "iufb":
            raise ValueError(f"attribute '{name}' must be numbers, not {values.dtype}")
        at_corners = len(values) != self.size[0]
        rows = values.reshape(len(values), int(np.prod(values.shape[1:]))).astype(np.float64)
        if at_corners:
            of_halfedges = np.zeros((len(self.edges()[0]), rows.shape[1]))
            of_halfedges[self.faces()[2]] = rows
            rows = of_halfedges
        number = self.add_attribute(rows, at_corners, values.dtype.kind != "f")
        self.names.append((name, number, at_corners, values.dtype, values.shape[1:]))

    def attributes(self, halfedges):
        result = {}
        for name, number, at_corners, dtype, shape in self.names:
            rows = self.attribute(number, at_corners).reshape(-1, int(np.prod(shape)))
            rows = rows[halfedges] if at_corners else rows
            if dtype.kind in "iu":
                rows = np.clip(np.rint(rows), np.iinfo(dtype).min, np.iinfo(dtype).max)
            result[name] = rows.astype(dtype).reshape(len(rows), *shape)
        return result

    def result(self, report=None):
        """What the control mesh has become."""
        offsets, indices, halfedges = self.faces()
        ends, of_edges, of_vertices = self.edges()
        creases, corners, attributes = np.flatnonzero(of_edges), np.flatnonzero(of_vertices), self.attributes(halfedges)
        return Mesh(self.points(), offsets, indices, *self.normals(report is not None), ends.reshape(-1, 2)[creases], of_edges[creases],
                    corners, of_vertices[corners], attributes.pop("uv", None), attributes, self.face_parents(), report)
