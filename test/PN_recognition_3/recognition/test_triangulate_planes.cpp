// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Planes from their rims: counts and areas that do not depend on how they are triangulated.

#include <CGAL/PN_recognition_3/triangulate_planes.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kind = PN::Recognized_surface::Kind;
using Kernel = CGAL::Simple_cartesian<double>;

// Polygons in a plane, each with the number of its surface; the plane is tilted in space.
struct Soup
{
  std::vector<std::array<double, 2>> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::size_t> surfaces;

  void add(std::size_t surface, const std::vector<std::size_t>& face)
  {
    faces.push_back(face);
    surfaces.push_back(surface);
  }
  // a square of n x n cells from (x, y) on; those of which `surface` tells none are left out
  template <class Function>
  void add_grid(double x, double y, double cell, std::size_t n, const Function& surface)
  {
    const std::size_t first = points.size();
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t i = 0; i <= n; ++i)
        points.push_back({x + cell * double(i), y + cell * double(j)});
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        if (const int s = surface(i, j); s >= 0) {
          const std::size_t v = first + j * (n + 1) + i;
          add(std::size_t(s), {v, v + 1, v + n + 2, v + n + 1});
        }
  }
};

// What has come of it, in coordinates of the plane again.
struct Outcome
{
  bool is_triangulated = false;
  std::size_t triangles = 0;
  double area = 0;
  bool is_oriented = true;
  std::set<std::pair<std::size_t, std::size_t>> open; // sides without the opposite one
};

template <class Mesh>
Outcome outcome(const Soup& soup, std::size_t surface = 0, std::size_t of = 2)
{
  using Point = typename boost::property_traits<
    typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;
  // x, y along two edges of a cuboid that is turned
  std::vector<Point> points;
  for (const auto& [x, y] : soup.points)
    points.emplace_back(0.36 * x + 0.48 * y + 5, 0.8 * x - 0.6 * y, -0.48 * x - 0.64 * y + 2);
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.faces, mesh);
  std::map<Face, std::size_t> patches;
  std::size_t n = 0;
  for (const Face f : faces(mesh)) patches[f] = soup.surfaces[n++];
  std::map<Vertex, std::size_t> numbers;
  n = 0;
  for (const Vertex v : vertices(mesh)) numbers.emplace(v, n++);

  std::vector<PN::Recognized_surface> surfaces(of);
  for (auto& s : surfaces) s.kind = Kind::plane;
  Outcome result;
  for (const auto& plane :
       PN::triangulate_planes(mesh, boost::make_assoc_property_map(patches), surfaces)) {
    if (plane.surface != surface) continue;
    result.is_triangulated = plane.is_triangulated;
    result.triangles = plane.triangles.size();
    for (const auto& t : plane.triangles) {
      std::array<std::size_t, 3> v{};
      for (std::size_t i = 0; i < 3; ++i) v[i] = numbers.at(t[i]);
      const auto &a = soup.points[v[0]], &b = soup.points[v[1]], &c = soup.points[v[2]];
      const double area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
      result.area += area;
      result.is_oriented = result.is_oriented && area > 0;
      for (std::size_t i = 0; i < 3; ++i)
        if (result.open.erase({v[(i + 1) % 3], v[i]}) == 0)
          result.open.insert({v[i], v[(i + 1) % 3]});
    }
  }
  return result;
}

using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;

template <class Mesh>
class Triangulate_planes : public testing::Test
{};
using Meshes = testing::Types<Surface_mesh, Polyhedron, Exact_mesh>;
TYPED_TEST_SUITE(Triangulate_planes, Meshes, );

} // namespace

// A polygon of n vertices with h holes is n - 2 + 2 h triangles.
TYPED_TEST(Triangulate_planes, HolesAndIslands)
{
  Soup soup;
  soup.add_grid(0, 0, 1, 5, [](auto i, auto j) {
    if (i == 2 && j == 2) return 0;                  // an island
    return i > 0 && i < 4 && j > 0 && j < 4 ? 1 : 0; // the hole is another surface
  });
  const Outcome ring = outcome<TypeParam>(soup, 0), hole = outcome<TypeParam>(soup, 1);
  EXPECT_TRUE(ring.is_triangulated);
  EXPECT_EQ(ring.triangles, (20u + 12 - 2 + 2) + 2);
  EXPECT_NEAR(ring.area, 25 - 9 + 1, 1e-12);
  EXPECT_TRUE(ring.is_oriented);
  EXPECT_EQ(ring.open.size(), 20u + 12 + 4);
  EXPECT_TRUE(hole.is_triangulated);
  EXPECT_EQ(hole.triangles, 12u + 4 - 2 + 2);
  EXPECT_NEAR(hole.area, 8, 1e-12);
  EXPECT_TRUE(hole.is_oriented);
}

// Their sides are those of the neighbors the other way round.
TYPED_TEST(Triangulate_planes, SidesFitToThoseOfNeighbors)
{
  Soup soup;
  soup.add_grid(0, 0, 1, 4, [](auto i, auto) { return i < 2 ? 0 : 1; });
  const Outcome left = outcome<TypeParam>(soup, 0), right = outcome<TypeParam>(soup, 1);
  std::size_t common = 0;
  for (const auto& [a, b] : left.open) common += right.open.count({b, a});
  EXPECT_EQ(common, 4u);
  EXPECT_EQ(left.triangles + right.triangles, 2u * (12 - 2));
}

// Pieces of one surface that lie on each other.
TYPED_TEST(Triangulate_planes, CrossingRims)
{
  for (const double shift : {0.5, 1.5, 2.5, 4.0}) {
    Soup soup;
    const auto all = [](auto, auto) { return 0; };
    soup.add_grid(0, 0, 1, 3, all);
    soup.add_grid(shift, 0.25, 1, 3, all);
    EXPECT_EQ(outcome<TypeParam>(soup).is_triangulated, shift > 3) << shift;
  }
}

// A vertex on the rim of another piece would tear the mesh, a common point of two vertices, too.
TYPED_TEST(Triangulate_planes, TouchingRims)
{
  const auto all = [](auto, auto) { return 0; };
  for (const double y : {0.5, 1.}) {
    Soup soup;
    soup.add_grid(0, 0, 1, 3, all);
    soup.add_grid(3, y, 1, 1, all);
    EXPECT_FALSE(outcome<TypeParam>(soup).is_triangulated) << y;
  }
}

// Inside another piece, not in a hole: seen from outside it would be one.
TYPED_TEST(Triangulate_planes, NestedPieces)
{
  const auto all = [](auto, auto) { return 0; };
  Soup soup;
  soup.add_grid(0, 0, 1, 3, all);
  soup.add_grid(1.25, 1.25, 0.5, 1, all);
  EXPECT_FALSE(outcome<TypeParam>(soup).is_triangulated);
}

// A pillow: one side may not have the diagonal of the other.
TYPED_TEST(Triangulate_planes, EdgesOfOthers)
{
  for (const bool is_long : {false, true}) { // the diagonal 0 2
    Soup soup;
    soup.points = {{is_long ? -5. : -1., 0}, {0, -3}, {is_long ? 5. : 1., 0}, {0, 3}};
    soup.add(0, {0, 1, 2, 3});
    soup.add(1, {0, 2, 1});
    soup.add(1, {0, 3, 2});
    EXPECT_EQ(outcome<TypeParam>(soup, 0).is_triangulated, is_long);
  }
}

TYPED_TEST(Triangulate_planes, OtherSurfacesAndNoFaces)
{
  const TypeParam none;
  using Face = typename boost::graph_traits<TypeParam>::face_descriptor;
  std::map<Face, int> patches;
  std::vector<PN::Recognized_surface> surfaces(1);
  const auto map = boost::make_assoc_property_map(patches);
  EXPECT_TRUE(PN::triangulate_planes(none, map, surfaces).empty());
  surfaces[0].kind = Kind::plane;
  EXPECT_TRUE(PN::triangulate_planes(none, map, surfaces).empty());
  using Point = typename boost::property_traits<
    typename boost::property_map<TypeParam, CGAL::vertex_point_t>::type>::value_type;
  TypeParam triangle;
  CGAL::make_triangle(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), triangle);
  for (const Face f : faces(triangle)) patches[f] = 0;
  EXPECT_EQ(PN::triangulate_planes(triangle, map, surfaces).size(), 1u);
  for (const Kind other : {Kind::unknown, Kind::cylinder, Kind::sphere}) {
    surfaces[0].kind = other;
    EXPECT_TRUE(PN::triangulate_planes(triangle, map, surfaces).empty());
  }
  Soup soup;
  soup.add_grid(0, 0, 1, 2, [](auto, auto) { return 7; });
  EXPECT_THROW(outcome<TypeParam>(soup), std::invalid_argument);
}
