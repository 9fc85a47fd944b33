// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Points that are joined, and those that are left apart although borders lie on each other.

#include "Command_test.h"
#include "Part_files.h"

#include "io/Error.h"
#include "io/mesh_io.h"
#include "io/soup_repair.h"

#include <array>
#include <cmath>
#include <functional>
#include <set>

using namespace pn_subdivide;

namespace {

using Triangle = std::array<Triple, 3>;

// The boundary of a box with sides of m x m squares, each of two triangles; `corner(triangle, corner)` is added to
// a corner.
using Shift = std::function<Triple(std::size_t, std::size_t)>;
std::vector<Triangle> box(int m, const Triple& low, double size, const Shift& shift)
{
  const Part part = triangulated(box_of_squares(m, low, {size, size, size}));
  std::vector<Triangle> triangles;
  for (const auto& face : part.faces) {
    triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Triple d = shift(triangles.size() - 1, i);
      for (std::size_t k = 0; k < 3; ++k) triangles.back()[i][k] = part.points[face[i]][k] + d[k];
    }
  }
  return triangles;
}

Triple none(std::size_t, std::size_t)
{
  return {0, 0, 0};
}

// Every triangle has vertices of its own.
Part split(const std::vector<Triangle>& triangles)
{
  Part part;
  for (const Triangle& t : triangles) {
    const std::size_t v = part.points.size();
    part.points.insert(part.points.end(), t.begin(), t.end());
    part.faces.push_back({v, v + 1, v + 2});
  }
  return part;
}
std::string split_off(const std::vector<Triangle>& triangles)
{
  return split(triangles).off();
}
// with as many digits as binary files have or with all
std::string stl(const std::vector<Triangle>& triangles, bool is_float)
{
  return split(triangles).stl([is_float](double x) { return is_float ? double(float(x)) : x; });
}

class Pn_subdivide_joins : public Command_test
{
protected:
  Outcome copied(const std::string& input, const std::string& options = "") const
  {
    return surface(input, "out.ply", "--levels 0 " + options);
  }
  Mesh_data joined(const std::string& input, const std::string& options = "") const
  {
    done(copied(input, "--quiet " + options));
    return read_mesh(folder.file("out.ply"));
  }
};

using Index = Mesh_data::Index;

// Of points without faces, which are all joined that are near each other or have near ones between them: the first of those
// that each point is joined with.
std::vector<Index> by_all_pairs(const std::vector<Triple>& points, double distance)
{
  std::vector<Index> first(points.size());
  for (Index i = 0; i < first.size(); ++i) first[i] = i;
  for (Index i = 0; i < first.size(); ++i)
    for (Index j = 0; j < i; ++j) {
      if (!(pn_subdivide::distance(points[i], points[j]) <= distance)) continue;
      const Index low = (std::min)(first[i], first[j]), high = (std::max)(first[i], first[j]);
      std::replace(first.begin(), first.end(), high, low);
    }
  return first;
}

Mesh_data points_alone(const std::vector<Triple>& points)
{
  Mesh_data mesh;
  mesh.points = points;
  return mesh;
}

std::size_t number_joined(const std::vector<Index>& first)
{
  std::size_t n = 0;
  for (Index i = 0; i < first.size(); ++i) n += first[i] != i;
  return n;
}

// Points of a unit box, beside `center`, of which each third one is near the one before.
std::vector<Triple> scattered(unsigned seed, const Triple& center, double size, double distance)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Triple> points;
  for (int i = 0; i < 120; ++i) {
    Triple p = center;
    for (double& x : p) x += size * uniform(random);
    if (i % 3 == 2) {
      p = points.back();
      p[i % 9 / 3] += distance * (i % 2 ? 1 : -1) * (i % 5 ? 0.9 : 1.1);
    }
    points.push_back(p);
  }
  return points;
}

// of a box, closed
std::size_t vertices_of_box(int m)
{
  return std::size_t(6 * m * m + 2);
}

} // namespace

// --- cracks ---

TEST_F(Pn_subdivide_joins, StlWithinFourUnitsOfTheLastPlace)
{
  for (const double far : {0., 1000., -1e-3, 1e6})
    for (const double ulps : {0.9, 3.}) {
      SCOPED_TRACE(std::to_string(far) + ", " + std::to_string(ulps));
      const double size = std::abs(far) > 1e5 ? 1000 : 2; // so that sides stay far longer
      const double largest = (std::max)(std::abs(far), std::abs(far + size));
      const double ulp = std::ldexp(1., std::ilogb(largest) - 23);
      std::mt19937 random(7);
      const auto crack = [&](std::size_t, std::size_t) -> Triple {
        // in a direction of its own, so that no two are more than `ulps` apart
        return {random() % 4 == 0 ? ulps * ulp : 0., 0, 0};
      };
      const std::string input = folder.write("a.stl", stl(box(3, {far, 0, 0}, size, crack), false));
      EXPECT_EQ(joined(input).points.size(), vertices_of_box(3));
      expect_part(copied(input).err, " joined with one within ");
      expect_no_part(copied(input).err, "warning");
      // as asked for
      const std::string apart = "--repair --merge-distance 0";
      EXPECT_GT(joined(input, apart).points.size(), vertices_of_box(3));
      expect_part(copied(input, apart).err, "border edges lie on others up to");
    }
}

TEST_F(Pn_subdivide_joins, StlBeyondThatIsLeftOpenAndSaid)
{
  const auto crack = [](std::size_t t, std::size_t) -> Triple {
    return {0, 0, t == 5 ? 8e-7 : 0}; // more than 4 * 2^-23
  };
  const std::string input = folder.write("a.stl", stl(box(2, {0, 0, 0}, 1, crack), false));
  const Outcome outcome = copied(input, "--quiet");
  EXPECT_EQ(joined(input).points.size(), vertices_of_box(2) + 3);
  expect_part(outcome.err, " border edges lie on others up to rounding: --merge-distance 0.0001%");
  EXPECT_EQ(joined(input, "--merge-distance 1e-6").points.size(), vertices_of_box(2));
  EXPECT_EQ(joined(input, "--merge-distance 0.0001%").points.size(), vertices_of_box(2));
  EXPECT_EQ(copied(input, "--quiet --merge-distance 1e-6").err, "");
}

// A closed file has nothing to join, however small its triangles are.
TEST_F(Pn_subdivide_joins, ClosedStlIsReadAsItIs)
{
  const std::vector<Triangle> tiny = box(4, {1000, 1000, 1000}, 4 * std::ldexp(1., -14), none);
  const std::string input = folder.write("tiny.stl", stl(tiny, true));
  const Outcome outcome = copied(input);
  EXPECT_EQ(joined(input).points.size(), vertices_of_box(4)); // a unit of the last place each
  expect_no_part(outcome.err, "joined");
  expect_no_part(outcome.err, "border");
}

TEST_F(Pn_subdivide_joins, NeverTwoCornersOfAFacet)
{
  std::vector<Triangle> strip; // thin triangles; their short sides are below the distance
  for (int i = 0; i < 5; ++i)
    strip.push_back({{{10. * i, 0, 0}, {10. * i + 1, 0, 0}, {10. * i, 3e-7, 0}}});
  for (const std::string& input :
       {folder.write("a.stl", stl(strip, false)), folder.write("a.off", split_off(strip))})
    for (const std::string options : {"", "--merge-distance 4e-7", "--merge-distance 1e-5"}) {
      done(copied(input, options));
      EXPECT_EQ(read_mesh(folder.file("out.ply")).number_of_faces(), 5u) << options;
    }
}

// What is joined and what is not, on soups of triangles with no order at all.
TEST(Near_points, AreJoinedUnlessAFaceHasBoth)
{
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    Mesh_data mesh;
    for (int i = 0; i < 60; ++i) mesh.points.push_back({uniform(random), uniform(random), 0});
    for (int f = 0; f < 25; ++f) {
      std::vector<Mesh_data::Index> face;
      while (face.size() < 3) {
        const auto v = Mesh_data::Index(random() % 60);
        if (std::find(face.begin(), face.end(), v) == face.end()) face.push_back(v);
      }
      mesh.add_face(face);
    }
    const double distance = 0.08;
    const std::vector<Mesh_data::Index> first = first_near(mesh, distance);
    const auto share_a_face = [&](Mesh_data::Index a, Mesh_data::Index b) {
      for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
        bool has_a = false, has_b = false;
        for (const Mesh_data::Index v : mesh.face(f)) {
          has_a = has_a || first[v] == a;
          has_b = has_b || first[v] == b;
        }
        if (has_a && has_b) return true;
      }
      return false;
    };
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      std::set<Mesh_data::Index> corners;
      for (const Mesh_data::Index v : mesh.face(f)) corners.insert(first[v]);
      EXPECT_EQ(corners.size(), 3u);
    }
    for (Mesh_data::Index a = 0; a < 60; ++a) {
      EXPECT_LE(first[a], a);
      EXPECT_EQ(first[first[a]], first[a]);
      for (Mesh_data::Index b = 0; b < a; ++b) {
        if (pn_subdivide::distance(mesh.points[a], mesh.points[b]) <= distance &&
            first[a] != first[b]) {
          EXPECT_TRUE(share_a_face(first[a], first[b])) << a << ' ' << b;
        }
      }
    }
    EXPECT_GT(number_joined(first), 0u);
  }
}

TEST_F(Pn_subdivide_joins, EveryFormatWithADistance)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
  const auto shift = [&](std::size_t, std::size_t) -> Triple {
    return {noise(random), noise(random), noise(random)};
  };
  const std::vector<Triangle> triangles = box(3, {0, 0, 0}, 3, shift);
  const std::string off = folder.write("a.off", split_off(triangles));
  done(surface(off, "a.ply", "--levels 0 --normals none"));
  done(surface(off, "a.obj", "--levels 0 --normals none"));
  for (const std::string& input : {off, folder.file("a.ply"), folder.file("a.obj"),
                                   folder.write("a.stl", stl(triangles, false))})
    for (const std::string distance : {"4e-4", "0.01%"}) {
      EXPECT_EQ(joined(input, "--merge-distance " + distance).points.size(), vertices_of_box(3));
      EXPECT_GT(joined(input, "--merge-distance 1e-7").points.size(), vertices_of_box(3));
      expect_no_part(copied(input, "--merge-distance " + distance).err, "border edge");
    }
}

TEST_F(Pn_subdivide_joins, DistancesThatAreNone)
{
  const std::string input = folder.write("a.off", split_off(box(1, {0, 0, 0}, 1, none)));
  for (const std::string distance : {"-1", "-1%", "x", "nan", "inf", "''", "%", "1%%", "1,2"})
    expect_one_line(copied(input, "--merge-distance=" + distance), 2, "--merge-distance");
  std::mt19937 random(3);
  const auto noise = [&](std::size_t, std::size_t) -> Triple {
    return {1e-6 * double(random() % 1000), 0, 0};
  };
  expect_one_line(
    copied(folder.write("b.off", split_off(box(20, {0, 0, 0}, 1, noise))), "--merge-distance 200%"),
    1, "too large for this mesh");
}

// --- what is open ---

TEST_F(Pn_subdivide_joins, SplitVerticesAreSaid)
{
  const std::vector<Triangle> triangles = box(2, {0, 0, 0}, 1, none);
  const std::string off = folder.write("a.off", split_off(triangles));
  for (const char* name : {"a.ply", "a.obj"})
    done(surface(off, name, "--levels 0 --normals none --no-mend"));
  for (const std::string& input : {off, folder.file("a.ply"), folder.file("a.obj")}) {
    const std::string said =
      "warning: " + input + ": 144 of 144 border edges lie on others: --merge-points joins them\n";
    expect_part(copied(input, "--quiet --no-mend").err, said);
    const Outcome strict = copied(input, "--quiet --strict");
    expect_part(strict.err, said);
    EXPECT_EQ(strict.code, 4);
    EXPECT_EQ(copied(input, "--quiet --merge-points").err, "");
    EXPECT_EQ(joined(input, "--merge-points").points.size(), vertices_of_box(2));
  }
  // only where they do: two squares with a common side, one apart
  const std::string some =
    folder.write("some.off", "OFF\n12 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n"
                             "5 0 0\n6 0 0\n6 1 0\n5 1 0\n4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n");
  expect_part(copied(some, "--quiet").err, ": 2 of 12 border edges lie on others: --merge-points");
  // borders that lie on nothing are what they are, and closed meshes have none
  EXPECT_EQ(copied(PN_DATA_DIR "/sphere_cap.ply", "--quiet").err, "");
  EXPECT_EQ(copied(PN_DATA_DIR "/cube.off", "--quiet").err, "");
}

// Loose faces are joined without being asked for, unless that breaks what can be read.
TEST_F(Pn_subdivide_joins, UnweldedFilesAreWelded)
{
  const std::string loose = folder.write("a.off", split_off(box(2, {0, 0, 0}, 1, none)));
  const Outcome outcome = done(copied(loose));
  expect_part(outcome.err, loose + ": 118 vertices merged with an equal one; --no-mend reads the "
                                   "file as it stands\n");
  expect_no_part(outcome.err, "warning");
  EXPECT_EQ(joined(loose).points.size(), vertices_of_box(2));
  EXPECT_EQ(joined(loose, "--no-mend").points.size(), 144u);

  // two boxes that touch in a point: this one stays two vertices
  std::vector<Triangle> two = box(1, {0, 0, 0}, 1, none);
  for (const Triangle& t : box(1, {1, 1, 1}, 1, none)) two.push_back(t);
  const std::string touching = folder.write("two.off", split_off(two));
  expect_part(copied(touching).err, "57 vertices merged with an equal one, 1 vertex added where "
                                    "fans of faces meet; --no-mend");
  EXPECT_EQ(joined(touching).points.size(), 16u);

  // along an edge, which would have four faces
  two = box(1, {0, 0, 0}, 1, none);
  for (const Triangle& t : box(1, {1, 1, 0}, 1, none)) two.push_back(t);
  const std::string along = folder.write("along.off", split_off(two));
  EXPECT_EQ(joined(along).points.size(), 72u);
  expect_part(copied(along, "--quiet").err, "border edges lie on others: --repair joins them");
  EXPECT_EQ(joined(along, "--repair").points.size(), 16u);
  expect_part(copied(along, "--merge-points").err, "more than two faces");

  // a face with two equal points
  two = box(1, {0, 0, 0}, 1, none);
  two.push_back({{{5, 5, 5}, {5, 5, 5}, {6, 5, 5}}});
  const std::string narrow = folder.write("narrow.off", split_off(two));
  EXPECT_EQ(joined(narrow).points.size(), 39u);
  EXPECT_EQ(joined(narrow, "--repair").points.size(), vertices_of_box(1) + 2);
}

TEST_F(Pn_subdivide_joins, VerticesWhereFansMeetAreDoubled)
{
  const std::string input = folder.write(
    "tie.ply",
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
    "property double z\nproperty double nx\nproperty double ny\nproperty double nz\n"
    "property double heat\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "1 0 0 0 0 1 3\n0 0 0 0 0 1 4\n0 1 0 0 0 1 5\n-1 0 0 0 0 1 6\n0 -1 0 0 0 1 7\n"
    "3 1 0 2\n3 1 3 4\n");
  const Outcome outcome = done(copied(input));
  expect_part(outcome.err, "1 vertex added where fans of faces meet; --no-mend");
  expect_no_part(outcome.err, "warning");
  const Mesh_data mesh = joined(input, "--normals file");
  ASSERT_EQ(mesh.points.size(), 6u);
  EXPECT_EQ(mesh.points[5], mesh.points[1]);
  EXPECT_EQ(mesh.normals[5], (Triple{0, 0, 1}));
  EXPECT_EQ(mesh.attributes.of_vertices[0].values[5], 4);
  // a selection means both
  const std::string selection = folder.write("s.selection.txt", "1\n\n\n");
  done(surface(input, "sharp.off", "--quiet --levels 1 --sharp '" + selection + "'"));
  const std::vector<Triple> points = read_mesh(folder.file("sharp.off")).points;
  EXPECT_EQ(std::count(points.begin(), points.end(), Triple{0, 0, 0}), 2);
}

// CGAL does not come back from an edge that leads from a vertex to itself (found by a search).
TEST_F(Pn_subdivide_joins, FansAreNotSplitAtFacesThatVisitAVertexTwice)
{
  const std::string input =
    folder.write("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0.5\n3 0 1 1\n3 1 3 2\n");
  const Outcome outcome = copied(input);
  EXPECT_EQ(outcome.code, 1);
  expect_part(outcome.err, "face 0 visits vertex 1 twice; --repair");
  EXPECT_EQ(joined(input, "--repair").number_of_faces(), 1u);
}

// of vertices that were merged as the first of them
TEST_F(Pn_subdivide_joins, MessagesNameVerticesAsTheFileDoes)
{
  std::string s = "ply\nformat ascii 1.0\nelement vertex 9\nproperty double x\n"
                  "property double y\nproperty double z\nproperty double nx\n"
                  "property double ny\nproperty double nz\nelement face 3\n"
                  "property list uchar int vertex_indices\nend_header\n";
  for (const char* v : {"0 0 0 0 0 1", "1 0 0 0 0 1", "0 1 0 0 0 1", "1 0 0 0 0 1", "1 1 0 0 0 1",
                        "0 1 0 0 0 1", "1 1 0 0 0 1", "0 2 0 0 0 -1", "0 1 0 0 0 1"})
    s += std::string(v) + "\n";
  const std::string input = folder.write("a.ply", s + "3 0 1 2\n3 3 4 5\n3 6 7 8\n");
  for (const char* options : {"--no-mend", "--merge-points"})
    expect_part(copied(input, std::string("--normals file ") + options).err,
                "(first: at vertex 7)");
}

TEST_F(Pn_subdivide_joins, TJunctionsAreSaid)
{
  // a square beside two half ones
  const std::string s =
    "OFF\n10 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n2 0 0\n2 .5 0\n1 .5 0\n2 1 0\n1 1 0\n"
    "4 0 1 2 3\n4 4 5 6 7\n4 7 6 8 9\n";
  for (const std::string& input : {folder.write("a.off", s)})
    for (const std::string options :
         {"", "--repair --merge-points", "--repair --merge-distance 1e-3"}) {
      const Outcome outcome = done(copied(input, "--quiet " + options));
      expect_part(outcome.err,
                  ": 3 of 10 border edges lie along others with other ends (T-junctions)");
    }
  // straight borders do not lie along each other, nor do those that meet at an angle
  const std::string straight =
    "OFF\n6 2 0\n0 0 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n0 1 0\n4 0 1 4 5\n4 1 2 3 4\n";
  EXPECT_EQ(copied(folder.write("b.off", straight), "--quiet").err, "");
}

// Copies that --repair makes of edges with three faces have to be apart.
TEST_F(Pn_subdivide_joins, CopiesOfRepairAreNotSaid)
{
  const std::string input = folder.write(
    "a.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n");
  const Outcome outcome = done(copied(input, "--quiet --repair"));
  expect_no_part(outcome.err, "border edge");
}

// Three sheets that are bound along three points of a circle, the middle one of which is off the plane of the sheets.
TEST_F(Pn_subdivide_joins, CopiesOfRepairKeepOneCurve)
{
  const std::string input = folder.write(
    "a.off", "OFF\n12 6 0\n0 0 0\n.25 1 .15\n0 2 0\n1 0 0\n1 1 0\n1 2 0\n-.5 0 .9\n-.5 1 .9\n"
             "-.5 2 .9\n-.5 0 -.9\n-.5 1 -.9\n-.5 2 -.9\n4 0 3 4 1\n4 1 4 5 2\n4 0 1 7 6\n"
             "4 1 2 8 7\n4 0 9 10 1\n4 1 10 11 2\n");
  // of the circle; it is in the plane of (.25, 0, .15) and the y-axis
  const double sagitta = std::hypot(.25, .15), radius = (1 + sagitta * sagitta) / (2 * sagitta);
  const double x = (sagitta - radius) / sagitta;
  const Triple center{.25 * x, 1, .15 * x};
  for (const std::string options :
       {"", "--linear", "--sharp angle:20", "--normals reciprocal", "--border curve",
        "--border corners", "--roundness 1", "--triangulate --scheme loop", "--limit"}) {
    SCOPED_TRACE(options);
    done(surface(input, "o.off", "--repair --quiet --levels 3 " + options));
    const std::vector<Triple> points = read_mesh(folder.file("o.off")).points;
    std::size_t common = 0;
    for (const Triple& p : points) {
      const auto is_near = [&](const Triple& q) { return distance(p, q) < 1e-12; };
      const auto copies = std::count_if(points.begin(), points.end(), is_near);
      EXPECT_TRUE(copies == 1 || copies == 3) << copies;
      if (copies < 3) continue;
      ++common;
      if (options == "--roundness 1" || options == "--normals reciprocal")
        EXPECT_NEAR(distance(p, center), radius, 1e-12);
    }
    EXPECT_EQ(common, 3u * (2 * 8 + 1));
  }
  // what has no rules for creases is refined as it was
  done(surface(input, "o.off", "--repair --quiet --scheme doo-sabin"));
}

// --- normals of what is merged ---

// Hard edges of split vertices are those of a file with normals of corners, in every format.
TEST_F(Pn_subdivide_joins, DifferentNormalsBecomeThoseOfCorners)
{
  const std::string bolt = PN_DATA_DIR "/parts/";
  for (const std::string name : {"capped_cylinder", "washer", "lens", "bolt", "d_section"}) {
    SCOPED_TRACE(name);
    const Mesh_data part = read_mesh(bolt + name + ".obj");
    ASSERT_TRUE(part.has_corner_normals());
    Part corners;
    for (std::size_t f = 0; f < part.number_of_faces(); ++f) {
      corners.faces.emplace_back();
      for (const Mesh_data::Index v : part.face(f)) {
        corners.faces.back().push_back(corners.points.size());
        corners.points.push_back(part.points[v]);
      }
    }
    const std::string split = folder.write("split.ply", corners.ply(part.corner_normals));
    const auto refined = [&](const std::string& input, const std::string& options) {
      done(surface(input, "out.obj", "--levels 2 --quiet " + options));
      return read_mesh(folder.file("out.obj")).points;
    };
    const auto expected = refined(bolt + name + ".obj", "");
    const auto merged = refined(split, "--merge-points");
    ASSERT_EQ(expected.size(), merged.size());
    // vertices have another order, so that sums differ in the last bits
    for (const Triple& p : merged) ASSERT_LE(distance_to_nearest(p, expected), 1e-13);
    expect_part(copied(split, "--merge-points").err, " sharp edges");
    // summed only if that is asked for
    expect_part(copied(split, "--merge-points --sharp none").err,
                "several normals; their normalized sum is taken");
  }
}

// Of which one is none: it is the other's.
TEST_F(Pn_subdivide_joins, NormalsOfMergedVerticesMayBeMissing)
{
  const std::string s =
    "NOFF\n8 2 0\n0 0 0 0 0 1\n1 0 0 0 0 0\n1 1 0 0 0 1\n0 1 0 0 0 1\n"
    "1 0 0 1 0 1\n2 0 0 1 0 1\n2 1 0 1 0 1\n1 1 0 0 0 1\n4 0 1 2 3\n4 4 5 6 7\n";
  const Mesh_data mesh = joined(folder.write("a.off", s), "--merge-points --normals file");
  ASSERT_EQ(mesh.points.size(), 6u);
  EXPECT_NEAR(mesh.normals[1][0], std::sqrt(0.5), 1e-15);
  EXPECT_EQ(mesh.normals[2], (Triple{0, 0, 1}));
}

TEST(Near_points, UnitsOfTheLastPlace)
{
  EXPECT_EQ(rounding_of_floats({{1, 0, 0}}), std::ldexp(1., -21));
  EXPECT_EQ(rounding_of_floats({{0, -1.99, 0}, {1, 1, 1}}), std::ldexp(1., -21));
  EXPECT_EQ(rounding_of_floats({{0, 0, 1000}}), std::ldexp(1., 9 - 21));
  EXPECT_EQ(rounding_of_floats({{0, 0, 0}}), 0);
}

// --- points without faces, as a comparison of all pairs finds them ---

TEST(Near_points, AreThoseOfAllPairs)
{
  for (const double distance : {0.02, 0.2, 1e-9})
    for (unsigned seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(std::to_string(distance) + " " + std::to_string(seed));
      const auto points = scattered(seed, {0.3, -0.2, 0}, 1, distance);
      const auto expected = by_all_pairs(points, distance);
      EXPECT_GT(number_joined(expected), 10u);
      EXPECT_EQ(first_near(points_alone(points), distance), expected);
    }
}

// multiples of the distance and of its half, which are ends of cells
TEST(Near_points, AreThoseOfAllPairsOnAGrid)
{
  const double distance = 0.25;
  std::mt19937 random(5);
  std::vector<Triple> points;
  for (int i = 0; i < 150; ++i) {
    Triple p;
    for (double& x : p) x = 0.125 * (int(random() % 16) - 8);
    points.push_back(p);
  }
  for (const double d : {distance, std::nextafter(distance, 0.), 0.125, 0.})
    EXPECT_EQ(first_near(points_alone(points), d), by_all_pairs(points, d)) << d;
}

// where the distance is a few of the last digits of a coordinate, one of them, and less
TEST(Near_points, AreThoseOfAllPairsFarAway)
{
  for (const double distance : {1e-6, 1.2e-7, 6e-8, 1e-9, 1e-30, 5e-324, 0.}) {
    SCOPED_TRACE(distance);
    std::vector<Triple> points;
    for (int i = 0; i < 60; ++i) // 6e-8 is half of the last digit
      points.push_back({std::ldexp(1, 29) + (i % 7) * std::ldexp(1, -23), -1e9, i % 3 * 1e-7});
    points.push_back({0, 0, 0});
    points.push_back({distance, 0, 0});
    points.push_back({-distance, -1e-320, 0});
    points.push_back({1e300, 1e300, 1e300});
    points.push_back({1e300, 1e300, 1e300});
    EXPECT_EQ(first_near(points_alone(points), distance), by_all_pairs(points, distance));
  }
}

TEST(Near_points, AreRefusedWhereAllAreNear)
{
  std::vector<Triple> points;
  for (int i = 0; i < 300; ++i) points.push_back({i * 1e-3, 0, 0});
  EXPECT_THROW(first_near(points_alone(points), 1), Error);
}
