// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Limit surfaces at any parameters: against B-splines and box splines in closed form, spheres and cylinders, and the limits of
// meshes that are refined as a whole.

#include "Named_shapes.h"
#include "Scheme_named.h"
#include "Scheme_runs.h"
#include "Surface_checks.h"
#include "support/Options.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_limit_surface_3/Limit_surface.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using test_meshes::Cells;
using test_meshes::Control_mesh;
using test_meshes::Triple;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Face = Surface_mesh::Face_index;
using Location = PN::Limit_surface<Surface_mesh>::Location;

using named_shapes::on_unit_sphere;
using surface_checks::length;

// \name Splines in closed form

// M(x, y) of some of the directions (1,0), (0,1), (1,1), each with a multiplicity, by the recursion of de Boor and Hoellig; the box is
// half-open
double box_spline(std::array<int, 3> m, double x, double y)
{
  constexpr double directions[3][2] = {{1, 0}, {0, 1}, {1, 1}};
  const int k = m[0] + m[1] + m[2];
  if (k == 2) {
    std::array<int, 2> at{};
    for (int i = 0, n = 0; i < 3; ++i)
      if (m[i] == 1) at[n++] = i;
    const auto &a = directions[at[0]], &b = directions[at[1]];
    const double det = a[0] * b[1] - a[1] * b[0];
    const double s = (x * b[1] - y * b[0]) / det, t = (a[0] * y - a[1] * x) / det;
    return s >= 0 && s < 1 && t >= 0 && t < 1 ? 1 / std::abs(det) : 0;
  }
  // a representation of (x, y) by the directions
  std::array<double, 3> t{};
  if (m[0] > 0 && m[1] > 0)
    t = {x, y, 0};
  else if (m[0] > 0)
    t = {x - y, 0, y};
  else
    t = {0, y - x, x};
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (m[i] == 0) continue;
    auto fewer = m;
    --fewer[i];
    const int different = (fewer[0] > 0) + (fewer[1] > 0) + (fewer[2] > 0);
    if (different < 2) continue; // zero almost everywhere
    sum += t[i] * box_spline(fewer, x, y);
    sum += (m[i] - t[i]) * box_spline(fewer, x - directions[i][0], y - directions[i][1]);
  }
  return sum / (k - 2);
}

double cubic_spline(double x) // centered
{
  x = std::abs(x);
  if (x >= 2) return 0;
  return x >= 1 ? (2 - x) * (2 - x) * (2 - x) / 6 : (4 - 6 * x * x + 3 * x * x * x) / 6;
}

double weight(Cells cells, double x, double y)
{
  if (cells == Cells::quads) return cubic_spline(x) * cubic_spline(y);
  return box_spline({2, 2, 2}, x + 2, y + 2);
}

// a grid over integers, with the diagonals from (0,0) to (1,1) in triangles
struct Grid
{
  static constexpr int n = 6;
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> vertices;

  explicit Grid(Cells cells)
  {
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        vertices.push_back(mesh.add_vertex(Point(
          i + 0.3 * std::sin(3. * i + j), j + 0.2 * std::cos(i + 2. * j), std::sin(5. * i * j))));
    const auto at = [&](int i, int j) { return vertices[j * n + i]; };
    for (int j = 0; j + 1 < n; ++j)
      for (int i = 0; i + 1 < n; ++i)
        if (cells == Cells::quads)
          mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        else {
          mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
          mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
  }
  std::array<double, 2> place(Surface_mesh::Vertex_index v) const
  {
    return {double(v.idx() % n), double(v.idx() / n)};
  }
  // what the parameters of a face are in the plane
  std::array<double, 2> place(Face f, double u, double v) const
  {
    const auto h = mesh.halfedge(f);
    const auto a = place(mesh.target(h)), b = place(mesh.target(mesh.next(h))),
               d = place(mesh.source(h));
    const bool is_quad = mesh.degree(f) == 4;
    const auto c = is_quad ? a : place(mesh.source(h)); // the corner that v leads to
    const auto& last = is_quad ? d : c;
    return {a[0] + u * (b[0] - a[0]) + v * (last[0] - a[0]),
            a[1] + u * (b[1] - a[1]) + v * (last[1] - a[1])};
  }
  // without borders: of the points of the mesh alone
  Vector sum(Cells cells, const std::array<double, 2>& p) const
  {
    Vector s = CGAL::NULL_VECTOR;
    for (auto v : mesh.vertices())
      if (std::abs(p[0] - place(v)[0]) <= 2 && std::abs(p[1] - place(v)[1]) <= 2)
        s += weight(cells, p[0] - place(v)[0], p[1] - place(v)[1]) * (mesh.point(v) - CGAL::ORIGIN);
    return s;
  }
  bool is_inside(Face f) const
  {
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      for (double x : place(v))
        if (x < 1 || x > n - 2) return false;
    return true;
  }
};

template <class Scheme>
void expect_spline(Cells cells, const Scheme& scheme)
{
  Grid grid(cells);
  const PN::Limit_surface surface(grid.mesh, PN::linear(scheme));
  for (Face f : grid.mesh.faces()) {
    if (!grid.is_inside(f)) continue;
    for (const auto& at :
         {std::array{0.213, 0.117}, std::array{0.604, 0.311}, std::array{0.07, 0.72}}) {
      const double u = at[0], v = at[1];
      const auto s = surface.evaluate(f, u, v);
      const auto value = [&](double du, double dv) {
        return grid.sum(cells, grid.place(f, u + du, v + dv));
      };
      EXPECT_LE(length(s.point - CGAL::ORIGIN - value(0, 0)), 1e-13);
      EXPECT_EQ(s.rounds, 0u);
      ASSERT_EQ(s.derivatives, 2u);
      constexpr double h =
        1e-3; // of a polynomial of degree 4 or 6: the error of differences is of second order
      EXPECT_LE(length(s.du - (value(h, 0) - value(-h, 0)) / (2 * h)), 2e-5);
      EXPECT_LE(length(s.dv - (value(0, h) - value(0, -h)) / (2 * h)), 2e-5);
      EXPECT_LE(length(s.duu - (value(h, 0) - 2 * value(0, 0) + value(-h, 0)) / (h * h)), 2e-5);
      EXPECT_LE(length(s.dvv - (value(0, h) - 2 * value(0, 0) + value(0, -h)) / (h * h)), 2e-5);
      EXPECT_LE(
        length(s.duv - (value(h, h) - value(h, -h) - value(-h, h) + value(-h, -h)) / (4 * h * h)),
        2e-5);
      const Vector n = CGAL::cross_product(s.du, s.dv);
      EXPECT_LE(length(s.normal - n / length(n)), 1e-12);
      EXPECT_LE(s.error, 1e-12);
    }
  }
}

TEST(LimitSurface, BicubicPieces)
{
  expect_spline(Cells::quads, PN::CatmullClark_scheme());
  expect_spline(Cells::quads, PN::CatmullClark_scheme::Tuned());
}
TEST(LimitSurface, BoxSplinePieces)
{
  expect_spline(Cells::triangles, PN::Loop_scheme());
}

// On a border the surface is the cubic spline of the border.
template <class Scheme>
void expect_border_spline(Cells cells, const Scheme& scheme)
{
  Grid grid(cells);
  const PN::Limit_surface surface(grid.mesh, PN::linear(scheme));
  int number = 0;
  for (Face f : grid.mesh.faces())
    for (int i = 0; i <= 20; ++i)
      for (const bool on_u : {true, false}) {
        const double t = i / 20., u = on_u ? t : 0, v = on_u ? 0 : t;
        const auto p = grid.place(f, u, v);
        if (p[1] > 1e-9 || p[0] < 1 || p[0] > Grid::n - 2) continue;
        Vector sum = CGAL::NULL_VECTOR;
        for (int k = 0; k < Grid::n; ++k)
          sum += cubic_spline(p[0] - k) * (grid.mesh.point(grid.vertices[k]) - CGAL::ORIGIN);
        EXPECT_LE(length(surface.point(f, u, v) - CGAL::ORIGIN - sum), 1e-13);
        ++number;
      }
  EXPECT_GE(number, 60);
}
TEST(LimitSurface, BordersAreSplines)
{
  expect_border_spline(Cells::quads, PN::CatmullClark_scheme());
  expect_border_spline(Cells::triangles, PN::Loop_scheme());
}

// \name Spheres and cylinders

template <class Scheme>
void expect_sphere(const Control_mesh& shape, const Scheme& scheme)
{
  Surface_mesh mesh = to_surface_mesh(on_unit_sphere(shape));
  const PN::Limit_surface surface(
    mesh, scheme, PN::parameters::tolerance(5e-5).vertex_normal_map(normal_map(mesh)));
  const auto places = surface_checks::grid_places(surface, [](Face) { return 5; });
  const auto all = surface.evaluate(places);
  ASSERT_EQ(all.size(), places.size());
  for (const auto& s : all) {
    const Vector p = s.point - CGAL::ORIGIN;
    EXPECT_NEAR(length(p), 1, 1e-9);
    EXPECT_LE(length(s.normal - p), 1e-6);
    if (s.derivatives < 2) continue;
    EXPECT_NEAR(s.du * p, 0, 1e-9 * length(s.du));
    EXPECT_NEAR(s.duv * p, -(s.du * s.dv), 1e-7 * (1 + length(s.duv))); // of p * p = 1
    EXPECT_NEAR(s.dvv * p, -(s.dv * s.dv), 1e-7 * (1 + length(s.dvv)));
  }
}
TEST(LimitSurface, Spheres)
{
  expect_sphere(named_shapes::cube(), PN::CatmullClark_scheme());
  expect_sphere(named_shapes::prism(5), PN::CatmullClark_scheme()); // pentagons
  expect_sphere(test_meshes::bipyramid(7), PN::Loop_scheme());
  expect_sphere(named_shapes::tetrahedron(), PN::Loop_scheme::Tuned());
}

// \name The limits of refined meshes

// Every limit of the mesh refined is found at parameters that are multiples of a power of 1/2. The tolerance is a part of the
// largest side of the box of the control points.
template <class Scheme, class Parameters>
void expect_limits(const Surface_mesh& control, Surface_mesh& refined, const Scheme& scheme,
                   const Parameters& np, const Parameters& np_refined, unsigned rounds,
                   double tolerance)
{
  test_options::Limit_options options;
  options.tolerance = 1e-10;
  PN::subdivide_to_limit(refined, scheme, PN::parameters::join(options.pack(), np_refined));
  const PN::Limit_surface surface(control, scheme,
                                  PN::parameters::join(PN::parameters::tolerance(tolerance), np));
  const auto places = surface_checks::grid_places(
    surface, [&](Face f) { return 1 << (surface.number_of_pieces(f) == 1 ? rounds : rounds - 1); });
  CGAL::Bbox_3 box;
  for (auto v : control.vertices()) box += control.point(v).bbox();
  const double size =
    (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  std::vector<char> is_found(refined.number_of_vertices(), 0);
  std::size_t k = 0;
  for (const auto& s : surface.evaluate(places)) {
    double least = 1e9;
    Surface_mesh::Vertex_index nearest;
    for (auto v : refined.vertices()) {
      const double d = CGAL::squared_distance(refined.point(v), s.point);
      if (d < least) least = d, nearest = v;
    }
    EXPECT_LE(std::sqrt(least), s.error + 1e-9)
      << places[k].face << " (" << places[k].u << ", " << places[k].v << ")";
    EXPECT_LE(s.error, tolerance * size + 1e-9);
    is_found[nearest.idx()] = 1;
    ++k;
  }
  for (auto v : refined.vertices())
    EXPECT_TRUE(is_found[v.idx()] != 0 || refined.is_isolated(v)) << v;
}

template <class Scheme>
void expect_limits(Control_mesh shape, const Scheme& scheme, double tolerance = 1e-5)
{
  SCOPED_TRACE(shape.name);
  test_meshes::set_uneven_normals(shape, 5);
  Surface_mesh control = to_surface_mesh(shape), refined = control;
  const auto np = params::number_of_iterations(12).vertex_normal_map(normal_map(control));
  const auto np_refined = params::number_of_iterations(2).vertex_normal_map(normal_map(refined));
  expect_limits(control, refined, scheme, np, np_refined, 2, tolerance);
}

TEST(LimitSurface, LimitsOfRefinedQuads)
{
  expect_limits(named_shapes::cube(), PN::CatmullClark_scheme());
  expect_limits(named_shapes::prism(5), PN::CatmullClark_scheme());
  expect_limits(test_meshes::grid(3, 3, false, false, Cells::quads), PN::CatmullClark_scheme());
  expect_limits(test_meshes::star(5, 2, Cells::quads), PN::CatmullClark_scheme::Tuned());
}
TEST(LimitSurface, LimitsOfRefinedTriangles)
{
  expect_limits(named_shapes::tetrahedron(), PN::Loop_scheme());
  expect_limits(test_meshes::bipyramid(7), PN::Loop_scheme());
  expect_limits(test_meshes::grid(3, 3, false, false, Cells::triangles), PN::Loop_scheme());
  expect_limits(test_meshes::with_isolated_vertices(test_meshes::star(5, 2, Cells::triangles)),
                PN::Loop_scheme::Tuned());
}
TEST(LimitSurface, LimitsOfInterpolatingSchemes)
{
  expect_limits(test_meshes::bipyramid(5), PN::Butterfly_scheme(), 1e-3);
  expect_limits(named_shapes::cube(), PN::Kobbelt_scheme(), 1e-3);
}
TEST(LimitSurface, AnySchemeIsAsTheOneThatItHolds)
{
  Control_mesh shape = named_shapes::cube();
  test_meshes::set_uneven_normals(shape, 3);
  Surface_mesh mesh = to_surface_mesh(shape);
  const auto np = params::vertex_normal_map(normal_map(mesh));
  const PN::Limit_surface one(mesh, PN::CatmullClark_scheme(), np),
    other(mesh, scheme_named("catmull-clark"), np);
  EXPECT_EQ(one.point(Face(2), 0.3, 0.6), other.point(Face(2), 0.3, 0.6));
}

// \name Derivatives and roundness

// of whatever child the point lies in, after some rounds
template <class Scheme>
void expect_derivatives_of_points(Control_mesh shape, const Scheme& scheme)
{
  test_meshes::set_uneven_normals(shape, 5);
  Surface_mesh mesh = to_surface_mesh(shape);
  const PN::Limit_surface surface(
    mesh, scheme, PN::parameters::tolerance(5e-9).vertex_normal_map(normal_map(mesh)));
  constexpr double h = 1e-3;
  for (const auto& at :
       {std::array{0.2, 0.1}, std::array{0.7, 0.2}, std::array{0.1, 0.8}, std::array{0.3, 0.4}}) {
    const double u = at[0], v = at[1];
    const auto s = surface.evaluate(Face(1), u, v);
    const auto p = [&](double du, double dv) {
      return surface.point(Face(1), u + du, v + dv) - CGAL::ORIGIN;
    };
    ASSERT_EQ(s.derivatives, 2u);
    EXPECT_GT(s.rounds, 0u);
    EXPECT_LE(length(s.du - (p(h, 0) - p(-h, 0)) / (2 * h)), 2e-3);
    EXPECT_LE(length(s.dv - (p(0, h) - p(0, -h)) / (2 * h)), 2e-3);
    EXPECT_LE(length(s.duu - (p(h, 0) - 2 * p(0, 0) + p(-h, 0)) / (h * h)), 0.1);
    EXPECT_LE(length(s.duv - (p(h, h) - p(h, -h) - p(-h, h) + p(-h, -h)) / (4 * h * h)), 0.1);
    EXPECT_LE(length(s.dvv - (p(0, h) - 2 * p(0, 0) + p(0, -h)) / (h * h)), 0.1);
  }
}
TEST(LimitSurface, DerivativesAreThoseOfThePoints)
{
  expect_derivatives_of_points(test_meshes::bipyramid(7), PN::Loop_scheme());
  expect_derivatives_of_points(named_shapes::cube(), PN::CatmullClark_scheme());
  expect_derivatives_of_points(named_shapes::prism(5), PN::CatmullClark_scheme()); // of a pentagon
}

template <class Scheme>
void expect_linear_derivatives(Control_mesh shape, const Scheme& scheme)
{
  SCOPED_TRACE(shape.name);
  test_meshes::set_uneven_normals(shape, 5);
  const Surface_mesh mesh = to_surface_mesh(shape);
  surface_checks::expect_derivatives(PN::Limit_surface(mesh, PN::linear(scheme)),
                                     [&](Face f) { return mesh.degree(f); }, {2, 1e-4, 1e-3});
}
TEST(LimitSurface, DerivativesInAllKindsOfFaces)
{
  expect_linear_derivatives(named_shapes::tetrahedron(), PN::CatmullClark_scheme());
  expect_linear_derivatives(named_shapes::prism(5), PN::CatmullClark_scheme());
  expect_linear_derivatives(named_shapes::prism(6), PN::CatmullClark_scheme());
  expect_linear_derivatives(test_meshes::single_polygon(5), PN::CatmullClark_scheme()); // a border
  expect_linear_derivatives(named_shapes::tetrahedron(), PN::Loop_scheme());
  expect_linear_derivatives(test_meshes::star(5, 2, Cells::triangles), PN::Loop_scheme());
}

TEST(LimitSurface, Roundness0IsTheLinearScheme)
{
  Control_mesh shape = named_shapes::cube();
  test_meshes::set_uneven_normals(shape, 5);
  Surface_mesh mesh = to_surface_mesh(shape);
  const PN::Limit_surface linear(mesh, PN::linear(PN::CatmullClark_scheme())),
    surface(mesh, PN::CatmullClark_scheme(),
            PN::parameters::roundness(0.).vertex_normal_map(normal_map(mesh)));
  for (Face f : mesh.faces())
    EXPECT_LE(length(surface.point(f, 0.3, 0.6) - linear.point(f, 0.3, 0.6)), 1e-12);
}

TEST(LimitSurface, NormalsDoNotDependOnTheScale)
{
  Control_mesh shape = named_shapes::cube();
  test_meshes::set_uneven_normals(shape, 5);
  Surface_mesh mesh = to_surface_mesh(shape);
  const auto normals = [](Surface_mesh& m) {
    const PN::Limit_surface surface(m, PN::CatmullClark_scheme(),
                                    params::vertex_normal_map(normal_map(m)));
    std::vector<Vector> all;
    for (Face f : m.faces()) all.push_back(surface.normal(f, 0.3, 0.6));
    return all;
  };
  const auto expected = normals(mesh);
  for (const int exponent : {600, -600}) {
    Surface_mesh scaled = mesh;
    for (auto v : scaled.vertices()) {
      const Point p = scaled.point(v);
      scaled.point(v) = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                              std::ldexp(p.z(), exponent));
    }
    const auto all = normals(scaled);
    for (std::size_t f = 0; f < all.size(); ++f) EXPECT_LE(length(all[f] - expected[f]), 1e-12);
  }
}

// \name Meshes and numbers

template <class Mesh>
void expect_as_surface_mesh(const Mesh& mesh,
                            const PN::Limit_surface<Surface_mesh, Kernel>& expected,
                            double tolerance)
{
  const PN::Limit_surface surface(mesh, PN::CatmullClark_scheme());
  auto f = surface.faces().begin();
  for (Face face : expected.faces()) {
    // the first half-edge of a face may be another one
    const auto of = *f++;
    const Point q = expected.point(face, 0.31, 0.47);
    double least = 1e9;
    for (const auto& at : {std::array{0.31, 0.47}, std::array{0.53, 0.31}, std::array{0.69, 0.53},
                           std::array{0.47, 0.69}}) {
      const auto p = surface.point(of, at[0], at[1]);
      const Point in_double(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      least = (std::min)(least, length(in_double - q));
    }
    EXPECT_LE(least, tolerance);
  }
}
TEST(LimitSurface, OtherMeshes)
{
  Surface_mesh mesh = to_surface_mesh(on_unit_sphere(named_shapes::cube()));
  const PN::Limit_surface expected(mesh, PN::CatmullClark_scheme());
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  expect_as_surface_mesh(polyhedron, expected, 1e-12);
  CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> floats;
  CGAL::copy_face_graph(mesh, floats);
  expect_as_surface_mesh(floats, expected, 1e-6);
  CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> exact;
  CGAL::copy_face_graph(mesh, exact);
  expect_as_surface_mesh(exact, expected, 1e-14);
}

// \name Errors

TEST(LimitSurface, WrongParametersAreRefused)
{
  Surface_mesh mesh = to_surface_mesh(on_unit_sphere(named_shapes::prism(5)));
  PN::Limit_surface surface(mesh, PN::CatmullClark_scheme());
  Face pentagon, quad;
  for (Face f : mesh.faces()) (mesh.degree(f) == 4 ? quad : pentagon) = f;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(surface.number_of_pieces(pentagon), 5u);
  EXPECT_EQ(surface.number_of_pieces(quad), 1u);
  EXPECT_NO_THROW(surface.point(quad, 1, 1));
  EXPECT_NO_THROW(surface.point(pentagon, 9, 1));
  EXPECT_THROW(surface.point(pentagon, 10, 0), std::invalid_argument);
  EXPECT_THROW(surface.point(pentagon, 9.5, 0), std::invalid_argument);
  EXPECT_THROW(surface.point(pentagon, 1e300, 0), std::invalid_argument);
  EXPECT_THROW(surface.point(quad, 1.01, 0), std::invalid_argument);
  EXPECT_THROW(surface.point(quad, 0, -0.01), std::invalid_argument);
  EXPECT_THROW(surface.point(quad, nan, 0), std::invalid_argument);
  EXPECT_THROW(surface.point(quad, 0, nan), std::invalid_argument);
  EXPECT_THROW(surface.point(Face(99), 0, 0), std::invalid_argument);
  const auto with = [&](const auto& np) { PN::Limit_surface(mesh, PN::CatmullClark_scheme(), np); };
  EXPECT_THROW(with(PN::parameters::tolerance(-1.)), std::invalid_argument);
  EXPECT_THROW(with(PN::parameters::normal_tolerance(nan)), std::invalid_argument);
  EXPECT_THROW(PN::Limit_surface(mesh, PN::DooSabin_scheme()), std::invalid_argument);
  Surface_mesh triangles = to_surface_mesh(on_unit_sphere(named_shapes::tetrahedron()));
  EXPECT_THROW(PN::Limit_surface(triangles, PN::Sqrt3_scheme()), std::invalid_argument);
  const PN::Limit_surface loop(triangles, PN::Loop_scheme());
  EXPECT_NO_THROW(loop.point(Face(0), 0.7, 0.3));
  EXPECT_THROW(loop.point(Face(0), 0.6, 0.6), std::invalid_argument);
  EXPECT_TRUE(surface.evaluate(std::vector<Location>()).empty());
}
TEST(LimitSurface, AnEmptyMesh)
{
  const Surface_mesh mesh;
  const PN::Limit_surface surface(mesh, PN::CatmullClark_scheme());
  EXPECT_TRUE(surface.faces().empty());
}

} // namespace
