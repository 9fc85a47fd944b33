// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// `pn_subdivide --interpolate` of surfaces and curves.

#include "Command_test.h"
#include "Extent.h"
#include "Part_files.h"

#include "io/mesh_io.h"

#include <cmath>

using namespace pn_subdivide;

namespace {

class Pn_subdivide_interpolate : public Command_test
{
protected:
  std::vector<Triple> points(const std::string& file) const { return read_mesh(file).points; }
};

// The limits of the vertices, which stay in front, are the points of the input.
TEST_F(Pn_subdivide_interpolate, LimitsArePoints)
{
  const std::string out = folder.file("out.ply"), in = folder.file("in.ply");
  done(surface(data("paper/torus_8.ply"), in, "--levels 0 --ascii"));
  const auto before = points(in);
  ASSERT_FALSE(before.empty());
  const std::string levels = tests_are_full ? "3" : "1"; // 3 are work for two threads
  for (const char* options :
       {"--scheme modified-catmull-clark", "--scheme catmull-clark --linear",
        "--scheme modified-catmull-clark --first-round 2", "--scheme catmull-clark --threads 2"}) {
    const Outcome outcome =
      surface(in, out, "--ascii --limit --interpolate points --levels " + levels + " " + options);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    expect_part(outcome.err, "through the points: largest distance ");
    expect_part(outcome.err, "estimated error ");
    expect_part(outcome.err, "step");
    const auto after = points(out);
    for (std::size_t v = 0; v < before.size(); ++v)
      EXPECT_LE(distance(before[v], after[v]), 1e-7) << options << " " << v;
  }
}

TEST_F(Pn_subdivide_interpolate, SpheresFromPointsAloneNeedNoStep)
{
  const std::string out = folder.file("out.ply");
  const Outcome outcome = surface(data("sphere_quads.ply"), out,
                                  "--scheme modified-catmull-clark --levels 0 --ascii "
                                  "--interpolate slide --normals sphere:0,0,0");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_part(outcome.err, " 0 steps");
}

TEST_F(Pn_subdivide_interpolate, WhatSlidesTellsHowFarItIs)
{
  const Outcome outcome = surface(data("torus_quads.ply"), "out.ply",
                                  "--scheme catmull-clark --levels 0 --interpolate slide");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_part(outcome.err, "interpolation: nearly through the points: largest distance 0.000");
}

TEST_F(Pn_subdivide_interpolate, Curves)
{
  folder.write("ellipse.txt", "2 0\n1.2 0.8\n0 1\n-1.6 0.6\n-2 0\n-1.2 -0.8\n0 -1\n1.6 -0.6\n");
  const std::string in = folder.file("ellipse.txt"), out = folder.file("out.txt");
  const Rows before = rows_of(content(in));
  ASSERT_EQ(before.size(), 8u);
  for (const char* options : {"--closed", "--end reflect", "--closed --linear"}) {
    const Outcome outcome = done(curve(
      in, out, std::string("--scheme bspline:3 --levels 12 --interpolate points ") + options));
    expect_part(outcome.err, "through the points: largest distance ");
    const Rows after = rows_of(content(out));
    for (std::size_t i = 0; i < before.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(before[i][k], after.at(i << 12)[k], 1e-6) << options << " " << i;
  }
}

// A box with a dent, all of whose edges are sharp but those of the dent.
TEST_F(Pn_subdivide_interpolate, PointsWithSharpEdges)
{
  folder.write("box.ply",
               "ply\nformat ascii 1.0\nelement vertex 9\nproperty double x\nproperty double "
               "y\nproperty double z\n"
               "element face 9\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 "
               "0\n2 2 0\n0 2 0\n0 0 1\n2 0 1\n2 2 1\n0 2 1\n"
               "1 0.9 0.9\n4 3 2 1 0\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"
               "3 4 5 8\n3 5 6 8\n3 6 7 8\n3 7 4 8\n");
  const std::string in = folder.file("box.ply"), out = folder.file("out.ply");
  const auto before = points(in);
  ASSERT_EQ(before.size(), 9u);
  for (const char* const scheme : {"catmull-clark", "modified-catmull-clark"})
    for (const char* const options : {"--levels 0", "--levels 2", "--levels 2 --linear"}) {
      const Outcome outcome =
        surface(in, out,
                std::string("--interpolate points --limit --ascii --sharp angle:60 ") +
                  "--scheme " + scheme + " " + options);
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      expect_part(outcome.err, "sharp edges");
      const auto after = points(out);
      for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_LE(distance(before[i], after[i]), 1e-8) << scheme << options << " " << i;
    }
}

TEST_F(Pn_subdivide_interpolate, WhatCannotBeIsRefusedInOneLine)
{
  const std::string torus =
    "surface '" + data("torus_quads.ply") + "' '" + folder.file("out.ply") + "' ";
  expect_one_line(run(torus + "--interpolate yes"), 2, "it takes slide or points");
  expect_one_line(run(torus + "--interpolate slide --scheme ct-catmull-clark"), 2,
                  "surfaces of ct-catmull-clark cannot be made to pass through points");
  expect_one_line(run(torus + "--interpolate slide --scheme doo-sabin"), 2, "doo-sabin");
  expect_one_line(run(torus + "--interpolate slide --scheme sqrt3"), 2, "sqrt3");
  expect_one_line(run(torus + "--interpolate slide --scheme catmull-clark --normal-scheme kobbelt"),
                  2, "exclude each other");
  expect_one_line(run(torus + "--interpolate slide --scheme catmull-clark --sharp angle:1"), 1,
                  "sharp edges");
  expect_one_line(run(torus + "--interpolate points --scheme catmull-clark --sharp angle:1 "
                              "--sharpness 2"),
                  1, "--sharpness");
  expect_one_line(surface(data("sphere_cap.ply"), "out.ply",
                          "--interpolate slide --scheme catmull-clark --border curve"),
                  2, "--border");
  folder.write("line.txt", "0 0\n1 0\n2 1\n3 1\n");
  const std::string curve =
    "curve '" + folder.file("line.txt") + "' '" + folder.file("out.txt") + "' ";
  expect_one_line(run(curve + "--scheme bspline:2 --interpolate slide"), 2, "bspline:2");
  expect_one_line(run(curve + "--scheme bspline:3 --end none --interpolate slide"), 2,
                  "--end none");
  expect_one_line(run(curve + "--scheme bspline:3 --interpolate no"), 2,
                  "it takes slide or points");
}

} // namespace
