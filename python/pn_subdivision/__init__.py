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

import numpy as np

from . import _core
from ._input import Input, choice, integers, real_rows

__version__ = _core.version
_SURFACE_POINT = np.dtype([*((name, float, 3) for name in ("point", "normal", "du", "dv", "duu", "duv", "dvv")),
                           *((name, float) for name in ("derivatives", "error", "normal_error"))])
KINDS = ("unknown", "plane", "cylinder", "cone", "sphere", "torus")


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
        degrees = np.diff(self.offsets)
        cells = [({3: "triangle", 4: "quad"}.get(d, "polygon"),
                  self.indices[self.offsets[:-1][degrees == d][:, None] + np.arange(d)]) for d in np.unique(degrees)]
        import meshio
        return meshio.Mesh(self.points, cells)

    def _options(self):
        given = {"normals": self.normals, "roundness": self.roundness, "uv": self.uv, "attributes": self.attributes,
                 "creases": None if self.creases is None else (self.creases, self.crease_sharpness),
                 "corners": None if self.corners is None else (self.corners, self.corner_sharpness)}
        return {name: value for name, value in given.items() if value is not None}


def _read(points, faces, options):
    if isinstance(points, Mesh) and faces is None:
        return Input(points.points, (points.offsets, points.indices), **{**points._options(), **options})
    return Input(points, faces, **options)


def _result(given, report=None):
    control = given.control
    offsets, indices, halfedges = control.faces()
    normals, roundness = control.normals()
    ends, of_edges, of_vertices = control.edges()
    creases, corners, parents = np.flatnonzero(of_edges), np.flatnonzero(of_vertices), control.face_parents()
    attributes = given.read_attributes(halfedges)
    return Mesh(control.points(), offsets, indices, normals, roundness, ends.reshape(-1, 2)[creases], of_edges[creases],
                corners, of_vertices[corners], attributes.pop("uv", None), attributes,
                parents if len(parents) else np.arange(len(offsets) - 1), report)


def subdivide(points, faces=None, *, levels=1, progress=None, **options):
    """The mesh refined by some rounds, with its control normals for more of them.

    progress(round, faces) is called after each round; an exception that it raises, or Ctrl-C, ends the call.
    """
    given = _read(points, faces, options)
    _core.subdivide(given.control, levels, progress)
    return _result(given)


def limit(points, faces=None, *, levels=1, tolerance=1e-9, normal_tolerance=1e-3, progress=None, **options):
    """As subdivide(), with all vertices on the limit surface, and its normals: a mesh to be seen, not to be refined again.

    The tolerance is a part of the largest side of the box of the points. `report` has the largest estimated errors ("error", "normal_error"), how
    many vertices missed the tolerances ("number_of_misses"), and at how many the control normal stands in ("number_of_stand_ins").
    """
    given = _read(points, faces, options)
    return _result(given, _core.limit(given.control, levels, tolerance, normal_tolerance, progress)[0])


def tessellate(points, faces=None, *, chord, **options):
    """Triangles with the limit surface within a distance of `chord`, large where it is flat, with its normals.

    `report` has the estimated distance ("bound"), whether it is within `chord` ("reached"), and where it is ("worst_face", "worst_place").
    """
    given = _read(points, faces, options)
    return _result(given, _core.tessellate(given.control, chord)[0])


def estimate_normals(points, faces=None, **options):
    """Control normals and their roundness, as they are where none are given: (n, 3) and (n,); with creases of corners."""
    return _read(points, faces, options).control.normals()


def recognize(points, faces=None, *, min_facets=8, tolerance=0.0, sharp_angle=30.0):
    """The planes, cylinders, cones, spheres and tori of which a mesh has facets: a Mesh with their normals, creases, corners and roundness,
    which other functions take; an array of them with the fields "kind" (a number of KINDS), "point", "direction", "radius", "residual", ...;
    and (m,) the number of that of each face. What is not recognized is refined linearly.

    A prism of fewer sides than `min_facets` stays one; 0 is the tolerance of the digits that coordinates have.
    """
    given = _read(points, faces, {})
    surfaces, of_face = _core.recognize(given.control, min_facets, tolerance, sharp_angle)
    return _result(given), surfaces, of_face


class Refiner:
    """A refined surface that follows its control points and normals: as subdivide() of them, bit for bit, but faster."""

    def __init__(self, points, faces=None, *, levels=1, **options):
        given = _read(points, faces, options)
        self._number = given.size[0]
        self._refiner = _core.Refiner(given.control, levels)

    def set_points(self, vertices, points):
        """Of some control vertices (k,): the points (k, 3), from the next update() on."""
        self._refiner.set_points(*self._rows(vertices, points))

    def set_normals(self, vertices, normals):
        """The same of the normals; those that are not set are estimated again unless there were some."""
        self._refiner.set_normals(*self._rows(vertices, normals))

    def update(self):
        """Computes what has changed, and returns the numbers of these refined vertices."""
        return self._refiner.update()

    @property
    def points(self):
        """(n, 3): a view, which the next update() changes."""
        return self._refiner.points()

    @property
    def normals(self):
        """The same of the normals; with creases the means of those of the corners."""
        return self._refiner.normals()

    def mesh(self):
        """A copy."""
        normals = self.normals.copy()
        return Mesh(self.points.copy(), *self._refiner.faces(), normals if len(normals) else None)

    def _rows(self, vertices, values):
        vertices = integers("vertices", vertices, self._number)
        values = real_rows("values", np.reshape(values, (-1, 3)), 3)
        if len(vertices) != len(values):
            raise ValueError(f"{len(vertices)} vertices do not go with {len(values)} rows")
        return vertices, values


class Limit_surface:
    """The limit surface with parameters on each control face, of schemes that split edges in halves.

    Those of a quadrilateral are u, v from 0 to 1, (0, 0) at its first corner and (1, 0) at the second one; of triangles u, v >= 0 with
    u + v <= 1; other polygons have a square at each corner i, with u from 2i to 2i + 1.
    """

    def __init__(self, points, faces=None, *, tolerance=1e-7, normal_tolerance=1e-3, **options):
        given = _read(points, faces, options)
        self._number = len(given.control.faces()[0]) - 1
        self._surface = _core.Limit_surface(given.control, tolerance, normal_tolerance)

    def evaluate(self, faces, uv):
        """Of faces (k,) with parameters (k, 2) an array with the fields "point", "normal", "du", "dv", "duu", "duv", "dvv",
        "derivatives" (up to which order there are some), "error" and "normal_error" (estimates)."""
        faces, uv = integers("faces", faces, self._number), real_rows("uv", uv, 2)
        if len(faces) != len(uv):
            raise ValueError(f"{len(faces)} faces do not go with {len(uv)} pairs of parameters")
        return self._surface.evaluate(faces, uv).view(_SURFACE_POINT)

    def closest_point(self, points):
        """Of points (k, 3) an array with the fields "face", "uv", "point", "normal", "distance" and "error"."""
        return self._surface.closest(real_rows("points", points, 3))

    def ray(self, sources, directions):
        """The same of the first intersections with rays (k, 3) and (k, 3); without one the face is -1, and all else not a number."""
        sources, directions = np.broadcast_arrays(real_rows("sources", sources, 3), real_rows("directions", directions, 3))
        return self._surface.intersect(sources, directions)


def curve(points, normals=None, *, mask="bspline:3", closed=False, end="reflect", levels=1, linear=False, roundness=1.0):
    """A refined polygon in the plane or in space: points and normals (n, 2) or (n, 3); normals that are not given are estimated.

    Masks are "bspline:DEGREE" and "N-point" (interpolating, N even). end="none": only points with all of their stencil.
    """
    columns = 2 if np.ndim(points) == 2 and np.shape(points)[1] == 2 else 3
    points = real_rows("points", points, columns)
    normals = None if normals is None else real_rows("normals", normals, columns)
    if normals is not None and len(normals) != len(points):
        raise ValueError(f"{len(points)} points do not go with {len(normals)} normals")
    spline, number = mask.startswith("bspline:"), mask.removeprefix("bspline:").removesuffix("-point")
    if not number.isdigit() or not (spline or mask.endswith("-point")):
        raise ValueError(f"mask '{mask}': it must be bspline:DEGREE or N-point")
    ending = 0 if closed else 1 + choice("end", end, ("reflect", "none"))
    return _core.refine_curve(points, normals, spline, int(number), ending, levels, linear, roundness)
