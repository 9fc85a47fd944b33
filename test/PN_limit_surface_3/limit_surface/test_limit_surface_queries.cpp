// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Closest points and rays on limit surfaces: spheres, and what many samples of a surface tell.

#include "Extent.h"
#include "Named_shapes.h"
#include "Scheme_runs.h"
#include "Surface_checks.h"

#include <CGAL/PN_limit_surface_3/Limit_surface_queries.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using test_meshes::Control_mesh;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Queries = PN::Limit_surface_queries<Surface_mesh, Kernel>;

using surface_checks::length;

std::vector<Vector> directions()
{
  std::vector<Vector> all;
  for (int i = 0; i < 4; ++i) {
    const Vector d(std::sin(1 + 2.3 * i), std::cos(0.5 + 1.7 * i), std::sin(0.3 + 4.1 * i));
    all.push_back(d / length(d));
  }
  return all;
}

template <class Scheme>
void expect_sphere(const Control_mesh& shape, const Scheme& scheme)
{
  Surface_mesh mesh = to_surface_mesh(named_shapes::on_unit_sphere(shape));
  const PN::Limit_surface surface(
    mesh, scheme, PN::parameters::tolerance(5e-6).vertex_normal_map(normal_map(mesh)));
  const Queries queries(surface);
  EXPECT_LT(queries.distance_from_triangles(), 0.1);
  for (const Vector& d : directions())
    for (const double r : {0.4, 3.}) {
      const auto c = queries.closest_point(CGAL::ORIGIN + r * d);
      EXPECT_NEAR(c.distance, std::abs(1 - r), 1e-6);
      EXPECT_LE(length(c.point - (CGAL::ORIGIN + d)), 1e-3);
      EXPECT_LE(length(surface.point(c.location.face, c.location.u, c.location.v) - c.point),
                1e-12);
      EXPECT_LE(c.error, 1e-4);
      // from outside, and from inside
      const Vector side(0.3, -0.2, 0.1);
      const Point source = r > 1 ? CGAL::ORIGIN + r * d : CGAL::ORIGIN + 0.1 * side;
      const auto hit = queries.first_intersection(source, r > 1 ? side - r * d : d * 5);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(length(hit->point - CGAL::ORIGIN), 1, 1e-6);
      EXPECT_LE(hit->error, 1e-4);
      const Vector u = (r > 1 ? side - r * d : d) / length(r > 1 ? side - r * d : d),
                   o = source - CGAL::ORIGIN;
      const double root = std::sqrt((o * u) * (o * u) - o * o + 1);
      EXPECT_NEAR(hit->distance, -(o * u) + (r > 1 ? -root : root), 1e-4);
      EXPECT_FALSE(queries.first_intersection(CGAL::ORIGIN + 3 * d, d));
    }
}

TEST(LimitSurfaceQueries, SpheresOfQuads)
{
  expect_sphere(named_shapes::cube(), PN::CatmullClark_scheme());
  if (tests_are_full) expect_sphere(named_shapes::prism(5), PN::CatmullClark_scheme());
}
TEST(LimitSurfaceQueries, SpheresOfTriangles)
{
  expect_sphere(test_meshes::bipyramid(5), PN::Loop_scheme());
}

// From inside, a large face may be the nearest though its triangles are not: those of small ones may be wholly nearer than what is
// found there, and over one of them several places be nearer than its neighbors. Near the middle not all can be looked at: what is
// claimed holds.
TEST(LimitSurfaceQueries, SpheresOfUnequalFacesFromInside)
{
  const auto expect = [](const Control_mesh& shape, const auto& scheme, const Vector& v,
                         double claimed) {
    Surface_mesh mesh = to_surface_mesh(named_shapes::on_unit_sphere(shape));
    const PN::Limit_surface surface(
      mesh, scheme, PN::parameters::tolerance(5e-6).vertex_normal_map(normal_map(mesh)));
    const auto hit = Queries(surface, 2).closest_point(CGAL::ORIGIN + v);
    EXPECT_LE(hit.error, claimed);
    EXPECT_NEAR(hit.distance, 1 - length(v), hit.error + 1e-6);
  };
  Control_mesh narrow = named_shapes::cube();
  for (auto& p : narrow.points) p = {0.3 * p[0] + 0.2, p[1] + 0.3, p[2]};
  expect(narrow, PN::CatmullClark_scheme(), 0.2 * directions().back(), 1e-5);
  Control_mesh flat = test_meshes::bipyramid(5);
  for (auto& p : flat.points) p[0] = 0.6 * p[0] + 0.2;
  expect(flat, PN::Loop_scheme(), {0.007543998, -0.026169655, -0.012579239}, 0.1);
}

// Faces of three corners become three pieces, and Newton's method ends at their sides.
TEST(LimitSurfaceQueries, PiecesOfPolygons)
{
  Control_mesh shape = named_shapes::tetrahedron();
  test_meshes::set_uneven_normals(shape, 5);
  Surface_mesh mesh = to_surface_mesh(shape);
  const PN::Limit_surface surface(mesh, PN::linear(PN::CatmullClark_scheme()),
                                  PN::parameters::tolerance(1e-9));
  const surface_checks::Fine_triangles fine(surface, 6);
  const Queries queries(surface);
  surface_checks::expect_rays(surface, queries, fine, 40);
  surface_checks::expect_closest_points(surface, queries, fine, 8);
}

// What is between a curved border and the chord of its ends belongs to the surface.
TEST(LimitSurfaceQueries, RaysBesideCurvedBorders)
{
  const auto expect = [](Control_mesh shape, const auto& scheme) {
    test_meshes::set_uneven_normals(shape, 5);
    Surface_mesh mesh = to_surface_mesh(shape);
    const PN::Limit_surface surface(
      mesh, scheme, PN::parameters::tolerance(1e-9).vertex_normal_map(normal_map(mesh)));
    const surface_checks::Fine_triangles fine(surface, 6);
    surface_checks::expect_rays(surface, Queries(surface), fine, 40);
  };
  using test_meshes::Cells;
  expect(test_meshes::grid(3, 3, false, false, Cells::quads),
         PN::linear(PN::CatmullClark_scheme()));
  expect(test_meshes::grid(3, 3, false, false, Cells::triangles), PN::linear(PN::Loop_scheme()));
  // sides of pieces inside a plane, too
  Control_mesh flat = test_meshes::grid(3, 3, false, false, Cells::quads);
  for (auto& p : flat.points) p[2] = 0;
  for (std::size_t k : {5u, 10u}) flat.points[k][0] += 0.4;
  expect(flat, PN::linear(PN::CatmullClark_scheme()));
}

// in how many triangles of parameters a place is
template <class Triangles>
int number_of_triangles(const Triangles& triangles, double u, double v)
{
  int number = 0;
  for (const auto& t : triangles) {
    int left = 0; // of how many sides
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &a = t.corners[k].parameters, &b = t.corners[(k + 1) % 3].parameters;
      if ((b[0] - a[0]) * (v - a[1]) > (b[1] - a[1]) * (u - a[0])) ++left;
    }
    if (left == 0 || left == 3) ++number;
  }
  return number;
}

// Every place of a piece is in one triangle, and in one part of that.
template <class Scheme>
void expect_one_triangle_everywhere(Control_mesh shape, const Scheme& scheme)
{
  shape.normals = shape.points; // not used
  const Surface_mesh mesh = to_surface_mesh(shape);
  const PN::Limit_surface<Surface_mesh, Kernel> surface(mesh, scheme);
  const PN::internal::Surface_places<PN::Limit_surface<Surface_mesh, Kernel>> places(surface);
  std::vector<PN::internal::Query_triangle<Surface_mesh::Face_index>> triangles;
  places.add_triangles(*mesh.faces().begin(), 0, 2, triangles);
  for (int round = 0; round < 2; ++round) {
    constexpr int n = 12; // between the sides
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < (surface.is_triangular() ? n - i : n); ++j) {
        const double u = (i + 0.37) / n, v = (j + 0.41) / n;
        const bool is_inside = !surface.is_triangular() || u + v < 1;
        EXPECT_EQ(number_of_triangles(triangles, u, v), is_inside ? 1 : 0)
          << "(" << u << ", " << v << ") after " << round;
      }
    auto split = triangles;
    split.clear();
    for (const auto& t : triangles)
      for (const auto& part : places.parts(t)) split.push_back(part);
    triangles = split;
  }
}

TEST(LimitSurfaceQueries, PartsOfTrianglesCoverThem)
{
  expect_one_triangle_everywhere(named_shapes::cube(), PN::linear(PN::CatmullClark_scheme()));
  expect_one_triangle_everywhere(test_meshes::bipyramid(5), PN::linear(PN::Loop_scheme()));
}

// \name Creases and borders: the surfaces are known

using surface_checks::expect_point;

// all edges of the cube of side 2 are sharp, so that it is its own limit
TEST(LimitSurfaceQueries, EdgesAndCornersOfABox)
{
  Control_mesh shape = named_shapes::cube();
  shape.normals = shape.points; // not used
  Surface_mesh mesh = to_surface_mesh(shape);
  double side = 0;
  for (auto v : mesh.vertices()) side = (std::max)(side, std::abs(mesh.point(v).x()));
  const auto sharp = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", true).first;
  const PN::Limit_surface surface(mesh, PN::linear(PN::CatmullClark_scheme()),
                                  PN::parameters::tolerance(1e-7).edge_is_constrained_map(sharp));
  const Queries queries(surface);
  const auto closest = [&](const Point& p) {
    const auto clamped = [&](double x) { return (std::max)(-side, (std::min)(side, x)); };
    const Point on(clamped(p.x()), clamped(p.y()), clamped(p.z()));
    expect_point(queries.closest_point(p), on, length(p - on));
  };
  for (const double t : {-1., -0.62, 0., 0.3, 1.}) {
    closest({1.5 * side, 1.4 * side, t * side}); // of an edge
    closest({t * side, -1.2 * side, 1.9 * side});
    closest({-1.2 * side, t * side, -1.001 * side});
    closest({1.5 * side, t * side, 0.99 * side}); // of a face, beside an edge
  }
  closest({2 * side, 1.5 * side, -3 * side}); // of a corner
  closest({1.001 * side, -1.001 * side, 1.002 * side});
  // from inside
  expect_point(queries.closest_point({0.9 * side, 0.8 * side, 0.1 * side}),
               {side, 0.8 * side, 0.1 * side}, 0.1 * side);
  // rays on either side of an edge, and past it
  for (const double t : {1e-3, 0.2, 0.5}) {
    const Vector d(-1, -1, 0.25);
    const auto hit = queries.first_intersection({2 * side + t * side, 2 * side, 0}, d);
    ASSERT_TRUE(hit);
    const double s = (1 + t) * side; // where x is that of the side
    expect_point(*hit, Point(2 * side + t * side, 2 * side, 0) + s * d, s * length(d));
    EXPECT_LE(length(hit->normal - Vector(1, 0, 0)), 1e-6);
  }
  for (const double t : {1e-3, 0.2, 0.5}) {
    const auto hit = queries.first_intersection({2 * side, t * side, side + t * side}, {-1, 0, 0});
    EXPECT_FALSE(hit);
  }
}

// A square whose border stays, in the plane z = 0.
TEST(LimitSurfaceQueries, BordersOfASquare)
{
  Control_mesh shape = test_meshes::grid(3, 3, false, false, test_meshes::Cells::quads);
  shape.normals = shape.points; // not used
  Surface_mesh mesh = to_surface_mesh(shape);
  const double side = 3;
  for (auto v : mesh.vertices()) mesh.point(v) = Point(double(v % 4), double(v / 4), 0);
  const PN::Limit_surface surface(mesh, PN::linear(PN::CatmullClark_scheme()),
                                  PN::parameters::tolerance(1e-7).border(PN::Border::corners));
  const Queries queries(surface);
  const auto at = [&](double u, double v, double z) { return Point(u * side, v * side, z); };
  for (const double t : {0.013, 0.4, 0.77}) {
    expect_point(queries.closest_point(at(-0.5, t, 0)), at(0, t, 0), 0.5 * side);
    expect_point(queries.closest_point(at(t, 1.25, 0.3)), at(t, 1, 0),
                 std::hypot(0.25 * side, 0.3));
    const auto hit = queries.first_intersection(at(1e-3, t, 1), Vector(0, 0, -2));
    ASSERT_TRUE(hit);
    expect_point(*hit, at(1e-3, t, 0), 1);
    EXPECT_FALSE(queries.first_intersection(at(-1e-3, t, 1), Vector(0, 0, -2)));
  }
  expect_point(queries.closest_point(at(-1, -1, 0)), at(0, 0, 0), std::hypot(side, side));
}

// Where lines of parameters are oblique to a side, what it leaves of a step past it may lead to the wrong end of the side.
TEST(LimitSurfaceQueries, ObliqueBordersFromFarAway)
{
  const auto expect = [](const test_meshes::Cells cells, const auto& scheme) {
    Control_mesh shape = test_meshes::grid(3, 3, false, false, cells);
    shape.normals = shape.points; // not used
    Surface_mesh mesh = to_surface_mesh(shape);
    for (auto v : mesh.vertices())
      mesh.point(v) = Point(double(v % 4), double(v / 4) + double(v % 4), 0);
    const PN::Limit_surface surface(mesh, scheme,
                                    PN::parameters::tolerance(1e-9).border(PN::Border::corners));
    const Queries queries(surface, 2);
    for (const double y : {1.2, 1.8})
      EXPECT_NEAR(queries.closest_point({-20, y, 0}).distance, 20, 1e-8) << y;
  };
  expect(test_meshes::Cells::quads, PN::linear(PN::CatmullClark_scheme()));
  expect(test_meshes::Cells::triangles, PN::linear(PN::Loop_scheme()));
}

TEST(LimitSurfaceQueries, WrongArgumentsAreRefused)
{
  Control_mesh shape = named_shapes::cube();
  shape.normals = shape.points;
  Surface_mesh mesh = to_surface_mesh(shape);
  const PN::Limit_surface surface(mesh, PN::linear(PN::CatmullClark_scheme()));
  EXPECT_THROW(Queries(surface, 3), std::invalid_argument);
  EXPECT_THROW(Queries(surface, 0), std::invalid_argument);
  const Queries queries(surface, 2);
  EXPECT_THROW(queries.first_intersection(Point(0, 0, 0), CGAL::NULL_VECTOR),
               std::invalid_argument);
  const Surface_mesh empty;
  const PN::Limit_surface none(empty, PN::CatmullClark_scheme());
  EXPECT_THROW(Queries{none}, std::invalid_argument);
}

} // namespace
