# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The jobs of compare_bytes.py: command lines in which @NAME is a file of data/meshes or of byte_data.py."""

import itertools

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
