// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// What maps of sharpness and of tangents may hold: integers whose largest value means for ever, tangents that somebody
// has set.

#include "Messages.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/creases/Crease_average.h>
#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;

Mesh cube()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(-1, -1, -1), Point(1, -1, -1), Point(1, 1, -1), Point(-1, 1, -1),
                        Point(-1, 1, 1), Point(-1, -1, 1), Point(1, -1, 1), Point(1, 1, 1), mesh);
  return mesh;
}

template <class Value>
auto creases_of(Mesh& mesh)
{
  return mesh.add_property_map<Edge, Value>("e:sharp", Value(0)).first;
}

const std::vector<Point>& points_of(const Mesh& mesh, std::vector<Point>& points)
{
  points.assign(mesh.points().begin(), mesh.points().end());
  return points;
}

} // namespace

// --- integers ---

template <class Integer>
class Crease_maps_of : public testing::Test
{};
using Integers = testing::Types<int, unsigned char, std::uint64_t>;
TYPED_TEST_SUITE(Crease_maps_of, Integers, );

TYPED_TEST(Crease_maps_of, TheLargestIntegerIsSharpForEver)
{
  const TypeParam for_ever = (std::numeric_limits<TypeParam>::max)();
  Mesh by_integers = cube(), by_numbers = cube();
  const auto integers = creases_of<TypeParam>(by_integers);
  const auto numbers = creases_of<double>(by_numbers);
  ASSERT_EQ(PN::detect_creases(by_integers, 30, integers), 12u);
  ASSERT_EQ(PN::detect_creases(by_numbers, 30, numbers), 12u);
  for (const Edge e : by_integers.edges()) EXPECT_EQ(integers[e], for_ever);

  // rounds, and limits, which know what is sharp forever only
  const auto scheme = PN::CatmullClark_scheme();
  const auto two = np::number_of_iterations(2);
  PN::subdivide(by_integers, scheme, two.edge_is_constrained_map(integers));
  PN::subdivide(by_numbers, scheme, two.edge_is_constrained_map(numbers));
  for (const Edge e : by_integers.edges())
    EXPECT_EQ(integers[e], numbers[e] > 0 ? for_ever : TypeParam(0));
  PN::subdivide_to_limit(by_integers, scheme, np::edge_is_constrained_map(integers));
  PN::subdivide_to_limit(by_numbers, scheme, np::edge_is_constrained_map(numbers));
  std::vector<Point> a, b;
  EXPECT_EQ(points_of(by_integers, a), points_of(by_numbers, b));
  for (const Edge e : by_integers.edges())
    EXPECT_EQ(integers[e], numbers[e] > 0 ? for_ever : TypeParam(0));
}

template <class Integer>
void expect_read_and_written()
{
  const Integer for_ever = (std::numeric_limits<Integer>::max)();
  EXPECT_EQ(PN::internal::sharp_for_ever<Integer>(), for_ever);
  EXPECT_EQ(PN::internal::sharpness_of(for_ever), std::numeric_limits<double>::infinity());
  EXPECT_EQ(PN::internal::sharpness_of(Integer(3)), 3.);
  EXPECT_EQ(PN::internal::sharpness_of(Integer(0)), 0.);
}

TEST(Crease_maps, AllIntegersAreReadAndWrittenAlike)
{
  expect_read_and_written<char>();
  expect_read_and_written<signed char>();
  expect_read_and_written<unsigned char>();
  expect_read_and_written<short>();
  expect_read_and_written<unsigned short>();
  expect_read_and_written<int>();
  expect_read_and_written<unsigned>();
  expect_read_and_written<long>();
  expect_read_and_written<unsigned long>();
  expect_read_and_written<long long>();
  expect_read_and_written<unsigned long long>();
}

// other integers are numbers of rounds; those next to the largest one are not made larger than it
TEST(Crease_maps, FiniteIntegersCountRounds)
{
  Mesh mesh = cube();
  const auto sharp = creases_of<std::uint64_t>(mesh);
  const std::uint64_t many = (std::numeric_limits<std::uint64_t>::max)() - 1;
  sharp[Edge(0)] = 2;
  sharp[Edge(1)] = many;
  PN::subdivide(mesh, PN::CatmullClark_scheme(), np::edge_is_constrained_map(sharp));
  EXPECT_EQ(sharp[Edge(0)], 1u);
  EXPECT_EQ(sharp[Edge(1)], many);
}

// so are the numbers of vertices, in one call as in several
TEST(Crease_maps, FiniteCornersCountRounds)
{
  using Vertex = Mesh::Vertex_index;
  for (const bool at_once : {false, true}) {
    Mesh mesh = cube();
    const auto sharp = mesh.add_property_map<Vertex, double>("v:sharp", 0).first;
    sharp[Vertex(0)] = 1.5;
    sharp[Vertex(1)] = 2.5;
    sharp[Vertex(2)] = std::numeric_limits<double>::infinity();
    for (unsigned calls = at_once ? 1 : 2; calls > 0; --calls)
      PN::subdivide(mesh, PN::CatmullClark_scheme(),
                    np::vertex_is_constrained_map(sharp).number_of_iterations(at_once ? 2 : 1));
    EXPECT_EQ(sharp[Vertex(0)], 0);
    EXPECT_EQ(sharp[Vertex(1)], 0.5);
    EXPECT_EQ(sharp[Vertex(2)], std::numeric_limits<double>::infinity());
  }
}

// Beside an edge of 1/2 between corners rows are half those of a sharp edge, though no vertex has a smooth rule.
TEST(Crease_maps, EdgesBelowOneFadeBetweenCorners)
{
  Mesh mesh = cube();
  const auto sharp = creases_of<double>(mesh);
  const auto corners = mesh.add_property_map<Mesh::Vertex_index, bool>("v:corner", false).first;
  const Edge e(0);
  const auto a = mesh.vertex(e, 0), b = mesh.vertex(e, 1);
  sharp[e] = 0.5;
  corners[a] = corners[b] = true;
  const Vector ends = (mesh.point(a) - CGAL::ORIGIN) + (mesh.point(b) - CGAL::ORIGIN);
  Vector all = ends; // and the middles of the two faces
  for (const Halfedge h : {mesh.halfedge(e, 0), mesh.halfedge(e, 1)})
    for (const auto v : mesh.vertices_around_face(h)) all += (mesh.point(v) - CGAL::ORIGIN) / 4;
  const auto new_vertex = mesh.number_of_vertices() + e.idx();
  PN::subdivide(mesh, PN::linear(PN::CatmullClark_scheme()),
                np::edge_is_constrained_map(sharp).vertex_is_constrained_map(corners));
  const Vector expected = ends / 4 + all / 8;
  EXPECT_EQ(mesh.point(Mesh::Vertex_index(unsigned(new_vertex))), CGAL::ORIGIN + expected);
}

// --- tangents ---

TEST(Crease_maps, TangentsThatNobodyHasSetAreRefused)
{
  for (const double length : {5e-324, 1e-310, 1e-160, 1e-12, 9.9e-7}) {
    Mesh mesh = cube();
    const auto sharp = creases_of<bool>(mesh);
    PN::detect_creases(mesh, 30, sharp);
    const auto tangents =
      mesh.add_property_map<Halfedge, Vector>("h:tangent", CGAL::NULL_VECTOR).first;
    tangents[Halfedge(5)] = Vector(0, length, 0);
    const auto scheme = PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), tangents);
    std::vector<Point> before, after;
    points_of(mesh, before);
    const auto expect_refusal = [&](const auto& call) {
      messages::expect_refused(call, {"CGAL::NULL_VECTOR"});
      EXPECT_EQ(points_of(mesh, after), before);
      EXPECT_EQ(tangents[Halfedge(5)], Vector(0, length, 0));
    };
    expect_refusal([&] { PN::subdivide(mesh, scheme, np::edge_is_constrained_map(sharp)); });
    expect_refusal(
      [&] { PN::subdivide_to_limit(mesh, scheme, np::edge_is_constrained_map(sharp)); });
  }
}

// What the package writes is taken again: no tangent is shorter than 1e-6 but zero.
TEST(Crease_maps, AveragesOfTangentsAreNotTooShort)
{
  using Average = PN::Crease_average<double, 3>;
  int zeros = 0, short_ones = 0;
  for (double angle = 1e-13; angle < 1; angle *= 1.1) { // off opposite
    const std::array<double, 3> t = {-std::cos(angle), std::sin(angle), 0};
    const Average::Entry entries[2] = {{0.5, {0, 0, 0}, {1, 0, 0}}, {0.5, {1, 0, 0}, t}};
    const auto tangent = Average(entries, entries + 2).tangent();
    const double length = std::hypot(tangent[0], tangent[1], tangent[2]);
    EXPECT_TRUE(length == 0 || length >= 1e-6) << angle << ' ' << length;
    zeros += length == 0;
    short_ones += length > 0 && length < 1e-3;
  }
  EXPECT_GT(zeros, 0);
  EXPECT_GT(short_ones, 0);
}

TEST(Crease_maps, ControlTangentsAreNotTooShort)
{
  // a crease across a strip, folded more and more at its middle
  for (double fold = 1e-9; fold < 1; fold *= 1.5) {
    Mesh mesh;
    const auto row = [&](double z) {
      return std::array<Mesh::Vertex_index, 3>{mesh.add_vertex(Point(1, fold, z)),
                                               mesh.add_vertex(Point(0, 0, z)),
                                               mesh.add_vertex(Point(1, -fold, z))};
    };
    const auto a = row(0), b = row(1), c = row(2);
    for (int i = 0; i < 2; ++i) {
      mesh.add_face(a[i], a[i + 1], b[i + 1], b[i]);
      mesh.add_face(b[i], b[i + 1], c[i + 1], c[i]);
    }
    const auto sharp = creases_of<bool>(mesh);
    for (int i = 0; i < 2; ++i) sharp[mesh.edge(mesh.halfedge(b[i], b[i + 1]))] = true;
    const auto tangents =
      mesh.add_property_map<Halfedge, Vector>("h:tangent", CGAL::NULL_VECTOR).first;
    const auto scheme = PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), tangents);
    for (int round = 0; round < 3; ++round)
      ASSERT_NO_THROW(PN::subdivide(mesh, scheme, np::edge_is_constrained_map(sharp))) << fold;
    for (const Halfedge h : mesh.halfedges()) {
      const double length = std::sqrt(tangents[h].squared_length());
      ASSERT_TRUE(length == 0 || length >= 1e-6) << fold << ' ' << length;
    }
  }
}
