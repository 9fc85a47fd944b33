// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// PN_mask_3 over CGAL's masks in CGAL's hosts: reproduction, reduction to the linear scheme,
// symmetries, and the PN rule itself against a dense matrix form in long double.

#include "Messages.h"
#include "PN_mask_3_cases.h"
#include "reference/PN_rule.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Epick_mesh = CGAL::Surface_mesh<Epick::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Epick>;

template <class Scheme_, class Mesh_>
struct Case
{
  using Scheme = Scheme_;
  using Mesh = Mesh_;
};

template <class>
class PN_mask_3 : public testing::Test
{};

using Cases =
  testing::Types<Case<CatmullClark, Surface_mesh>, Case<Loop, Surface_mesh>,
                 Case<DooSabin, Surface_mesh>, Case<Sqrt3, Surface_mesh>,
                 Case<CatmullClark, Epick_mesh>, Case<CatmullClark, Polyhedron>,
                 Case<Loop, Polyhedron>, Case<DooSabin, Polyhedron>, Case<Sqrt3, Polyhedron>>;
TYPED_TEST_SUITE(PN_mask_3, Cases, );

std::vector<Triple> scaled(std::vector<Triple> vectors, double factor)
{
  for (Triple& v : vectors)
    for (double& x : v) x *= factor;
  return vectors;
}

template <class Vector>
long double length(const Vector& v, bool with_z = true)
{
  const long double x = v.x(), y = v.y(), z = with_z ? v.z() : 0;
  return std::sqrt(x * x + y * y + z * z);
}

TYPED_TEST(PN_mask_3, KeepsSphere)
{
  using Scheme = typename TypeParam::Scheme;
  for (bool closed : {true, false}) {
    const Soup soup = on_sphere(control_soup<Scheme>(closed), 2);
    Control<typename TypeParam::Mesh> control(soup, scaled(soup.points, 0.5));
    subdivide_pn<Scheme>(control, 5);
    EXPECT_GT(num_vertices(control.mesh), 1000u);
    for (auto v : vertices(control.mesh)) {
      const auto radius = get(get(CGAL::vertex_point, control.mesh), v) - CGAL::ORIGIN;
      const auto normal = get(control.normals, v);
      ASSERT_NEAR(double(length(radius) / 2 - 1), 0, 4e-15);
      ASSERT_NEAR(double(length(normal) - 1), 0, 1e-15);
      ASSERT_NEAR(double(length(radius / 2 - normal)), 0, 1e-14);
    }
  }
}

TYPED_TEST(PN_mask_3, KeepsCylinder)
{
  using Scheme = typename TypeParam::Scheme;
  const Soup soup = tube(Scheme::triangles);
  std::vector<Triple> normals;
  for (const Triple& p : soup.points) normals.push_back({p[0] / 3, p[1] / 3, 0});
  Control<typename TypeParam::Mesh> control(soup, normals);
  subdivide_pn<Scheme>(control, 4);
  EXPECT_GT(num_vertices(control.mesh), 1000u);
  for (auto v : vertices(control.mesh)) {
    const auto radius = get(get(CGAL::vertex_point, control.mesh), v) - CGAL::ORIGIN;
    ASSERT_NEAR(double(length(radius, false) / 3 - 1), 0, 4e-15);
    ASSERT_EQ(get(control.normals, v).z(), 0);
  }
}

TYPED_TEST(PN_mask_3, IsLinearForEqualAndForZeroNormals)
{
  using Scheme = typename TypeParam::Scheme;
  using Mesh = typename TypeParam::Mesh;
  for (bool closed : {true, false})
    for (const Triple& normal : {Triple{0, 0, 0}, Triple{2. / 3, -2. / 3, 1. / 3}}) {
      const Soup soup = control_soup<Scheme>(closed);
      const std::vector<Triple> normals(soup.points.size(), normal);
      Control<Mesh> pn(soup, normals), linear(soup, normals);
      subdivide_pn<Scheme>(pn, 3);
      subdivide_linear<Scheme>(linear, 3);
      EXPECT_LE(largest_distance(pn.points(), linear.points()), 1e-13);
      for (const auto& n : pn.normal_vectors()) {
        const typename Control<Mesh>::Vector expected(normal[0], normal[1], normal[2]);
        ASSERT_LE(distance(n, expected), normal[0] == 0 ? 0 : 1e-15);
      }
    }
}

TYPED_TEST(PN_mask_3, NormalizesControlNormalsOfAnyLength)
{
  using Scheme = typename TypeParam::Scheme;
  const Soup soup = control_soup<Scheme>(false);
  const std::vector<Triple> normals = random_normals(soup.points.size(), 13);
  Control<typename TypeParam::Mesh> unit(soup, normals);
  subdivide_pn<Scheme>(unit, 2);
  for (double factor : {1e-250, 0.3, 17., 1e250}) {
    Control<typename TypeParam::Mesh> other(soup, scaled(normals, factor));
    subdivide_pn<Scheme>(other, 2);
    EXPECT_LE(largest_distance(unit.points(), other.points()), 1e-13) << factor;
    EXPECT_LE(largest_distance(unit.normal_vectors(), other.normal_vectors()), 1e-13) << factor;
  }
}

// --- the PN rule, against that of the references over a dense matrix ---

// How often a stencil had an entry that fades, that has left, and a normal that vanished.
struct Seen
{
  int fading = 0, gone = 0, vanished = 0;

  void add(const reference::Row& row, const reference::Values& old, const reference::Vector& normal)
  {
    vanished += normal.isZero(0);
    for (Eigen::Index j = 0; j < row.size(); ++j) {
      const reference::Vector& n = old.normals[std::size_t(j)];
      const reference::Real share = reference::share((n + normal).dot(normal));
      if (row[j] == 0 || share == 1 || normal.isZero(0)) continue;
      ++(share > 0 ? fading : gone);
    }
  }
};

// Column j of one round of CGAL's linear scheme: the x-coordinates it makes of a unit impulse.
template <class Scheme, class Mesh>
std::vector<std::vector<double>> columns_of_linear_scheme(const Soup& soup)
{
  std::vector<std::vector<double>> columns;
  for (std::size_t j = 0; j < soup.points.size(); ++j) {
    Soup impulse = soup;
    impulse.points.assign(soup.points.size(), Triple{0, 0, 0});
    impulse.points[j] = {1, 0, 0};
    Control<Mesh> control(impulse, std::vector<Triple>(soup.points.size()));
    subdivide_linear<Scheme>(control, 1);
    columns.emplace_back();
    for (const auto& p : control.points()) columns.back().push_back(p.x());
  }
  return columns;
}

template <class Scheme, class Mesh>
Seen compare_with_dense_form(const Soup& soup, const std::vector<Triple>& normals, double tolerance)
{
  const auto columns = columns_of_linear_scheme<Scheme, Mesh>(soup);
  reference::Values old;
  for (const Triple& p : soup.points) old.points.emplace_back(p[0], p[1], p[2]);
  for (const Triple& n : normals) old.normals.emplace_back(n[0], n[1], n[2]);
  Control<Mesh> control(soup, normals);
  subdivide_pn<Scheme>(control, 1);
  const auto points = control.points();
  const auto new_normals = control.normal_vectors();
  EXPECT_EQ(points.size(), columns.front().size());
  Seen seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    reference::Row row(Eigen::Index(columns.size()));
    for (std::size_t j = 0; j < columns.size(); ++j) row[Eigen::Index(j)] = columns[j][i];
    const auto [p, n] = reference::pn_rule(row, row, old);
    seen.add(row, old, n);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(points[i][k], double(p[k]), tolerance) << "vertex " << i;
      EXPECT_NEAR(new_normals[i][k], double(n[k]), 1e-14) << "vertex " << i;
    }
  }
  return seen;
}

TYPED_TEST(PN_mask_3, FollowsTheRule)
{
  using Scheme = typename TypeParam::Scheme;
  for (bool closed : {true, false}) {
    const Soup soup = control_soup<Scheme>(closed);
    std::vector<Triple> normals = random_normals(soup.points.size(), 17);
    normals[1] = normals[4] = {0, 0, 0};
    compare_with_dense_form<Scheme, typename TypeParam::Mesh>(soup, normals, 1e-13);
  }
}

// Normals along z, every third one nearly reversed, tilted by 0 to 46 degrees.
TYPED_TEST(PN_mask_3, FadesOppositeNormals)
{
  using Scheme = typename TypeParam::Scheme;
  Seen seen;
  for (bool closed : {true, false}) {
    const Soup soup = control_soup<Scheme>(closed);
    for (double tilt : {0.5, 10., 22., 26., 31., 36., 41., 46.}) {
      std::vector<Triple> normals(soup.points.size(), Triple{0, 0, 1});
      const double angle = tilt * CGAL_PI / 180;
      for (std::size_t i = 0; i < normals.size(); i += 3)
        normals[i] = {std::sin(angle), 0, -std::cos(angle)};
      const Seen more =
        compare_with_dense_form<Scheme, typename TypeParam::Mesh>(soup, normals, 1e-11);
      seen.fading += more.fading;
      seen.gone += more.gone;
    }
  }
  EXPECT_GT(seen.fading, 20);
  EXPECT_GT(seen.gone, 20);
}

// On a bordered mesh the node of a border edge takes both ends equally: opposite normals cancel,
// up to half the tilt of one of them.
TEST(PN_mask_3_rule, VanishingNormalGivesLinearPointAndNoNormal)
{
  const Soup soup = prism(false);
  for (double tilt : {0., 1e-13, 1.7e-12, 2e-12}) {
    std::vector<Triple> normals(soup.points.size(), Triple{0, 0.6, 0.8});
    normals[1] = {tilt, -0.6, -0.8};
    const Seen seen = compare_with_dense_form<CatmullClark, Surface_mesh>(soup, normals, 1e-13);
    EXPECT_EQ(seen.vanished > 0, tilt < 1.8e-12);

    Control<Surface_mesh> control(soup, normals);
    subdivide_pn<CatmullClark>(control, 1);
    int zero = 0;
    for (const auto& n : control.normal_vectors()) zero += n == CGAL::NULL_VECTOR;
    EXPECT_EQ(zero, seen.vanished);
  }
}

// --- input that CGAL's hosts do not check ---

TEST(PN_mask_3_checks, NamesTheOffendingVertex)
{
  const Soup soup = prism(true);
  const std::vector<Triple> normals(soup.points.size(), Triple{0, 0, 1});
  const auto message = [](Control<Surface_mesh>& control) {
    return messages::message_of([&] { CatmullClark::mask(control.mesh, control.point_normals()); });
  };
  {
    Control<Surface_mesh> control(soup, normals);
    EXPECT_EQ(message(control), "");
    control.mesh.point(CGAL::SM_Vertex_index(3)) =
      Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
    messages::expect_words(message(control), {"vertex 3 "});
  }
  {
    Control<Surface_mesh> control(soup, normals);
    put(control.normals, CGAL::SM_Vertex_index(5),
        Kernel::Vector_3(0, 0, -std::numeric_limits<double>::infinity()));
    messages::expect_words(message(control), {"vertex 5 "});
  }
  {
    Control<Surface_mesh> control(soup, normals);
    put(control.normals, control.mesh.add_vertex(Kernel::Point_3(9, 9, 9)), CGAL::NULL_VECTOR);
    messages::expect_words(message(control), {"vertex 11 "});
    messages::expect_words(message(control), {"has no edge"});
  }
}

} // namespace
