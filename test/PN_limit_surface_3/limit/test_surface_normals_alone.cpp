// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Surface normals where limit points are not asked for: how far they are from those of small tolerances, what is
// claimed of them, their sides, and the rings that are looked at side by side against one after the other.

#include "Extent.h"
#include "Limit_cases.h"
#include "Mesh_shapes.h"
#include "Test_meshes.h"
#include "support/Options.h"

#include <CGAL/PN_limit_surface_3/internal/limit/Ring_geometry.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_lanes.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>

namespace {

using namespace limit_cases;
namespace in = PN::internal;
using test_meshes::Cells;
using test_meshes::Control_mesh;

test_options::Limit_options normals_alone(double normal_tolerance)
{
  test_options::Limit_options options = close(1e-9, normal_tolerance);
  options.points = false;
  return options;
}

double angle(const Limit& a, const Limit& b)
{
  return std::sqrt((a.surface_normal - b.surface_normal).squared_length());
}

// Points moved, and normals of the faces turned, by some part, at random.
Control_mesh shaken(Control_mesh mesh, double points, double normals, unsigned seed)
{
  std::mt19937 g(seed);
  std::uniform_real_distribution<double> d(-1, 1);
  for (auto& p : mesh.points)
    for (double& x : p) x += points * d(g);
  test_meshes::set_uneven_normals(mesh, seed);
  for (auto& n : mesh.normals) {
    for (double& x : n) x += normals * d(g);
    n = test_meshes::unit(n);
  }
  return mesh;
}

Control_mesh torus(Cells cells)
{
  return test_meshes::grid(8, 6, true, true, cells);
}

// A normal is that which is found where points are asked for, too, or was found by one average, and then its error is
// what is claimed, at most, and that what was asked for.
template <class Scheme>
std::size_t expect_normals(const Control_mesh& control, const Scheme& scheme, unsigned rounds)
{
  const std::string what =
    std::string(scheme.name()) + ", " + control.name + ", round " + std::to_string(rounds);
  Surface_mesh mesh = to_surface_mesh(control);
  PN::subdivide(mesh, scheme,
                CGAL::parameters::number_of_iterations(rounds).vertex_normal_map(normal_map(mesh)));
  test_options::Limit_options fine = close(1e-9, 1e-7), beside = close(1, 1e-3),
                              alone = normals_alone(1e-3);
  fine.rounds_done = beside.rounds_done = alone.rounds_done = rounds;
  const Limits expected = limits(mesh, scheme, fine), with_points = limits(mesh, scheme, beside);
  const Limits found = limits(mesh, scheme, alone);
  EXPECT_TRUE(found.report.is_within_tolerance()) << what;
  std::size_t at_once = 0;
  for (std::size_t v = 0; v < found.at.size(); ++v) {
    EXPECT_EQ(found.at[v].has_surface_normal, expected.at[v].has_surface_normal) << what;
    if (!found.at[v].has_surface_normal) { // as exact as points
      EXPECT_LE(angle(found.at[v], expected.at[v]), 1e-6) << what << ", vertex " << v;
      continue;
    }
    if (angle(found.at[v], with_points.at[v]) == 0) continue;
    ++at_once;
    EXPECT_LE(found.at[v].normal_error, 1e-3) << what << ", vertex " << v;
    EXPECT_LE(angle(found.at[v], expected.at[v]), found.at[v].normal_error + 1e-7)
      << what << ", vertex " << v;
  }
  return at_once;
}

template <class Scheme>
void expect_normals(Cells cells, const Scheme& scheme)
{
  std::size_t at_once = 0;
  for (const double normals : {0., .3}) {
    at_once += expect_normals(shaken(torus(cells), .1, normals, 1), scheme, 2);
    at_once += expect_normals(shaken(test_meshes::grid(5, 4, false, false, cells), .05, normals, 2),
                              scheme, 3);
    at_once += expect_normals(shaken(test_meshes::star(7, 2, cells), .05, normals, 3), scheme, 2);
  }
  EXPECT_GT(at_once, 10u) << scheme.name();
}

TEST(Surface_normals_alone, MeetTheirClaims)
{
  expect_normals(Cells::quads, PN::CatmullClark_scheme());
  expect_normals(Cells::triangles, PN::Loop_scheme());
  if (!tests_are_full) return;
  expect_normals(Cells::quads, PN::CatmullClark_scheme::Tuned());
  expect_normals(Cells::triangles, PN::Butterfly_scheme());
  expect_normals(Cells::triangles, PN::Sqrt3_scheme());
}

// Small rings of little curvature need no round, which is what makes normals alone cheap; and of points nothing is
// claimed.
TEST(Surface_normals_alone, NeedNoRoundOnFineMeshes)
{
  Surface_mesh mesh = to_surface_mesh(shaken(torus(Cells::quads), 0, 0, 8));
  const PN::CatmullClark_scheme scheme;
  PN::subdivide(mesh, scheme,
                CGAL::parameters::number_of_iterations(4).vertex_normal_map(normal_map(mesh)));
  const Limits alone = limits(mesh, scheme, normals_alone(.02));
  EXPECT_EQ(alone.report.depth, 0u);
  EXPECT_EQ(alone.report.error, 0.);
  EXPECT_EQ(alone.report.number_of_misses, 0u);
  EXPECT_GT(limits(mesh, scheme, close(1, .02)).report.depth, 0u);
}

// A control normal on the wrong side does not take the surface normal there: it is on the side of the faces around.
TEST(Surface_normals_alone, AreOnTheSideOfTheFaces)
{
  for (const Cells cells : {Cells::quads, Cells::triangles}) {
    Control_mesh control = shaken(test_meshes::grid(7, 7, false, false, cells), .05, 0, 4);
    for (auto& n : control.normals) n = {0, 0, -1}; // the grid's faces are seen from above
    Surface_mesh mesh = to_surface_mesh(control);
    const Limits down = cells == Cells::quads
                          ? limits(mesh, PN::CatmullClark_scheme(), normals_alone(1e-3))
                          : limits(mesh, PN::Loop_scheme(), normals_alone(1e-3));
    Kernel::Vector_3 area(0, 0, 0);
    for (const auto f : mesh.faces()) {
      std::vector<Kernel::Point_3> p;
      for (const auto v : vertices_around_face(mesh.halfedge(f), mesh)) p.push_back(mesh.point(v));
      for (std::size_t i = 1; i + 1 < p.size(); ++i)
        area = area + CGAL::cross_product(p[i] - p[0], p[i + 1] - p[0]);
    }
    for (const Limit& l : down.at) {
      if (!l.has_surface_normal) continue;
      EXPECT_GT(l.surface_normal * area, 0);
    }
  }
}

// Where all points are one there is no surface normal, and the control normal that stands in for it is the one that is
// found with points.
TEST(Surface_normals_alone, HaveTheSameStandIns)
{
  Control_mesh control = shaken(test_meshes::grid(5, 4, false, false, Cells::quads), 0, .3, 9);
  for (auto& p : control.points) p = {1, 2, 3};
  Surface_mesh mesh = to_surface_mesh(control);
  const Limits alone = limits(mesh, PN::CatmullClark_scheme(), normals_alone(1e-3));
  const Limits with_points = limits(mesh, PN::CatmullClark_scheme(), close(1e-9, 1e-3));
  for (std::size_t v = 0; v < alone.at.size(); ++v) {
    EXPECT_FALSE(alone.at[v].has_surface_normal);
    EXPECT_EQ(alone.at[v].surface_normal, with_points.at[v].surface_normal) << v;
  }
}

// Points stay where they are, and normals become those of the surface.
TEST(Surface_normals_alone, LeavePointsWhereTheyAre)
{
  const Control_mesh control = shaken(torus(Cells::quads), .1, .2, 10);
  const PN::CatmullClark_scheme scheme;
  test_options::Limit_options options = normals_alone(1e-3);
  Surface_mesh mesh = to_surface_mesh(control), moved = to_surface_mesh(control);
  PN::subdivide(mesh, scheme,
                CGAL::parameters::number_of_iterations(2).vertex_normal_map(normal_map(mesh)));
  PN::subdivide_to_limit(
    moved, scheme,
    PN::parameters::join(
      options.pack(),
      CGAL::parameters::number_of_iterations(2).vertex_normal_map(normal_map(moved))));
  options.rounds_done = 2;
  const Limits expected = limits(mesh, scheme, options);
  const auto expect_equal = [&](Surface_mesh& other) {
    for (const auto v : mesh.vertices()) {
      EXPECT_EQ(other.point(v), mesh.point(v));
      EXPECT_EQ(normal_map(other)[v], expected.at[v].surface_normal);
    }
  };
  expect_equal(moved);
  Surface_mesh later = mesh;
  PN::subdivide_to_limit(
    later, scheme,
    PN::parameters::join(CGAL::parameters::number_of_iterations(0), options.pack(),
                         CGAL::parameters::vertex_normal_map(normal_map(later))));
  expect_equal(later);
  options.points = true;
  PN::subdivide_to_limit(
    mesh, scheme,
    PN::parameters::join(CGAL::parameters::number_of_iterations(0), options.pack(),
                         CGAL::parameters::vertex_normal_map(normal_map(mesh))));
  EXPECT_NE(mesh.point(*mesh.vertices().begin()), later.point(*later.vertices().begin()));
}

// At scales that rings are not looked at side by side, too.
TEST(Surface_normals_alone, AreTheSameAtAnyScale)
{
  const Control_mesh control = shaken(torus(Cells::quads), .1, .2, 11);
  std::vector<Limits> found;
  for (const int exponent : {0, -300, 300}) {
    Control_mesh scaled = control;
    for (auto& p : scaled.points)
      for (double& x : p) x = std::ldexp(x, exponent);
    Surface_mesh mesh = to_surface_mesh(scaled);
    PN::subdivide(mesh, PN::CatmullClark_scheme(),
                  CGAL::parameters::number_of_iterations(3).vertex_normal_map(normal_map(mesh)));
    found.push_back(limits(mesh, PN::CatmullClark_scheme(), normals_alone(1e-2)));
  }
  for (std::size_t v = 0; v < found[0].at.size(); ++v)
    for (const std::size_t k : {1, 2}) {
      ASSERT_EQ(found[k].at[v].surface_normal, found[0].at[v].surface_normal) << v;
      ASSERT_EQ(found[k].at[v].normal_error, found[0].at[v].normal_error) << v;
    }
}

// --- rings side by side ---

using Ring = std::vector<PN::Point_normal<double, 3>>;

struct Case
{
  Ring ring;
  PN::Point_normal<double, 3> limit;
};

Case random_case(std::mt19937& g, std::size_t places, double scale)
{
  std::normal_distribution<double> d;
  const auto vector = [&](double s) {
    return PN::Coordinates<double, 3>{s * d(g), s * d(g), s * d(g)};
  };
  Case c{Ring(places), {vector(scale), test_meshes::unit(vector(1))}};
  for (auto& v : c.ring) v = {vector(scale), test_meshes::unit(vector(1))};
  return c;
}

void put(const Case& c, std::size_t lane, in::Ring_lanes& lanes)
{
  lanes.ring.resize(c.ring.size());
  for (std::size_t i = 0; i < 3; ++i) {
    lanes.limit.point[i][lane] = c.limit.point[i];
    lanes.limit.normal[i][lane] = c.limit.normal[i];
    for (std::size_t p = 0; p < c.ring.size(); ++p) {
      lanes.ring[p].point[i][lane] = c.ring[p].point[i];
      lanes.ring[p].normal[i][lane] = c.ring[p].normal[i];
    }
  }
}

in::Ring_lanes::Masks random_masks(std::mt19937& g, std::size_t places)
{
  std::normal_distribution<double> d;
  in::Ring_lanes::Masks masks;
  for (auto& mask : masks) {
    double sum = 0;
    for (std::size_t i = 0; i < places; ++i) mask.push_back(d(g));
    for (const double w : mask) sum += w;
    for (double& w : mask) w -= sum / double(places);
  }
  return masks;
}

in::Ring_geometry geometry(Case& c, const in::Ring_lanes::Masks& masks, double roundness = 1)
{
  for (auto& v : c.ring)
    for (std::size_t i = 0; i < 3; ++i) v.point[i] -= c.limit.point[i];
  PN::Point_normal<double, 3> limit = c.limit;
  limit.point = {0, 0, 0};
  return {c.ring, limit, masks, roundness};
}

TEST(Ring_lanes, FindWhatRingsOneByOneHave)
{
  std::mt19937 g(5);
  for (int k = 0; k < 200; ++k) {
    const std::size_t places = 4 + std::size_t(k) % 14;
    const auto masks = random_masks(g, places);
    std::vector<Case> cases;
    in::Ring_lanes lanes;
    for (std::size_t l = 0; l < in::Ring_lanes::lanes; ++l) {
      cases.push_back(random_case(g, places, std::ldexp(1., k % 40 - 20)));
      put(cases[l], l, lanes);
      lanes.roundness[l] = double((std::size_t(k) + l) % 3) / 2;
    }
    lanes.find(masks, {3, true});
    for (std::size_t l = 0; l < in::Ring_lanes::lanes; ++l) {
      const in::Ring_geometry expected = geometry(cases[l], masks, lanes.roundness[l]);
      ASSERT_EQ(lanes.is_found[l], expected.is_regular());
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(lanes.normal[i][l], expected.normal()[i], 1e-11);
      EXPECT_NEAR(lanes.size[l], expected.size(), 1e-11 * expected.size());
    }
  }
}

// With roundness 0 the surface is that of the linear twin, of which all masks are exact: whatever the tolerance.
TEST(Surface_normals, OfRoundnessZeroAreThoseOfTheLinearTwin)
{
  const Control_mesh control = shaken(torus(Cells::quads), .1, .3, 1);
  Surface_mesh mesh = to_surface_mesh(control);
  auto found =
    mesh.add_property_map<Surface_mesh::Vertex_index, PN::Limit_point<Kernel>>("f").first;
  auto linear =
    mesh.add_property_map<Surface_mesh::Vertex_index, PN::Limit_point<Kernel>>("l").first;
  test_options::Limit_options options = close(1, 1);
  PN::limit_points(
    mesh, PN::CatmullClark_scheme(), found,
    PN::parameters::join(options.pack(),
                         PN::parameters::roundness(0.).vertex_normal_map(normal_map(mesh))));
  PN::limit_points(mesh, PN::linear(PN::CatmullClark_scheme()), linear, options.pack());
  for (auto v : mesh.vertices())
    EXPECT_LE((found[v].surface_normal - linear[v].surface_normal).squared_length(), 1e-24);
}

// What a lane holds has no part in the others.
TEST(Ring_lanes, LeaveOtherRingsAlone)
{
  std::mt19937 g(6);
  const auto masks = random_masks(g, 9);
  for (const int kind : {0, 1, 2, 3}) {
    in::Ring_lanes lanes;
    std::vector<Case> cases;
    for (std::size_t l = 0; l < in::Ring_lanes::lanes; ++l) {
      cases.push_back(random_case(g, 9, 1));
      if (l == 1) {
        if (kind == 0) cases[l] = random_case(g, 9, std::ldexp(1., 300));
        if (kind == 1) cases[l] = random_case(g, 9, std::ldexp(1., -300));
        if (kind == 2) cases[l].limit.normal = {0, 0, 0};
        if (kind == 3)
          for (auto& v : cases[l].ring) v.point = cases[l].limit.point;
      }
      put(cases[l], l, lanes);
    }
    lanes.find(masks, {3, false});
    EXPECT_FALSE(lanes.is_found[1]) << kind;
    for (const std::size_t l : {0, 2, 3}) {
      EXPECT_TRUE(lanes.is_found[l]) << kind;
      const in::Ring_geometry expected = geometry(cases[l], masks);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(lanes.normal[i][l], expected.normal()[i], 1e-11);
    }
  }
}

// The error claimed: four times the slope between the normal and that of the plain masks, or half the square of the
// longest chord between control normals; far too much where one is missing.
TEST(Ring_lanes, ClaimWhatArcsAndControlNormalsTell)
{
  std::mt19937 g(7);
  std::normal_distribution<double> d;
  const auto masks = random_masks(g, 9);
  for (const double bend : {1e-3, 1e-2, .1}) {
    in::Ring_lanes lanes;
    std::vector<Case> cases;
    for (std::size_t l = 0; l < in::Ring_lanes::lanes; ++l) {
      Case c{Ring(9), {{0, 0, 0}, {0, 0, 1}}};
      for (auto& v : c.ring)
        v = {{d(g), d(g), bend * d(g)}, test_meshes::unit({bend * d(g), bend * d(g), 1})};
      if (l == 3) c.ring[4].normal = {0, 0, 0};
      cases.push_back(c);
      put(c, l, lanes);
    }
    lanes.find(masks, {4, true});
    for (std::size_t l = 0; l < 3; ++l) {
      Kernel::Vector_3 t[2] = {{0, 0, 0}, {0, 0, 0}};
      double chord2 = 0;
      for (std::size_t p = 0; p < 9; ++p) {
        const auto &v = cases[l].ring[p].point, &n = cases[l].ring[p].normal;
        for (std::size_t r = 0; r < 2; ++r)
          t[r] = t[r] + masks[r][p] * Kernel::Vector_3(v[0], v[1], v[2]);
        chord2 = (std::max)(chord2, n[0] * n[0] + n[1] * n[1] + (n[2] - 1) * (n[2] - 1));
      }
      Kernel::Vector_3 plain = CGAL::cross_product(t[0], t[1]);
      // slopes of the planes perpendicular to both
      const double x = plain.x() / plain.z() - lanes.normal[0][l] / lanes.normal[2][l];
      const double y = plain.y() / plain.z() - lanes.normal[1][l] / lanes.normal[2][l];
      const double expected = (std::max)(chord2 / 2, 4 * std::hypot(x, y));
      EXPECT_NEAR(lanes.error[l], expected, 1e-9 * (1 + expected));
    }
    EXPECT_GE(lanes.error[3], 1);
  }
}

} // namespace
