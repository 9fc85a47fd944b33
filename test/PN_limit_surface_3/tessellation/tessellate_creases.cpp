// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Tessellations of parts with creases and borders, whose surfaces are known.

#include "Crease_shapes.h"
#include "Tagged_meshes.h"
#include "Tessellation_cases.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/Surface_mesh.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using namespace tessellation_cases;
using crease_shapes::Part;
using Mesh = CGAL::Surface_mesh<Point>;

void expect_part(const std::string& name, Part part, double eps)
{
  SCOPED_TRACE(name);
  part.place();
  const auto data = part.control();
  tagged_meshes::Tagged<Mesh> control(data);
  Mesh out;
  const auto result = PN::tessellate(
    control.mesh, PN::internal::with_border(PN::CatmullClark_scheme(), data.border), eps, out,
    params::vertex_normal_map(control.normals)
      .edge_is_constrained_map(control.sharp)
      .vertex_is_constrained_map(control.corners));
  EXPECT_TRUE(result.reached);
  EXPECT_LE(result.bound, eps);
  expect_conforming(out, control.mesh);
  double error = 0;
  for_each_sample(triangles(out), [&](const Point& p) {
    crease_shapes::Real least = crease_shapes::infinity;
    for (const auto& surface : part.surfaces)
      least = (std::min)(least, surface.distance({p.x(), p.y(), p.z()}));
    error = (std::max)(error, double(least));
  });
  EXPECT_LE(error, eps);
  for (auto e : out.edges()) {
    if (!out.is_border(e)) continue;
    for (const double t : {0., 0.3, 0.5}) {
      const Point p = CGAL::ORIGIN + (out.point(out.vertex(e, 0)) - CGAL::ORIGIN) * t +
                      (out.point(out.vertex(e, 1)) - CGAL::ORIGIN) * (1 - t);
      crease_shapes::Real least = crease_shapes::infinity;
      for (const auto& surface : part.of_border)
        least = (std::min)(least, surface.distance({p.x(), p.y(), p.z()}));
      EXPECT_LE(double(least), eps);
    }
  }
}

TEST(Tessellate, Parts)
{
  for (const double eps : {0.05, 0.01}) {
    expect_part("capped cylinder", crease_shapes::capped_cylinder(crease_shapes::uneven(7)), eps);
    expect_part("half ball", crease_shapes::half_ball(), eps);
    expect_part("lens", crease_shapes::lens(), eps);
    expect_part("washer", crease_shapes::washer(), eps);
    expect_part("D-section", crease_shapes::d_section(), eps);
    expect_part("rounded box", crease_shapes::rounded_box(), eps);
  }
}
TEST(Tessellate, PartsWithBorders)
{
  for (const double eps : {0.05, 0.01}) {
    expect_part("plate with hole", crease_shapes::plate_with_hole(), eps);
    expect_part("ball cap", crease_shapes::ball_cap(), eps);
    expect_part("octant", crease_shapes::octant(), eps);
  }
}
// as a rim, not as an area
void expect_growth_of_rim(Part part)
{
  part.place();
  const auto data = part.control();
  tagged_meshes::Tagged<Mesh> control(data);
  std::vector<std::size_t> numbers;
  for (const double eps : {0.01, 0.0025, 0.000625}) {
    Mesh out;
    PN::tessellate(control.mesh, PN::internal::with_border(PN::CatmullClark_scheme(), data.border),
                   eps, out,
                   params::vertex_normal_map(control.normals)
                     .edge_is_constrained_map(control.sharp)
                     .vertex_is_constrained_map(control.corners));
    expect_conforming(out, control.mesh);
    numbers.push_back(out.number_of_faces());
  }
  EXPECT_LE(double(numbers[2] - numbers[1]), 2.6 * double(numbers[1] - numbers[0]));
}
TEST(Tessellate, PlanesStayCoarse)
{
  expect_growth_of_rim(crease_shapes::plate_with_hole());
}
TEST(Tessellate, RulingsStayUndivided)
{
  expect_growth_of_rim(crease_shapes::capped_cylinder(crease_shapes::uneven(7)));
}

// \name Against uniform rounds

struct Tagged_mesh
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, double> sharp =
    mesh.add_property_map<Mesh::Edge_index, double>("e:sharpness", 0).first;

  Tagged_mesh(const std::vector<Point>& points, const std::vector<std::vector<unsigned>>& faces)
  {
    for (const Point& p : points) mesh.add_vertex(p);
    for (const auto& f : faces) {
      std::vector<Mesh::Vertex_index> corners;
      for (const unsigned v : f) corners.emplace_back(v);
      mesh.add_face(corners);
    }
  }
  double& sharpness(unsigned v, unsigned w)
  {
    return sharp[mesh.edge(mesh.halfedge(Mesh::Vertex_index(v), Mesh::Vertex_index(w)))];
  }
};

// the limits after so many rounds
template <class Scheme>
std::vector<Point> uniform_limits(const Tagged_mesh& control, const Scheme& scheme, unsigned rounds)
{
  Mesh mesh = control.mesh;
  const auto sharp = mesh.add_property_map<Mesh::Edge_index, double>("e:sharpness", 0).first;
  PN::subdivide_to_limit(mesh, scheme,
                         params::number_of_iterations(rounds).edge_is_constrained_map(sharp));
  std::vector<Point> points;
  for (auto v : mesh.vertices()) points.push_back(mesh.point(v));
  return points;
}

double largest_distance(const std::vector<Point>& points, const std::vector<Triangle>& all)
{
  double largest = 0;
  for (const Point& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : all) {
      const double radius =
        std::sqrt((std::max)(CGAL::squared_distance(a, b), CGAL::squared_distance(a, c)));
      if (std::sqrt(CGAL::squared_distance(p, a)) - radius > least) continue;
      least = (std::min)(least, std::sqrt(CGAL::squared_distance(
                                  p, CGAL::Simple_cartesian<double>::Triangle_3(a, b, c))));
    }
    largest = (std::max)(largest, least);
  }
  return largest;
}

// A prism of five sides: a crease in a face of five corners.
TEST(Tessellate, CreasesInPolygons)
{
  std::vector<Point> points;
  for (const double z : {-1., 1.})
    for (int i = 0; i < 5; ++i)
      points.emplace_back(std::cos(0.4 * CGAL_PI * i), std::sin(0.4 * CGAL_PI * i), z);
  Tagged_mesh control(points, {{4, 3, 2, 1, 0},
                               {5, 6, 7, 8, 9},
                               {0, 1, 6, 5},
                               {1, 2, 7, 6},
                               {2, 3, 8, 7},
                               {3, 4, 9, 8},
                               {4, 0, 5, 9}});
  control.sharpness(3, 4) = std::numeric_limits<double>::infinity();
  const std::vector<Point> limits = uniform_limits(control, PN::CatmullClark_scheme(), 3);
  constexpr double eps = 0.03;
  Mesh out;
  const auto result = PN::tessellate(control.mesh, PN::CatmullClark_scheme(), eps, out,
                                     params::edge_is_constrained_map(control.sharp));
  EXPECT_TRUE(result.reached);
  EXPECT_EQ(result.obstacle, PN::Tessellation_result::Obstacle::none);
  EXPECT_LE(result.bound, eps);
  expect_conforming(out, control.mesh);
  EXPECT_LE(largest_distance(limits, triangles(out)), eps);
}

// Leaves beside finer ones have triangles that their own corners do not tell of.
TEST(Tessellate, LeavesWithFinerNeighborsAreSplitAgain)
{
  const Tagged_mesh control({{-0.07, 0.00760844, 0.0275278},
                             {-0.07, 0.00760844, 0.0324721},
                             {-0.07, 0.00785828, 0.0285009},
                             {-0.07, 0.00785828, 0.031499},
                             {-0.07, 0.0079842, 0.0294976},
                             {-0.07, 0.0079842, 0.0305023},
                             {-0.0391895, 0.00760844, 0.0275278},
                             {-0.0391895, 0.00760844, 0.0324721},
                             {-0.0391419, 0.00785828, 0.0285009},
                             {-0.0391419, 0.00785828, 0.031499},
                             {-0.0391178, 0.0079842, 0.0305023}},
                            {{2, 5, 4},
                             {2, 3, 5},
                             {0, 3, 2},
                             {0, 1, 3},
                             {2, 6, 0},
                             {3, 7, 9},
                             {3, 1, 7},
                             {5, 9, 10},
                             {5, 3, 9},
                             {4, 8, 2}});
  for (const double eps : {4e-4, 2e-4, 1e-4}) {
    Mesh out;
    const auto result = PN::tessellate(control.mesh, PN::Loop_scheme(), eps, out);
    EXPECT_TRUE(result.reached) << eps;
    EXPECT_LE(result.bound, eps);
    expect_conforming(out, control.mesh);
  }
}

// As they are on both sides of a crease that is folded: the last bits of such normals must not decide on an estimate.
TEST(Tessellate, SectionsOfOppositeNormalsDoNotDependOnRounding)
{
  using namespace PN::internal::flatness;
  const Vector n = {0.6, 0.64, 0.48};
  double least = 1, largest = 0;
  for (int i = 0; i < 27; ++i) {
    const double bit = 0x1p-53;
    const Vector m = {-n[0] + bit * (i % 3 - 1), -n[1] + bit * (i / 3 % 3 - 1),
                      -n[2] + bit * (i / 9 - 1)};
    for (const auto& section : {Section({{0, 0, 0}, n}, {{1, 0.5, 0.25}, m}),
                                Section({{1, 0.5, 0.25}, m}, {{0, 0, 0}, n})}) {
      least = (std::min)(least, section.bulge());
      largest = (std::max)(largest, section.bulge());
    }
  }
  EXPECT_NEAR(least, largest, 1e-9);
}

// \name What is sharp, but not forever

template <class Scheme>
void expect_finite_sharpness(const Scheme& scheme, double some, double others)
{
  SCOPED_TRACE(std::to_string(some) + " and " + std::to_string(others));
  Tagged_mesh control(
    {{0, 0, 0},
     {1.3, 0, 0},
     {0, 0.9, 0},
     {1.3, 1, 0},
     {0, 0, 1.1},
     {1.3, 0, 1.1},
     {0, 0.9, 0.9},
     {1.3, 1, 0.9}},
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  unsigned number = 0;
  for (auto e : control.mesh.edges()) control.sharp[e] = number++ % 3 == 0 ? some : others;
  const std::vector<Point> limits = uniform_limits(control, scheme, 4);
  constexpr double eps = 0.06;
  Mesh out;
  const auto result =
    PN::tessellate(control.mesh, scheme, eps, out, params::edge_is_constrained_map(control.sharp));
  EXPECT_TRUE(result.reached);
  EXPECT_LE(result.depth, 4U);
  expect_conforming(out, control.mesh);
  for (auto v : out.vertices()) {
    double least = 1;
    for (const Point& p : limits)
      least = (std::min)(least, CGAL::squared_distance(out.point(v), p));
    EXPECT_LE(least, 1e-16);
  }
  EXPECT_LE(largest_distance(limits, triangles(out)), 1.25 * eps); // it is an estimate
}
TEST(Tessellate, SharpnessMayBeFinite)
{
  constexpr double forever = std::numeric_limits<double>::infinity();
  expect_finite_sharpness(PN::CatmullClark_scheme(), 0.5, 0);
  expect_finite_sharpness(PN::CatmullClark_scheme(), 1.5, 2);
  expect_finite_sharpness(PN::CatmullClark_scheme(), 1, forever);
  expect_finite_sharpness(PN::linear(PN::CatmullClark_scheme()), 1.5, forever);
}

} // namespace
