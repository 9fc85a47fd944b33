// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Estimated control normals: the angle-weighted ones against closed forms, and what all estimates
// have in common.

#include "Failing_map.h"
#include "Mesh_cases.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <string>
#include <type_traits>

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

using Double = CGAL::Simple_cartesian<double>;
using Float = CGAL::Simple_cartesian<float>;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

constexpr double pi = 3.14159265358979323846;

using PN::Control_normal_estimate;

constexpr Control_normal_estimate all[] = {Control_normal_estimate::coherent,
                                           Control_normal_estimate::reciprocal,
                                           Control_normal_estimate::angle};

template <class K>
std::vector<Triple> estimate(const Soup& soup,
                             Control_normal_estimate how = Control_normal_estimate::angle)
{
  CGAL::Surface_mesh<typename K::Point_3> mesh;
  build(soup, mesh);
  auto n = mesh.template add_property_map<CGAL::SM_Vertex_index, typename K::Vector_3>("n").first;
  PN::estimate_control_normals(mesh, n, PN::parameters::control_normal_estimate(how));
  return values(mesh, n);
}

Triple unit(double x, double y, double z)
{
  const double l = std::hypot(x, y, z);
  return {x / l, y / l, z / l};
}

void expect_near(const Triple& a, const Triple& b, double tolerance, const std::string& where = "")
{
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << where;
}

Soup transformed(Soup soup, double scale, const Triple& shift)
{
  for (Triple& p : soup.points)
    for (int k = 0; k < 3; ++k) p[k] = scale * p[k] + shift[k];
  return soup;
}

// right triangles in the planes z = 0 and x = 0
Soup fan()
{
  return {{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 5}}, {{0, 1, 2}, {0, 2, 3}}};
}

// however the square faces are cut into triangles: the weights are angles
// the areas at the corners of a triangulated cube differ
TEST(Estimate_control_normals, TriangulatedCubeCornersAreDiagonal)
{
  for (Control_normal_estimate how :
       {Control_normal_estimate::reciprocal, Control_normal_estimate::angle}) {
    Soup soup = cube();
    std::vector<Polygon> triangles;
    std::size_t i = 0;
    for (const Polygon& f : soup.faces) {
      const std::size_t s = i++ % 2;
      triangles.push_back({f[s], f[s + 1], f[s + 2]});
      triangles.push_back({f[s], f[s + 2], f[(s + 3) % 4]});
    }
    soup.faces = triangles;
    const auto n = estimate<Double>(soup, how);
    for (std::size_t v = 0; v < 8; ++v)
      expect_near(n[v], unit(soup.points[v][0], soup.points[v][1], soup.points[v][2]), 4e-16);
  }
}

TEST(Estimate_control_normals, FanOfKnownAngles)
{
  const auto n = estimate<Double>(fan());
  // vertex 0: right angles in both planes. Vertex 2: atan(2/3) and atan(5/3)
  expect_near(n[0], unit(1, 0, 1), 2e-16);
  expect_near(n[1], {0, 0, 1}, 0);
  expect_near(n[2], unit(std::atan2(5, 3), 0, std::atan2(2, 3)), 4e-16);
  expect_near(n[3], {1, 0, 0}, 0);
}

TEST(Estimate_control_normals, ObtuseAnglesCountAsTheyAre)
{
  // 150 degrees in the plane z = 0 and 90 in the plane x = 0
  const double c = std::cos(5 * pi / 6), s = std::sin(5 * pi / 6);
  const Soup soup{{{0, 0, 0}, {s, c, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  expect_near(estimate<Double>(soup)[0], unit(3, 0, 5), 4e-16);
}

// the area vector of a quad is half the cross product of its diagonals
// A frustum of radii 1 and 2 and height 1: at the upper rim a corner of the cap and two equal ones of the sides.
TEST(Estimate_control_normals, FacesWithManyCorners)
{
  for (const std::size_t n : {5, 16, 17, 40}) {
    const double half = pi / double(n), c = std::cos(half);
    Soup soup;
    soup.faces.resize(2);
    for (std::size_t ring : {1, 2})
      for (std::size_t i = 0; i < n; ++i)
        soup.points.push_back({double(ring) * std::cos(2 * half * double(i)),
                               double(ring) * std::sin(2 * half * double(i)), double(2 - ring)});
    for (std::size_t i = 0, j = 1; i < n; ++i, j = (i + 1) % n) {
      soup.faces[0].push_back(i);
      soup.faces[1].push_back(2 * n - 1 - i);
      soup.faces.push_back({i, n + i, n + j, j});
    }
    const double in_cap = pi - 2 * half, in_side = std::acos(-std::sin(half) / std::sqrt(2.));
    const double side = in_side / std::sqrt(1 + c * c);
    const Triple expected = unit(2 * side * c, 0, in_cap + 2 * side * c);
    expect_near(estimate<Double>(soup)[0], expected, 1e-14, std::to_string(n));
    expect_near(estimate<Epeck>(soup)[0], expected, 1e-13, std::to_string(n));
    for (const Control_normal_estimate how : all) {
      const auto normals = estimate<Double>(soup, how);
      const Triple first = normals[0];
      EXPECT_GT(first[0], 0.1);
      for (std::size_t i = 0; i < n; ++i) {
        const double t = 2 * half * double(i);
        expect_near(normals[i], {first[0] * std::cos(t), first[0] * std::sin(t), first[2]}, 1e-14);
      }
    }
  }
}

TEST(Estimate_control_normals, QuadThatIsNotPlanar)
{
  const Soup soup{{{0, 0, 0}, {2, 0, 1}, {2.5, 3, -0.5}, {-0.5, 2, 1}}, {{0, 1, 2, 3}}};
  // diagonals (2.5, 3, -0.5) and (-2.5, 2, 0)
  const Triple expected = unit(3 * 0 + 0.5 * 2, 0.5 * 2.5 - 2.5 * 0, 2.5 * 2 + 3 * 2.5);
  for (const Triple& n : estimate<Double>(soup)) expect_near(n, expected, 2e-16);
  for (const Triple& n : estimate<Epeck>(soup)) expect_near(n, expected, std::ldexp(1., -47));
}

TEST(Estimate_control_normals, VerticesWithoutFacesGetZero)
{
  for (Control_normal_estimate how : all) {
    Soup soup = fan();
    soup.points.push_back({1, 2, 3});
    EXPECT_EQ(estimate<Double>(soup, how)[4], (Triple{0, 0, 0}));
    EXPECT_EQ(estimate<Epeck>(soup, how)[4], (Triple{0, 0, 0}));
  }
}

// two triangles back to back, folded together: opposite unit normals, equal angles
TEST(Estimate_control_normals, SumsThatVanishAreZero)
{
  for (Control_normal_estimate how : all) {
    const Soup soup{{{0.1, 0.2, 0.3}, {1.7, 0.4, 0.9}, {0.3, 2.1, 0.2}}, {{0, 1, 2}, {1, 0, 2}}};
    for (const Triple& n : estimate<Double>(soup, how)) EXPECT_EQ(n, (Triple{0, 0, 0}));
    for (const Triple& n : estimate<Float>(soup, how)) EXPECT_EQ(n, (Triple{0, 0, 0}));
    for (const Triple& n : estimate<Epeck>(soup, how)) EXPECT_EQ(n, (Triple{0, 0, 0}));
  }
}

// a triangle whose corners are on a line, with directions that no binary number has: only rounding
// gives it an area
TEST(Estimate_control_normals, FacesWithoutAreaAddNothing)
{
  for (const Triple& d : {Triple{1, 0, 0}, Triple{0.1, 0.7, -0.3}, Triple{1 / 3., 1 / 7., 1 / 11.}})
    for (double t : {0.3, 0.5, 0.9}) {
      // a triangle in the plane of d and z, its first edge along d, and one without area beside it
      Soup soup{{{0, 0, 0}, d, {0, 0, 1}, {t * d[0], t * d[1], t * d[2]}}, {{0, 1, 2}, {1, 0, 3}}};
      soup = transformed(soup, 1, {0.1, 0.2, 0.3});
      const auto n = estimate<Double>(soup);
      const Triple expected = unit(d[1], -d[0], 0);
      for (std::size_t v = 0; v < 3; ++v) expect_near(n[v], expected, 4e-15);
      EXPECT_EQ(n[3], (Triple{0, 0, 0})) << t;
    }
}

// but needles with an area of their own do
TEST(Estimate_control_normals, NeedlesHaveNormals)
{
  for (Control_normal_estimate how : all) {
    for (double width : {1e-3, 1e-6, 1e-9, 1e-12}) {
      const Soup soup{{{0, 0, 0}, {1, 0, 0}, {0.5, width, 0}}, {{0, 1, 2}}};
      for (const Triple& n : estimate<Double>(soup, how)) EXPECT_EQ(n, (Triple{0, 0, 1})) << width;
      for (const Triple& n : estimate<Epeck>(soup, how))
        expect_near(n, {0, 0, 1}, std::ldexp(1., -47));
    }
  }
}

TEST(Estimate_control_normals, RepeatedCornersAreHarmless)
{
  // a quad with two equal neighboring corners is a triangle
  const Soup soup{{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}};
  const auto n = estimate<Double>(soup);
  expect_near(n[0], {0, 0, 1}, 0);
  expect_near(n[3], {0, 0, 1}, 0);
  for (double x : n[1]) EXPECT_FALSE(std::isnan(x));
}

// scaling by powers of two changes no bit
TEST(Estimate_control_normals, DoNotDependOnTheScale)
{
  for (Control_normal_estimate how : all) {
    for (const Soup& soup : {mixed_with_border(), triangles_with_border()}) {
      const auto expected = estimate<Double>(soup, how);
      for (int exponent : {-1000, -700, -332, -60, 60, 332, 500, 1000})
        EXPECT_EQ(estimate<Double>(transformed(soup, std::ldexp(1., exponent), {0, 0, 0}), how),
                  expected)
          << exponent;
      for (double scale : {1e-300, 1e-200, 1e-100, 1e-10, 1e10, 1e100, 1e150, 1e300}) {
        const auto n = estimate<Double>(transformed(soup, scale, {0, 0, 0}), how);
        for (std::size_t v = 0; v < n.size(); ++v) expect_near(n[v], expected[v], 4e-15);
      }
    }
  }
}

TEST(Estimate_control_normals, DoNotDependOnTheScaleInOtherKernels)
{
  for (Control_normal_estimate how : all) {
    const Soup soup = triangles_with_border();
    const auto expected = estimate<Double>(soup, how);
    for (double scale : {1e-30, 1e-20, 1., 1e20, 1e35}) {
      const auto n = estimate<Float>(transformed(soup, scale, {0, 0, 0}), how);
      for (std::size_t v = 0; v < n.size(); ++v) expect_near(n[v], expected[v], 4e-7);
    }
    for (double scale : {1e-200, 1e-100, 1e150}) {
      const auto n = estimate<Epeck>(transformed(soup, scale, {0, 0, 0}), how);
      for (std::size_t v = 0; v < n.size(); ++v) expect_near(n[v], expected[v], 1e-14);
    }
  }
}

// far from the origin the differences of points are exact, if the shift rounds nothing
TEST(Estimate_control_normals, DoNotDependOnThePlace)
{
  for (Control_normal_estimate how : all) {
    const double shift = std::ldexp(1., 40);
    EXPECT_EQ(estimate<Double>(transformed(cube(), 1, {shift, -shift, shift}), how),
              estimate<Double>(cube(), how));
  }
}

TEST(Estimate_control_normals, Polyhedron)
{
  for (const Soup& soup : {cube(), mixed_with_border()}) {
    CGAL::Polyhedron_3<Double> mesh;
    build(soup, mesh);
    const auto n = get(CGAL::dynamic_vertex_property_t<Double::Vector_3>(), mesh);
    const auto& constant = mesh;
    for (Control_normal_estimate how : all) {
      PN::estimate_control_normals(constant, n, PN::parameters::control_normal_estimate(how));
      EXPECT_EQ(values(mesh, n), estimate<Double>(soup, how));
    }
  }
}

TEST(Estimate_control_normals, PointsOfAMapOfTheUser)
{
  CGAL::Surface_mesh<Double::Point_3> mesh;
  const auto p = mesh.add_property_map<CGAL::SM_Vertex_index, Double::Point_3>("p").first;
  const auto n = mesh.add_property_map<CGAL::SM_Vertex_index, Double::Vector_3>("n").first;
  build(mixed_with_border(), mesh, p);
  for (auto v : mesh.vertices()) mesh.point(v) = Double::Point_3(0, 0, 0);
  PN::estimate_control_normals(mesh, n, params::vertex_point_map(p));
  EXPECT_EQ(values(mesh, n),
            estimate<Double>(mixed_with_border(), Control_normal_estimate::coherent));
}

// what the subdivision takes when it gets no normals
template <class Scheme>
void expect_estimate(const Scheme& scheme, Control_normal_estimate how)
{
  auto without = built<CGAL::Surface_mesh<Double::Point_3>>(mixed_with_border()), with = without;
  const auto n = with.add_property_map<CGAL::SM_Vertex_index, Double::Vector_3>("n").first;
  const auto w = with.add_property_map<CGAL::SM_Vertex_index, double>("w").first;
  PN::estimate_control_normals(
    with, n, PN::parameters::control_normal_estimate(how).vertex_roundness_map(w));
  PN::subdivide(
    with, scheme,
    PN::parameters::vertex_roundness_map(w).number_of_iterations(2).vertex_normal_map(n));
  PN::subdivide(without, scheme, params::number_of_iterations(2));
  EXPECT_EQ(points(with), points(without));
}

TEST(Estimate_control_normals, AreThoseOfASubdivisionWithoutNormals)
{
  expect_estimate(PN::CatmullClark_scheme(), Control_normal_estimate::coherent);
  for (Control_normal_estimate how : all)
    expect_estimate(PN::internal::with_normal_estimate(PN::CatmullClark_scheme(), how), how);
}

// the named parameter chooses as the adaptor does, and before it
TEST(Estimate_control_normals, AreChosenByANamedParameter)
{
  using Mesh = CGAL::Surface_mesh<Double::Point_3>;
  const PN::CatmullClark_scheme scheme;
  std::vector<std::vector<Triple>> results;
  for (const Control_normal_estimate how : all) {
    const auto run = [&](const auto& call) {
      Mesh mesh = built<Mesh>(mixed_with_border());
      call(mesh);
      return points(mesh);
    };
    const auto np = PN::parameters::control_normal_estimate(how);
    const auto other = how == Control_normal_estimate::angle ? Control_normal_estimate::reciprocal
                                                             : Control_normal_estimate::angle;
    const auto expected =
      run([&](Mesh& m) { PN::subdivide(m, PN::internal::with_normal_estimate(scheme, how)); });
    EXPECT_EQ(run([&](Mesh& m) { PN::subdivide(m, scheme, np); }), expected);
    EXPECT_EQ(run([&](Mesh& m) {
                PN::subdivide(m, PN::internal::with_normal_estimate(scheme, other), np);
              }),
              expected);
    EXPECT_EQ(run([&](Mesh& m) { PN::subdivide(m, PN::Any_scheme<>(scheme), np); }), expected);
    results.push_back(expected);
    EXPECT_EQ(run([&](Mesh& m) { PN::subdivide_to_limit(m, scheme, np.number_of_iterations(0)); }),
              run([&](Mesh& m) {
                PN::subdivide_to_limit(m, PN::internal::with_normal_estimate(scheme, how),
                                       CGAL::parameters::number_of_iterations(0));
              }));
    Mesh mesh;
    build(mixed_with_border(), mesh);
    auto n = mesh.add_property_map<CGAL::SM_Vertex_index, Double::Vector_3>("n").first;
    PN::estimate_control_normals(mesh, n, np);
    EXPECT_EQ(values(mesh, n), estimate<Double>(mixed_with_border(), how));
  }
  EXPECT_NE(results[0], results[1]);
  EXPECT_NE(results[1], results[2]);
}

// in either order, and without a copy of the visitor; that of two packs the first one counts is the subject of
// test_parameters.cpp
TEST(Named_parameters, AreJoined)
{
  struct Not_copied : PN::Default_visitor
  {
    Not_copied() = default;
    Not_copied(const Not_copied&) = delete;
    void round_done(unsigned round, std::size_t) { last = round; }
    unsigned last = 0;
  };
  const auto refined = [](const auto& np) {
    auto mesh = built<CGAL::Surface_mesh<Double::Point_3>>(mixed_with_border());
    PN::subdivide(mesh, PN::CatmullClark_scheme(), np);
    return points(mesh);
  };
  Not_copied visitor;
  const auto ours =
    PN::parameters::roundness(0.25).control_normal_estimate(Control_normal_estimate::angle);
  const auto cgals = params::number_of_iterations(3).visitor(std::ref(visitor));
  const auto expected = refined(ours.number_of_iterations(3));
  EXPECT_EQ(refined(PN::parameters::join(ours, cgals)), expected);
  EXPECT_EQ(visitor.last, 3u);
  visitor.last = 0;
  EXPECT_EQ(refined(PN::parameters::join(cgals, ours)), expected);
  EXPECT_EQ(visitor.last, 3u);
  EXPECT_EQ(refined(PN::parameters::join(params::default_values(), ours)), refined(ours));
}

TEST(Estimate_control_normals, AdaptorsOfSchemesNest)
{
  const PN::CatmullClark_scheme catmull_clark;
  constexpr auto angle = Control_normal_estimate::angle,
                 reciprocal = Control_normal_estimate::reciprocal;
  const auto both_masks = PN::with_normal_scheme(catmull_clark, PN::CatmullClark_scheme::Tuned());
  expect_estimate(both_masks, Control_normal_estimate::coherent);
  expect_estimate(PN::internal::with_normal_estimate(both_masks, angle), angle);
  expect_estimate(PN::with_normal_scheme(PN::internal::with_normal_estimate(catmull_clark, angle),
                                         PN::CatmullClark_scheme::Tuned()),
                  angle);
  expect_estimate(
    PN::with_normal_scheme(PN::internal::with_normal_estimate(catmull_clark, reciprocal),
                           PN::internal::with_normal_estimate(catmull_clark, angle)),
    angle);
  expect_estimate(PN::internal::with_normal_estimate(
                    PN::internal::with_normal_estimate(catmull_clark, reciprocal), angle),
                  angle);

  // linear schemes have no normals, whatever is said of them
  std::vector<std::vector<Triple>> results;
  const auto add = [&](const auto& scheme) {
    CGAL::Surface_mesh<Double::Point_3> mesh;
    build(mixed_with_border(), mesh);
    PN::subdivide(mesh, scheme);
    results.push_back(points(mesh));
  };
  add(PN::linear(catmull_clark));
  add(PN::linear(PN::internal::with_normal_estimate(catmull_clark, angle)));
  add(PN::internal::with_normal_estimate(PN::linear(catmull_clark), angle));
  EXPECT_EQ(results[1], results[0]);
  EXPECT_EQ(results[2], results[0]);
}

// --- passed on as one thing: the surface is the one without normals, and where a normal is put it is round ---

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

// a long box on whose top a point stands out, and a vertex without faces
Soup spired_box()
{
  Soup soup = cube();
  for (Triple& p : soup.points) p[0] *= 3;
  Polygon& face = soup.faces.back();
  const Polygon top = face;
  face = {top[0], top[1], 8};
  for (std::size_t i = 1; i < top.size(); ++i)
    soup.faces.push_back({top[i], top[(i + 1) % top.size()], 8});
  Triple middle{0, 0, 0};
  for (const std::size_t v : top)
    for (int k = 0; k < 3; ++k) middle[k] += soup.points[v][k] / 4;
  for (int k = 0; k < 3; ++k) middle[k] *= 1.2;
  soup.points.push_back(middle);
  soup.points.push_back({9, 9, 9});
  return soup;
}

const PN::CatmullClark_scheme scheme;

// bit for bit but for what an exact number is in double
void expect_same(const std::vector<Triple>& a, const std::vector<Triple>& b,
                 const std::string& what)
{
  if (what != "exact") {
    EXPECT_EQ(a, b) << what;
  }
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t v = 0; v < a.size(); ++v)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[v][k], b[v][k], 1e-14) << what;
}

template <class Any_mesh>
void expect_same_surface(const Soup& soup, unsigned rounds, const std::string& what)
{
  Any_mesh without = built<Any_mesh>(soup), once = without, twice = without;
  const auto normals = PN::estimate_control_normals(once);
  const auto same = normals.clone();
  PN::subdivide(without, scheme, params::number_of_iterations(rounds));
  PN::subdivide(once, scheme, params::number_of_iterations(rounds).vertex_normal_map(normals));
  for (unsigned k = 0; k < rounds; ++k)
    PN::subdivide(twice, scheme, params::vertex_normal_map(same));
  expect_same(points(once), points(without), what);
  expect_same(points(twice), points(without), what);
  expect_same(values(once, normals), values(twice, same), what);
  EXPECT_EQ(values(once, normals).size(), num_vertices(without)) << what;
}

TEST(Estimate_passed_on, IsTheSurfaceWithoutNormals)
{
  for (const Soup& soup : {spired_box(), mixed_with_border(), Soup()}) {
    expect_same_surface<Mesh>(soup, 2, "Surface_mesh");
    expect_same_surface<CGAL::Surface_mesh<Epeck::Point_3>>(soup, 1, "exact");
  }
}

// with roundness 0, 1 and between: otherwise the other tests would tell nothing
TEST(Estimate_passed_on, HasTheRoundnessOfTheMaps)
{
  Mesh mesh = built<Mesh>(spired_box());
  const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
  const auto w = mesh.add_property_map<Vertex, double>("w").first;
  PN::estimate_control_normals(mesh, n, PN::parameters::vertex_roundness_map(w));
  const auto normals = PN::estimate_control_normals(mesh);
  double least = 1, largest = 0;
  for (const Vertex v : mesh.vertices()) {
    EXPECT_EQ(normals[v], n[v]);
    EXPECT_EQ(get(normals.roundness_map(), v), w[v]);
    least = (std::min)(least, w[v]);
    if (!mesh.is_isolated(v)) largest = (std::max)(largest, w[v]);
  }
  EXPECT_LT(least, .9);
  EXPECT_LT(largest, 1);
  // and into an estimate as a map of one's own
  const PN::Estimated_control_normals<Vertex, Kernel> own;
  PN::estimate_control_normals(mesh, own);
  for (const Vertex v : mesh.vertices()) EXPECT_EQ(get(own.roundness_map(), v), w[v]);
}

TEST(Estimate_passed_on, IsRoundWhereANormalIsPut)
{
  Mesh mesh = built<Mesh>(spired_box());
  const Mesh control = mesh;
  const auto normals = PN::estimate_control_normals(mesh),
             before = PN::estimate_control_normals(mesh);
  const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
  const auto w = mesh.add_property_map<Vertex, double>("w").first;
  put(normals, Vertex(1), Kernel::Vector_3(0, .6, .8));
  put(normals, Vertex(2), before[Vertex(2)]);
  for (const Vertex v : mesh.vertices()) {
    n[v] = normals[v];
    w[v] = get(normals.roundness_map(), v);
    const bool is_put = v == Vertex(1) || v == Vertex(2);
    EXPECT_EQ(w[v], is_put ? 1. : get(before.roundness_map(), v));
  }
  EXPECT_EQ(n[Vertex(1)], Kernel::Vector_3(0, .6, .8));
  Mesh own = mesh, refined = control;
  const auto n_of_own = PN::internal::find_property_map<Vertex, Kernel::Vector_3>(own, "n").value();
  const auto w_of_own = PN::internal::find_property_map<Vertex, double>(own, "w").value();
  PN::subdivide(
    own, scheme,
    PN::parameters::vertex_roundness_map(w_of_own).number_of_iterations(2).vertex_normal_map(
      n_of_own));
  PN::subdivide(refined, scheme, params::number_of_iterations(2).vertex_normal_map(normals));
  EXPECT_EQ(points(refined), points(own));
  // what was written here left the roundness that was written here
  for (const Vertex v : refined.vertices()) EXPECT_EQ(get(normals.roundness_map(), v), w_of_own[v]);
}

TEST(Estimate_passed_on, GivesWayToAnotherRoundness)
{
  const Mesh control = built<Mesh>(spired_box());
  const auto run = [&](const auto& np_of) {
    Mesh mesh = control;
    const auto normals = PN::estimate_control_normals(mesh);
    PN::subdivide(mesh, scheme, np_of(mesh).vertex_normal_map(normals));
    for (const Vertex v : control.vertices())
      EXPECT_EQ(get(normals.roundness_map(), v),
                get(PN::estimate_control_normals(control).roundness_map(), v));
    return points(mesh);
  };
  const auto half = run([](Mesh&) { return PN::parameters::roundness(.5); });
  EXPECT_EQ(run([](Mesh& mesh) {
              return PN::parameters::vertex_roundness_map(
                mesh.add_property_map<Vertex, double>("w", .5).first);
            }),
            half);
  Mesh mesh = control;
  const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
  PN::estimate_control_normals(mesh, n);
  PN::subdivide(mesh, scheme, PN::parameters::roundness(.5).vertex_normal_map(n));
  EXPECT_EQ(points(mesh), half);
}

template <class Any_mesh>
auto some_sharp_edges(Any_mesh& mesh, int every)
{
  const auto sharp = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  int k = 0;
  for (const auto e : edges(mesh)) put(sharp, e, k++ % every == 0);
  return sharp;
}

// of corners: creases that end, cross and close
template <class Any_mesh>
void expect_same_creases(const std::string& what)
{
  for (const int every : {1, 3, 5}) {
    Any_mesh without = built<Any_mesh>(spired_box()), with = without, put_again = without;
    const auto run = [&](Any_mesh& mesh, const auto& change) {
      const auto sharp = some_sharp_edges(mesh, every);
      const auto normals =
        PN::estimate_control_normals(mesh, params::edge_is_constrained_map(sharp));
      change(normals);
      const auto np =
        params::number_of_iterations(2).edge_is_constrained_map(sharp).vertex_normal_map(normals);
      if constexpr (std::is_same_v<Any_mesh, Mesh>) {
        const PN::Surface_refiner refiner(mesh, scheme, np);
        PN::subdivide(mesh, scheme, np);
        for (const Vertex v : mesh.vertices()) EXPECT_EQ(refiner.points()[v.idx()], mesh.point(v));
      } else
        PN::subdivide(mesh, scheme, np);
    };
    run(with, [](const auto&) {});
    PN::subdivide(
      without, scheme,
      params::number_of_iterations(2).edge_is_constrained_map(some_sharp_edges(without, every)));
    EXPECT_EQ(points(with), points(without)) << what << every;
    // who puts a normal at a corner makes its wedge round
    run(put_again, [&](const auto& normals) {
      for (const auto h : halfedges(put_again)) {
        put(normals, h, get(normals, h));
        EXPECT_EQ(get(normals.roundness_map(), h), 1);
      }
    });
    if (every > 1) { // else planes
      EXPECT_NE(points(put_again), points(without)) << what << every;
    }
  }
}

// keys without numbers, and a mesh that grows elsewhere; the vertices of the copy are others
TEST(Estimate_passed_on, GrowsWithAPolyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  for (const Soup& soup : {spired_box(), mixed_with_border()}) {
    Polyhedron without = built<Polyhedron>(soup), with = without;
    const auto normals = PN::estimate_control_normals(with);
    PN::subdivide(without, scheme, params::number_of_iterations(2));
    for (int k = 0; k < 2; ++k) PN::subdivide(with, scheme, params::vertex_normal_map(normals));
    EXPECT_EQ(points(with), points(without));
  }
}

TEST(Estimate_passed_on, IsTheSurfaceWithoutNormalsAtCreases)
{
  expect_same_creases<Mesh>("Surface_mesh");
  expect_same_creases<CGAL::Polyhedron_3<Kernel>>("Polyhedron_3");
}

// what a map of vertices says where a vertex has several wedges is not taken: neither its normals nor their roundness
TEST(Estimate_passed_on, OfVerticesIsEstimatedAgainBetweenCreases)
{
  const auto run = [&](double w) {
    Mesh mesh = built<Mesh>(spired_box());
    const auto sharp = some_sharp_edges(mesh, 3);
    const auto normals = PN::estimate_control_normals(mesh);
    std::size_t changed = 0;
    for (const Vertex v : mesh.vertices()) {
      if (mesh.is_isolated(v)) continue;
      int ends = 0;
      for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
        ends += get(sharp, mesh.edge(h));
      if (ends < 2) continue;
      put(normals, v, Kernel::Vector_3(w, 1, 0));
      put(normals.roundness_map(), v, w);
      ++changed;
    }
    EXPECT_GT(changed, 2u);
    PN::subdivide(mesh, scheme, params::vertex_normal_map(normals).edge_is_constrained_map(sharp));
    return points(mesh);
  };
  EXPECT_EQ(run(0), run(1));
}

// a call that fails leaves the normals and the roundness of the old vertices, or of the corners
template <class Estimate_of, class Keys>
void expect_strong_guarantee(const Estimate_of& estimate_of, const Keys& keys)
{
  Mesh mesh = built<Mesh>(spired_box());
  const auto normals = estimate_of(mesh), before = estimate_of(mesh);
  const auto sharp = some_sharp_edges(mesh, 3);
  const std::size_t n = mesh.number_of_vertices();
  for (int puts = 0; puts < 35; puts += 17) {
    failing_maps::Calls_left left(puts);
    const auto points = failing(get(CGAL::vertex_point, mesh), left);
    const auto np = params::vertex_normal_map(normals).edge_is_constrained_map(sharp);
    EXPECT_THROW(PN::subdivide(mesh, scheme, np.vertex_point_map(points)),
                 failing_maps::User_failure);
    ASSERT_EQ(mesh.number_of_vertices(), n);
    for (const auto key : keys(mesh)) {
      EXPECT_EQ(normals[key], before[key]);
      EXPECT_EQ(get(normals.roundness_map(), key), get(before.roundness_map(), key));
    }
  }
}

TEST(Estimate_passed_on, HasTheStrongGuarantee)
{
  expect_strong_guarantee([](Mesh& mesh) { return PN::estimate_control_normals(mesh); },
                          [](Mesh& mesh) { return vertices(mesh); });
  expect_strong_guarantee(
    [](Mesh& mesh) {
      return PN::estimate_control_normals(
        mesh, params::edge_is_constrained_map(some_sharp_edges(mesh, 3)));
    },
    [](Mesh& mesh) { return halfedges(mesh); });
  Mesh mesh = built<Mesh>(spired_box());
  mesh.point(Vertex(3)) = Kernel::Point_3(0, 0, std::nan(""));
  EXPECT_THROW(PN::estimate_control_normals(mesh), std::invalid_argument);
}

} // namespace
