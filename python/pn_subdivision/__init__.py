# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Point-normal subdivision: refined meshes, limit surfaces, triangles to a tolerance, and curves, of NumPy arrays.

A mesh is points (n, 3) with faces, which are an array of integers (m, 3) or (m, 4), a list of polygons, or a tuple (offsets,
indices); or one object for both: a `Mesh` of this module, whose normals, creases and attributes count unless others are given, a
trimesh.Trimesh, pyvista.PolyData or meshio.Mesh. It is an oriented surface, with or without borders. Nothing given is changed.
Lengths are in the unit of the points, angles in radians unless degrees are named. Whatever is refused is a ValueError that
names the element. Long calls release the lock of the interpreter.

Options of all functions that take a control mesh:
  scheme      a name such as "catmull-clark", "loop", "butterfly", "kobbelt", "doo-sabin", "sqrt3", or a tuple with a dict of its
              parameters; by default "loop" of triangles, else "catmull-clark"
  linear      True: the linear scheme, without normals
  normals     control normals (n, 3) or, of the corners of the faces, (c, 3), 0 0 0 where there is none; or how they are
              estimated: "coherent" (the default), "reciprocal" or "angle"
  roundness   from 0 (points as of the linear scheme) to 1: a number, (n,) or (c,); by default 1 where normals are given, else
              estimated
  creases     sharp edges: pairs of vertices (k, 2), or a tuple of these and the number of rounds (k,) for which each is sharp; or
              an angle in degrees, above which edges are sharp
  corners     sharp vertices (k,), or a tuple as for creases
  border      "surface", "curve", "corners" or "fixed"
  uv          (n, 2) or (c, 2), where those of a vertex may differ along seams
  attributes  a dict of arrays (n, ...) or (c, ...): floats are averaged, integers at vertices are labels. What belongs to
              faces is array[mesh.face_parents] afterwards.
  threads     how many there may be, by default 1; the result is the same, bit for bit
"""

import dataclasses
import functools

import numpy as np

from . import _core

__all__ = ["KINDS", "Limit_surface", "Mesh", "Refiner", "curve", "estimate_normals", "limit", "recognize", "subdivide", "tessellate"]
__version__, KINDS = _core.version, _core.KINDS
# as the structures of C++, aligned
_POINT = np.dtype({"names": "point normal du dv duu duv dvv derivatives error normal_error rounds".split(),
                   "formats": 7 * ["3d"] + ["u4", "d", "d", "u4"]}, align=True)
_HIT = np.dtype({"names": "face uv point normal distance error".split(), "formats": "i4 2d 3d 3d d d".split()}, align=True)


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
    is_tuple = isinstance(given, tuple) and len(given) == 2 and (given[0] is None or np.ndim(given[0]) == columns)
    elements, rounds = given if is_tuple else (given, None)
    elements = integers(name, () if elements is None else elements, vertices)
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
        most = degrees.max(initial=3)
        return self.indices.reshape(-1, most) if (degrees == most).all() else np.split(self.indices, self.offsets[1:-1])

    def triangles(self):
        """(t, 3): the faces as fans of triangles."""
        first = np.repeat(self.offsets[:-1], np.diff(self.offsets) - 2)
        second = np.delete(np.arange(len(self.indices)), np.concatenate([self.offsets[:-1], self.offsets[1:] - 1]))
        return self.indices[np.stack([first, second, second + 1], axis=1)]

    def to_trimesh(self):
        """A trimesh.Trimesh of triangles(), with normals if they are of vertices."""
        import trimesh
        return trimesh.Trimesh(self.points, self.triangles(), process=False,
                               vertex_normals=self.normals if np.shape(self.normals) == self.points.shape else None)

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
        own = {name: getattr(mesh, name) for name in ("normals", "roundness", "uv", "attributes")}
        own.update(creases=(mesh.creases, mesh.crease_sharpness), corners=(mesh.corners, mesh.corner_sharpness))
        return Control(mesh.points, (mesh.offsets, mesh.indices), **{**own, **options})
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):  # trimesh
        return Control(mesh.vertices, np.asarray(mesh.faces), **options)
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):  # meshio
        blocks = (b for b in mesh.cells if b.type in ("triangle", "quad") or b.type.startswith("polygon"))
        return Control(mesh.points, [face for b in blocks for face in b.data], **options)
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):  # pyvista, with the size of each face before its vertices
        numbers = iter(np.asarray(mesh.faces).tolist())
        return Control(mesh.points, [[next(numbers) for _ in range(size)] for size in numbers], **options)
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
        default = "loop" if (np.diff(offsets) == 3).all() else "catmull-clark"
        name, parameters = scheme if isinstance(scheme, tuple) else (default if scheme is None else scheme, {})
        estimates, borders = ("coherent", "reciprocal", "angle"), ("surface", "curve", "corners", "fixed")
        estimate, normals = (choice("normals", normals, estimates), None) if isinstance(normals, str) else (0, normals)
        super().__init__(points, offsets, indices, name, parameters, linear, threads,
                         choice("border", border, borders), estimate)
        n, self.number_of_faces, self.threads = len(points), len(offsets) - 1, threads
        self.size, self.carried = (n, len(indices)), ([], [])  # of vertices, of corners
        angle, creases = (reals("creases", creases)[0], None) if np.isscalar(creases) else (None, creases)
        self.set_sharpness(angle, *sharp("creases", creases, 2, n), *sharp("corners", corners, 1, n))
        normals = None if normals is None else self.one_of_each("normals", reals("normals", normals, 3))
        if roundness is not None:
            roundness = reals("roundness", roundness).reshape(-1)
            roundness = self.one_of_each("roundness", np.full(n, roundness) if roundness.size == 1 else roundness)
        self.set_normals(normals, roundness)
        for name, values in {**(attributes or {}), **({} if uv is None else {"uv": uv})}.items():
            self.carry(name, self.one_of_each(f"attribute '{name}'", np.asarray(values)))

    def one_of_each(self, name, array):
        """The array, which has a row for each vertex or corner."""
        if np.ndim(array) and len(array) in self.size:
            return array
        raise ValueError("{} must have a row for each of the {} vertices or of the {} corners of faces".format(name, *self.size))

    def carry(self, name, values):
        """Takes an attribute along, which C++ has for vertices or for half-edges."""
        if values.dtype.kind not in "iufb":
            raise ValueError(f"attribute '{name}' must be numbers, not {values.dtype}")
        at_corners = len(values) != self.size[0]
        places = self.halfedges() if at_corners else slice(None)
        size = places.max(initial=-1) // 2 * 2 + 2 if at_corners else len(values)
        rows = np.zeros((size, int(np.prod(values.shape[1:]))))
        rows[places] = values.reshape(len(values), rows.shape[1])
        self.add_attribute(rows, at_corners, values.dtype.kind != "f")
        self.carried[at_corners].append((name, at_corners, values.dtype, values.shape[1:]))

    def result(self, report=None):
        """What the control mesh has become."""
        arrays, attributes = self.arrays(report is not None), {}
        for (name, at_corners, dtype, shape), rows in zip(self.carried[0] + self.carried[1], arrays.pop("attributes")):
            rows = rows.reshape(-1, *shape)[self.halfedges() if at_corners else slice(None)]
            if dtype.kind in "iu":
                rows = np.clip(np.rint(rows), np.iinfo(dtype).min, np.iinfo(dtype).max)
            attributes[name] = rows.astype(dtype)
        return Mesh(**arrays, uv=attributes.pop("uv", None), attributes=attributes, report=report)


def subdivide(points, faces=None, *, levels=1, progress=None, **options):
    """The mesh refined by some rounds, with its control normals for more of them.

    progress(round, faces) is called after each round; an exception that it raises, or Ctrl-C, ends the call.
    """
    control = control_mesh(points, faces, options)
    control.subdivide(*integers("levels", levels, 64), progress, None, 0)
    return control.result()


def limit(points, faces=None, *, levels=1, tolerance=1e-9, normal_tolerance=1e-3, progress=None, **options):
    """As subdivide(), with all vertices on the limit surface, and its normals: a mesh to be seen, not to be refined again.

    The tolerance is a part of the largest side of the box of the points. `report` has the largest estimated errors ("error",
    "normal_error"), how many vertices missed the tolerances ("number_of_misses"), and at how many the control normal stands in
    ("number_of_stand_ins").
    """
    control = control_mesh(points, faces, options)
    return control.result(control.subdivide(*integers("levels", levels, 64), progress, tolerance, normal_tolerance)[0])


def tessellate(points, faces=None, *, chord, **options):
    """Triangles with the limit surface within a distance of `chord`, large where it is flat, with its normals.

    `report` has the estimated distance ("bound"), whether it is within `chord` ("reached"), and where it is ("worst_face", "worst_place").
    """
    control = control_mesh(points, faces, options)
    return control.result(control.tessellate(chord)[0])


def estimate_normals(points, faces=None, **options):
    """Control normals and their roundness, as they are where none are given: (n, 3) and (n,); with creases of corners."""
    mesh = control_mesh(points, faces, options).result()
    return mesh.normals, mesh.roundness


def recognize(points, faces=None, *, min_facets=8, tolerance=0.0, sharp_angle=30.0):
    """The planes, cylinders, cones, spheres and tori of which a mesh has facets: a Mesh with their normals, creases, corners and roundness,
    which other functions take; an array of them with the fields "kind" (a number of KINDS), "point", "direction", "radius", "residual", ...;
    and (m,) the number of that of each face. What is not recognized is refined linearly.

    A prism of fewer sides than `min_facets` stays one; 0 is the tolerance of the digits that coordinates have.
    """
    control = control_mesh(points, faces, {})
    surfaces, of_face, roundness = control.recognize(min_facets, tolerance, sharp_angle)
    part = control.result()
    part.roundness = roundness[part.indices]
    part.crease_sharpness[:] = part.corner_sharpness[:] = np.inf
    return part, surfaces, of_face


class Refiner:
    """A refined surface that follows its control points and normals: as subdivide() of them, bit for bit, but faster.

    `points` and `normals` (n, 3) are views, which update() changes; with creases normals are the means of those of the corners.
    """

    def __init__(self, points, faces=None, *, levels=1, **options):
        control = control_mesh(points, faces, options)
        self._size, self._threads = control.size[0], control.threads
        self._refiner = control.refiner(*integers("levels", levels, 64))
        self.points, self.normals = self._refiner.points(), self._refiner.normals()
        self.points.flags.writeable = self.normals.flags.writeable = False

    def set_points(self, vertices, points):
        """Of some control vertices (k,): the points (k, 3), from the next update() on."""
        self._refiner.set(*integers_and_reals("vertices", vertices, self._size, "points", points, 3), False)

    def set_normals(self, vertices, normals):
        """The same of the normals; those that are not set are estimated again unless there were some."""
        self._refiner.set(*integers_and_reals("vertices", vertices, self._size, "normals", normals, 3), True)

    def update(self):
        """Computes what has changed, and returns the numbers of these refined vertices."""
        return self._refiner.update(self._threads)

    def mesh(self):
        """A copy."""
        normals = self.normals.copy() if len(self.normals) else None
        return Mesh(self.points.copy(), **self._refiner.faces(), normals=normals)


class Limit_surface:
    """The limit surface with parameters on each control face, of schemes that split edges in halves.

    Those of a quadrilateral are u, v from 0 to 1, (0, 0) at its first corner and (1, 0) at the second one; of triangles u, v >= 0 with
    u + v <= 1; other polygons have a square at each corner i, with u from 2i to 2i + 1.
    """

    def __init__(self, points, faces=None, *, tolerance=1e-7, normal_tolerance=1e-3, **options):
        control = control_mesh(points, faces, options)
        self._number_of_faces = control.number_of_faces
        self._surface = control.limit_surface(tolerance, normal_tolerance)
        self._queries = functools.cache(functools.partial(_core.Limit_surface_queries, self._surface))

    def evaluate(self, faces, uv):
        """Of faces (k,) with parameters (k, 2) an array with the fields "point", "normal", "du", "dv", "duu", "duv", "dvv",
        "derivatives" (up to which order there are some), "error" and "normal_error" (estimates), and "rounds"."""
        return self._surface.evaluate(*integers_and_reals("faces", faces, self._number_of_faces, "parameters", uv, 2)).view(_POINT)[:, 0]

    def closest_point(self, points):
        """Of points (k, 3) an array with the fields "face", "uv", "point", "normal", "distance" and "error"."""
        return self._queries().hits(reals("points", points, 3), None).view(_HIT)[:, 0]

    def ray(self, sources, directions):
        """The same of the first intersections with rays (k, 3) and (k, 3); without one the face is -1, and all else not a number."""
        rays = np.broadcast_arrays(reals("sources", sources, 3), reals("directions", directions, 3))
        return self._queries().hits(*rays).view(_HIT)[:, 0]


def curve(points, normals=None, *, mask="bspline:3", closed=False, end="reflect", levels=1, linear=False, roundness=1.0):
    """A refined polygon in the plane or in space: points and normals (n, 2) or (n, 3); normals that are not given are estimated.

    Masks are "bspline:DEGREE" and "N-point" (interpolating, N even). end="none": only points with all of their stencil.
    """
    columns = 2 if np.ndim(points) == 2 and np.shape(points)[1] == 2 else 3
    points = reals("points", points, columns)
    rows = np.zeros_like(points) if normals is None else reals("normals", normals, columns)
    if len(rows) != len(points):
        raise ValueError(f"{len(points)} points do not go with {len(rows)} normals")
    spline, number = str(mask).startswith("bspline:"), str(mask).removeprefix("bspline:").removesuffix("-point")
    if not number.isdigit() or not (spline or str(mask).endswith("-point")):
        raise ValueError(f"mask '{mask}': it must be bspline:DEGREE or N-point")
    ending = 0 if closed else 1 + choice("end", end, ("reflect", "none"))
    refine = _core.curve_2 if columns == 2 else _core.curve_3
    rows = refine(np.hstack([points, rows]), normals is not None, spline, int(number), ending, *integers("levels", levels, 64), linear, roundness)
    return rows[:, :columns].copy(), rows[:, columns:].copy()
