// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Comparison with the linear result, against loops over faces and coordinates that are written here, in long double.

#include "Mesh_cases.h"
#include "Mesh_shapes.h"
#include "support/Exact_rational.h"

#include <CGAL/PN_certificates_3/compare_with_linear.h>

#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_by_name.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>

#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
using mesh_cases::built;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using mesh_cases::Polygon;

// Points and faces of a mesh, and what is measured of them.
struct Measured
{
  explicit Measured(const Mesh& mesh)
    : faces(mesh_cases::faces_of(mesh))
  {
    for (const auto& p : mesh_cases::points(mesh)) points.emplace_back(p[0], p[1], p[2]);
  }

  // a sixth of the determinants of the triangles round the means
  Real volume() const
  {
    Real sum = 0;
    for (const Polygon& face : faces) {
      Vector mean = Vector::Zero();
      for (const std::size_t v : face) mean += points[v] / Real(face.size());
      for (std::size_t i = 0; i < face.size(); ++i)
        sum += mean.dot(points[face[i]].cross(points[face[(i + 1) % face.size()]])) / 6;
    }
    return sum;
  }

  // the angles in degrees at edges of two faces
  std::map<std::pair<std::size_t, std::size_t>, Real> turns() const
  {
    std::map<std::pair<std::size_t, std::size_t>, Vector> sides;
    for (const Polygon& face : faces) {
      Vector area = Vector::Zero();
      for (std::size_t i = 2; i < face.size(); ++i)
        area += (points[face[i - 1]] - points[face[0]]).cross(points[face[i]] - points[face[0]]);
      for (std::size_t i = 0; i < face.size(); ++i)
        sides[{face[i], face[(i + 1) % face.size()]}] = area;
    }
    std::map<std::pair<std::size_t, std::size_t>, Real> angles;
    for (const auto& [ends, n] : sides) {
      const auto other = sides.find({ends.second, ends.first});
      if (ends.first > ends.second || other == sides.end()) continue;
      const Vector& m = other->second;
      if (m.norm() > 0 && n.norm() > 0)
        angles[ends] = std::atan2(m.cross(n).norm(), m.dot(n)) * 180 / std::acos(Real(-1));
    }
    return angles;
  }
  std::size_t edges_beyond(Real degrees) const
  {
    std::size_t number = 0;
    for (const auto& edge : turns()) number += edge.second > degrees;
    return number;
  }

  // of the edges at a vertex
  Real mean_length(std::size_t v) const
  {
    std::set<std::size_t> neighbors;
    for (const Polygon& face : faces)
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::size_t a = face[i], b = face[(i + 1) % face.size()];
        if (a == v) neighbors.insert(b);
        if (b == v) neighbors.insert(a);
      }
    Real sum = 0;
    for (const std::size_t w : neighbors) sum += (points[w] - points[v]).norm();
    return neighbors.empty() ? 0 : sum / Real(neighbors.size());
  }

  std::vector<Vector> points;
  std::vector<Polygon> faces;
};

Mesh cube(double a = 1, double b = 1, double c = 1)
{
  Mesh mesh = built<Mesh>(mesh_cases::cube());
  for (const auto v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    mesh.point(v) = Point_3(a * p.x(), b * p.y(), c * p.z());
  }
  return mesh;
}

// a prism with n sides of which the first one is in x direction
Mesh prism(std::size_t n)
{
  mesh_cases::Soup soup{{}, {{}, {}}};
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double t = 2 * std::acos(-1.) * double(i % n) / double(n);
    soup.points.push_back({std::cos(t), std::sin(t), i < n ? 0. : 1.});
    soup.faces[i / n].push_back(i < n ? n - 1 - i : i);
  }
  for (std::size_t i = 0; i < n; ++i)
    soup.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  return built<Mesh>(soup);
}

// two triangles that meet in an edge at this angle
Mesh roof(double degrees)
{
  const double t = degrees * std::acos(-1.) / 180;
  return built<Mesh>({{{0, 0, 0}, {1, 0, 0}, {0.5, -1, 0}, {0.5, std::cos(t), std::sin(t)}},
                      {{1, 0, 2}, {0, 1, 3}}});
}

Mesh transformed(Mesh mesh, double factor, const Vector_3& move = CGAL::NULL_VECTOR)
{
  for (const auto v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + factor * (mesh.point(v) - CGAL::ORIGIN) + move;
  return mesh;
}

// crumpled: some faces fold
Mesh shaken(Mesh mesh, double by, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> d(-by, by);
  for (const auto v : mesh.vertices()) {
    const double x = d(random), y = d(random), z = d(random);
    mesh.point(v) = mesh.point(v) + Vector_3(x, y, z);
  }
  return mesh;
}

template <class Scheme>
Mesh refined(Mesh mesh, const Scheme& scheme, unsigned rounds)
{
  PN::subdivide(mesh, scheme, CGAL::parameters::number_of_iterations(rounds));
  return mesh;
}

Mesh torus()
{
  return built<Mesh>(test_meshes::grid(9, 6, true, true, test_meshes::Cells::quads));
}

void expect_measures(const PN::Comparison_with_linear& c, const Measured& control,
                     const Measured& result, const Measured& linear)
{
  EXPECT_NEAR(c.control_volume, double(control.volume()), 1e-12 * std::abs(c.control_volume));
  EXPECT_NEAR(c.volume_ratio, double(result.volume() / control.volume()), 1e-11);
  EXPECT_NEAR(c.linear_volume_ratio, double(linear.volume() / control.volume()), 1e-11);
  EXPECT_EQ(c.folded_edges, result.edges_beyond(90));
  EXPECT_EQ(c.linear_folded_edges, linear.edges_beyond(90));
  EXPECT_EQ(c.sharply_folded_edges, result.edges_beyond(150));
  EXPECT_EQ(c.linear_sharply_folded_edges, linear.edges_beyond(150));
  EXPECT_EQ(c.turning_edges, control.edges_beyond(40.1L));
  EXPECT_EQ(c.control_vertices, control.points.size());
  Real largest = 0, at_vertex = 0;
  for (std::size_t v = 0; v < linear.points.size(); ++v) {
    const Real x = (result.points[v] - linear.points[v]).norm() / linear.mean_length(v);
    largest = std::max(largest, x);
    if (v == c.farthest_vertex) at_vertex = x;
  }
  const double rounding = 1e-12 * (1 + double(largest));
  EXPECT_NEAR(c.largest_distance, double(largest), rounding);
  EXPECT_NEAR(c.largest_distance, double(at_vertex), rounding);
}

void expect_same(const PN::Comparison_with_linear& a, const PN::Comparison_with_linear& b,
                 double tolerance)
{
  EXPECT_EQ(a.is_closed, b.is_closed);
  EXPECT_NEAR(a.volume_ratio, b.volume_ratio, tolerance);
  EXPECT_NEAR(a.linear_volume_ratio, b.linear_volume_ratio, tolerance);
  EXPECT_EQ(a.folded_edges, b.folded_edges);
  EXPECT_EQ(a.linear_folded_edges, b.linear_folded_edges);
  EXPECT_EQ(a.sharply_folded_edges, b.sharply_folded_edges);
  EXPECT_NEAR(a.largest_distance, b.largest_distance, tolerance * a.largest_distance);
  EXPECT_EQ(a.turning_edges, b.turning_edges);
}

template <class Scheme>
PN::Comparison_with_linear compare(const Mesh& mesh, const Scheme& scheme, unsigned rounds)
{
  return PN::compare_with_linear(mesh, scheme, CGAL::parameters::number_of_iterations(rounds));
}

} // namespace

// --- against the loops ---

TEST(Compare_with_linear, MeasuresWhatPlainLoopsMeasure)
{
  std::size_t folds = 0, sharp_folds = 0;
  for (unsigned seed = 0; seed < 6; ++seed)
    for (const double by : {0.05, 0.6, 1.5}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", moved by " << by);
      const Mesh mesh = shaken(torus(), by, seed);
      const PN::CatmullClark_scheme scheme;
      const auto c = compare(mesh, scheme, 2);
      const Measured result(refined(mesh, scheme, 2)), linear(refined(mesh, PN::linear(scheme), 2));
      EXPECT_TRUE(c.is_closed);
      expect_measures(c, Measured(mesh), result, linear);
      folds += c.folded_edges;
      sharp_folds += c.sharply_folded_edges;
    }
  EXPECT_GT(folds, sharp_folds); // both are there
  EXPECT_GT(sharp_folds, 0u);
}

TEST(Compare_with_linear, EverySchemeIsComparedWithItsOwnTwin)
{
  const Mesh quads = shaken(torus(), 0.3, 1);
  PN::for_each_shipped_scheme([&](const auto& scheme) {
    SCOPED_TRACE(scheme.name());
    Mesh mesh = quads;
    const auto any = PN::any_scheme<double>(scheme.name());
    if (any.needs_triangles()) CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    const Measured result(refined(mesh, scheme, 2)), linear(refined(mesh, PN::linear(scheme), 2));
    expect_measures(compare(mesh, scheme, 2), Measured(mesh), result, linear);
    expect_same(compare(mesh, any, 2), compare(mesh, scheme, 2), 0);
  });
}

// Edges of a cube whose tangents lean: the comparison is that of what subdivide() makes of them.
TEST(Compare_with_linear, TangentsThatAreGivenAreTaken)
{
  Mesh mesh = cube();
  auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", true).first;
  auto tangents = mesh.add_property_map<Mesh::Halfedge_index, Vector_3>("h:t").first;
  for (const auto h : mesh.halfedges()) {
    const Vector_3 along = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    const Vector_3 t = along + 0.4 * (mesh.point(mesh.source(h)) - CGAL::ORIGIN);
    tangents[h] = t / std::sqrt(t.squared_length());
  }
  const Mesh control = mesh;
  const auto np = CGAL::parameters::number_of_iterations(2).edge_is_constrained_map(sharp);
  const PN::CatmullClark_scheme scheme;
  const auto given =
    PN::compare_with_linear(control, PN::internal::with_crease_tangents(scheme, tangents), np);
  Mesh linear = mesh, result = mesh;
  const auto refine = [&](Mesh& m, const auto& s) {
    auto map = m.add_property_map<Mesh::Edge_index, bool>("e:sharp").first;
    PN::subdivide(m, s, CGAL::parameters::number_of_iterations(2).edge_is_constrained_map(map));
  };
  refine(linear, PN::linear(scheme));
  auto map = result.add_property_map<Mesh::Halfedge_index, Vector_3>("h:t").first;
  refine(result, PN::internal::with_crease_tangents(scheme, map));
  const auto expected = PN::compare_with_linear(control, result, linear);
  EXPECT_NEAR(given.volume_ratio, expected.volume_ratio, 1e-12);
  EXPECT_NEAR(given.largest_distance, expected.largest_distance, 1e-12);
  EXPECT_GT(
    std::abs(given.volume_ratio - PN::compare_with_linear(control, scheme, np).volume_ratio), 1e-3);
}

// The ball through the corners of the cube has the volume 4/3 pi 3 sqrt(3) for 8: pi sqrt(3) / 2.
TEST(Compare_with_linear, TheBallAroundACube)
{
  Mesh mesh = cube();
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:n").first;
  for (const auto v : mesh.vertices()) normals[v] = mesh.point(v) - CGAL::ORIGIN;
  const auto ratio = [&](unsigned rounds) {
    const auto c = PN::compare_with_linear(
      mesh, PN::CatmullClark_scheme(),
      CGAL::parameters::number_of_iterations(rounds).vertex_normal_map(normals));
    EXPECT_FALSE(c.is_folded());
    EXPECT_FALSE(c.is_swollen()); // the linear one shrinks to a third
    EXPECT_EQ(c.folded_edges, 0u);
    EXPECT_DOUBLE_EQ(c.control_volume, 8);
    EXPECT_EQ(c.turning_edges, 12u);
    return c.volume_ratio;
  };
  const double ball = std::acos(-1.) * std::sqrt(3.) / 2;
  const double before = ratio(4), last = ratio(5);
  EXPECT_LT(before, last); // points are on the sphere, faces inside it
  EXPECT_LT(last, ball);
  EXPECT_NEAR((4 * last - before) / 3, ball, 1e-4);        // their error goes with h^2
  EXPECT_DOUBLE_EQ(normals[Mesh::Vertex_index(6)].x(), 1); // as they were
}

// --- places and sizes ---

TEST(Compare_with_linear, NothingDependsOnThePlaceAndTheSize)
{
  const Mesh mesh = shaken(torus(), 1.5, 3);
  Mesh lattice = mesh; // so that a move is exact
  for (const auto v : lattice.vertices()) {
    const Point_3& p = lattice.point(v);
    lattice.point(v) = Point_3(std::floor(p.x() * 1024) / 1024, std::floor(p.y() * 1024) / 1024,
                               std::floor(p.z() * 1024) / 1024);
  }
  const PN::CatmullClark_scheme scheme;
  const auto expected = compare(lattice, scheme, 2);
  EXPECT_GT(expected.folded_edges, 0u);
  for (const double factor : {0x1p600, 0x1p-600, 0x1p20}) {
    const auto c = compare(transformed(lattice, factor), scheme, 2);
    expect_same(c, expected, 0);
    EXPECT_EQ(c.farthest_vertex, expected.farthest_vertex);
  }
  EXPECT_EQ(compare(transformed(lattice, 0x1p20), scheme, 2).control_volume,
            std::ldexp(expected.control_volume, 60));
  // the cubes of these coordinates have no digit left for the volume
  expect_same(compare(transformed(lattice, 1, Vector_3(0x1p30, -0x1p30, 0x1p29)), scheme, 2),
              expected, 1e-4);
}

TEST(Compare_with_linear, InsideOutTheRatiosAreTheSame)
{
  const Mesh mesh = shaken(torus(), 0.3, 2);
  Mesh turned = mesh;
  CGAL::Polygon_mesh_processing::reverse_face_orientations(turned);
  const PN::CatmullClark_scheme scheme;
  const auto a = compare(mesh, scheme, 2), b = compare(turned, scheme, 2);
  EXPECT_GT(a.control_volume, 0);
  EXPECT_NEAR(b.control_volume, -a.control_volume, 1e-12 * a.control_volume);
  EXPECT_NEAR(b.volume_ratio, a.volume_ratio, 1e-11);
}

TEST(Compare_with_linear, OpenMeshesAndFlatOnesHaveNoVolume)
{
  const PN::CatmullClark_scheme scheme;
  const auto open = compare(roof(60), scheme, 2);
  EXPECT_FALSE(open.is_closed);
  EXPECT_TRUE(std::isnan(open.control_volume));
  EXPECT_TRUE(std::isnan(open.volume_ratio));
  EXPECT_FALSE(open.is_swollen());
  // pillows of two squares in a plane that no axis is in; of one that is cut volumes cancel but for rounding
  const std::vector<mesh_cases::Triple> corners = {
    {0, 0, 0}, {1, 0, 0.3}, {1.1, 1, 1}, {0.1, 1, 0.7}, {0.41, 0.37, 0.3709}};
  for (const Mesh& flat :
       {built<Mesh>({{corners.begin(), corners.end() - 1}, {{0, 1, 2, 3}, {3, 2, 1, 0}}}),
        built<Mesh>({corners, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {3, 2, 1, 0}}})})
    for (const double far : {0., 1e5}) {
      const auto c = compare(transformed(flat, 1, Vector_3(far, far, far)), PN::linear(scheme), 1);
      EXPECT_TRUE(c.is_closed);
      EXPECT_EQ(c.control_volume, 0);
      EXPECT_TRUE(std::isnan(c.volume_ratio));
      EXPECT_FALSE(c.is_swollen());
    }
  EXPECT_FALSE(compare(Mesh(), scheme, 2).is_closed);
  Mesh points;
  points.add_vertex(Point_3(1, 2, 3));
  EXPECT_EQ(compare(points, scheme, 2).largest_distance, 0);
}

// --- folds ---

TEST(Compare_with_linear, FoldsOfRoofs)
{
  for (const auto& [degrees, beyond_90, beyond_150] :
       {std::tuple<double, unsigned, unsigned>{89.9, 0, 0},
        {90, 0, 0},
        {90.1, 1, 0},
        {149.9, 1, 0},
        {150.1, 1, 1},
        {180, 1, 1}}) {
    SCOPED_TRACE(degrees);
    const Mesh mesh = roof(degrees), flat = roof(0);
    const auto c = PN::compare_with_linear(flat, mesh, flat);
    EXPECT_EQ(c.folded_edges, beyond_90);
    EXPECT_EQ(c.sharply_folded_edges, beyond_150);
    EXPECT_EQ(c.linear_folded_edges, 0u);
    EXPECT_EQ(c.turning_edges, 0u);
    const auto d = PN::compare_with_linear(mesh, flat, mesh);
    EXPECT_EQ(d.folded_edges, 0u);
    EXPECT_EQ(d.linear_folded_edges, beyond_90);
    EXPECT_EQ(d.linear_sharply_folded_edges, beyond_150);
    EXPECT_EQ(d.turning_edges, 1u);
  }
}

// Whatever their angle.
TEST(Compare_with_linear, CreasesAreNoFolds)
{
  Mesh box = cube(1, 1, 1);
  for (const auto v : box.vertices())
    box.point(v) = box.point(v) + Vector_3(box.point(v).z() / 2, 0, 0);
  const PN::CatmullClark_scheme scheme;
  Mesh result = box, linear = box;
  const auto all = [](Mesh& m) {
    return CGAL::parameters::number_of_iterations(2).edge_is_constrained_map(
      m.add_property_map<Mesh::Edge_index, bool>("e:sharp", true).first);
  };
  const auto of_box = all(box), of_result = all(result), of_linear = all(linear);
  PN::subdivide(result, scheme, of_result);
  PN::subdivide(linear, PN::linear(scheme), of_linear);
  const Mesh& control = box;
  for (const auto& c :
       {PN::compare_with_linear(control, scheme, of_box),
        PN::compare_with_linear(control, result, linear, of_box, of_result, of_linear)}) {
    EXPECT_EQ(c.folded_edges, 0u);
    EXPECT_EQ(c.linear_folded_edges, 0u);
  }
  const auto untold = PN::compare_with_linear(control, result, linear, of_box);
  EXPECT_GT(untold.folded_edges, 0u);
  EXPECT_GT(untold.linear_folded_edges, 0u);
}

// Right angles stay right whatever the rounding of a turned box.
TEST(Compare_with_linear, BoxesDoNotFold)
{
  const double c = std::cos(1.), s = std::sin(1.);
  Mesh box = cube(1, 2, 5);
  for (const auto v : box.vertices()) {
    const Point_3 p = box.point(v), q(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
    box.point(v) = Point_3(q.x(), c * q.y() - s * q.z(), s * q.y() + c * q.z());
  }
  auto sharp = box.add_property_map<Mesh::Edge_index, bool>("e:sharp", true).first;
  const Mesh& constant = box;
  const auto r = PN::compare_with_linear(
    constant, PN::CatmullClark_scheme(),
    CGAL::parameters::number_of_iterations(3).edge_is_constrained_map(sharp));
  EXPECT_EQ(r.folded_edges, 0u);
  EXPECT_NEAR(r.volume_ratio, 1, 1e-12);
  EXPECT_EQ(r.turning_edges, 0u); // all are sharp
  EXPECT_EQ(box.number_of_faces(), 6u);
}

// The middle face has its corners in a line, exactly or but for rounding; its normal would be any.
TEST(Compare_with_linear, FacesWithoutAreaAreLeftOut)
{
  for (const double far : {0., 1e7}) {
    SCOPED_TRACE(far);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> d(0, 1);
    for (int run = 0; run < 50; ++run) {
      const double x = d(random), y = d(random), z = d(random);
      const auto at = [&](double t, double u) { // along a line, and beside it
        return mesh_cases::Triple{far + t * x, far + t * y + u, far + t * z};
      };
      const Mesh mesh = built<Mesh>({{at(0, 0), at(1, 0), at(1. / 3, 0), at(.5, 1), at(.5, -1)},
                                     {{0, 1, 2}, {0, 4, 1}, {2, 1, 3}, {0, 2, 3}}});
      const auto c = PN::compare_with_linear(mesh, mesh, mesh);
      EXPECT_EQ(c.folded_edges, 0u);
    }
  }
}

// --- edges that turn ---

TEST(Compare_with_linear, EdgesThatTurnAndAreNotSharp)
{
  const PN::CatmullClark_scheme scheme;
  EXPECT_EQ(compare(cube(), scheme, 1).turning_edges, 12u);
  EXPECT_EQ(compare(prism(8), scheme, 1).turning_edges, 24u); // 45 degrees
  EXPECT_EQ(compare(prism(9), scheme, 1).turning_edges, 18u); // 40 degrees are not beyond 40
  EXPECT_EQ(compare(prism(10), scheme, 1).turning_edges, 20u);
  Mesh mesh = cube();
  auto sharpness = mesh.add_property_map<Mesh::Edge_index, double>("e:s", 0).first;
  sharpness[Mesh::Edge_index(2)] = 0.5;
  sharpness[Mesh::Edge_index(5)] = 3;
  const auto np = CGAL::parameters::number_of_iterations(1).edge_is_constrained_map(sharpness);
  EXPECT_EQ(PN::compare_with_linear(mesh, scheme, np).turning_edges, 10u);
  EXPECT_EQ(
    PN::compare_with_linear(mesh, mesh, mesh, CGAL::parameters::edge_is_constrained_map(sharpness))
      .turning_edges,
    10u);
  EXPECT_EQ(sharpness[Mesh::Edge_index(5)], 3);
}

// --- verdicts ---

// Cubes of volumes r and l times that of the control mesh.
TEST(Compare_with_linear, SwollenIsFartherFromTheVolumeThanLinear)
{
  const Mesh control = cube();
  const auto is_swollen = [&](double result, double linear) {
    const auto c = PN::compare_with_linear(control, transformed(control, std::cbrt(result)),
                                           transformed(control, std::cbrt(linear)));
    EXPECT_NEAR(c.volume_ratio, result, 1e-14 * std::abs(result));
    EXPECT_NEAR(c.linear_volume_ratio, linear, 1e-14 * std::abs(linear));
    return c.is_swollen();
  };
  const double e = std::exp(0.051), f = std::exp(0.049);
  EXPECT_FALSE(is_swollen(1, 1));
  EXPECT_TRUE(is_swollen(e, 1));
  EXPECT_FALSE(is_swollen(f, 1));
  EXPECT_TRUE(is_swollen(1 / e, 1)); // to shrink is no better
  EXPECT_FALSE(is_swollen(1 / f, 1));
  EXPECT_FALSE(is_swollen(2 * f, 0.5)); // linear halves it
  EXPECT_TRUE(is_swollen(2 * e, 0.5));
  EXPECT_FALSE(is_swollen(0.5, 2));
  EXPECT_TRUE(is_swollen(-1, 0.1)); // turned inside out
  EXPECT_FALSE(is_swollen(-1, -1));
}

TEST(Compare_with_linear, FoldedIsMoreThanATenthAndFourMore)
{
  PN::Comparison_with_linear c;
  const auto is_folded = [&](std::size_t result, std::size_t linear) {
    c.folded_edges = result;
    c.linear_folded_edges = linear;
    return c.is_folded();
  };
  EXPECT_FALSE(is_folded(4, 0));
  EXPECT_TRUE(is_folded(5, 0));
  EXPECT_FALSE(is_folded(114, 100));
  EXPECT_TRUE(is_folded(115, 100));
  EXPECT_FALSE(is_folded(0, 100));
}

// --- arguments ---

TEST(Compare_with_linear, MeshesOfOtherKindsAndNumbers)
{
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  auto exact = built<CGAL::Polyhedron_3<Exact>>(mesh_cases::cube());
  const PN::CatmullClark_scheme scheme;
  const auto c = PN::compare_with_linear(exact, scheme);
  const auto expected = compare(cube(), scheme, 1);
  EXPECT_DOUBLE_EQ(c.control_volume, 8);
  EXPECT_NEAR(c.volume_ratio, expected.volume_ratio, 1e-12);
  EXPECT_DOUBLE_EQ(c.linear_volume_ratio, expected.linear_volume_ratio);
  EXPECT_EQ(exact.size_of_vertices(), 8u);
  const Exact::FT away(std::ldexp(1., 80)), back(-std::ldexp(3., 80)), zero(0);
  for (auto v = exact.vertices_begin(); v != exact.vertices_end();
       ++v) // beyond the digits of double
    v->point() = v->point() + Exact::Vector_3(away, zero, back);
  const auto far = PN::compare_with_linear(exact, scheme);
  EXPECT_NEAR(far.volume_ratio, c.volume_ratio, 1e-12);
  EXPECT_NEAR(far.largest_distance, c.largest_distance, 1e-12);
  EXPECT_EQ(far.turning_edges, 12u);

  using Small = CGAL::Simple_cartesian<float>;
  const auto small = built<CGAL::Surface_mesh<Small::Point_3>>(mesh_cases::cube());
  EXPECT_NEAR(PN::compare_with_linear(small, scheme).volume_ratio, expected.volume_ratio, 1e-5);
}

// Normals by corner, a border that is a crease: what subdivide() makes of them is what is measured.
TEST(Compare_with_linear, TakesWhatSubdivideTakes)
{
  Mesh mesh = cube(1, 1, 3);
  CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(1)), mesh);
  mesh.collect_garbage();
  auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    sharp[e] = mesh.point(mesh.source(h)).z() < 0 && mesh.point(mesh.target(h)).z() < 0;
  }
  auto normals = mesh.add_property_map<Mesh::Halfedge_index, Vector_3>("h:n").first;
  for (const auto h : mesh.halfedges()) {
    const Point_3& p = mesh.point(mesh.target(h));
    if (mesh.is_border(h)) continue;
    normals[h] =
      mesh.face(h) == Mesh::Face_index(0) ? Vector_3(0, 0, -1) : Vector_3(p.x(), p.y(), 0);
  }
  const auto scheme = PN::internal::with_border(PN::CatmullClark_scheme(), PN::Border::curve);
  const Mesh control = mesh;
  const auto c = PN::compare_with_linear(
    mesh, scheme,
    CGAL::parameters::number_of_iterations(3).vertex_normal_map(normals).edge_is_constrained_map(
      sharp));
  EXPECT_FALSE(c.is_closed);
  EXPECT_EQ(c.turning_edges, 4u);
  Mesh linear = mesh;
  auto tags = linear.add_property_map<Mesh::Edge_index, bool>("e:tags", false).first;
  for (const auto e : linear.edges()) tags[e] = sharp[e];
  PN::subdivide(linear, PN::linear(scheme),
                CGAL::parameters::number_of_iterations(3).edge_is_constrained_map(tags));
  PN::subdivide(
    mesh, scheme,
    CGAL::parameters::number_of_iterations(3).vertex_normal_map(normals).edge_is_constrained_map(
      sharp));
  const auto d = PN::compare_with_linear(control, mesh, linear);
  EXPECT_EQ(c.largest_distance, d.largest_distance);
  EXPECT_EQ(c.farthest_vertex, d.farthest_vertex);
  EXPECT_EQ(c.folded_edges, d.folded_edges);
  EXPECT_GT(c.largest_distance, 0.5); // the rim is a circle, that of the linear one is none
}

// --- roundness ---

TEST(Compare_with_linear, RoundnessIsThatOfTheCall)
{
  Mesh mesh = shaken(torus(), 0.05, 4);
  auto roundness = mesh.add_property_map<Mesh::Vertex_index, double>("v:w", 1).first;
  for (unsigned v = 0; v < 12; ++v) roundness[Mesh::Vertex_index(v)] = v < 5 ? 0 : 0.5;
  const PN::CatmullClark_scheme scheme;
  const auto np = [&](auto map) {
    return PN::parameters::vertex_roundness_map(map).number_of_iterations(2);
  };
  const auto c = PN::compare_with_linear(mesh, scheme, np(roundness));
  EXPECT_EQ(c.vertices_of_roundness_0, 5u);
  EXPECT_EQ(c.vertices_of_roundness_below_1, 12u);
  EXPECT_EQ(c.control_vertices, 54u);
  EXPECT_EQ(roundness[Mesh::Vertex_index(7)], 0.5);
  Mesh result = mesh;
  auto copy = result.add_property_map<Mesh::Vertex_index, double>("v:copy", 1).first;
  for (const auto v : mesh.vertices()) copy[v] = roundness[v];
  PN::subdivide(result, scheme, np(copy));
  expect_measures(c, Measured(mesh), Measured(result),
                  Measured(refined(mesh, PN::linear(scheme), 2)));
  EXPECT_GT(c.largest_distance, 0.1);
}

TEST(Compare_with_linear, RoundnessOfAllVertices)
{
  Mesh mesh = cube(1, 1, 10);
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:n").first;
  for (const auto v : mesh.vertices()) normals[v] = mesh.point(v) - CGAL::ORIGIN;
  const PN::CatmullClark_scheme scheme;
  const auto of = [&](double w, const auto& np) {
    const auto c =
      PN::compare_with_linear(mesh, scheme, PN::parameters::join(PN::parameters::roundness(w), np));
    EXPECT_EQ(c.vertices_of_roundness_0, 0u); // it does not vary
    EXPECT_EQ(c.vertices_of_roundness_below_1, 0u);
    return c;
  };
  const auto given = CGAL::parameters::number_of_iterations(3).vertex_normal_map(normals);
  const auto estimated = CGAL::parameters::number_of_iterations(3);
  for (const auto& none : {of(0, given), of(0, estimated)}) {
    EXPECT_EQ(none.largest_distance, 0);
    EXPECT_FALSE(none.is_swollen());
  }
  EXPECT_LT(of(0, given).volume_ratio, of(0.5, given).volume_ratio);
  EXPECT_LT(of(0.5, given).volume_ratio, of(1, given).volume_ratio);
  EXPECT_LT(of(0.5, estimated).volume_ratio, of(1, estimated).volume_ratio);
  EXPECT_TRUE(of(1, given).is_swollen()); // a ball around the beam
}

// --- what is refused ---

TEST(Compare_with_linear, RefusesWhatCannotBeCompared)
{
  const Mesh a = cube(), b = refined(a, PN::CatmullClark_scheme(), 1);
  EXPECT_THROW(PN::compare_with_linear(a, a, b), std::invalid_argument);
  EXPECT_THROW(compare(a, PN::Loop_scheme(), 1), std::invalid_argument); // quads
  Mesh bad = a;
  bad.point(Mesh::Vertex_index(3)) = Point_3(0, std::nan(""), 0);
  EXPECT_THROW(compare(bad, PN::CatmullClark_scheme(), 1), std::invalid_argument);
  EXPECT_THROW(PN::compare_with_linear(a, a, bad), std::invalid_argument);
  EXPECT_THROW(compare(a, PN::CatmullClark_scheme(), 40), std::length_error);
}
