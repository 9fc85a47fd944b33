# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Meshes of other libraries, by small classes with the same attributes; the real ones where they are installed."""

import ast
import importlib.util
import inspect
import os
import subprocess
import sys
import types
from pathlib import Path

import numpy as np
import pn_subdivision as pn
import pytest
from shapes import CUBE, OCTAHEDRON, QUADS, TRIANGLES, prism, same_bits


class Trimesh:
    def __init__(self, vertices, faces, vertex_normals=None, process=True):
        assert not process
        self.vertices, self.faces, self.vertex_normals = np.asarray(vertices), np.asarray(faces), vertex_normals


class PolyData:
    def __init__(self, points, faces):
        self.points, self.faces = np.asarray(points), np.asarray(faces)


class MeshioMesh:
    def __init__(self, points, cells):
        self.points = np.asarray(points)
        self.cells = [types.SimpleNamespace(type=kind, data=np.asarray(data)) for kind, data in cells]


@pytest.fixture(params=["stand-in", "real"])
def library(request, monkeypatch):
    def get(name, **classes):
        if request.param == "stand-in":
            monkeypatch.setitem(sys.modules, name, types.SimpleNamespace(**classes))
        elif importlib.util.find_spec(name) is None:
            pytest.skip(f"left out, as it may be: {name} is not installed")
        return sys.modules.get(name) or importlib.import_module(name)
    return get


def test_trimesh(library):
    trimesh = library("trimesh", Trimesh=Trimesh)
    fine = pn.subdivide(trimesh.Trimesh(OCTAHEDRON, TRIANGLES, process=False), levels=2)
    assert same_bits(fine.points, pn.subdivide(OCTAHEDRON, TRIANGLES, levels=2).points)
    back = fine.to_trimesh()
    assert np.array_equal(back.vertices, fine.points) and np.array_equal(back.faces, fine.faces)
    assert np.abs(np.asarray(back.vertex_normals) - fine.normals).max() < 1e-6
    part = pn.subdivide(*prism(8)[:2], creases=50.0)
    assert len(part.normals) > len(part.points) and np.array_equal(part.to_trimesh().faces, part.triangles())


def test_pyvista(library):
    pyvista = library("pyvista", PolyData=PolyData)
    points, polygons, _ = prism(5)
    flat = np.concatenate([[len(p), *p] for p in polygons])
    fine = pn.subdivide(pyvista.PolyData(points, flat), linear=True)
    assert same_bits(fine.points, pn.subdivide(points, polygons, linear=True).points)
    assert fine.to_pyvista().faces.reshape(-1, 5)[:, 1:].tolist() == fine.faces.tolist()
    assert pn.subdivide(points, polygons, levels=0).to_pyvista().faces.tolist() == flat.tolist()


def test_meshio(library):
    meshio = library("meshio", Mesh=MeshioMesh)
    points = np.concatenate([CUBE, [[0, 0, 3]]])
    faces = [*QUADS[[0, 2, 3, 4, 5]], *([a, b, 8] for a, b in zip(QUADS[1], np.roll(QUADS[1], -1)))]
    house = meshio.Mesh(points, [("quad", QUADS[[0, 2, 3, 4, 5]]), ("line", [[0, 1]]), ("triangle", np.array(faces[5:]))])
    fine = pn.subdivide(house, levels=0)
    assert [list(face) for face in fine.faces] == [list(face) for face in faces]
    assert {block.type: len(block.data) for block in fine.to_meshio().cells} == {"triangle": 4, "quad": 5}


def test_triangles():
    points, polygons, rims = prism(6)
    mesh = pn.subdivide(points, polygons, creases=rims, levels=0)
    triangles = mesh.triangles()
    assert triangles.shape == (6 * 2 + 2 * 4, 3) and triangles[-4:].tolist() == [[6, 6 + i, 7 + i] for i in range(1, 5)]
    a, b, c = (points[triangles[:, i]] for i in range(3))
    volume = np.sum(np.cross(a, b) * c) / 6
    assert abs(volume - 2 * 1.5 * np.sqrt(3)) < 1e-14


def test_a_mesh_goes_on_with_what_it_has_unless_something_else_is_given():
    mesh = pn.subdivide(CUBE, QUADS, normals=CUBE, uv=CUBE[:, :2], corners=[0])
    again = pn.subdivide(mesh)
    assert again.uv.shape == (len(again.points), 2) and again.corners.tolist() == [0]
    assert pn.subdivide(mesh, linear=True).normals is None
    assert not same_bits(pn.subdivide(mesh, normals="angle", corners=[]).points, again.points)


def test_type_hints_are_those_of_the_functions(tmp_path):
    """All names and parameters, by mypy; what it cannot see is that the options are those of control meshes."""
    stubs = Path(pn.__file__).with_name("__init__.pyi")
    assert stubs.with_name("py.typed").exists()
    options = next(node for node in ast.parse(stubs.read_text()).body if isinstance(node, ast.ClassDef) and node.name == "_Options")
    known = list(inspect.signature(pn.Control.__init__).parameters)[3:]
    assert [item.target.id for item in options.body] == known and all(f"\n  {name} " in pn.__doc__ for name in known)
    assert all(getattr(pn, name).__doc__ for name in pn.__all__ if callable(getattr(pn, name)))
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("left out: mypy is not installed")
    (tmp_path / "mypy.ini").write_text("[mypy]\nenable_incomplete_feature = Unpack\n")
    run = subprocess.run([sys.executable, "-B", "-m", "mypy.stubtest", "--ignore-missing-stub", "--mypy-config-file", "mypy.ini", "pn_subdivision"],
                         cwd=tmp_path, env={**os.environ, "MYPYPATH": str(Path(pn.__file__).parent.parent)}, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
