# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Reads polygon meshes as Python has them, and checks them."""

from __future__ import annotations

import numpy as np

from . import _core

BORDERS = ("surface", "curve", "corners", "fixed")
ESTIMATES = ("coherent", "reciprocal", "angle")


def real_rows(name, values, columns):
    rows = np.ascontiguousarray(values, dtype=np.float64)
    if rows.ndim != 2 or rows.shape[1] != columns:
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


def choice(name, value, words):
    if value not in words:
        raise ValueError(f"{name} '{value}': it must be one of {', '.join(words)}")
    return words.index(value)


def of_corners(name, array, vertices, corners):
    """Whether an array has a row for each corner, and not for each vertex."""
    if np.ndim(array) and len(array) in (vertices, corners):
        return len(array) != vertices
    raise ValueError(f"{name} must have a row for each of the {vertices} vertices or of the {corners} corners of faces")


def polygons(faces):
    """Offsets and indices of an array (m, d), of a tuple (offsets, indices), or of a list of polygons."""
    if isinstance(faces, tuple) and len(faces) == 2:
        return faces
    if isinstance(faces, np.ndarray):
        if faces.ndim != 2:
            raise ValueError(f"faces must have the shape (m, 3) or (m, 4), not {faces.shape}")
        return np.arange(len(faces) + 1) * faces.shape[1], faces.reshape(-1)
    offsets = np.cumsum([0, *map(len, faces)])
    return offsets, np.concatenate([np.asarray(face) for face in faces]) if len(faces) else np.empty(0, int)


def arrays(mesh, faces):
    """Points, and the faces as one of the forms above, of a mesh of another library."""
    if faces is not None:
        return mesh, faces
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):  # trimesh
        return mesh.vertices, np.asarray(mesh.faces)
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):  # meshio
        blocks = [block for block in mesh.cells if block.type in ("triangle", "quad") or block.type.startswith("polygon")]
        return mesh.points, [face for block in blocks for face in np.asarray(block.data)]
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):  # pyvista: the size of each face before its vertices
        flat, found, at = np.asarray(mesh.faces), [], 0
        while at < len(flat):
            found.append(flat[at + 1:at + 1 + flat[at]])
            at += 1 + flat[at]
        return mesh.points, found
    raise ValueError("points need faces, unless they are a mesh: one of this module, trimesh, pyvista or meshio")


class Connectivity:
    """The half-edges of faces, checked. Edges have the numbers that the command pn_subdivide gives them, so that bits are the same."""

    def __init__(self, n, offsets, indices):
        offsets, indices = integers("offsets of faces", offsets, 2**32), integers("vertices of faces", indices, n)
        if max(n, 2 * len(indices)) >= 2**32:
            raise ValueError("too large: elements are numbered with 32 bits")
        degrees, sides = np.diff(offsets), np.arange(len(indices))
        if not len(offsets) or offsets[0] != 0 or offsets[-1] != len(indices) or (degrees < 0).any():
            raise ValueError("the offsets of the faces must ascend from 0 to the number of their corners")
        if (degrees < 3).any():
            face = np.argmax(degrees < 3)
            raise ValueError(f"face {face} has {degrees[face]} vertices: at least 3 are needed")
        face_of = np.repeat(np.arange(len(degrees)), degrees)
        keys = np.sort(face_of * n + indices)
        twice = keys[1:][keys[1:] == keys[:-1]]
        if twice.size:
            raise ValueError("face {} has vertex {} twice".format(*divmod(twice[0], n)))
        after = sides + 1
        after[offsets[1:] - 1] = offsets[:-1]
        self.n, self.offsets, self.indices, ends = n, offsets, indices, indices[after]
        # sides of faces with the same ends
        keys = np.minimum(indices, ends) * n + np.maximum(indices, ends)
        order = np.argsort(keys, kind="stable")
        meets = keys[order][1:] == keys[order][:-1]
        one, other = order[:-1][meets], order[1:][meets]
        wrong = np.flatnonzero((np.bincount(np.append(one, other), minlength=1) > 1)[one] | (indices[one] == indices[other]))
        if wrong.size:
            side = one[wrong[0]]
            raise ValueError(f"the faces at the edge from vertex {indices[side]} to vertex {ends[side]} do not fit into an oriented "
                             "surface: more than two, or two of opposite orientation")
        makes_edge = np.full(len(sides), True)
        makes_edge[other] = False
        halfedges = 2 * np.cumsum(makes_edge) - 2
        halfedges[other] = halfedges[one] + 1
        size = 2 * makes_edge.sum()
        targets, nexts, faces, leaving = (np.full(k, -1) for k in (size, size, size, n))
        targets[halfedges], targets[halfedges ^ 1] = ends, indices
        nexts[halfedges], faces[halfedges] = halfedges[after], face_of
        border = np.flatnonzero(faces < 0)
        fans = np.flatnonzero(np.bincount(targets[border], minlength=1) > 1)
        if fans.size:
            raise ValueError(f"vertex {fans[0]} joins several fans of faces")
        leaving[targets[border ^ 1]] = border
        nexts[border] = leaving[targets[border]]
        of_vertices = np.full(n, -1)
        of_vertices[ends] = halfedges
        of_vertices[targets[border]] = border
        self.arrays = targets, nexts, faces, of_vertices, halfedges[offsets[1:] - 1]
        self.edges, self.keys = halfedges[order] // 2, keys[order]

    def sharpness(self, creases, corners):
        """That of all edges and vertices."""
        of_edges, of_vertices = np.zeros(len(self.arrays[0]) // 2), np.zeros(self.n)
        (ends, values), (vertices, of_vertices_given) = sharp("creases", creases, 2, self.n), sharp("corners", corners, 1, self.n)
        of_vertices[vertices] = of_vertices_given
        ends = ends.reshape(-1, 2)
        keys = ends.min(axis=1) * self.n + ends.max(axis=1)
        found = np.searchsorted(self.keys, keys)
        is_there = np.append(self.keys, -1)[found] == keys
        if not is_there.all():
            raise ValueError("no face has the crease from vertex {} to vertex {}".format(*ends[np.argmin(is_there)]))
        of_edges[self.edges[found]] = values
        return of_edges, of_vertices


def sharp(name, given, columns, vertices):
    """Vertices and numbers of what is sharp: given alone, for ever, or as a tuple with the numbers of rounds."""
    values = None
    if isinstance(given, tuple) and len(given) == 2 and np.ndim(given[0]) == columns:
        given, values = given
    elements = integers(name, () if given is None else given, vertices)
    number = len(elements) // columns
    values = np.full(number, np.inf) if values is None else np.asarray(values, dtype=np.float64)
    if len(elements) != number * columns or values.shape != (number,):
        raise ValueError(f"{name} must have the shape (k{', 2' * (columns - 1)}), and their sharpness the shape (k,)")
    return elements, values


class Input:
    """A control mesh with all that is told of it, read into a Control of C++."""

    def __init__(self, points, faces=None, *, scheme=None, linear=False, normals=None, roundness=None, creases=None,
                 corners=None, border="surface", uv=None, attributes=None, threads=1):
        points, faces = arrays(points, faces)
        points = real_rows("points", points, 3)
        connectivity = Connectivity(len(points), *polygons(faces))
        if threads < 1 or (threads > 1 and not _core.has_threads):
            raise ValueError(f"threads {threads}: " + ("at least 1" if threads < 1 else "this module was built without TBB"))
        self.size = len(points), len(connectivity.indices)
        self.control = _core.Control(points, *connectivity.arrays)
        self.control.threads = threads
        if scheme is None:
            scheme = "loop" if (np.diff(connectivity.offsets) == 3).all() else "catmull-clark"
        name, parameters = (scheme, {}) if isinstance(scheme, str) else scheme
        self.control.set_scheme(name, parameters, linear)
        angle = -1.0
        if np.isscalar(creases):
            angle, creases = float(creases), None
        self.control.set_sharpness(choice("border", border, BORDERS), *connectivity.sharpness(creases, corners), angle)
        self.set_normals(normals, roundness)
        self.attributes = []
        for key, values in {**(attributes or {}), **({} if uv is None else {"uv": uv})}.items():
            self.add_attribute(key, np.asarray(values))

    def set_normals(self, normals, roundness):
        n, c = self.size
        estimate = choice("normals", normals, ESTIMATES) if isinstance(normals, str) else 0
        normals = None if normals is None or isinstance(normals, str) else real_rows("normals", normals, 3)
        if roundness is not None:
            roundness = np.asarray(roundness, dtype=np.float64)
            roundness = np.full(n, roundness) if roundness.ndim == 0 else roundness
            # refined values are a little beyond 0 and 1
            if not ((roundness >= -0.5) & (roundness <= 1.5)).all():
                raise ValueError("roundness must be from 0 to 1")
        self.control.set_normals(
            normals, normals is not None and of_corners("normals", normals, n, c),
            roundness, roundness is not None and of_corners("roundness", roundness, n, c), estimate)

    def add_attribute(self, name, values):
        if values.dtype.kind not in "iufb":
            raise ValueError(f"attribute '{name}' must be numbers, not {values.dtype}")
        at_corners = of_corners(f"attribute '{name}'", values, *self.size)
        rows = values.reshape(len(values), -1).astype(np.float64)
        if at_corners:
            halfedges = self.control.faces()[2]
            of_halfedges = np.zeros((2 * len(self.control.edges()[1]), rows.shape[1]))
            of_halfedges[halfedges] = rows
            rows = of_halfedges
        self.control.add_attribute(rows, at_corners, values.dtype.kind != "f")
        self.attributes.append((name, at_corners, values.dtype, values.shape[1:]))

    def read_attributes(self, halfedges):
        """Those of the refined mesh."""
        result, numbers = {}, [0, 0]
        for name, at_corners, dtype, shape in self.attributes:
            rows = self.control.attribute(numbers[at_corners], at_corners).reshape(-1, int(np.prod(shape, dtype=int)))
            numbers[at_corners] += 1
            rows = rows[halfedges] if at_corners else rows
            if dtype.kind in "iu":
                rows = np.clip(np.rint(rows), np.iinfo(dtype).min, np.iinfo(dtype).max)
            result[name] = rows.astype(dtype).reshape(len(rows), *shape)
        return result
