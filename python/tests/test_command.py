# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The same bits as the command pn_subdivide, of which PN_SUBDIVIDE in the environment is a build."""

import os
import subprocess

import numpy as np
import pn_subdivision as pn
import pytest
from shapes import CUBE, OCTAHEDRON, QUADS, TRIANGLES, open_cylinder, prism, torus

COMMAND = os.environ.get("PN_SUBDIVIDE")
pytestmark = pytest.mark.skipif(not COMMAND, reason="left out: PN_SUBDIVIDE does not name a build of the command")


def write_ply(file, points, faces, normals, creases):
    names = "x y z" + (" nx ny nz" if normals is not None else "")
    rows = points if normals is None else np.concatenate([points, normals], axis=1)
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}", *(f"property double {name}" for name in names.split()),
             f"element face {len(faces)}", "property list uchar int vertex_indices", f"element edge {len(creases)}", "property int vertex1",
             "property int vertex2", "property double sharpness", "end_header", *(" ".join(map(repr, row.tolist())) for row in rows),
             *(" ".join(map(str, [len(face), *face])) for face in faces), *(f"{a} {b} inf" for a, b in creases)]
    file.write_text("\n".join(lines) + "\n")


def read_ply(file):
    """The columns of the vertices by name, and the faces."""
    lines = iter(file.read_text().splitlines())
    names, sizes = {}, {}
    for line in lines:
        words = line.split()
        if words[0] == "element":
            element = words[1]
            sizes[element], names[element] = int(words[2]), []
        elif words[0] == "property":
            names[element].append(words[-1])
        elif words[0] == "end_header":
            break
    rows = np.array([next(lines).split() for _ in range(sizes["vertex"])], float)
    faces = []
    for _ in range(sizes["face"]):
        numbers = next(lines).split()
        faces.append([int(v) for v in numbers[1:1 + int(numbers[0])]])
    return dict(zip(names["vertex"], rows.T)), faces


SPHERE, TORUS, PRISM, TUBE = (CUBE, QUADS, CUBE), torus(6, 5), (*prism(8)[:2], None), (*open_cylinder(), open_cylinder()[0] * [1, 1, 0])
SKEW = (CUBE * [1, 2, 3] + 0.1 * np.sin(np.arange(24)).reshape(8, 3), QUADS, None)
RIMS = prism(8)[2].tolist()


@pytest.mark.parametrize("mesh, creases, function, options, words", [
    *((SPHERE, [], pn.subdivide, {"scheme": s, "levels": 3}, f"--scheme {s} --normals file --roundness 1")
      for s in ("catmull-clark", "kobbelt", "doo-sabin", "modified-catmull-clark", "ct-catmull-clark")),
    ((OCTAHEDRON, TRIANGLES, OCTAHEDRON * [1, 2, 3]), [], pn.subdivide, {"levels": 3}, "--normals file --roundness 1"),
    (TORUS, [], pn.subdivide, {"levels": 2, "roundness": 0.5}, "--normals file --roundness 0.5"),
    (SKEW, [], pn.subdivide, {"levels": 3}, "--normals estimate --roundness estimate"),
    (SKEW, [], pn.subdivide, {"levels": 2, "normals": "angle", "roundness": 1}, "--normals angle --roundness 1"),
    (SKEW, [], pn.subdivide, {"levels": 3, "linear": True}, "--linear"),
    (PRISM, RIMS, pn.subdivide, {"levels": 2}, "--sharp file --normals estimate --roundness estimate"),
    ((*PRISM[:2], PRISM[0] - [0, 0, 1]), RIMS[1:2], pn.subdivide, {"levels": 3}, "--sharp file --normals file --roundness 1"),
    (PRISM, RIMS[1:4], pn.subdivide, {"levels": 2, "linear": True}, "--sharp file --linear"),
    (PRISM, [], pn.subdivide, {"levels": 2, "creases": 50.0}, "--sharp angle:50 --normals estimate --roundness estimate"),
    *((TUBE, [], pn.subdivide, {"levels": 2, "border": b}, f"--border {b} --normals file --roundness 1") for b in ("curve", "corners", "fixed")),
    (SKEW, [], pn.limit, {"levels": 2}, "--limit --normals estimate --roundness estimate"),
    (PRISM, RIMS, pn.limit, {"levels": 1}, "--limit --sharp file --normals estimate --roundness estimate"),
    (SKEW, [], pn.tessellate, {"chord": 0.05}, "--chord 0.05 --normals estimate --roundness estimate"),
], ids=lambda value: value if isinstance(value, str) else "")
def test_bits_are_those_of_the_command(tmp_path, mesh, creases, function, options, words):
    points, faces, normals = mesh
    faces = [list(map(int, face)) for face in faces]
    write_ply(tmp_path / "in.ply", points, faces, normals, creases)
    words = words if "--sharp" in words else words + " --sharp none"
    words += f" --levels {options['levels']}" if "levels" in options else ""
    words += "" if function is not pn.subdivide or "--linear" in words else " --output-normals control"
    run = subprocess.run([COMMAND, "surface", "in.ply", "out.ply", *words.split(), "--ascii", "--quiet", "--no-mend"], cwd=tmp_path,
                         capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    columns, expected_faces = read_ply(tmp_path / "out.ply")
    given = {"normals": normals, **({"creases": creases} if creases else {})}
    ours = function(points, faces, **{**given, **options})
    assert [list(face) for face in ours.faces] == expected_faces
    assert np.array_equal(ours.points, np.stack([columns[c] for c in "xyz"], 1))
    if "nx" in columns and len(ours.normals) == len(ours.points):
        assert np.array_equal(ours.normals, np.stack([columns["n" + c] for c in "xyz"], 1))
    if "roundness" in columns and ours.roundness is not None and len(ours.roundness) == len(ours.points):
        assert np.array_equal(ours.roundness, columns["roundness"])
