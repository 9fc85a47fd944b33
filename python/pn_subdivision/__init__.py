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

import functools

import numpy as np

from . import _core
from ._mesh import Mesh, choice, control_mesh, integers, integers_and_reals, reals

__version__ = _core.version
KINDS = ("unknown", "plane", "cylinder", "cone", "sphere", "torus")
# as the structures of C++, aligned
_POINT = np.dtype([*((name, float, 3) for name in ("point", "normal", "du", "dv", "duu", "duv", "dvv")), ("derivatives", np.uint32),
                   ("error", float), ("normal_error", float), ("rounds", np.uint32)], align=True)
_HIT = np.dtype([("face", np.int32), ("uv", float, 2), ("point", float, 3), ("normal", float, 3), ("distance", float), ("error", float)],
                align=True)


def subdivide(points, faces=None, *, levels=1, progress=None, **options):
    """The mesh refined by some rounds, with its control normals for more of them.

    progress(round, faces) is called after each round; an exception that it raises, or Ctrl-C, ends the call.
    """
    control = control_mesh(points, faces, options)
    _core.subdivide(control, *integers("levels", levels, 64), progress)
    return control.result()


def limit(points, faces=None, *, levels=1, tolerance=1e-9, normal_tolerance=1e-3, progress=None, **options):
    """As subdivide(), with all vertices on the limit surface, and its normals: a mesh to be seen, not to be refined again.

    The tolerance is a part of the largest side of the box of the points. `report` has the largest estimated errors ("error",
    "normal_error"), how many vertices missed the tolerances ("number_of_misses"), and at how many the control normal stands in
    ("number_of_stand_ins").
    """
    control = control_mesh(points, faces, options)
    return control.result(_core.limit(control, *integers("levels", levels, 64), tolerance, normal_tolerance, progress)[0])


def tessellate(points, faces=None, *, chord, **options):
    """Triangles with the limit surface within a distance of `chord`, large where it is flat, with its normals.

    `report` has the estimated distance ("bound"), whether it is within `chord` ("reached"), and where it is ("worst_face", "worst_place").
    """
    control = control_mesh(points, faces, options)
    return control.result(_core.tessellate(control, chord)[0])


def estimate_normals(points, faces=None, **options):
    """Control normals and their roundness, as they are where none are given: (n, 3) and (n,); with creases of corners."""
    return control_mesh(points, faces, options).normals(False)


def recognize(points, faces=None, *, min_facets=8, tolerance=0.0, sharp_angle=30.0):
    """The planes, cylinders, cones, spheres and tori of which a mesh has facets: a Mesh with their normals, creases, corners and roundness,
    which other functions take; an array of them with the fields "kind" (a number of KINDS), "point", "direction", "radius", "residual", ...;
    and (m,) the number of that of each face. What is not recognized is refined linearly.

    A prism of fewer sides than `min_facets` stays one; 0 is the tolerance of the digits that coordinates have.
    """
    control = control_mesh(points, faces, {})
    surfaces, of_face = _core.recognize(control, min_facets, tolerance, sharp_angle)
    return control.result(), surfaces, of_face


class Refiner:
    """A refined surface that follows its control points and normals: as subdivide() of them, bit for bit, but faster.

    `points` and `normals` (n, 3) are views, which update() changes; with creases normals are the means of those of the corners.
    """

    def __init__(self, points, faces=None, *, levels=1, **options):
        control = control_mesh(points, faces, options)
        self._size, self._threads = control.size[0], control.threads
        self._refiner = _core.refiner(control, *integers("levels", levels, 64))
        self.points, self.normals = self._refiner.points(), self._refiner.normals()

    def set_points(self, vertices, points):
        """Of some control vertices (k,): the points (k, 3), from the next update() on."""
        self._refiner.set_points(*integers_and_reals("vertices", vertices, self._size, "points", points, 3))

    def set_normals(self, vertices, normals):
        """The same of the normals; those that are not set are estimated again unless there were some."""
        self._refiner.set_normals(*integers_and_reals("vertices", vertices, self._size, "normals", normals, 3))

    def update(self):
        """Computes what has changed, and returns the numbers of these refined vertices."""
        return self._refiner.update(self._threads)

    def mesh(self):
        """A copy."""
        return Mesh(self.points.copy(), *self._refiner.faces()[:2], self.normals.copy() if len(self.normals) else None)


class Limit_surface:
    """The limit surface with parameters on each control face, of schemes that split edges in halves.

    Those of a quadrilateral are u, v from 0 to 1, (0, 0) at its first corner and (1, 0) at the second one; of triangles u, v >= 0 with
    u + v <= 1; other polygons have a square at each corner i, with u from 2i to 2i + 1.
    """

    def __init__(self, points, faces=None, *, tolerance=1e-7, normal_tolerance=1e-3, **options):
        control = control_mesh(points, faces, options)
        self._number_of_faces = len(control.face_parents())
        self._surface = _core.limit_surface(control, tolerance, normal_tolerance)

    def evaluate(self, faces, uv):
        """Of faces (k,) with parameters (k, 2) an array with the fields "point", "normal", "du", "dv", "duu", "duv", "dvv",
        "derivatives" (up to which order there are some), "error" and "normal_error" (estimates), and "rounds"."""
        return self._surface.evaluate(*integers_and_reals("faces", faces, self._number_of_faces, "parameters", uv, 2)).view(_POINT)[:, 0]

    def closest_point(self, points):
        """Of points (k, 3) an array with the fields "face", "uv", "point", "normal", "distance" and "error"."""
        return self._queries.closest_points(reals("points", points, 3)).view(_HIT)[:, 0]

    def ray(self, sources, directions):
        """The same of the first intersections with rays (k, 3) and (k, 3); without one the face is -1, and all else not a number."""
        sources, directions = np.broadcast_arrays(reals("sources", sources, 3), reals("directions", directions, 3))
        return self._queries.first_intersections(sources, directions).view(_HIT)[:, 0]

    @functools.cached_property
    def _queries(self):
        return _core.Limit_surface_queries(self._surface)


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
    rows = _core.curve(np.hstack([points, rows]), normals is not None, spline, int(number), ending, *integers("levels", levels, 64), linear, roundness)
    return rows[:, :columns].copy(), rows[:, columns:].copy()
