# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Small meshes, curves and selections for the jobs of compare_bytes.py: what data/meshes does not have."""

import itertools
import math

from control_meshes.files import as_text
from control_meshes.mesh import Mesh, grid_quads


def off(points, faces):
    return as_text(Mesh(points, faces), "mesh.off")


def grid(columns, rows, is_triangles):
    points = [(x, y, round(math.sin(x + 0.5 * y), 3)) for y in range(rows + 1) for x in range(columns + 1)]
    quads = points, [list(f) for f in grid_quads(columns + 1, rows + 1)]
    return split_in_triangles(*quads) if is_triangles else quads


def pole(valence, is_closed):
    """A vertex between so many triangles; closed by another one below."""
    def angle(i):
        return 2 * math.pi * i / valence
    points = [(0, 0, 1)] + [(round(math.cos(angle(i)), 3), round(math.sin(angle(i)), 3), 0) for i in range(valence)]
    rim = [(1 + i, 1 + (i + 1) % valence) for i in range(valence)]
    faces = [[0, a, b] for a, b in rim]
    if is_closed:
        points.append((0, 0, -2))
        faces += [[b, a, valence + 1] for a, b in rim]
    return points, faces


CUBE = ([(x, y, z) for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))],
        [[3, 2, 1, 0], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]])


def union(first, second):
    return first[0] + second[0], first[1] + [[v + len(first[0]) for v in f] for f in second[1]]


def split_in_triangles(points, faces):
    return points, [list(f) for f in Mesh(points, faces).triangles()]


def tagged_ply(points, faces, edges, corners):
    """Sharpness of edges (a, b, s) and of vertices {v: s}."""
    rows = ["ply", "format ascii 1.0", f"element vertex {len(points)}",
            *(f"property double {c}" for c in "xyz"), "property float sharpness",
            f"element face {len(faces)}", "property list uchar int vertex_indices",
            f"element edge {len(edges)}", "property int vertex1", "property int vertex2", "property float sharpness",
            "end_header"]
    rows += [" ".join(map(str, [*p, corners.get(v, 0)])) for v, p in enumerate(points)]
    rows += [" ".join(map(str, [len(f), *f])) for f in faces]
    rows += [" ".join(map(str, e)) for e in edges]
    return "\n".join(rows) + "\n"


def tagged_obj(points, faces, edges, corners):
    rows = ["v " + " ".join(map(str, p)) for p in points]
    rows += ["f " + " ".join(str(v + 1) for v in f) for f in faces]
    rows += [f"t crease 2/1/0 {a} {b} {s}" for a, b, s in edges]
    rows += [f"t corner 1/1/0 {v} {s}" for v, s in corners.items()]
    return "\n".join(rows) + "\n"


def attributes_obj(points, faces):
    """A chart for each face, colors, groups, materials and smoothing groups."""
    rows = ["mtllib box.mtl", "o box"]
    rows += [" ".join(map(str, ["v", *p, i / 50, 0.25, 1])) for i, p in enumerate(points)]
    number = 0
    for f, face in enumerate(faces):
        rows += [f"g g{f % 3}", f"usemtl m{f % 4}", f"s {f % 2}"]
        rows += [f"vt {f + i % 2} {i // 2}" for i in range(len(face))]
        rows.append("f " + " ".join(f"{v + 1}/{number + i + 1}" for i, v in enumerate(face)))
        number += len(face)
    return "\n".join(rows) + "\n"


def attributes_ply(points, faces, has_seams):
    rows = ["ply", "format ascii 1.0", "comment TextureFile box.png", f"element vertex {len(points)}",
            *(f"property double {c}" for c in "xyz"), *(f"property uchar {c}" for c in ("red", "green", "blue")),
            "property float quality", "property int id",
            *([] if has_seams else ["property float s", "property float t"]),
            f"element face {len(faces)}", "property list uchar int vertex_indices", "property int label",
            "property double weight", *(["property list uchar float texcoord"] if has_seams else []), "end_header"]
    for v, p in enumerate(points):
        chart = [] if has_seams else [v % 5, v // 5]
        rows.append(" ".join(map(str, [*p, 7 * v % 256, 20, 255, v / 8, 10 * v, *chart])))
    for f, face in enumerate(faces):
        chart = [2 * len(face), *(x for i in range(len(face)) for x in (f // 3 + i % 2, i // 2))] if has_seams else []
        rows.append(" ".join(map(str, [len(face), *face, 100 + f, f / 10, *chart])))
    return "\n".join(rows) + "\n"


def colored_off(points, faces):
    rows = ["COFF", f"{len(points)} {len(faces)} 0"]
    rows += [" ".join(map(str, [*p, 9 * v % 256, 0, 128, 255])) for v, p in enumerate(points)]
    rows += [" ".join(map(str, [len(f), *f, i % 256, 200, 10])) for i, f in enumerate(faces)]
    return "\n".join(rows) + "\n"


def stl(points, faces):
    rows = ["solid box"]
    for triangle in split_in_triangles(points, faces)[1]:
        rows += ["facet normal 0 0 0", "outer loop", *("vertex " + " ".join(map(str, points[v])) for v in triangle),
                 "endloop", "endfacet"]
    return "\n".join([*rows, "endsolid box"]) + "\n"


def split_points(points, faces):
    """Every face with vertices of its own."""
    ends = itertools.accumulate(len(f) for f in faces)
    return [points[v] for f in faces for v in f], [list(range(e - len(f), e)) for e, f in zip(ends, faces)]


def curves():
    angles = [0.0, 0.7, 1.9, 2.6, 3.9, 5.2]
    circle = [(math.cos(a), math.sin(a)) for a in angles]
    helix = [(math.cos(a), math.sin(a), 0.3 * a) for a in angles]
    rows = {"circle.txt": [(*p, *p) for p in circle], "plane.txt": [(i, i * i % 5) for i in range(9)],
            "some.txt": [(*p, *(p if i % 3 else (0, 0))) for i, p in enumerate(circle)],
            "helix.txt": [(*p, *p[:2], 0) for p in helix], "space.txt": helix, "two.txt": [(0, 0), (1, 2)],
            "one.txt": [(0, 0)], "corners.txt": [(2,), (4,)]}
    return {name: "".join(" ".join(map(repr, row)) + "\n" for row in r) for name, r in rows.items()}


def written():
    quads, triangles = grid(4, 3, False), grid(4, 3, True)
    edges, corners = [(0, 1, 1), (1, 2, 2.5), (2, 3, 10), (4, 5, 0.5), (2, 6, 10)], {5: 10, 7: 1.5}
    cube_in_triangles = split_in_triangles(*CUBE)
    return {
        **curves(), "quads.off": off(*quads), "triangles.off": off(*triangles), "empty.off": off([], []),
        "points.off": off(quads[0], []), "triangle.off": off(quads[0][:2] + quads[0][6:7], [[0, 1, 2]]),
        "pole.off": off(*pole(24, False)), "octahedron.off": off(*pole(4, True)), "poles.off": off(*pole(7, True)),
        "two_parts.off": off(*union(CUBE, quads)), "two_poles.off": off(*union(pole(5, True), triangles)),
        "tagged.ply": tagged_ply(*CUBE, edges, corners), "tagged.obj": tagged_obj(*CUBE, edges, corners),
        "tagged_triangles.ply": tagged_ply(*cube_in_triangles, edges, corners),
        "charts.obj": attributes_obj(*CUBE), "charts.ply": attributes_ply(*quads, True),
        "smooth.ply": attributes_ply(*quads, False), "charts_triangles.ply": attributes_ply(*triangles, True),
        "colors.off": colored_off(*quads), "colors_triangles.off": colored_off(*triangles), "box.stl": stl(*CUBE),
        "split.off": off(*split_points(*CUBE)), "turned.off": off(CUBE[0], [CUBE[1][0][::-1], *CUBE[1][1:]]),
        "bow_tie.off": off([(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)], [[0, 1, 2], [0, 3, 4]]),
        "wrong.off": off(CUBE[0], [[0, 1, 9]]),
        "not_finite.off": off([(0, 0, 0), (1, 0, math.nan), (0, 1, 0)], [[0, 1, 2]]),
        "rim.selection.txt": "1 3\n\n0 1 1 2 2 3 3 0\n", "middle.selection.txt": "\n\n5 6 6 7 7 8 8 9\n",
    }
