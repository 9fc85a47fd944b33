// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Faces become triangles whatever their points are: n - 2 of n corners, one disc, without folds where there is a way.

#include "Extent.h"
#include "Refined_files.h"

#include "io/mesh_io.h"
#include "surface/split_polygon.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cmath>
#include <set>
#include <utility>

using namespace pn_subdivide;

namespace {

using Points = std::vector<Point_3>;
using Triangles = std::vector<Corner_triangle>;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

const Is_edge no_edge = [](std::uint32_t, std::uint32_t) { return false; };

// Each triangle cuts its middle corner off what is left of the polygon, and nothing is left.
void expect_split(const Triangles& triangles, std::size_t n)
{
  ASSERT_EQ(triangles.size(), n - 2);
  std::vector<std::uint32_t> after(n);
  for (std::uint32_t i = 0; i < n; ++i) after[i] = i + 1;
  for (const Corner_triangle& t : triangles) {
    ASSERT_LT(t[0], t[1]);
    ASSERT_LT(t[2], n);
    ASSERT_EQ(after[t[0]], t[1]);
    ASSERT_EQ(after[t[1]], t[2]);
    after[t[0]] = t[2];
  }
  ASSERT_EQ(after[0], n - 1);
}

Points plane_points(const std::vector<std::pair<double, double>>& xy, double scale = 1)
{
  Points points;
  for (const auto& [x, y] : xy) points.emplace_back(x * scale, y * scale, 0);
  return points;
}

// of a polygon in a plane z = constant, which turns left: no triangle is turned over or flat, exactly
void expect_no_folds(const Points& points, const Triangles& triangles)
{
  for (const Corner_triangle& t : triangles) {
    const auto at = [&](int i) {
      return Exact::Point_2(points[t[std::size_t(i)]].x(), points[t[std::size_t(i)]].y());
    };
    ASSERT_EQ(CGAL::orientation(at(0), at(1), at(2)), CGAL::LEFT_TURN)
      << t[0] << ' ' << t[1] << ' ' << t[2];
  }
}

// as the coordinate axes go round
Points turned(const Points& points)
{
  Points result;
  for (const Point_3& p : points) result.emplace_back(p.z(), p.x(), p.y());
  return result;
}

void expect_split_without_folds(const Points& points)
{
  const Triangles triangles = split_polygon(points, no_edge);
  expect_split(triangles, points.size());
  expect_no_folds(points, triangles);
  EXPECT_EQ(split_polygon(turned(points), no_edge), triangles);
}

const std::vector<double> scales = {1, 0x1p-500, 0x1p-300, 0x1p-40, 0x1p40, 0x1p300, 0x1p500};

// 2 n corners, every second one at the radius `inner`
Points star(std::size_t n, double inner, double scale = 1)
{
  Points points;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double a = 3.14159265358979 * double(i) / double(n), r = (i % 2 ? inner : 1) * scale;
    points.emplace_back(r * std::cos(a), r * std::sin(a), 0);
  }
  return points;
}

// teeth above a base line, on which each tooth has corners in a line
Points comb(std::size_t teeth)
{
  Points points = {{double(2 * teeth), 0, 0}};
  for (std::size_t i = 2 * teeth; i-- > 0;) points.emplace_back(double(i), i % 2 ? 1 : 100, 0);
  for (std::size_t i = 0; i < 2 * teeth; ++i) points.emplace_back(double(i), 0, 0);
  return points;
}

Points spiral(std::size_t n)
{
  Points points;
  const auto add = [&](double r, double a) {
    points.emplace_back(r * std::cos(a), r * std::sin(a), 0);
  };
  for (std::size_t i = 0; i < n; ++i) add(double(n + i), 0.1 * double(i));
  for (std::size_t i = n; i-- > 0;) add(double(n + i) - 20, 0.1 * double(i));
  return points;
}

} // namespace

TEST(Split_polygon, ConcavePolygonsHaveNoFoldsAtAnyScale)
{
  const std::vector<std::vector<std::pair<double, double>>> shapes = {
    {{2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}},
    // corners on straight sides
    {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {1, 3}, {0, 3}},
    {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}},
    // a square with a square hole and the bridge to it
    {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}},
    // an arrow, a needle
    {{0, 0}, {4, 1}, {0, 2}, {0.1, 1.1}, {1, 1}, {0.1, 0.9}},
    {{0, 0}, {1, 0x1p-40}, {2, 0x1p-41}, {3, 0x1p-40}, {4, 0x1p-20}},
  };
  for (const double scale : scales)
    for (const auto& shape : shapes) expect_split_without_folds(plane_points(shape, scale));
  for (const double scale : scales)
    for (const std::size_t n : {5, 12, 150}) expect_split_without_folds(star(n, 0.1, scale));
}

TEST(Split_polygon, ManyCornersDoNotFoldEither)
{
  constexpr int n = tests_are_full ? 20000 : 2000;
  expect_split_without_folds(star(n / 2, 0.99));
  expect_split_without_folds(star(n / 2, 0.01));
  expect_split_without_folds(comb(n / 4));
  expect_split_without_folds(spiral(n / 2));
  Points circle;
  for (int i = 0; i < n; ++i) circle.emplace_back(std::cos(i * 6. / n), std::sin(i * 6. / n), 0);
  expect_split_without_folds(circle);
}

// The angles opposite to each diagonal sum up to at most 180 degrees.
TEST(Split_polygon, TrianglesAreThoseOfDelaunay)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(0, 6.28318530717958), unit(-1, 1);
  for (int round = 0; round < 50; ++round) {
    std::set<double> angles;
    while (angles.size() < 30) angles.insert(angle(random));
    Points points; // on an ellipse in a plane of any direction
    const Vector_3 u(unit(random), unit(random), unit(random)),
      v(unit(random), unit(random), unit(random));
    for (const double a : angles)
      points.push_back(CGAL::ORIGIN + std::cos(a) * u + std::sin(a) * v);
    const Triangles triangles = split_polygon(points, no_edge);
    expect_split(triangles, points.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> opposite;
    for (const Corner_triangle& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[(i + 1) % 3], b = t[(i + 2) % 3];
        const Vector_3 x = points[a] - points[t[i]], y = points[b] - points[t[i]];
        opposite[std::minmax(a, b)] += std::acos((std::min)(
          1., (std::max)(-1., x * y / std::sqrt(x.squared_length() * y.squared_length()))));
      }
    for (const auto& [diagonal, sum] : opposite)
      if (diagonal.second - diagonal.first != 1 && diagonal.second - diagonal.first != 29) {
        EXPECT_LE(sum, 3.14159265358979 + 1e-6) << diagonal.first << ' ' << diagonal.second;
      }
  }
}

TEST(Split_polygon, AnyPointsGiveTwoTrianglesLess)
{
  std::mt19937 random(7);
  const auto number = [&](int n) { return int(random() % unsigned(n)); };
  const auto coarse = [&] { return double(number(3)); };
  const auto fine = [&] { return number(2001) / 1000. - 1; };
  for (int round = 0; round < (tests_are_full ? 1500 : 500); ++round) {
    const std::size_t n = 3 + std::size_t(number(round % 50 == 0 ? 300 : 12));
    const double scale = scales[std::size_t(number(int(scales.size())))];
    const Vector_3 direction(fine(), fine(), fine());
    const int kind = number(5);
    Points points;
    for (std::size_t i = 0; i < n; ++i) {
      Vector_3 p = kind == 0   ? Vector_3(fine(), fine(), fine()) // anywhere
                   : kind == 1 ? Vector_3(coarse(), coarse(), coarse())
                   : kind == 2 ? Vector_3(coarse(), coarse(), 0)
                   : kind == 3 ? fine() * direction // in a line
                               : direction;
      points.push_back(CGAL::ORIGIN + scale * p);
    }
    expect_split(split_polygon(points, no_edge), n);
  }
  for (const std::size_t n : {1000, tests_are_full ? 20000 : 3000}) {
    Points any, in_line, equal(n, Point_3(1, 2, 3));
    for (std::size_t i = 0; i < n; ++i) {
      any.emplace_back(fine(), fine(), fine());
      in_line.emplace_back(0.1 * double(i), 0.2 * double(i), 0.3 * double(i));
    }
    for (const Points& points : {any, in_line, equal})
      expect_split(split_polygon(points, no_edge), n);
  }
}

// The last bits of the coordinates, and coordinates of very different size.
TEST(Split_polygon, NumbersAtTheLimitsOfDouble)
{
  const double limits[] = {0, 5e-324, -5e-324, 1e-160, 1, 1e160, 1.7e308, -1.7e308};
  std::mt19937 random(9);
  for (int round = 0; round < 300; ++round) {
    const std::size_t n = 5 + random() % 4;
    Points points;
    for (std::size_t i = 0; i < n; ++i)
      points.emplace_back(limits[random() % 8], limits[random() % 8], limits[random() % 8]);
    expect_split(split_polygon(points, no_edge), n);
  }
}

TEST(Split_polygon, DiagonalsAreNoEdgesElsewhereIfThatIsPossible)
{
  const Points pentagon = plane_points({{0, 0}, {2, 0}, {3, 2}, {1, 3}, {-1, 2}});
  for (std::uint32_t a = 0; a < 5; ++a) {
    // all diagonals at a corner are taken
    const auto is_edge = [&](std::uint32_t i, std::uint32_t j) { return i == a || j == a; };
    const Triangles triangles = split_polygon(pentagon, is_edge);
    expect_split(triangles, 5);
    for (const Corner_triangle& t : triangles)
      EXPECT_FALSE(t[2] - t[0] != 4 && is_edge(t[0], t[2]));
  }
  expect_split(split_polygon(pentagon, [](std::uint32_t, std::uint32_t) { return true; }), 5);
}

// --- the command ---

class Pn_subdivide_triangulate : public Command_test
{
protected:
  Mesh_data split(const std::string& input, const std::string& output, const std::string& options)
  {
    const Outcome outcome = done(surface(input, output, "--levels 0 " + options));
    return outcome.code == 0 ? read_mesh(folder.file(output)) : Mesh_data();
  }
};

TEST_F(Pn_subdivide_triangulate, FacesWithoutAreaAreSplit)
{
  const std::vector<std::string> bad = {"0 0 0\n1 .1 .3\n2 .2 .6\n3 .3 .9\n4 .4 1.2\n", // in a line
                                        "0 0 0\n1 0 0\n1 0 0\n1 1 0\n0 1 0\n",  // a corner twice
                                        "0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n",  // all in one point
                                        "0 0 0\n1 1 0\n1 0 0\n0 1 0\n0 .5 0\n", // crosses itself
                                        "0 0 0\n1e300 0 0\n1e-300 1 0\n2 0 7\n0 0 5e-324\n"};
  for (const std::string& points : bad)
    for (const std::string scale : {"", "e200", "e-200"}) {
      std::string scaled;
      std::istringstream in(points);
      int column = 0;
      for (std::string word; in >> word; ++column) {
        scaled += word;
        if (word.find('e') == std::string::npos) scaled += scale;
        scaled += column % 3 == 2 ? '\n' : ' ';
      }
      const std::string input = folder.write("bad.off", "OFF\n5 1 0\n" + scaled + "5 0 1 2 3 4\n");
      EXPECT_EQ(split(input, "o.ply", "--triangulate").number_of_faces(), 3u) << scaled;
      if (scale.empty() && points.find('e') == std::string::npos) {
        EXPECT_EQ(split(input, "o.stl", "").number_of_faces(), 3u) << scaled;
      }
    }
}

TEST_F(Pn_subdivide_triangulate, TheMeshRoundAFaceStaysManifold)
{
  // two pentagons back to back: equal diagonals would be edges of four faces
  const std::string pillow = folder.write(
    "p.off", "OFF\n5 2 0\n0 0 0\n2 0 0\n3 2 0\n1 3 0\n-1 2 0\n5 0 1 2 3 4\n5 4 3 2 1 0\n");
  EXPECT_EQ(split(pillow, "o.ply", "--triangulate").number_of_faces(), 6u);
  const std::string two_quads =
    folder.write("q.off", "OFF\n4 2 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 1 2 3\n4 3 2 1 0\n");
  EXPECT_EQ(split(two_quads, "o.ply", "--triangulate").number_of_faces(), 4u);
  done(surface(pillow, "r.ply", "--levels 1 --triangulate --scheme loop"));
  EXPECT_EQ(read_mesh(folder.file("r.ply")).number_of_faces(), 24u);
}

// A prism keeps its volume: the triangles have the faces' borders and directions.
TEST_F(Pn_subdivide_triangulate, FacesOfSolidsKeepTheirDirection)
{
  // over a concave hexagon, of volume 3
  const Part part = prism({{2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}}, 1);
  const std::string input = folder.write("l.off", part.off());
  for (const auto& [output, options] :
       {std::pair<std::string, std::string>("o.ply", "--triangulate"),
        std::pair<std::string, std::string>("o.stl", "")}) {
    const Mesh_data mesh = split(input, output, options);
    ASSERT_EQ(mesh.number_of_faces(), 20u);
    EXPECT_NEAR(volume(mesh), 3, 1e-12);
  }
}
