// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// `--roundness`: where it comes from, what is written of it, and what it does to the result.

#include "Extent.h"
#include "Part_files.h"
#include "Refined_files.h"

#include "io/mesh_io.h"

#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <limits>

using namespace pn_subdivide;

namespace {

// A box of quads or triangles with m x m squares a side, stretched; the origin is its center.
std::string box(int m, bool is_triangles)
{
  const Part part = box_of_squares(m, {-4, -1, -1.5}, {8, 2, 3});
  return (is_triangles ? triangulated(part) : part).obj();
}

// A ball with a ridge, of which some vertices are round and some are not.
std::string ply(const std::vector<double>& roundness, bool with_normals)
{
  Part part;
  part.points = {{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -3}};
  part.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  std::vector<Triple> normals;
  if (with_normals)
    for (const Triple& p : part.points) // no sum of normals of faces
      normals.push_back(unit({p[0] + 0.3, p[1] - 0.2, p[2] + 0.25}));
  Part::Columns_by_name columns{{"heat", {0, 10, 20, 30, 40, 50}}};
  if (!roundness.empty()) columns.emplace_back("roundness", roundness);
  return part.ply(normals, columns);
}

const std::vector<double> several = {0, 0.25, 1, 0.5, 0.3, 0};

// Twelve sides that end in a chamfer, and a lid or a cap of a sphere below; with the normals of the sides, or without any.
std::string pin(bool with_normals, bool has_cap = false)
{
  Profile profile{{2.4, 0}, {2.4, 26}, {1.8, 28}};
  for (const double angle : {0.4, 0.2, 0.}) // of a sphere of radius 4 through the lowest ring
    if (has_cap) profile.insert(profile.begin(), {4 * std::sin(angle), 3.2 - 4 * std::cos(angle)});
  const Part part = turned(profile, 12);
  std::vector<Triple> normals;
  for (const Triple& p : part.points) normals.push_back(unit({p[0], p[1], 0}));
  return with_normals ? part.off(normals) : part.off();
}

std::vector<Triple> blended(std::vector<Triple> a, const std::vector<Triple>& b, double part_of_b)
{
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = sum(a[i], difference(b[i], a[i]), part_of_b);
  return a;
}

class Pn_subdivide_roundness : public Refined_files
{
protected:
  void SetUp() override
  {
    folder.write("box.obj", box(2, false));
    folder.write("triangles.obj", box(2, true));
    folder.write("ridge.ply", ply({}, true));
    folder.write("round.ply", ply(several, true));
    folder.write("points.ply", ply(several, false));
    folder.write("p.txt", "0 0\n4 0\n5 2\n3 4\n0 3\n-1 1\n");
  }
  std::string err(const std::string& input, const std::string& options, int code = 0) const
  {
    const Outcome outcome = run(words(input, "e.ply") + options);
    EXPECT_EQ(outcome.code, code) << options << outcome.err;
    return outcome.err;
  }
  // the points of a curve of six control points
  std::vector<Triple> curve(const std::string& options) const
  {
    done(Command_test::curve("p.txt", "o.txt", "--quiet " + options));
    std::vector<Triple> points;
    for (const auto& row : rows_of(content("o.txt"))) points.push_back({row.at(0), row.at(1), 0});
    return points;
  }
};

} // namespace

// The p = q + w H n, w the same everywhere: between the linear points and those of 1.
TEST_F(Pn_subdivide_roundness, OneRoundOfANumberIsABlend)
{
  for (const std::string input : {"box.obj", "triangles.obj", "ridge.ply"})
    for (const std::string scheme : {"", " --scheme sqrt3 --triangulate", " --scheme doo-sabin"}) {
      const std::string options = "--drop-attributes --normals " +
                                  std::string(input == "ridge.ply" ? "file" : "reciprocal") +
                                  scheme;
      const auto points = [&](const std::string& more) {
        return refined(input, "o.ply", options + more).points;
      };
      const std::vector<Triple> linear =
        refined(input, "o.ply", "--drop-attributes --linear" + scheme).points;
      const std::vector<Triple> full = points("");
      EXPECT_EQ(points(" --roundness 1"), full);
      EXPECT_EQ(points(" --roundness 0"), linear);
      EXPECT_GT(largest_distance(full, linear), 0.05);
      for (const double x : {0.25, 0.5, 0.9}) {
        EXPECT_LE(
          largest_distance(points(" --roundness " + std::to_string(x)), blended(linear, full, x)),
          1e-14);
      }
    }
}

TEST_F(Pn_subdivide_roundness, ZeroIsLinearHoweverManyRounds)
{
  for (const std::string more : {" --levels 3", " --levels 2 --sharp angle:50 --normals coherent",
                                 " --levels 2 --border curve"})
    EXPECT_EQ(
      refined("box.obj", "o.ply", "--roundness 0" + more).points,
      refined("box.obj", "o.ply", "--linear" + more.substr(0, more.find(" --normals"))).points)
      << more;
}

// --- where it comes from ---

TEST_F(Pn_subdivide_roundness, AutoTakesThatOfTheFileBesideControlNormals)
{
  const std::string of_file = written("round.ply", "a.ply", "--levels 2 --output-normals control");
  EXPECT_EQ(of_file,
            written("round.ply", "b.ply", "--levels 2 --output-normals control --roundness file"));
  EXPECT_EQ(of_file,
            written("round.ply", "b.ply", "--levels 2 --output-normals control --roundness auto"));
  EXPECT_NE(of_file,
            written("round.ply", "b.ply", "--levels 2 --output-normals control --roundness 1"));
  EXPECT_EQ(written("round.ply", "b.ply", "--levels 2 --roundness 1"),
            written("ridge.ply", "b.ply", "--levels 2 --normals file"));
  expect_part(err("round.ply", ""), "normals of the file, roundness 0 at 2 of 6 vertices");
  folder.write("rounder.ply", ply({1, 0.5, 1, 1, 0.25, 1}, true));
  expect_part(err("rounder.ply", ""), "normals of the file, roundness below 1 at 2 of 6 vertices");
  // it is none of the attributes
  EXPECT_EQ(read_mesh(folder.file("a.ply")).attributes.of_vertices.size(), 1u);
  for (const std::string options : {"--linear", "--normals none", "--normals estimate"})
    EXPECT_EQ(written("round.ply", "a.ply", options), written("ridge.ply", "b.ply", options));
}

TEST_F(Pn_subdivide_roundness, FileNeedsTheProperty)
{
  folder.write("o.ply", "old");
  expect_one_line(surface("ridge.ply", "o.ply", "--roundness file"), 1, "--roundness file");
  expect_one_line(surface("box.obj", "o.ply", "--roundness file"), 1, "--roundness estimate");
  EXPECT_EQ(content("o.ply"), "old");
  // also where the normals are estimated
  expect_part(err("points.ply", "--roundness file"),
              "estimated normals, roundness 0 at 2 of 6 vertices");
  EXPECT_NE(written("points.ply", "a.ply", "--roundness file"),
            written("points.ply", "b.ply", "--roundness auto"));
  for (const char* const wrong : {"-0.6", "1.6", "nan", "inf"}) {
    std::string text = ply(several, true);
    text.replace(text.find(" 0.25\n"), 6, std::string(" ") + wrong + "\n");
    folder.write("wrong.ply", text);
    expect_one_line(surface("wrong.ply", "o.ply", ""), 1, "vertex 1 has the roundness ");
    expect_one_line(surface("wrong.ply", "o.ply", "--roundness file"), 1, "from 0 to 1");
  }
}

// Estimated normals have the roundness of the estimate, and given ones 1, unless it is asked for.
TEST_F(Pn_subdivide_roundness, EstimateReadsItOffThePoints)
{
  for (const std::string input : {"box.obj", "triangles.obj"}) {
    const Mesh_data mesh = refined(input, "a.ply", "--levels 0 --output-normals control");
    ASSERT_EQ(mesh.roundness.size(), mesh.points.size());
    const auto zeros = std::count(mesh.roundness.begin(), mesh.roundness.end(), 0.);
    EXPECT_GT(zeros, 0);
    const std::string part = "roundness 0 at " + std::to_string(zeros) + " of 26 vertices";
    expect_part(err(input, ""), "estimated normals, " + part);
    expect_part(err(input, "--normals sphere:0,0,0 --roundness estimate"), part);
    expect_part(err(input, "--roundness 0"), ", roundness 0 at all 26 vertices, ");
    for (const std::string options : {"--normals sphere:0,0,0", "--normals reciprocal",
                                      "--normals angle", "--roundness 0.5", "--roundness 1"}) {
      expect_no_part(err(input, options), "roundness 0");
      EXPECT_EQ(
        refined(input, "b.ply", "--levels 0 --output-normals control " + options).roundness.size(),
        options == "--roundness 0.5" ? mesh.points.size() : 0u);
    }
    for (const std::string same : {"--normals estimate", "--normals coherent", "--normals auto",
                                   "--roundness estimate", "--roundness auto"})
      EXPECT_EQ(written(input, "a.ply", "--levels 2"),
                written(input, "b.ply", "--levels 2 " + same))
        << same;
    for (const std::string other : {"--normals reciprocal", "--normals angle", "--roundness 1"})
      EXPECT_NE(written(input, "a.ply", "--levels 2"),
                written(input, "b.ply", "--levels 2 " + other))
        << other;
  }
}

// Sides that end in a chamfer. The normals of a file are round, but not the wedges that are estimated beside them.
TEST_F(Pn_subdivide_roundness, WedgesBesideChamfersAreNotRound)
{
  for (const bool with_normals : {false, true}) {
    folder.write("pin.off", pin(with_normals));
    const std::string all = with_normals ? "roundness 0 at 24 of 36" : "roundness 0 at";
    const std::string said =
      err("pin.off", with_normals ? "--sharp angle:40 --normals file" : "--sharp angle:40");
    expect_part(said, all);
  }
}

// One of each wedge, which files carry on: beside the side, that is not round, the cap is.
TEST_F(Pn_subdivide_roundness, WedgesHaveThatOfTheLibrary)
{
  namespace PN = CGAL::PN_subdivision_3;
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  for (const bool has_cap : {false, true}) {
    folder.write("pin.off", pin(false, has_cap));
    Mesh mesh;
    std::ifstream(folder.file("pin.off")) >> mesh;
    const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
    PN::detect_creases(mesh, 40, sharp);
    PN::subdivide(mesh, PN::CatmullClark_scheme(),
                  CGAL::parameters::number_of_iterations(2).edge_is_constrained_map(sharp));
    std::vector<Triple> points;
    for (const auto v : mesh.vertices())
      points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
    const Mesh_data once =
      refined("pin.off", "o.ply", "--levels 2 --sharp angle:40 --output-normals both");
    EXPECT_LE(largest_distance(once.points, points), 1e-12) << has_cap;
    EXPECT_EQ(once.corner_roundness.empty(), false) << has_cap;
    written("pin.off", "a.ply", "--sharp angle:40 --output-normals both");
    expect_same_but_for_numbers(once, refined("a.ply", "b.ply", "--output-normals both"));
  }
}

// Planes are.
TEST_F(Pn_subdivide_roundness, CreasesAreRound)
{
  expect_no_part(err("box.obj", "--sharp angle:50"), "roundness");
  folder.write("one.selection.txt", "\n\n0 1\n");
  const Mesh_data mesh = refined("box.obj", "a.ply",
                                 "--levels 0 --output-normals control --sharp '" +
                                   folder.file("one.selection.txt") + "'");
  EXPECT_EQ(mesh.roundness.size(), mesh.points.size()); // others are not
}

// --- what is written ---

TEST_F(Pn_subdivide_roundness, ItIsWrittenBesideControlNormals)
{
  for (const std::string encoding : {"", " --ascii"})
    for (const std::string output : {"o.ply", "o.vtp"}) {
      const auto has = [&](const std::string& input, const std::string& options) {
        const std::string text = written(input, output, options + encoding);
        return contains(text,
                        output == "o.ply" ? "property double roundness\n" : "Name=\"roundness\"");
      };
      for (const std::string choice : {"control", "both"}) {
        EXPECT_TRUE(has("box.obj", "--output-normals " + choice));
        EXPECT_TRUE(has("round.ply", "--levels 2 --output-normals " + choice));
        EXPECT_FALSE(has("ridge.ply", "--levels 2 --normals file --output-normals " + choice));
        EXPECT_FALSE(has("box.obj", "--normals sphere:0,0,0 --output-normals " + choice));
      }
      for (const std::string choice : {"auto", "surface", "none"})
        EXPECT_FALSE(has("box.obj", "--output-normals " + choice));
    }
}

// Of schemes without negative weights, with which roundness leaves the range from 0 to 1.
TEST_F(Pn_subdivide_roundness, CallsOfOneRoundAreOneCallOfSeveral)
{
  folder.write("box.selection.txt", "\n\n0 1 1 2\n");
  folder.write("ball.selection.txt", "\n\n0 2 2 4\n");
  bool is_text = false;
  for (const std::string input : {"box.obj", "triangles.obj", "round.ply"}) {
    const std::string selection = input == "round.ply" ? "ball" : "box";
    const std::string sharp = " --sharp '" + folder.file(selection + ".selection.txt") + "'";
    std::vector<std::string> modes = {" --scheme sqrt3 --triangulate", " --scheme doo-sabin"};
    for (const std::string& more : {std::string(), sharp, sharp + " --sharpness 2",
                                    sharp + " --sharpness 1.5", std::string(" --roundness 0.5")})
      modes.push_back(more);
    for (const std::string& more : modes) {
      is_text = !is_text; // the number of modes is odd: of the next input the other encoding
      for (const std::string encoding : {"", " --ascii"}) {
        const bool is_scheme = more.find("--scheme") != std::string::npos;
        const bool is_short = is_text != encoding.empty() && (input == "box.obj" || is_scheme);
        if (!tests_are_full && !is_short) continue;
        const std::string options =
          "--drop-attributes --output-normals both" + encoding + (is_scheme ? more : "");
        const Mesh_data one =
          refined(input, "one.ply", options + (is_scheme ? "" : more) + " --levels 3");
        written(input, "a.ply", options + (is_scheme ? "" : more));
        written("a.ply", "b.ply", options);
        SCOPED_TRACE(input + options + more);
        expect_same_but_for_numbers(one, refined("b.ply", "c.ply", options));
      }
    }
  }
}

// Whether all are semi-sharp, or one edge is sharp forever beside them.
TEST_F(Pn_subdivide_roundness, EdgesThatHardlyAreSharpAreNot)
{
  const auto box = [&](const std::string& file, bool has_normals, double some, double one) {
    Part part = box_of_squares(1, {0, 0, 0}, {2, 1.7, 1.5});
    std::vector<Triple> normals;
    for (const Triple& p : part.points)
      normals.push_back({p[0] / 2 - .4, p[1] / 1.7 - .4, p[2] / 1.5 - .4});
    std::vector<Edge_tag> edges;
    for (const auto& face : part.faces)
      for (std::size_t i = 0; i < 4; ++i)
        if (const int v = int(face[i]), w = int(face[(i + 1) % 4]); v < w)
          edges.push_back({{v, w}, edges.empty() ? one : some});
    folder.write(file, with_edges(has_normals ? part.ply(normals) : part.ply(), edges));
  };
  for (const bool has_normals : {false, true})
    for (const char* const options :
         {"", " --normals angle", " --roundness 0.7", " --scheme loop --triangulate"})
      for (const double one : {0., std::numeric_limits<double>::infinity()}) {
        box("none.ply", has_normals, 0, one);
        const std::string all = std::string("--levels 2") + options;
        const std::vector<Triple> none = refined("none.ply", "o.ply", all).points;
        for (const double s : {1e-12, 1e-4}) {
          box("some.ply", has_normals, s, one == 0 ? s : one);
          const std::vector<Triple> some = refined("some.ply", "o.ply", all).points;
          EXPECT_LE(largest_distance(some, none), 10 * s + 1e-10)
            << options << s << one << has_normals;
        }
      }
}

// --- surfaces through points ---

// The net has the roundness that it was solved for, with which a further call finds the points.
TEST_F(Pn_subdivide_roundness, NetsOfInterpolationKeepIt)
{
  const std::vector<Triple> data = refined("triangles.obj", "o.ply", "--linear --levels 0").points;
  for (const std::string roundness : {"0.3", "estimate", "0"}) {
    refined("triangles.obj", "net.ply",
            "--levels 0 --interpolate points --scheme loop --output-normals control --roundness " +
              roundness);
    const auto farthest = [&](const std::string& options) {
      const std::string all = "--scheme loop --levels 0 --limit --limit-tolerance 1e-13 " + options;
      return largest_distance(refined("net.ply", "limit.ply", all).points, data);
    };
    EXPECT_LE(farthest("--roundness auto"), 1e-10) << roundness;
    EXPECT_GE(farthest("--roundness 1"), 1e-3) << roundness;
  }
}

// --- what does not go together ---

TEST_F(Pn_subdivide_roundness, WhatMeansNothingIsAUsageError)
{
  folder.write("o.ply", "old");
  for (const std::string x : {"-0.01", "1.01", "nan", "round", "", "0.5x"})
    expect_one_line(surface("box.obj", "o.ply", "--roundness='" + x + "'"), 2, "--roundness");
  for (const std::string x : {"auto", "file", "estimate", "0.5", "1"})
    for (const std::string other : {"--linear", "--normals none"})
      for (const std::string& part : {std::string("--roundness"), other})
        expect_one_line(surface("round.ply", "o.ply", "--roundness " + x + " " + other), 2, part);
  EXPECT_EQ(content("o.ply"), "old");
  expect_one_line(surface("box.obj", "o.ply", "--normals coherently"), 2, "coherent");
}

// --- curves ---

TEST_F(Pn_subdivide_roundness, CurvesTakeANumber)
{
  for (const std::string scheme : {"bspline:3 --closed", "chaikin --closed", "4-point --closed",
                                   "bspline:3", "6-point --normal-scheme 4-point"}) {
    const std::string options = "--scheme " + scheme;
    const std::vector<Triple> linear = curve("--linear --scheme " +
                                             scheme.substr(0, scheme.find(" --normal"))),
                              full = curve(options);
    EXPECT_EQ(curve(options + " --roundness 1"), full);
    EXPECT_EQ(curve(options + " --roundness 0"), linear);
    EXPECT_EQ(curve(options + " --levels 4 --roundness 0"),
              curve("--linear --levels 4 --scheme " + scheme.substr(0, scheme.find(" --normal"))));
    EXPECT_LE(largest_distance(curve(options + " --roundness 0.3"), blended(linear, full, 0.3)),
              1e-14);
  }
  const std::string calls = "curve " + words("p.txt", "o.txt");
  for (const std::string x : {"1.5", "auto", "file", "-1"})
    expect_one_line(run(calls + "--roundness=" + x), 2, "from 0 to 1");
  expect_one_line(run(calls + "--roundness 1 --linear"), 2, "--linear");
}

// Limits are those of many rounds of the same roundness; a net that interpolates has its points on the curve.
TEST_F(Pn_subdivide_roundness, CurvesHaveLimitsOfIt)
{
  const std::string half = "--closed --scheme bspline:3 --roundness 0.5 --levels ";
  const auto limits = curve(half + "0 --limit"), many = curve(half + "12");
  const auto through = curve(half + "0 --interpolate points --limit");
  ASSERT_EQ(limits.size(), 6u);
  const std::vector<Triple> given{{0, 0, 0}, {4, 0, 0}, {5, 2, 0},
                                  {3, 4, 0}, {0, 3, 0}, {-1, 1, 0}};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_LE(distance(limits[i], many[i << 12]), 1e-6);
  EXPECT_LE(largest_distance(through, given), 1e-7);
}
