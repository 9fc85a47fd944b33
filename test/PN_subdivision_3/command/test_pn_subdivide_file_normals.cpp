// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What normals in files are taken for: creases, smooth surfaces, or nothing that the faces do not say.

#include "Command_test.h"
#include "Extent.h"
#include "Part_files.h"

#include "io/mesh_io.h"

using namespace pn_subdivide;

namespace {

// A tube of n sides and `rings` rings of quads, closed by two polygons if it has caps; along z.
Part tube(std::size_t n, std::size_t rings, bool caps)
{
  Part s;
  for (std::size_t j = 0; j <= rings; ++j)
    for (std::size_t i = 0; i < n; ++i)
      s.points.push_back({std::cos(2 * std::acos(-1.) * double(i) / double(n)),
                          std::sin(2 * std::acos(-1.) * double(i) / double(n)),
                          2. * double(j) / double(rings)});
  for (std::size_t v = 0; v < n * rings; ++v) {
    const std::size_t next = v % n == n - 1 ? v + 1 - n : v + 1;
    s.faces.push_back({v, next, next + n, v + n});
  }
  if (!caps) return s;
  s.faces.resize(n * rings + 2);
  for (std::size_t i = 0; i < n; ++i) {
    s.faces[n * rings].push_back(n - 1 - i);
    s.faces.back().push_back(n * rings + i);
  }
  return s;
}

// a box of which every side has m x m quads
Part box(int m)
{
  return box_of_squares(m, {0, 0, 0}, {2, 1, 1.5});
}

// With a normal for each face, rounded as files are; turned by `degrees` at one corner of each.
std::string flat_obj(const Part& s, int digits, double degrees = 0)
{
  const auto normal = [&](std::size_t f, std::size_t i) {
    const Triple n = unit(s.area(f)), across = unit({n[1] - n[2], n[2] - n[0], n[0] - n[1]});
    return i > 0 ? n : unit(sum(n, across, std::tan(degrees * std::acos(-1.) / 180)));
  };
  return s.obj_of_corners(normal, {digits, true});
}

class Pn_subdivide_file_normals : public Command_test
{
protected:
  Outcome refine(const std::string& input, const std::string& options,
                 const std::string& output = "out.obj") const
  {
    return done(surface(input, output, options));
  }
  // The file that it makes.
  std::string refined(const std::string& input, const std::string& options) const
  {
    refine(input, "--quiet " + options);
    return content("out.obj");
  }
};

struct Case
{
  std::string name;
  Part shape;
  std::size_t normals; // different ones
  int creases;         // -1: none
};

// The rule: at most 6 different normals, or at least 20 faces for each.
std::vector<Case> flat_shapes()
{
  return {{"a box", box(1), 6, 12},
          {"a fine box", box(4), 6, 48},
          {"a box of triangles", triangulated(box(1)), 6, 12},
          {"a triangular prism", tube(3, 1, true), 5, 9},
          {"a prism with four sides", tube(4, 1, true), 6, 12},
          {"a prism with five", tube(5, 1, true), 7, -1},
          {"an open pipe", tube(6, 1, false), 6, 6},
          {"an open pipe with seven sides", tube(7, 1, false), 7, -1},
          {"large sides", tube(12, 23, true), 14, 12 * 23 + 24}, // 278 faces, 14 normals: 19.9
          {"larger sides", tube(12, 24, true), 14, 12 * 24 + 24},
          {"a triangulated pipe", triangulated(tube(20, 2, false)), 20, -1},
          {"a ball", ball_of(8, 4, on_sphere), 32, -1}};
}

} // namespace

TEST_F(Pn_subdivide_file_normals, FlatShadingMakesCreasesOfFewOrLargeSides)
{
  std::size_t k = 0;
  for (const Case& c : flat_shapes()) {
    SCOPED_TRACE(c.name);
    const bool has_creases =
      c.normals <= 6 || double(c.shape.faces.size()) / double(c.normals) >= 20;
    for (const int digits : {4, 15}) {
      const std::string input = folder.write("flat.obj", flat_obj(c.shape, digits));
      const Outcome outcome = refine(input, "--scheme catmull-clark");
      expect_part(outcome.err, "for flat shading (" + std::to_string(c.normals) + " different on " +
                                 std::to_string(c.shape.faces.size()) + " faces)");
      if (has_creases) {
        expect_part(outcome.err, std::to_string(c.creases) +
                                   " edges where they differ, taken for creases (--sharp none");
        expect_part(outcome.err,
                    "normals of the file, " + std::to_string(c.creases) + " sharp edges");
      } else {
        expect_part(outcome.err, "--sharp file");
        // planes and a cylinder, with normals or without
        const bool is_part = c.name == "large sides";
        expect_part(outcome.err,
                    is_part ? "normals of the surfaces, 24 sharp edges" : "estimated normals");
        if (!is_part) expect_no_part(outcome.err, "sharp edges");
        expect_no_part(outcome.err, "warning");
        // as if the file had none
        const std::string plain = folder.write("plain.obj", c.shape.obj());
        for (const std::string options :
             {"--levels 0", "--levels 2", "--levels 1 --sharp none", "--levels 1 --sharp angle:50",
              "--levels 1 --scheme doo-sabin", "--levels 1 --linear", "--levels 1 --normals angle"})
          if (tests_are_full || k++ % 3 == 0) {
            EXPECT_EQ(refined(input, options), refined(plain, options)) << options;
          }
      }
      expect_part(refine(input, "--sharp file").err, " sharp edges");
    }
  }
}

// A corner that is off by more than 0.1 degrees is somebody's work.
TEST_F(Pn_subdivide_file_normals, ATenthOfADegreeIsFlat)
{
  const Part pipe = triangulated(tube(60, 2, false));
  expect_part(refine(folder.write("a.obj", flat_obj(pipe, 15, 0.09)), "").err, "flat shading");
  const Outcome outcome = refine(folder.write("b.obj", flat_obj(pipe, 15, 0.12)), "");
  expect_no_part(outcome.err, "flat shading");
  expect_part(outcome.err, "sharp edges");
}

// Each edge of a capped cylinder of quads that is worth it: few of its edges are smooth, none is flat.
TEST_F(Pn_subdivide_file_normals, CreasesOfOtherFilesMayBeMany)
{
  const std::size_t n = 12;
  const Part s = tube(n, 1, true);
  const auto normal = [&](std::size_t f, std::size_t i) {
    const Triple& p = s.points[s.faces[f][i]];
    return f < n ? Triple{p[0], p[1], 0} : Triple{0, 0, f == n ? -1. : 1.};
  };
  const std::string input = folder.write("cylinder.obj", s.obj_of_corners(normal));
  const Outcome outcome = refine(input, "--levels 3", "out.obj"); // 24 of 36 inner edges
  expect_part(outcome.err,
              "the normals in the file differ at 24 edges, taken for creases (--sharp none");
  expect_part(outcome.err, "24 sharp edges");
  expect_no_part(outcome.err, "warning");
  for (const Triple& p : read_mesh(folder.file("out.obj")).points) {
    const double off_side = std::abs(std::hypot(p[0], p[1]) - 1);
    EXPECT_TRUE(off_side < 1e-14 || p[2] == 0 || p[2] == 2);
    EXPECT_LE(std::hypot(p[0], p[1]), 1 + 1e-14);
  }
  EXPECT_EQ(refined(input, "--levels 2 --sharp file"), refined(input, "--levels 2"));
}

TEST_F(Pn_subdivide_file_normals, FileInsists)
{
  const Part pipe = tube(8, 2, false);
  const std::string input = folder.write("flat.obj", flat_obj(pipe, 15));
  const Outcome outcome = refine(input, "--normals file");
  expect_part(outcome.err, "24 vertices have several normals; their normalized sum is taken");
  expect_part(outcome.err, "normals of the file");
  EXPECT_NE(refined(input, "--levels 1 --normals file"), refined(input, "--levels 1"));
}

// Normals of vertices are flat shading as well where every face has vertices of its own.
TEST_F(Pn_subdivide_file_normals, FlatShadingOfVertices)
{
  const Part joined = ball_of(12, 6, on_sphere);
  Part split;
  std::vector<Triple> normals;
  for (std::size_t f = 0; f < joined.faces.size(); ++f) {
    split.faces.emplace_back();
    for (const std::size_t v : joined.faces[f]) {
      split.faces.back().push_back(split.points.size());
      split.points.push_back(joined.points[v]);
      normals.push_back(unit(joined.area(f)));
    }
  }
  const std::string input = folder.write("flat.off", split.off(normals));
  const Outcome outcome = refine(input, "--merge-points");
  expect_part(outcome.err, "for flat shading (72 different on 72 faces): ");
  expect_part(outcome.err, "estimated normals");
  const std::string plain = folder.write("plain.obj", split.obj());
  EXPECT_EQ(refined(input, "--levels 2 --merge-points"),
            refined(plain, "--levels 2 --merge-points"));
}

// Splitting faces does not make other normals of them, nor does turning them.
TEST_F(Pn_subdivide_file_normals, FlatShadingIsThatOfTheFacesInTheFile)
{
  // none of its faces is planar
  const Part wavy = grid(5, 5, [](int i, int j) { return std::sin(1.3 * i) * std::cos(1.7 * j); });
  const auto area = [&](std::size_t f, std::size_t) { return wavy.area(f); };
  const std::string plain = wavy.obj(), flat = wavy.obj_of_corners(area);
  const std::string input = folder.write("flat.obj", flat), other = folder.write("p.obj", plain);
  expect_part(refine(input, "--triangulate").err, "for flat shading (25 different on 25 faces)");
  EXPECT_EQ(refined(input, "--levels 2 --triangulate"), refined(other, "--levels 2 --triangulate"));
}

// --- normals that are none ---

TEST_F(Pn_subdivide_file_normals, ZeroEverywhereIsNone)
{
  const Part pipe = tube(8, 2, false);
  const std::string plain = folder.write("plain.obj", pipe.obj());
  const std::vector<Triple> zero(pipe.points.size(), Triple{0, 0, 0});
  std::string obj;
  std::istringstream lines(pipe.obj() + "vn 0 0 0\n");
  for (std::string line; std::getline(lines, line); obj += line + "\n") {
    if (line[0] != 'f') continue;
    for (std::size_t i = line.find(' ', 2); i != std::string::npos; i = line.find(' ', i + 4))
      line.insert(i, "//1");
    line += "//1";
  }
  for (const std::string& input :
       {folder.write("zero.off", pipe.off(zero)), folder.write("zero.obj", obj)})
    for (const std::string sharp : {"", " --sharp angle:30", " --border curve"}) {
      const Outcome outcome = refine(input, sharp);
      expect_part(outcome.err, "the normals of the file are all zero");
      expect_part(outcome.err, "estimated normals");
      expect_no_part(outcome.err, ", normals of the file");
      EXPECT_EQ(refined(input, "--levels 2" + sharp), refined(plain, "--levels 2" + sharp));
      expect_part(refine(input, "--normals file" + sharp).err,
                  "no normals, those of the file are zero");
    }
}

// --- normals that oppose their faces ---

TEST_F(Pn_subdivide_file_normals, ThoseOfCornersAreCountedToo)
{
  Part s = box(1);
  std::string obj = flat_obj(s, 15);
  std::swap(s.faces[3][1], s.faces[3][3]); // its normal is now that of the other side
  std::string turned = flat_obj(s, 15);
  obj.replace(obj.find("vn"), obj.find("f ") - obj.find("vn"),
              turned.substr(turned.find("vn"), turned.find("f ") - turned.find("vn")));
  const std::string input = folder.write("box.obj", obj);
  expect_part(refine(input, "--quiet --sharp angle:50").err, "4 of 24 normals point against");
}

// --- with creases ---

// Without normals in the file every other source is what is asked for.
TEST_F(Pn_subdivide_file_normals, EverySourceIsHonoredWithCreases)
{
  Part s = tube(9, 3, true);
  for (Triple& p : s.points) // uneven, so that estimates differ
    p = {p[0] * (1 + 0.2 * p[2]), p[1], p[2] + 0.1 * p[0]};
  const std::string plain = folder.write("plain.obj", s.obj());
  const auto inner_normals = [&](const std::string& options, const std::string& input,
                                 const std::string& sharp = "angle:60") {
    refine(input, "--quiet --levels 0 --sharp " + sharp + " " + options);
    const std::vector<Triple> all = read_mesh(folder.file("out.obj")).normals;
    return std::vector<Triple>(all.begin() + 9, all.begin() + 27); // on no crease
  };
  const std::vector<Triple> normals(s.points.size(), Triple{0, 0, 1});
  const std::string given = folder.write("given.off", s.off(normals));
  for (const std::string options :
       {"--normals angle", "--normals sphere:0.1,0,1", "--normals cylinder:0,0,0,0,0.1,1"})
    for (const std::string& input : {plain, given}) {
      const std::vector<Triple> found = inner_normals(options, input);
      // far from creases nothing is different
      EXPECT_LE(largest_distance(found, inner_normals(options, plain, "none")), 1e-12) << options;
      EXPECT_GE(largest_distance(found, inner_normals("", plain)), 1e-3) << options;
    }
}
