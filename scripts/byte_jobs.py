# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The jobs of compare_bytes.py: command lines in which @NAME is a file of data/meshes or one that is written here, small
meshes, curves and selections that data/meshes does not have."""

import itertools
import math

from control_meshes.files import INDICES, as_text, ply, properties
from control_meshes.mesh import Mesh, grid_quads

OF_QUADS = ["catmull-clark", "kobbelt", "modified-catmull-clark", "ct-catmull-clark"]
OF_TRIANGLES = ["loop", "butterfly", "modified-loop", "ct-loop"]
CREASING = ["catmull-clark", "loop", "modified-catmull-clark", "modified-loop", "ct-catmull-clark", "ct-loop"]
SCHEMES = [*OF_QUADS, "doo-sabin", *OF_TRIANGLES, "sqrt3"]
INTERPOLATING = ["catmull-clark", "modified-catmull-clark", "loop", "modified-loop"]
CURVE_SCHEMES = ["bspline:3", "chaikin", "bspline:4", "bspline:5", "bspline:6", "bspline:9", "4-point", "6-point",
                 "8-point"]
TEXTURE_RULES = ["none", "corners-only", "corners-plus1", "corners-plus2", "boundaries", "all"]
OUTPUT_NORMALS = ["auto", "surface", "control", "both", "none"]


def is_of_triangles(scheme):
    return scheme in OF_TRIANGLES or scheme == "sqrt3"


def product(*parts):
    """Every choice of a text from each part."""
    return [" ".join(text for text in choice if text) for choice in itertools.product(*parts)]


def options(name, values):
    return [f"{name} {value}" for value in values]


QUAD_MESHES = ["@quads.off", "@cube_on_sphere.ply", "@saddle_5.ply", "@vase.obj", "@missing_normals.ply",
               "@mixed_borders.off", "@two_parts.off"]
TRIANGLE_MESHES = ["@octahedron.off", "@triangles.off", "@paper/tetrahedron.ply", "@valences_3_to_12.ply", "@pole.off",
                   "@two_poles.off"]


def by_scheme(schemes, of_quads, of_triangles, *parts):
    """Command lines over schemes, with the meshes that suit them."""
    lines = []
    for scheme in schemes:
        inputs = of_triangles if is_of_triangles(scheme) else of_quads
        lines += product(inputs, ["out.ply"], [f"--scheme {scheme}"], *parts)
    return lines


def surfaces():
    refined = ["--levels 1", "--levels 2 --linear", "--levels 1 --limit", "--levels 2 --output-normals control"]
    lines = by_scheme(SCHEMES, QUAD_MESHES, TRIANGLE_MESHES, refined)
    lines += by_scheme(SCHEMES, ["@cube.off"], ["@octahedron.off"], ["--levels 3", "--levels 0 --limit --linear"])
    lines += by_scheme(SCHEMES, ["@triangle.off", "@pole.off"], ["@triangle.off", "@poles.off"],
                       ["--levels 2", "--limit"])
    lines += by_scheme(CREASING, ["@quads.off", "@vase.obj"], ["@triangles.off", "@pole.off"],
                       options("--border", ["curve", "corners", "fixed"]),
                       ["--levels 2 --output-normals both", "--limit"])
    lines += by_scheme(SCHEMES, ["@paper/torus_4.ply"], ["@two_poles.off"], options("--output-normals", OUTPUT_NORMALS),
                       ["--levels 2", "--limit"])
    lines += product(["@cube_on_sphere.ply out.ply --levels 0"], options("--output-normals", OUTPUT_NORMALS))
    lines += by_scheme(SCHEMES, ["@mixed_borders.off"], ["@valences_3_to_12.ply"], ["--levels 2 --threads 2"],
                       ["", "--linear", "--limit"])
    lines += by_scheme(SCHEMES, ["@torus_quads.ply"], ["@valences_3_to_12.ply"],  # enough for several chunks
                       ["--levels 4", "--levels 4 --threads 2"])
    return lines


def sharp():
    lines = by_scheme(CREASING, ["@parts/capped_cylinder.obj --sharp @parts/capped_cylinder.selection.txt",
                                 "@parts/bracket.obj --sharp angle:40", "@quads.off --sharp @middle.selection.txt",
                                 "@creased_plate.ply --sharp file"],
                      ["@parts/capped_cylinder.obj --sharp @parts/capped_cylinder.selection.txt --triangulate",
                       "@octahedron.off --sharp angle:100", "@triangles.off --sharp @middle.selection.txt"],
                      ["--levels 2", "--levels 2 --sharpness 1.5", "--levels 2 --linear", "--limit",
                       "--levels 2 --limit --sharpness 2", "--limit --linear --border corners"])
    lines += by_scheme(CREASING, ["@tagged.ply", "@tagged.obj"], ["@tagged_triangles.ply"],
                       ["--levels 2 --output-normals control --write-tags tags.selection.txt",
                        "--levels 3 --limit --output-normals both"])
    lines += by_scheme(CREASING, ["@cube.off"], ["@cube.off --triangulate"],
                       ["--sharp @rim.selection.txt --levels 2 --threads 2", "--sharp none --levels 2"])
    lines += by_scheme(["catmull-clark", "loop"], ["@vase.obj"], ["@valences_3_to_12.ply"],
                       ["--sharp angle:30 --border curve --levels 4"], options("--threads", [1, 2]))
    lines += by_scheme(["doo-sabin", "kobbelt", "butterfly", "sqrt3"], ["@cube.off"], ["@octahedron.off"],
                       ["--sharp angle:40", "--border curve"])
    return lines + ["@parts/bracket.obj out.stl --part", "@parts/bolt.obj out.ply --part --levels 2"]


def pairs():
    lines = []
    for schemes, mesh, selection in [(OF_QUADS, "@quads.off", "@middle.selection.txt"),
                                     (OF_TRIANGLES, "@triangles.off", "@middle.selection.txt")]:
        for scheme, normals in itertools.permutations(schemes, 2):
            lines += product([f"{mesh} out.ply --scheme {scheme} --normal-scheme {normals}"],
                             ["--levels 2", "--levels 1 --limit", f"--levels 2 --sharp {selection}",
                              f"--limit --sharp {selection} --border curve", "--levels 2 --pieces 2"])
    return lines + ["@quads.off out.ply --scheme catmull-clark --normal-scheme loop"]


def measured_and_interpolated():
    lines = by_scheme(SCHEMES, ["@saddle_5.ply"], ["@poles.off"], options("--curvature", ["gaussian", "mean"]),
                      ["--levels 2", "--limit", "--linear --ascii"])
    lines += by_scheme(CREASING, ["@cube.off"], ["@octahedron.off"], ["--curvature mean --sharp angle:40 --levels 2"])
    lines += by_scheme(INTERPOLATING, ["@quads.off", "@cube_on_sphere.ply", "@two_parts.off"],
                       ["@triangles.off", "@paper/tetrahedron.ply"], options("--interpolate", ["slide", "points"]),
                       ["--levels 1", "--limit", "--border curve"])
    lines += by_scheme(SCHEMES, ["@cube_on_sphere.ply"], ["@octahedron.off --normals sphere:0,0,0"],
                       ["--verify sphere:0,0,0,1", "--verify sphere:0,0,0,1 --tolerance 1e-30 --levels 2"])
    return lines


def in_pieces():
    lines = by_scheme([*OF_QUADS, *OF_TRIANGLES], ["@mixed_borders.off", "@torus_quads.ply"],
                      ["@valences_3_to_12.ply"], ["--levels 2 --drop-attributes"],
                      ["--pieces 1", "--pieces 3", "--pieces 7 --linear", "--pieces 2 --output-normals control",
                       "--memory 200M --threads 2"])
    lines += product(["@vase.obj out.pvtp --drop-attributes --levels 2"], ["--pieces 3"],
                     ["", "--linear", "--output-normals both", "--output-normals none"])
    return lines + ["@cube.off out.ply --pieces 2 --limit", "@cube.off out.ply --pieces 2 --sharp angle:40",
                    "@cube.off out.ply --pieces 2 --border curve", "@vase.obj out.ply --pieces 2"]


def with_attributes():
    lines = by_scheme(["catmull-clark", "kobbelt", "doo-sabin", "loop", "butterfly", "sqrt3", "modified-loop"],
                      ["@vase.obj", "@charts.obj", "@charts.ply"], ["@charts_triangles.ply"],
                      ["--levels 2"], options("--texture-rule", TEXTURE_RULES))
    lines += by_scheme(SCHEMES, ["@charts.obj", "@smooth.ply", "@colors.off"],
                       ["@charts_triangles.ply", "@colors_triangles.off"],
                       ["--linear", "--levels 2 --threads 2", "--limit"])
    lines += by_scheme(CREASING, ["@charts.obj", "@charts.ply"], ["@charts_triangles.ply"],
                       ["--levels 2 --sharp angle:10", "--limit --sharp angle:10", "--levels 2 --border curve"])
    return lines + product(["@smooth.ply out.ply"], ["--nearest quality", "--directions quality,s,t"],
                           ["--levels 2", "--chord 1%", "--pieces 2"])


def formats():
    inputs = ["@charts.obj", "@charts.ply", "@smooth.ply", "@colors.off", "@box.stl", "@tagged.ply",
              "@parts/washer.obj", "@cube_on_sphere.ply"]
    outputs = ["out.ply --ascii", "out.ply", "out.off", "out.obj", "out.stl", "out.stl --ascii",
               "out.vtp", "out.vtp --ascii", "out.ply --split-seams"]
    return (product(inputs, outputs, ["--levels 0", "--levels 1"]) +
            product(["@charts.obj", "@tagged.ply"], outputs, ["--output-normals both", "--drop-attributes --linear"]))


def schemes_with_parameters():
    modified = by_scheme(["modified-catmull-clark", "modified-loop"],
                         ["@valences_3_to_12.ply --triangulate", "@spoon.obj"], ["@valences_3_to_12.ply", "@poles.off"],
                         ["--levels 2 --cap 1/4", "--levels 2 --first-round 2", "--tuned-valences diverging",
                          "--limit --cap 1"])
    return modified + product(["@saddle_5.ply out.ply --scheme kobbelt"], options("--tension", ["0", "1/16", "0.1"]),
                              ["--levels 2", "--limit"])


def read_and_refused():
    lines = product(["@mixed_borders.off out.ply", "@missing_normals.ply out.ply", "@creased_box.ply out.ply"],
                    options("--normals", ["auto", "file", "smooth", "estimate", "angle", "none", "sphere:0,0,0",
                                          "cylinder:0,0,0,0,0,1"]), ["--output-normals control"])
    lines += product(["@split.off", "@turned.off", "@bow_tie.off", "@box.stl", "@two_parts.off"],
                     ["out.off --report report.json"],
                     ["", "--repair", "--merge-points", "--merge-distance 1%", "--repair --merge-points --levels 2",
                      "--triangulate", "--strict"])
    lines += product(["@empty.off", "@points.off"], ["out.ply"],
                     ["", "--limit", "--linear", "--scheme loop", "--pieces 2", "--curvature mean", "--levels 0",
                      "--interpolate slide", "--scheme doo-sabin --limit", "--scheme modified-catmull-clark --limit"])
    lines += product(["@cube.off out.ply"],
                     ["--scheme none", "--levels -1", "--levels 99", "--scheme loop", "--tension x", "--border none",
                      "--sharp angle:x", "--limit-tolerance 1e-3 --limit", "--cap 2", "--unknown",
                      "--interpolate points --sharp angle:40", "--scheme kobbelt --interpolate slide",
                      "--chord 1% --pieces 2", "--scheme doo-sabin --pieces 2",
                      "--quiet --limit"])
    return lines + ["@wrong.off out.ply", "@not_finite.off out.ply", "@none.off out.ply", "@cube.off out.xyz",
                    "@cube.off", "- - --format off < @cube.off", "- - --format obj --levels 2 < @charts.obj"]


def of_curves():
    shapes = ["@circle.txt out.txt --closed", "@some.txt out.txt", "@plane.txt out.txt", "@helix.txt out.txt",
              "@space.txt out.txt --closed"]
    lines = product(["curve"], shapes, options("--scheme", CURVE_SCHEMES),
                    ["--levels 3", "--levels 2 --linear --curve-normals", "--levels 2 --limit"])
    lines += product(["curve"], ["@plane.txt out.txt", "@helix.txt out.txt"], options("--scheme", CURVE_SCHEMES),
                     ["--end reflect", "--end none --limit"])
    lines += product(["curve @some.txt out.txt --sharp @corners.txt"], ["", "--closed"],
                     options("--scheme", ["bspline:3", "bspline:5", "4-point", "chaikin"]), ["--levels 2", "--limit"])
    lines += product(["curve"], shapes, ["--interpolate slide", "--interpolate points --limit",
                                         "--comb comb.svg --levels 4"])
    lines += product(["curve @plane.txt out.txt"], ["--scheme bspline:3 --normal-scheme 4-point",
                                                     "--scheme 4-point --normal-scheme bspline:5 --limit",
                                                     "--scheme chaikin --normal-scheme bspline:4",
                                                     "--scheme chaikin --normal-scheme bspline:3"])
    return lines + product(["curve"], ["@two.txt out.txt", "@one.txt out.txt"],
                           options("--scheme", ["bspline:3", "chaikin", "6-point"]), ["", "--closed", "--limit"])


def is_refused(line):
    """The limit points of doo-sabin belong to faces, which one line is enough for."""
    return "--scheme doo-sabin" in line and ("--limit" in line or "surface" in line)


def jobs():
    """Every command line once."""
    subjects = (surfaces, sharp, pairs, measured_and_interpolated, in_pieces, with_attributes, formats,
                schemes_with_parameters, read_and_refused, of_curves)
    lines = dict.fromkeys(line for subject in subjects for line in subject() if not is_refused(line))
    return [*lines, "@cube.off out.ply --scheme doo-sabin --limit"]


# --- data ---


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
    return ply(("vertex", [*properties("xyz"), "float sharpness"], [(*p, corners.get(v, 0)) for v, p in enumerate(points)]),
               ("face", [INDICES], [(len(f), *f) for f in faces]),
               ("edge", ["int vertex1", "int vertex2", "float sharpness"], edges))


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
    of_vertices = [*properties("xyz"), "uchar red", "uchar green", "uchar blue", "float quality", "int id",
                   *([] if has_seams else ["float s", "float t"])]
    of_faces = [INDICES, "int label", "double weight", *(["list uchar float texcoord"] if has_seams else [])]
    vertices = [(*p, 7 * v % 256, 20, 255, v / 8, 10 * v, *(() if has_seams else (v % 5, v // 5))) for v, p in enumerate(points)]
    rows = []
    for f, face in enumerate(faces):
        chart = [2 * len(face), *(x for i in range(len(face)) for x in (f // 3 + i % 2, i // 2))] if has_seams else []
        rows.append([len(face), *face, 100 + f, f / 10, *chart])
    return ply(("vertex", of_vertices, vertices), ("face", of_faces, rows), comments=["TextureFile box.png"])


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
