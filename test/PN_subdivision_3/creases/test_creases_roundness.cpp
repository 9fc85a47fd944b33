// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Roundness of wedges and creases from points and tags alone.

#include <CGAL/PN_certificates_3/compare_with_linear.h>
#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Sharp = Mesh::Property_map<Mesh::Edge_index, bool>;

struct Ring
{
  double radius, height;
  bool is_sharp;
};

// Closed: rings around the axis, with lids. Angles in turns.
struct Turned_part
{
  Turned_part(const std::vector<double>& turns, const std::vector<Ring>& rings, bool triangles)
    : sharp(mesh.add_property_map<Mesh::Edge_index, bool>("sharp", false).first)
  {
    const auto n = unsigned(turns.size()), m = unsigned(rings.size());
    for (const Ring& r : rings)
      for (double t : turns)
        mesh.add_vertex(
          Point(r.radius * std::cos(2 * pi * t), r.radius * std::sin(2 * pi * t), r.height));
    const auto v = [&](unsigned j, unsigned i) { return Mesh::Vertex_index(j * n + i % n); };
    std::vector<Mesh::Vertex_index> lower, upper;
    for (unsigned i = 0; i < n; ++i) {
      lower.push_back(v(0, n - 1 - i));
      upper.push_back(v(m - 1, i));
      for (unsigned j = 0; j + 1 < m; ++j)
        if (triangles) {
          mesh.add_face(v(j, i), v(j, i + 1), v(j + 1, i + 1));
          mesh.add_face(v(j, i), v(j + 1, i + 1), v(j + 1, i));
        } else
          mesh.add_face(v(j, i), v(j, i + 1), v(j + 1, i + 1), v(j + 1, i));
    }
    for (auto* lid : {&lower, &upper})
      if (!triangles)
        mesh.add_face(*lid);
      else
        for (unsigned i = 1; i + 1 < n; ++i) mesh.add_face((*lid)[0], (*lid)[i], (*lid)[i + 1]);
    for (unsigned j = 0; j < m; ++j)
      for (unsigned i = 0; rings[j].is_sharp && i < n; ++i)
        sharp[mesh.edge(mesh.halfedge(v(j, i), v(j, i + 1)))] = true;
  }

  auto parameters() const
  {
    return CGAL::parameters::number_of_iterations(2).edge_is_constrained_map(sharp);
  }

  static constexpr double pi = 3.14159265358979323846;
  Mesh mesh;
  Sharp sharp;
};

std::vector<double> even(int n)
{
  std::vector<double> turns;
  for (int i = 0; i < n; ++i) turns.push_back(double(i) / n);
  return turns;
}

double excess_of_volume(const Turned_part& part, bool triangles)
{
  const auto result =
    triangles ? PN::compare_with_linear(part.mesh, PN::Loop_scheme(), part.parameters())
              : PN::compare_with_linear(part.mesh, PN::CatmullClark_scheme(), part.parameters());
  return std::abs(std::log(result.volume_ratio)) - std::abs(std::log(result.linear_volume_ratio));
}

// of the vertices from a cylinder of radius 1
double deviation(Turned_part part)
{
  PN::subdivide(part.mesh, PN::CatmullClark_scheme(), part.parameters());
  double largest = 0;
  for (auto v : part.mesh.vertices()) {
    const Point& p = part.mesh.point(v);
    const double r = std::hypot(p.x(), p.y());
    const bool is_inside_a_lid = part.mesh.degree(v) > 0 && r < 0.99;
    if (!is_inside_a_lid) largest = (std::max)(largest, std::abs(r - 1));
  }
  return largest;
}

} // namespace

// Sides that end in chamfers are arcs through three points, by all that a wedge shows, which mirrors its neighbor.
TEST(Creases_roundness, PinsDoNotSwell)
{
  for (int n : {12, 24})
    for (bool triangles : {false, true}) {
      const Turned_part pin(even(n), {{2.4, 0, true}, {2.4, 26, false}, {1.8, 28, true}},
                            triangles);
      EXPECT_LE(excess_of_volume(pin, triangles), 0.02) << n << triangles;
      const Turned_part both(
        even(n), {{4.2, -1.5, true}, {5, 0, false}, {5, 26, false}, {4.2, 27.5, true}}, triangles);
      EXPECT_LE(excess_of_volume(both, triangles), 0.02) << n << triangles;
    }
}

TEST(Creases_roundness, CylindersStayExact)
{
  const std::vector<double> uneven{0,    0.03, 0.1,  0.14, 0.25, 0.33,
                                   0.35, 0.47, 0.55, 0.66, 0.76, 0.88};
  for (const auto& turns : {even(3), even(4), even(12), uneven})
    for (double height : {0.02, 1., 30.}) {
      EXPECT_LE(deviation(Turned_part(turns, {{1, 0, true}, {1, height, true}}, false)), 1e-12)
        << turns.size() << ' ' << height;
      if (turns.size() <= 4) continue;
      EXPECT_LE(
        deviation(Turned_part(
          turns,
          {{1, 0, true}, {1, 0.1 * height, false}, {1, 0.12 * height, false}, {1, height, true}},
          false)),
        1e-12)
        << turns.size() << ' ' << height;
    }
}

// The side of the pin is not round, its rims are.
TEST(Creases_roundness, WedgesHaveTheirOwn)
{
  Turned_part pin(even(12), {{2.4, 0, true}, {2.4, 26, false}, {1.8, 28, true}}, false);
  PN::subdivide(pin.mesh, PN::CatmullClark_scheme(), pin.parameters());
  int on_rims = 0;
  for (auto v : pin.mesh.vertices()) {
    const Point& p = pin.mesh.point(v);
    const double r = std::hypot(p.x(), p.y());
    if (std::abs(p.z()) < 1e-12 && std::abs(r - 2.4) < 1e-12) ++on_rims;
    if (std::abs(p.z() - 28) < 1e-12 && std::abs(r - 1.8) < 1e-12) ++on_rims;
  }
  EXPECT_EQ(on_rims, 96);
}

// of a vertex it is that of the flattest wedge
TEST(Creases_roundness, VerticesHaveTheLeastOfTheirWedges)
{
  Turned_part pin(even(12), {{2.4, 0, true}, {2.4, 26, false}, {1.8, 28, true}}, false);
  const auto normals = pin.mesh.add_property_map<Mesh::Halfedge_index, Kernel::Vector_3>("n").first;
  const auto roundness = pin.mesh.add_property_map<Mesh::Vertex_index, double>("w", -1).first;
  PN::estimate_control_normals(
    pin.mesh, normals,
    PN::parameters::vertex_roundness_map(roundness).edge_is_constrained_map(pin.sharp));
  for (auto v : pin.mesh.vertices()) {
    if (pin.mesh.point(v).z() >= 27) continue;
    EXPECT_LE(roundness[v], 0.2) << v;
  }
}

// Round two circles of different size; where lines join the arcs, tangents of arcs do not meet.
TEST(Creases_roundness, RimsOfLinesAndArcsKeepTheVolume)
{
  const double pi = Turned_part::pi, step = pi / 12;
  std::vector<Point> rim;
  double twice_area = 0, twice_segments = 0;
  for (const auto& [x, r, first] : {std::tuple(0., 8., pi / 2), {25., 5., -pi / 2}}) {
    for (int i = 0; i <= 12; ++i)
      rim.emplace_back(x + r * std::cos(first + i * step), r * std::sin(first + i * step), 0);
    twice_segments += 12 * r * r * (step - std::sin(step));
  }
  const auto n = unsigned(rim.size());
  Mesh mesh;
  for (double height : {0., 6.})
    for (const Point& p : rim) mesh.add_vertex(Point(p.x(), p.y(), height));
  std::vector<Mesh::Vertex_index> lower, upper;
  for (unsigned i = 0; i < n; ++i) {
    const unsigned next = (i + 1) % n;
    twice_area += rim[i].x() * rim[next].y() - rim[i].y() * rim[next].x();
    lower.push_back(Mesh::Vertex_index(n - 1 - i));
    upper.push_back(Mesh::Vertex_index(n + i));
    mesh.add_face(Mesh::Vertex_index(i), Mesh::Vertex_index(next), Mesh::Vertex_index(n + next),
                  Mesh::Vertex_index(n + i));
  }
  mesh.add_face(lower);
  mesh.add_face(upper);
  const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("sharp", false).first;
  PN::detect_creases(mesh, 40, sharp);
  const auto result = PN::compare_with_linear(
    mesh, PN::CatmullClark_scheme(),
    CGAL::parameters::number_of_iterations(2).edge_is_constrained_map(sharp));
  EXPECT_NEAR(result.volume_ratio, 1 + twice_segments / twice_area, 0.015);
}

// Steps in a plane: tangents along their diagonal are those of no arc. Ends mirror them.
TEST(Creases_roundness, StepsAreNotRound)
{
  for (const bool ends_are_corners : {false, true}) // or darts
    for (unsigned steps : {2u, 5u}) {               // edges of the crease; of two both end
      Mesh mesh;
      const unsigned n = 8;
      for (unsigned j = 0; j <= n; ++j)
        for (unsigned i = 0; i <= n; ++i) mesh.add_vertex(Point(i, j, 0));
      const auto v = [&](unsigned i, unsigned j) { return Mesh::Vertex_index(j * (n + 1) + i); };
      for (unsigned j = 0; j < n; ++j)
        for (unsigned i = 0; i < n; ++i)
          mesh.add_face(v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1));
      const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("sharp", false).first;
      const auto corner = mesh.add_property_map<Mesh::Vertex_index, bool>("corner", false).first;
      const auto on_crease = [&](unsigned k) { return v(2 + (k + 1) / 2, 2 + k / 2); };
      for (unsigned k = 0; k < steps; ++k)
        sharp[mesh.edge(mesh.halfedge(on_crease(k), on_crease(k + 1)))] = true;
      for (unsigned k : {0u, steps}) corner[on_crease(k)] = ends_are_corners;
      const auto result = PN::compare_with_linear(mesh, PN::CatmullClark_scheme(),
                                                  CGAL::parameters::number_of_iterations(1)
                                                    .edge_is_constrained_map(sharp)
                                                    .vertex_is_constrained_map(corner));
      EXPECT_LE(result.largest_distance, 1e-9) << steps << ends_are_corners;
    }
}

// Both lie in the plane of a meridian, and a normal that is orthogonal to both is tangent to the ball.
TEST(Creases_roundness, CreasesThatBendAwayDoNotTurnNormals)
{
  Turned_part ball(even(7), {{1.5, 0, true}, {1.272, 0.795, true}, {0.658, 1.348, true}}, false);
  const auto edge = [&](unsigned a, unsigned b) {
    return ball.mesh.edge(ball.mesh.halfedge(Mesh::Vertex_index(a), Mesh::Vertex_index(b)));
  };
  for (unsigned i = 0; i < 14; ++i) ball.sharp[edge(i, i + 7)] = true;
  for (unsigned i : {7u, 9u, 11u}) ball.sharp[edge(i, i + 1)] = false;
  EXPECT_LE(excess_of_volume(ball, false), 0.02);
  const auto result =
    PN::compare_with_linear(ball.mesh, PN::CatmullClark_scheme(), ball.parameters());
  EXPECT_LE(result.largest_distance, 0.1);
}

// A slit in a plane, one lip of which is a little higher: the circle through its tip and its ends stands upright.
TEST(Creases_roundness, TipsOfSlitsDoNotTurnNormals)
{
  const double height = 1e-3;
  Mesh mesh;
  const auto tip = mesh.add_vertex(Point(0, 0, 0));
  std::vector<Mesh::Vertex_index> ring;
  for (unsigned i = 0; i < 8; ++i) {
    const double a = 2 * Turned_part::pi * i / 8;
    ring.push_back(mesh.add_vertex(Point(4 * std::cos(a), 4 * std::sin(a), 0)));
  }
  ring.push_back(mesh.add_vertex(Point(4, 0, height)));
  for (unsigned i = 0; i < 8; ++i) mesh.add_face(tip, ring[i], ring[i + 1]);
  mesh.add_face(tip, ring[8], ring[0]);
  const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("sharp", false).first;
  for (const auto end : {ring[0], ring[8]}) sharp[mesh.edge(mesh.halfedge(tip, end))] = true;
  PN::subdivide(mesh, PN::Loop_scheme(),
                CGAL::parameters::number_of_iterations(2).edge_is_constrained_map(sharp));
  for (auto v : mesh.vertices()) {
    EXPECT_LE(mesh.point(v).z(), 2 * height) << v;
    EXPECT_GE(mesh.point(v).z(), -height) << v;
  }
}

// Three points are on a circle, whatever they are: of a facet in a bumpy sheet it would fold the facet.
TEST(Creases_roundness, TrianglesAreNoCircles)
{
  Mesh mesh;
  const unsigned n = 8;
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i)
      mesh.add_vertex(Point(i + 0.7 * j, 0.5 * j, i == 4 && j == 4 ? 0.2 : 0));
  const auto v = [&](unsigned i, unsigned j) { return Mesh::Vertex_index(j * (n + 1) + i); };
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      mesh.add_face(v(i, j), v(i + 1, j), v(i + 1, j + 1));
      mesh.add_face(v(i, j), v(i + 1, j + 1), v(i, j + 1));
    }
  const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("sharp", false).first;
  for (const auto& [a, b] : {std::pair(v(4, 4), v(5, 4)), {v(5, 4), v(5, 5)}, {v(5, 5), v(4, 4)}})
    sharp[mesh.edge(mesh.halfedge(a, b))] = true;
  const auto result = PN::compare_with_linear(
    mesh, PN::Loop_scheme(),
    CGAL::parameters::number_of_iterations(2).edge_is_constrained_map(sharp));
  EXPECT_LE(result.folded_edges, result.linear_folded_edges);
  EXPECT_LE(result.largest_distance, 0.3);
}

// Arcs would move the rim of the lid by more than the faces beside it are wide. They do not meet exactly.
TEST(Creases_roundness, CreasesDoNotMoveByMoreThanTheWidthOfFaces)
{
  for (const double width : {1., 0.01}) {
    Turned_part part(even(9), {{2.5, -1, false}, {1 + width, 0.98, false}, {1, 1, true}}, false);
    for (unsigned v = 18; v < 27; ++v) {
      Point& p = part.mesh.point(Mesh::Vertex_index(v));
      p = Point(1.1 * p.x(), p.y(), p.z());
    }
    const auto result =
      PN::compare_with_linear(part.mesh, PN::CatmullClark_scheme(), part.parameters());
    if (width == 1)
      EXPECT_GE(result.largest_distance, 0.1);
    else
      EXPECT_LE(result.largest_distance, 0.01);
  }
}

// A lid that is folded by 24 degrees along a diagonal. At its ends no arcs meet. At the other corners all do, of one plane.
TEST(Creases_roundness, FoldedLidsAreNotRound)
{
  for (const bool triangles : {false, true}) {
    Mesh box;
    for (double z : {0., 1.})
      for (const auto& [x, y] : {std::pair(0., 0.), {0.25, -0.5}, {1., 0.}, {0.25, 0.5}})
        box.add_vertex(Point(x, y, z == 0 || y == 0 ? z : z - 0.1063));
    const auto v = [](unsigned i) { return Mesh::Vertex_index(i); };
    box.add_face(v(3), v(2), v(1), v(0));
    box.add_face(v(4), v(5), v(6));
    box.add_face(v(4), v(6), v(7));
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned j = (i + 1) % 4;
      box.add_face(v(i), v(j), v(j + 4), v(i + 4));
    }
    if (triangles) CGAL::Polygon_mesh_processing::triangulate_faces(box);
    const auto sharp = box.add_property_map<Mesh::Edge_index, bool>("sharp", false).first;
    PN::detect_creases(box, 30, sharp);
    const auto parameters =
      CGAL::parameters::number_of_iterations(2).edge_is_constrained_map(sharp);
    const auto result = triangles
                          ? PN::compare_with_linear(box, PN::Loop_scheme(), parameters)
                          : PN::compare_with_linear(box, PN::CatmullClark_scheme(), parameters);
    EXPECT_LE(result.largest_distance, 1e-9) << triangles;
  }
}

// There is an arc through any three points.
TEST(Creases_roundness, BetweenTwoCornersOneVertexIsNotRound)
{
  Turned_part prism(even(12), {{1, 0, true}, {1, 1, true}}, false);
  for (unsigned i = 0; i < 12; i += 2)
    prism.sharp[prism.mesh.edge(
      prism.mesh.halfedge(Mesh::Vertex_index(i), Mesh::Vertex_index(12 + i)))] = true;
  const auto result =
    PN::compare_with_linear(prism.mesh, PN::CatmullClark_scheme(), prism.parameters());
  EXPECT_LE(result.largest_distance, 1e-9);
}
