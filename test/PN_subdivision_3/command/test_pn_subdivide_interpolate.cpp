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
  // the limits of the vertices, which stay in front, are the points of the input
  void expect_points(const std::string& in, const std::string& options, double tolerance,
                     const std::vector<std::string>& said) const
  {
    const std::vector<Triple> before = read_mesh(in).points;
    const Outcome outcome =
      done(surface(in, "out.ply", "--ascii --limit --interpolate points " + options));
    for (const std::string& part : said) expect_part(outcome.err, part);
    std::vector<Triple> after = read_mesh(folder.file("out.ply")).points;
    ASSERT_GE(after.size(), before.size());
    after.resize(before.size());
    EXPECT_LE(largest_distance(before, after), tolerance) << options;
  }
};

TEST_F(Pn_subdivide_interpolate, LimitsArePoints)
{
  const std::string in = folder.file("in.ply");
  done(surface(data("paper/torus_8.ply"), in, "--levels 0 --ascii"));
  const std::string levels = tests_are_full ? "3" : "1"; // 3 are work for two threads
  for (const char* options :
       {"--scheme modified-catmull-clark", "--scheme catmull-clark --linear",
        "--scheme modified-catmull-clark --first-round 2", "--scheme catmull-clark --threads 2"})
    expect_points(in, "--levels " + levels + " " + options, 1e-7,
                  {"through the points: largest distance ", "estimated error ", "step"});
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
      EXPECT_LE(std::hypot(before[i][0] - after.at(i << 12)[0], before[i][1] - after[i << 12][1]),
                1e-6)
        << options << " " << i;
  }
}

// A box with a dent, all of whose edges are sharp but those of the dent.
TEST_F(Pn_subdivide_interpolate, PointsWithSharpEdges)
{
  Part box = prism({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 1);
  box.points.push_back({1, 0.9, 0.9});
  box.faces.erase(box.faces.begin() + 1);
  for (std::size_t i = 0; i < 4; ++i) box.faces.push_back({4 + i, 4 + (i + 1) % 4, 8});
  folder.write("box.off", box.off());
  for (const char* const scheme : {"catmull-clark", "modified-catmull-clark"})
    for (const char* const options : {"--levels 0", "--levels 2", "--levels 2 --linear"})
      expect_points(folder.file("box.off"),
                    std::string("--sharp angle:60 --scheme ") + scheme + " " + options, 1e-8,
                    {"sharp edges"});
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
  const std::string curve = "curve " + words("line.txt", "out.txt");
  expect_one_line(run(curve + "--scheme bspline:2 --interpolate slide"), 2, "bspline:2");
  expect_one_line(run(curve + "--scheme bspline:3 --end none --interpolate slide"), 2,
                  "--end none");
  expect_one_line(run(curve + "--scheme bspline:3 --interpolate no"), 2,
                  "it takes slide or points");
}

} // namespace
