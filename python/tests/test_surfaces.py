# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
import numpy as np
import pn_subdivision as pn
import pytest
from shapes import (CUBE, OCTAHEDRON, QUADS, TRIANGLES, catmull_clark_limit, distance_from_torus, open_cylinder, plane, prism, radius,
                    same_bits, torus, unit)

R = np.sqrt(3)
RANDOM = np.random.default_rng(1)


# --- limits ---

def test_limits_of_the_linear_scheme_are_those_of_its_mask():
    points, quads, _ = torus(5, 4)
    for p, q in ((CUBE, QUADS), (points, quads)):
        moved = pn.limit(p, q, levels=0, linear=True)
        assert np.abs(moved.points - catmull_clark_limit(p, q)).max() < 1e-14
        assert moved.report["error"] <= moved.report["tolerance"]


def test_limits_have_the_normals_of_the_surface():
    sphere = pn.limit(CUBE, QUADS, normals=CUBE, levels=2)
    assert np.abs(np.linalg.norm(sphere.points, axis=1) - R).max() < 1e-14
    assert np.abs(sphere.normals - sphere.points / R).max() < 1e-12 and sphere.roundness is None
    points, polygons, rims = prism(8)
    part = pn.limit(points, polygons, creases=rims, levels=2)
    assert np.abs(radius(part.points)[np.unique(part.creases)] - 1).max() < 1e-14
    ends = np.repeat(part.face_parents >= 8, np.diff(part.offsets))
    assert np.abs(np.abs(part.normals[ends, 2]) - 1).max() < 1e-14 and np.abs(part.normals[~ends, 2]).max() < 1e-14
    flat, cells = plane()
    mesh = pn.limit(flat, cells, linear=True)
    has_normal = mesh.normals.any(axis=1)  # a border vertex of one face has none
    assert (~has_normal).sum() == mesh.report["number_of_stand_ins"] == 4 and np.abs(mesh.normals[has_normal] - [0, 0, 1]).max() < 1e-14


# --- tessellations ---

@pytest.mark.parametrize("chord", [0.1, 0.004])
def test_triangles_are_within_the_chord_of_a_sphere(chord):
    uv = np.tile([[0, 0], [1, 0], [1, 1], [0, 1]], (6, 1)) + 10.0 * np.repeat(np.arange(6), 4)[:, None]
    mesh = pn.tessellate(CUBE, QUADS, normals=CUBE, chord=chord, attributes={"x": CUBE[:, 0]}, uv=uv)
    corners = mesh.points[mesh.faces]
    assert mesh.report["reached"] and mesh.report["bound"] <= chord
    assert np.abs(np.linalg.norm(mesh.points, axis=1) - R).max() < 1e-13
    assert chord / 8 < (R - np.linalg.norm(corners.mean(1), axis=1)).max() <= chord
    assert np.abs(mesh.normals - mesh.points / R).max() < 1e-9
    in_face = mesh.uv - 10 * np.repeat(mesh.face_parents, 3)[:, None]
    sides = in_face.reshape(-1, 3, 2)[:, 1:] - in_face.reshape(-1, 3, 2)[:, :1]
    assert abs(np.linalg.det(sides).sum() / 2 - 6) < 1e-12  # linear inside the faces: triangles fill the unit squares
    assert np.bincount(mesh.face_parents, minlength=6).min() > 0 and mesh.attributes["x"].shape == (len(mesh.points),)


def test_triangles_of_a_cylinder_with_ends():
    points, polygons, rims = prism(8)
    mesh = pn.tessellate(points, polygons, creases=rims, chord=0.01)
    sides = mesh.face_parents < 8
    assert mesh.normals.shape == (3 * len(mesh.faces), 3)
    assert np.abs(mesh.normals.reshape(-1, 3, 3)[sides][..., 2]).max() < 1e-12
    assert (1 - radius(mesh.points[mesh.faces][sides].mean(1))).max() < 0.01
    with pytest.raises(ValueError, match="chord error is -1"):
        pn.tessellate(points, polygons, chord=-1)


# --- normals ---

def test_estimates_are_exact_on_a_torus_and_know_what_is_flat():
    points, quads, normals = torus(8, 8)
    found, roundness = pn.estimate_normals(points, quads)
    assert np.abs(found - normals).max() < 1e-12 and np.abs(roundness - 1).max() < 1e-12
    blocks, cells = plane(5)
    wall = np.where(blocks[:, :1] > 2, np.stack([2 + 0 * blocks[:, 0], blocks[:, 1], blocks[:, 0] - 2], 1), blocks)
    bend = blocks[:, 0] == 2
    assert pn.estimate_normals(wall, cells)[1][bend].max() < 0.01
    of_corners, _ = pn.estimate_normals(wall, cells, creases=60.0)
    assert of_corners.shape == (64, 3)


# --- surfaces of parts ---

def test_a_cylinder_with_ends_is_recognized():
    points, polygons, rims = prism(24)
    part, surfaces, of_face = pn.recognize(points, polygons)
    kinds = [pn.KINDS[k] for k in surfaces["kind"]]
    assert sorted(kinds) == ["cylinder", "plane", "plane"]
    cylinder = surfaces[kinds.index("cylinder")]
    assert abs(cylinder["radius"] - 1) < 1e-12 and np.abs(np.abs(cylinder["direction"]) - [0, 0, 1]).max() < 1e-12
    assert cylinder["number_of_faces"] == 24 and np.all(of_face[:24] == kinds.index("cylinder"))
    assert sorted(map(tuple, np.sort(part.creases, axis=1))) == sorted(map(tuple, np.sort(rims, axis=1)))
    fine = pn.subdivide(part, levels=2)
    inside = (fine.points[:, 2] > 0) & (fine.points[:, 2] < 2)
    assert np.abs(radius(fine.points[inside]) - 1).max() < 1e-14 and set(fine.points[~inside, 2]) == {0.0, 2.0}
    unknown, none, _ = pn.recognize(CUBE + 0.1 * RANDOM.normal(size=(8, 3)), QUADS)
    assert set(none["kind"]) == {0} and np.all(unknown.roundness == 0)


# --- refiners ---

@pytest.mark.parametrize("options", [
    {}, {"linear": True}, {"normals": "given"}, {"normals": "given", "roundness": 0.25}, {"normals": "angle"},
    {"creases": [[0, 6], [6, 12]]}, {"creases": [[0, 6], [6, 12]], "corners": [20], "normals": "given"}], ids=str)
def test_a_refiner_is_subdivide_of_what_was_set(options):
    points, quads, normals = torus(8, 6)
    given = options.get("normals") == "given"
    options = {**options, **({"normals": normals} if given else {})}
    refiner = pn.Refiner(points, quads, levels=2, **options)
    fresh = pn.subdivide(points, quads, levels=2, **options)
    view = refiner.points
    assert same_bits(view, fresh.points) and same_bits(refiner.mesh().faces, fresh.faces)
    assert not view.flags.writeable and not view.flags.owndata
    for vertices in ([30], [31, 32]):
        points, normals = points.copy(), normals.copy()
        points[vertices] += 0.1 * RANDOM.normal(size=(len(vertices), 3))
        refiner.set_points(vertices, points[vertices])
        if given:
            normals[vertices] = unit(RANDOM.normal(size=(len(vertices), 3)))
            refiner.set_normals(vertices, normals[vertices])
            options["normals"] = normals
        changed = refiner.update()
        before, fresh = fresh, pn.subdivide(points, quads, levels=2, **options)
        assert same_bits(refiner.points, fresh.points) and np.shares_memory(view, refiner.points)
        moved = np.flatnonzero(np.any(fresh.points != before.points, axis=1))
        assert set(moved) <= set(changed.tolist())
        if len(fresh.points) == len(fresh.normals if fresh.normals is not None else ()):
            assert same_bits(refiner.normals, fresh.normals)


def test_a_refiner_refuses():
    refiner = pn.Refiner(CUBE, QUADS, linear=True)
    for function, arguments, message in (
            (refiner.set_points, ([8], CUBE[:1]), "8 is not from 0 to 7"), (refiner.set_points, ([1, 2], CUBE[:1]), "2 vertices do not go"),
            (refiner.set_normals, ([1], CUBE[:1]), "has no control normals"), (refiner.set_points, ([1], [[0, 0, np.inf]]), "finite")):
        with pytest.raises(ValueError, match=message):
            function(*arguments)
    with pytest.raises(ValueError, match="curvature"):
        pn.Refiner(CUBE, QUADS, scheme="ct-catmull-clark")


# --- limit surfaces ---

@pytest.mark.parametrize("mesh", [(CUBE, QUADS), (R * OCTAHEDRON, TRIANGLES)], ids=["quads", "triangles"])
def test_the_limit_surface_of_a_sphere(mesh):
    surface = pn.Limit_surface(*mesh, normals=mesh[0])
    face, uv = RANDOM.integers(len(mesh[1]), size=12), RANDOM.random((12, 2))
    uv = uv if len(mesh[1]) == 6 else uv / 2
    found = surface.evaluate(face, uv)
    assert np.abs(np.linalg.norm(found["point"], axis=1) - R).max() < 1e-13
    assert np.abs(found["normal"] - found["point"] / R).max() < 1e-3 and found["error"].max() <= 1e-6
    assert np.abs(np.sum(found["du"] * found["normal"], axis=1)).max() < 0.01
    far = 3 * unit(RANDOM.normal(size=(4, 3)))
    closest = surface.closest_point(far)
    assert np.abs(closest["point"] - R / 3 * far).max() < 1e-4 and np.abs(closest["distance"] - (3 - R)).max() < 1e-6
    assert np.abs(surface.evaluate(closest["face"], closest["uv"])["point"] - closest["point"]).max() < 1e-12
    hits = surface.ray(far, -far)
    assert np.abs(hits["point"] - R / 3 * far).max() < 5e-6 and np.abs(hits["distance"] - (3 - R)).max() < 5e-6
    missed = surface.ray([[0, 0, 5]], [[0, 1, 0]])
    assert missed["face"].tolist() == [-1] and np.isnan(missed["point"]).all() and np.isnan(missed["distance"]).all()
    for call, message in ((lambda: surface.evaluate([99], uv[:1]), "99 is not from 0"), (lambda: surface.evaluate([0], [[2, 2]]), "parameters"),
                          (lambda: surface.ray([[0, 0, 5]], [[0, 0, 0]]), "direction of a ray is zero")):
        with pytest.raises(ValueError, match=message):
            call()


def test_parameters_of_a_quad_begin_at_its_first_corner():
    flat, cells = plane(6)
    surface = pn.Limit_surface(flat, cells, linear=True)
    uv = RANDOM.random((len(cells), 2))
    found = surface.evaluate(np.arange(len(cells)), uv)
    inner = np.all((flat[cells].min(1)[:, :2] > 0) & (flat[cells].max(1)[:, :2] < 5), axis=1)
    a, b, d = (flat[cells[:, i]] for i in (0, 1, 3))
    expected = a + uv[:, :1] * (b - a) + uv[:, 1:] * (d - a)
    assert np.abs(found["point"] - expected)[inner].max() < 1e-14 and np.abs(found["du"] - (b - a))[inner].max() < 1e-14


def test_dual_schemes_have_no_such_surface():
    for function in (pn.Limit_surface, pn.limit, lambda *mesh, **o: pn.tessellate(*mesh, chord=1, **o)):
        with pytest.raises(ValueError, match="doo-sabin"):
            function(CUBE, QUADS, scheme="doo-sabin")


# --- curves ---

@pytest.mark.parametrize("mask", ["bspline:2", "bspline:3", "4-point"])
@pytest.mark.parametrize("turned", [False, True])
def test_a_polygon_on_a_circle_becomes_the_circle(mask, turned):
    angle = np.array([0, 0.9, 2, 3.1, 4, 5.2])
    polygon = np.stack([np.cos(angle), np.sin(angle)], 1)
    if turned:
        polygon = polygon @ np.linalg.qr(RANDOM.normal(size=(3, 3)))[0][:2]
    points, normals = pn.curve(polygon, mask=mask, closed=True, levels=4)
    assert points.shape == (96, polygon.shape[1])
    assert np.abs(np.linalg.norm(points, axis=1) - 1).max() < 1e-14 and np.abs(normals - points).max() < 1e-13
    linear, none = pn.curve(polygon, mask=mask, closed=True, levels=4, linear=True)
    assert np.abs(np.linalg.norm(linear, axis=1) - 1).max() > 1e-3 and not none.any()
    flat, _ = pn.curve(polygon, mask=mask, closed=True, levels=4, roundness=0)
    assert np.abs(flat - linear).max() < 1e-14
    if mask == "4-point":
        assert same_bits(points[::16], polygon)


def test_ends_of_curves_and_errors():
    line = np.stack([np.arange(5.0), np.arange(5.0)], 1)
    assert len(pn.curve(line)[0]) == 9 and len(pn.curve(line, end="none")[0]) == 7
    for arguments, message in (({"mask": "cubic"}, "mask 'cubic'"), ({"mask": "bspline:0"}, "degree from 1"), ({"mask": "3-point"}, "even number"),
                               ({"end": "loose"}, "end 'loose'"), ({"normals": line[:2]}, "5 points do not go with 2"), ({"roundness": 3}, "roundness")):
        with pytest.raises(ValueError, match=message):
            pn.curve(line, **arguments)


def test_distances_from_a_torus_are_computed_as_such():
    assert np.abs(distance_from_torus(torus(7, 5)[0])).max() < 1e-14 and distance_from_torus(np.array([[3.0, 0, 0.5]]))[0] == 0.5
    assert open_cylinder(8, 3)[1].shape == (16, 4)
