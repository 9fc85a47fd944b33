# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
import sys
import threading
import time
import tracemalloc

import numpy as np
import pn_subdivision as pn
import pytest
from shapes import (CUBE, CUBE_EDGES, OCTAHEDRON, QUADS, TRIANGLES, catmull_clark, in_order, open_cylinder, plane, prism, radius,
                    same_bits, torus, unit)

RANDOM = np.random.default_rng(1)


@pytest.mark.parametrize("scheme", ["catmull-clark", "kobbelt", "doo-sabin", "modified-catmull-clark", "bilinear"])
@pytest.mark.parametrize("normals", [CUBE, None, "reciprocal"])
def test_a_cube_becomes_a_sphere(scheme, normals):
    sphere = pn.subdivide(CUBE, QUADS, scheme=scheme, normals=normals, levels=3)
    assert np.abs(np.linalg.norm(sphere.points, axis=1) - np.sqrt(3)).max() < 1e-14 * 30
    assert np.abs(sphere.normals - unit(sphere.points)).max() < 1e-13
    assert np.all(sphere.roundness == 1)
    if scheme != "doo-sabin":
        assert sphere.faces.shape == (6 * 4**3, 4)
        assert np.bincount(sphere.face_parents).tolist() == [64] * 6


@pytest.mark.parametrize("scheme", [None, "loop", "butterfly", "sqrt3", "midpoint", "modified-loop"])
def test_an_octahedron_becomes_a_sphere(scheme):
    sphere = pn.subdivide(OCTAHEDRON, TRIANGLES, scheme=scheme, normals=OCTAHEDRON, levels=2)
    assert np.abs(np.linalg.norm(sphere.points, axis=1) - 1).max() < 1e-14
    assert sphere.faces.shape == (8 * (9 if scheme == "sqrt3" else 16), 3)


def test_the_default_scheme_is_loop_of_triangles_and_catmull_clark_of_others():
    assert same_bits(pn.subdivide(OCTAHEDRON, TRIANGLES).points, pn.subdivide(OCTAHEDRON, TRIANGLES, scheme="loop").points)
    assert same_bits(pn.subdivide(CUBE, QUADS).points, pn.subdivide(CUBE, QUADS, scheme="catmull-clark").points)


def test_faces_may_be_arrays_lists_or_offsets_and_indices():
    array = pn.subdivide(CUBE, QUADS, levels=2)
    for faces in (QUADS.tolist(), list(QUADS), (4 * np.arange(7), QUADS.reshape(-1)), QUADS.astype(np.uint8), QUADS[:, ::1].copy("F")):
        other = pn.subdivide(CUBE, faces, levels=2)
        assert same_bits(array.points, other.points) and same_bits(array.faces, other.faces)
    points, polygons, _ = prism(5)
    sizes = np.cumsum([0, *map(len, polygons)])
    mixed = pn.subdivide(points, polygons, linear=True)
    assert same_bits(mixed.points, pn.subdivide(points, (sizes, np.concatenate(polygons)), linear=True).points)
    back = pn.subdivide(points, polygons, levels=0)
    assert [face.tolist() for face in back.faces] == polygons and same_bits(back.points, points)
    assert back.face_parents.tolist() == list(range(7))


def test_linear_is_the_scheme_of_catmull_and_clark():
    points, quads, _ = torus(5, 4)
    for p, q in ((CUBE, QUADS), (points, quads)):
        linear = pn.subdivide(p, q, linear=True)
        assert np.abs(in_order(linear.points) - in_order(catmull_clark(p, q))).max() < 1e-14
        assert linear.normals is None and linear.roundness is None


def test_roundness_0_has_the_points_of_the_linear_scheme_and_a_half_is_between():
    points, quads, normals = torus(6, 5)
    linear, flat, half, full = (pn.subdivide(points, quads, **options) for options in (
        {"linear": True}, {"normals": normals, "roundness": 0}, {"normals": normals, "roundness": np.full(30, 0.5)}, {"normals": normals}))
    assert np.abs(linear.points - flat.points).max() < 1e-15
    assert 0.1 < np.linalg.norm(half.points - flat.points) / np.linalg.norm(full.points - flat.points) < 0.9
    assert np.all(half.roundness == 0.5)


def test_borders():
    points, quads = open_cylinder()
    radial = points * [1, 1, 0]
    surface = pn.subdivide(points, quads, normals=radial, levels=2)
    assert np.abs(radius(surface.points) - 1).max() < 1e-14
    curve = pn.subdivide(points, quads, normals=radial, levels=2, border="curve")
    on_border = np.isclose(curve.points[:, 2], 0)
    assert on_border.sum() == 32 and np.abs(radius(curve.points) - 1).max() < 1e-14
    flat, cells = plane()
    linear = {"linear": True, "scheme": "catmull-clark"}
    assert not np.any(np.all(pn.subdivide(flat, cells, **linear, border="curve").points == 0, axis=1))
    assert np.any(np.all(pn.subdivide(flat, cells, **linear, border="corners").points == 0, axis=1))
    fixed = pn.subdivide(flat, cells, border="fixed", normals="angle")
    outside = np.flatnonzero((flat[:, :2] == 0).any(1) | (flat[:, :2] == 3).any(1))
    assert same_bits(fixed.points[outside], flat[outside])


def test_a_cylinder_with_ends_stays_one_by_creases():
    points, polygons, rims = prism(8)
    part = pn.subdivide(points, polygons, creases=rims, levels=3)
    inside = (part.points[:, 2] > 0) & (part.points[:, 2] < 2)
    rim = np.unique(part.creases)
    assert np.abs(radius(part.points[inside]) - 1).max() < 1e-14 and np.abs(radius(part.points[rim]) - 1).max() < 1e-14
    assert set(part.points[~inside, 2]) == {0.0, 2.0}
    assert len(part.creases) == 16 * 8 and np.all(part.crease_sharpness == np.inf)
    assert part.normals.shape == part.points[part.indices].shape  # of corners
    z, sides = part.points[part.indices][:, 2], np.repeat(part.face_parents < 8, np.diff(part.offsets))
    assert np.abs(part.normals[sides, 2]).max() < 1e-14
    assert np.abs(np.abs(part.normals[~sides, 2]) - 1).max() < 1e-14 and set(z[~sides]) == {0.0, 2.0}
    detected = pn.subdivide(points, polygons, creases=50.0, levels=3)
    assert same_bits(detected.points, part.points) and same_bits(detected.normals, part.normals)


def test_normals_of_vertices_count_where_creases_do_not_separate():
    points, polygons, rims = prism(8)
    turned = np.zeros_like(points)
    both = pn.subdivide(points, polygons, creases=rims, levels=0, normals=turned)
    estimated = pn.subdivide(points, polygons, creases=rims, levels=0)
    assert same_bits(both.normals, estimated.normals)  # all vertices are on creases
    one = pn.subdivide(points, polygons, creases=rims[:1], levels=0, normals=unit(points - [0, 0, 1]))
    assert np.abs(one.normals[one.indices == 5] - unit(points - [0, 0, 1])[5]).max() < 1e-15


def test_sharpness_counts_rounds_and_corners_stay():
    semi = pn.subdivide(CUBE, QUADS, creases=(CUBE_EDGES[:3], [1, 2, np.inf]), linear=True)
    assert sorted(semi.crease_sharpness.tolist()) == [1, 1, np.inf, np.inf]
    corner = pn.subdivide(CUBE, QUADS, corners=[3], linear=True, levels=3)
    assert same_bits(corner.points[3], CUBE[3]) and corner.corners.tolist() == [3]
    once = pn.subdivide(CUBE, QUADS, corners=([3], [1]), linear=True, levels=2)
    assert not np.array_equal(once.points[3], CUBE[3]) and len(once.corners) == 0


def test_two_rounds_are_one_and_one_more():
    points, quads, normals = torus(6, 5)
    options = {"uv": np.arange(240.0).reshape(120, 2) % 7, "attributes": {"weight": points[:, 0], "label": np.arange(30)}}
    for mesh in (dict(points=points, faces=quads, normals=normals), dict(points=points, faces=quads),
                 dict(points=points, faces=quads, normals=normals, creases=[[0, 5], [5, 10]])):
        two = pn.subdivide(**mesh, **options, levels=2)
        one = pn.subdivide(pn.subdivide(**mesh, **options))  # numbers its edges in another order
        assert np.abs(in_order(two.points) - in_order(one.points)).max() < 1e-9
        assert np.abs(np.sort(two.uv, axis=0) - np.sort(one.uv, axis=0)).max() < 1e-13
        assert np.array_equal(np.bincount(two.attributes["label"]), np.bincount(one.attributes["label"]))


def test_attributes():
    flat, cells = plane()
    color = np.tile(np.array([[10, 20, 30]], np.uint8), (16, 1))
    mesh = pn.subdivide(flat, cells, scheme="bilinear", linear=True, levels=2, uv=2 * flat[:, :2] + 1,
                        attributes={"color": color, "label": np.arange(16, dtype=np.int16), "x": flat[:, 0].astype(np.float32),
                                    "tensor": flat[:, :, None] * np.ones(2)})
    assert np.abs(mesh.uv - (2 * mesh.points[:, :2] + 1)).max() < 1e-14
    assert mesh.attributes["color"].dtype == np.uint8 and np.all(mesh.attributes["color"] == [10, 20, 30])
    nearest = mesh.attributes["label"]
    assert nearest.dtype == np.int16 and np.abs(flat[nearest] - mesh.points).max() <= 0.5
    assert mesh.attributes["x"].dtype == np.float32 and mesh.attributes["tensor"].shape == (len(mesh.points), 3, 2)
    assert np.abs(mesh.attributes["tensor"] - mesh.points[:, :, None]).max() < 1e-14
    of_faces = np.array([7, 8, 9] * 3)[mesh.face_parents]
    middles = mesh.points[mesh.faces].mean(1)
    assert np.all(of_faces == 7 + middles[:, 1].astype(int))


def test_uv_of_corners_keep_their_seams():
    uv = np.tile([[0, 0], [1, 0], [1, 1], [0, 1]], (6, 1)) + 10.0 * np.repeat(np.arange(6), 4)[:, None]
    mesh = pn.subdivide(CUBE, QUADS, levels=2, uv=uv)
    assert mesh.uv.shape == (6 * 16 * 4, 2)
    assert np.abs(mesh.uv - 10 * np.repeat(mesh.face_parents, 4)[:, None] - 0.5).max() <= 0.5 + 1e-14


def test_threads_make_the_same_bits():
    if not pn._core.has_threads:
        pytest.skip("left out: the module is built without TBB")
    points, quads, normals = torus(20, 15)
    for options in ({"normals": normals}, {"linear": True}, {"creases": quads[:9, :2]}):
        one, two = (pn.subdivide(points, quads, levels=2, threads=n, **options) for n in (1, 3))
        assert same_bits(one.points, two.points)


def test_progress_is_told_and_ends_the_call():
    told = []
    pn.subdivide(CUBE, QUADS, levels=3, progress=lambda *numbers: told.append(numbers))
    assert told == [(1, 24), (2, 96), (3, 384)]

    class Enough(Exception):
        pass

    def end(round_done, faces):
        if round_done == 2:
            raise Enough(f"at {faces} faces")

    for function in (pn.subdivide, pn.limit):
        with pytest.raises(Enough, match="at 96 faces"):
            function(CUBE, QUADS, levels=5, progress=end)


@pytest.mark.parametrize("call", [
    lambda mesh, normals: pn.subdivide(*mesh, normals=normals, levels=2), lambda mesh, _: pn.subdivide(*mesh, linear=True, levels=3),
    lambda mesh, normals: pn.limit(*mesh, normals=normals), lambda mesh, normals: pn.tessellate(*mesh, normals=normals, chord=0.05),
    lambda mesh, _: pn.estimate_normals(*mesh), lambda mesh, _: pn.recognize(*mesh), lambda mesh, _: pn.Refiner(*mesh, levels=2),
    lambda *_: pn.Limit_surface(CUBE, QUADS).evaluate(np.zeros(400, int), np.full((400, 2), 0.3))])
def test_the_lock_is_released(call):
    """Another thread counts meanwhile, though it would not be let in once in an hour."""
    count, is_done = [0], threading.Event()

    def work():
        while not is_done.is_set():
            count[0] += 1
            time.sleep(0.0005)

    points, quads, normals = torus(32, 24)
    interval, worker = sys.getswitchinterval(), threading.Thread(target=work)
    sys.setswitchinterval(3600)
    try:
        worker.start()
        before, end = count[0], time.monotonic() + 0.2
        while time.monotonic() < end:
            call((points, quads), normals)
        assert count[0] - before > 10
    finally:
        sys.setswitchinterval(interval)
        is_done.set()
        worker.join()


def test_arrays_are_read_where_they_are_and_results_are_not_copied():
    points, faces = RANDOM.random((100_000, 3)), ([0], [])
    for given, most in ((points, 1.1), (np.asfortranarray(points), 2.1)):  # a copy of what is in another order
        tracemalloc.start()
        fine = pn.subdivide(given, faces, linear=True)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert (most - 1.1) * points.nbytes <= peak < (most - 1) * points.nbytes + 200_000
        assert np.array_equal(fine.points, points)
    assert not fine.points.flags.owndata and not fine.offsets.flags.owndata  # they show what C++ has made


def test_nothing_given_is_changed():
    points, normals, quads = CUBE.copy(), CUBE.copy(), QUADS.copy()
    for a in (points, normals, quads):
        a.setflags(write=False)
    pn.subdivide(points, quads, normals=normals, levels=1)
    assert same_bits(points, CUBE) and same_bits(normals, CUBE)


def test_empty_meshes_and_vertices_without_faces():
    empty = pn.subdivide(np.empty((0, 3)), [], levels=3)
    assert empty.points.shape == (0, 3) and len(empty.faces) == 0
    lonely = pn.subdivide(np.concatenate([CUBE, [[5, 6, 7]]]), QUADS, levels=1, linear=True)
    assert lonely.points[8].tolist() == [5, 6, 7]


POINT = CUBE.copy()
POINT[5, 1] = np.nan
TWO_FANS = ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], [[0, 1, 2], [0, 3, 4]])


@pytest.mark.parametrize("points, faces, options, message", [
    (CUBE[:, :2], QUADS, {}, r"points must have the shape \(n, 3\), not \(8, 2\)"),
    (CUBE, QUADS.reshape(-1), {}, r"faces must have the shape"),
    (CUBE, QUADS + 1, {}, "vertices of faces: 8 is not from 0 to 7"),
    (CUBE, -QUADS, {}, "vertices of faces: -2 is not from 0 to 7"),
    (CUBE, QUADS + 0.5, {}, "vertices of faces must be integers"),
    (CUBE, [[0, 1, 2], [3, 4]], {}, "face 1 has not three or more different vertices"),
    (CUBE, [[0, 1, 2], [3, 4, 5, 4, 6]], {}, "face 1 has not three or more different vertices"),
    (CUBE, ([0, 3, 2, 6], [0, 1, 2, 3, 4, 5]), {}, "offsets of the faces must ascend"),
    (CUBE, [[0, 1, 2], [0, 1, 3]], {}, "face 1 does not fit to those before it"),
    (CUBE, [[0, 1, 2], [1, 0, 3], [1, 0, 4]], {}, "face 2 does not fit to those before it"),
    (*TWO_FANS, {}, "vertex 0 joins several fans of faces"),
    (POINT, QUADS, {}, "of vertex 5 is not finite"),
    (CUBE, QUADS, {"scheme": "cubic"}, "there is no scheme 'cubic'; there are: catmull-clark"),
    (CUBE, QUADS, {"scheme": ("kobbelt", {"tension": 9})}, "tension"),
    (CUBE, QUADS, {"scheme": "loop"}, "triangle"),
    (CUBE, QUADS, {"border": "open"}, "border 'open': it must be one of surface, curve"),
    (CUBE, QUADS, {"normals": "best"}, "normals 'best': it must be one of coherent"),
    (CUBE, QUADS, {"normals": CUBE[:3]}, "normals must have a row for each of the 8 vertices or of the 24 corners"),
    (CUBE, QUADS, {"normals": POINT}, "of vertex 5 is not finite"),
    (CUBE, QUADS, {"roundness": 2}, "roundness of vertex 0 is 2.0+: it must be from 0 to 1"),
    (CUBE, QUADS, {"creases": [[0, 7]]}, "no face has the crease from vertex 0 to vertex 7"),
    (CUBE, QUADS, {"creases": [0, 1, 2]}, r"creases must have the shape \(k, 2\)"),
    (CUBE, QUADS, {"creases": (CUBE_EDGES[:2], [1, -1])}, "sharpness"),
    (CUBE, QUADS, {"creases": CUBE_EDGES, "scheme": "kobbelt"}, "kobbelt has no rules for creases"),
    (CUBE, QUADS, {"corners": [8]}, "corners: 8 is not from 0 to 7"),
    (CUBE, QUADS, {"uv": CUBE[:5, :2]}, "attribute 'uv' must have a row"),
    (CUBE, QUADS, {"attributes": {"name": np.array(["a"] * 8)}}, "attribute 'name' must be numbers"),
    (CUBE, QUADS, {"threads": 0}, "threads 0: at least 1"),
    (1.1e308 * CUBE, QUADS, {"normals": CUBE}, "new vertex 8 is out of the range"),
    (CUBE, None, {}, "points need faces"),
    (CUBE, 5, {}, r"faces must have the shape \(m, 3\) or \(m, 4\), or be a list"),
    (CUBE.tolist()[:-1] + [[0, 1]], QUADS, {}, "points must be numbers"),
    (np.full((8, 3), "a"), QUADS, {}, "points must be numbers"),
    (CUBE, QUADS, {"levels": -1}, "levels: -1 is not from 0"),
    (CUBE, QUADS, {"levels": 1.5}, "levels must be integers"),
    (CUBE, QUADS, {"levels": 40}, "round 14 would need [0-9]* vertices"),
    (CUBE, QUADS, {"roundness": "round"}, "roundness must be numbers"),
    (CUBE, QUADS, {"roundness": np.full(7, 0.5)}, "roundness must have a row for each of the 8 vertices"),
    (CUBE, QUADS, {"roundness": [np.nan] * 8}, "roundness of vertex 0 is nan"),
    (CUBE, QUADS, {"creases": -10.0}, "angle"),
    (CUBE, QUADS, {"creases": (CUBE_EDGES[:2], ["a", "b"])}, "the sharpness of creases must be numbers"),
    (CUBE, QUADS, {"creases": [[0, 99]]}, "creases: 99 is not from 0 to 7"),
    (CUBE, QUADS, {"attributes": {"weight": 1.0}}, "attribute 'weight' must have a row"),
])
def test_errors_name_what_is_wrong(points, faces, options, message):
    with pytest.raises(ValueError, match=message):
        pn.subdivide(points, faces, **options)


@pytest.mark.parametrize("function, options, message", [
    (pn.subdivide, {"level": 3}, "level"), (pn.subdivide, {"scheme": 5}, "scheme: str"), (pn.tessellate, {"chord": "fine"}, "chord: float"),
    (pn.limit, {"tolerance": "small"}, "tolerance: .*float"), (pn.recognize, {"min_facets": 8.5}, "min_facets: int")])
def test_wrong_types_are_named(function, options, message):
    with pytest.raises(TypeError, match=message):
        function(CUBE, QUADS, **options)
