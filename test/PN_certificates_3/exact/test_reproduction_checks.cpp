// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Deviations from shapes, against values found by hand, in every kind of kernel.

#include "Extent.h"
#include "Messages.h"
#include "One_root_number.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpfr.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <limits>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

using CGAL::certainly;
using CGAL::certainly_not;
using Q = CGAL::Exact_rational;
using Rational = CGAL::Simple_cartesian<Q>;
using Double = CGAL::Simple_cartesian<double>;
using Interval = CGAL::Simple_cartesian<CGAL::Interval_nt<>>;
using Rooted = CGAL::Simple_cartesian<One_root_number>;

// in which lengths of normals are rounded, so that averages leave shapes
template <class FT>
constexpr bool is_rounded_exact =
  std::is_same_v<FT, CGAL::Gmpq> || std::is_same_v<FT, CGAL::Epeck::FT>;

const double ulp = std::numeric_limits<double>::epsilon();

Q power_of_2(int e)
{
  Q x(1);
  for (; e > 0; --e) x *= 2;
  for (; e < 0; ++e) x /= 2;
  return x;
}

// Shapes with points by hand; all numbers are small integers. Every point is `twice_off`/2 from its
// shape, and `normal` is the shape's there.
template <class K>
struct Shapes
{
  using FT = typename K::FT;
  using Point_2 = typename K::Point_2;
  using Vector_2 = typename K::Vector_2;
  using Point_3 = typename K::Point_3;
  using Vector_3 = typename K::Vector_3;

  typename K::Circle_2 circle_2{Point_2(10, -3), FT(25)};
  typename K::Line_2 line_2{Point_2(1, 1), Vector_2(4, 3)};
  typename K::Sphere_3 sphere{Point_3(10, -3, 2), FT(49)};
  // about (1, 2, 2)
  PN::Cylinder_3<K> cylinder{typename K::Line_3(Point_3(1, 0, 5), Vector_3(1, 2, 2)), FT(36)};
  typename K::Circle_3 circle_3{Point_3(1, 0, 5), FT(36), Vector_3(1, 2, 2)};
  typename K::Plane_3 plane{Point_3(1, 0, 5), Vector_3(1, 2, 2)};
  typename K::Line_3 line_3{Point_3(1, 0, 5), Vector_3(1, 2, 2)};
  // orthogonal to (1, 2, 2), of length 3 too
  Vector_3 u{2, -2, 1}, v{2, 1, -2}, w{1, 2, 2};
  Point_3 o{1, 0, 5};

  template <class Check>
  void all(const Check& check) const
  {
    check(circle_2, Point_2(13, 1), Vector_2(3, 4), Vector_2(3, -4), 0);
    check(circle_2, Point_2(16, 5), Vector_2(-3, -4), Vector_2(4, -3), 10);
    check(line_2, Point_2(9, 7), Vector_2(-3, 4), Vector_2(3, 4), 0);
    check(line_2, Point_2(6, 11), Vector_2(-3, 4), Vector_2(3, 4), 10);
    check(sphere, Point_3(12, 0, 8), Vector_3(2, 3, 6), Vector_3(2, 3, 5), 0);
    check(sphere, Point_3(14, 3, 14), Vector_3(2, 3, 6), Vector_3(3, 3, 6), 14);
    check(cylinder, o + u + u + w, u, u + w, 0);
    check(cylinder, o + v + v + v + v, v, u, 12);
    check(circle_3, o + v + v, v, v + w, 0);
    check(circle_3, o - u - u - w, u, u + v, 6);
    check(plane, o + v - u - u, w, w + u, 0);
    check(plane, o + v - w, w, v, 6);
    check(line_3, o + w + w, u - v, u + w, 0);
    check(line_3, o + w + w + u + u, u + v, w, 12);
  }
};

template <class K>
class Exact_checks : public testing::Test
{};
using Kernels =
  In_full<testing::Types<CGAL::Simple_cartesian<float>, CGAL::Simple_cartesian<long double>,
                         CGAL::Simple_cartesian<CGAL::Gmpfr>, CGAL::Simple_cartesian<CGAL::Gmpq>,
                         CGAL::Exact_predicates_inexact_constructions_kernel,
                         CGAL::Exact_predicates_exact_constructions_kernel,
                         CGAL::Simple_cartesian<CORE::Expr>, Rooted, Interval>,
          testing::Types<CGAL::Exact_predicates_inexact_constructions_kernel,
                         CGAL::Exact_predicates_exact_constructions_kernel, Interval>>;
TYPED_TEST_SUITE(Exact_checks, Kernels, );

TYPED_TEST(Exact_checks, ShapesByHand)
{
  using Number = PN::Deviation_number<typename TypeParam::FT>;
  Shapes<TypeParam>().all(
    [](const auto& shape, const auto& p, const auto& n, const auto& wrong, int twice_off) {
      EXPECT_EQ(certainly(PN::is_on(p, shape)), twice_off == 0);
      EXPECT_EQ(certainly_not(PN::is_on(p, shape)),
                twice_off != 0 && !is_rounded_exact<typename TypeParam::FT>);
      EXPECT_EQ(certainly(PN::is_on(p, shape, 0.)), twice_off == 0);
      EXPECT_EQ(certainly_not(PN::is_on(p, shape, 0.)), twice_off != 0);
      EXPECT_EQ(certainly(PN::squared_deviation(p, shape) == Number(0)), twice_off == 0);
      const auto d = PN::distance_interval(p, shape);
      EXPECT_LE(d.inf(), twice_off / 2.);
      EXPECT_GE(d.sup(), twice_off / 2.);
      EXPECT_LE(d.sup() - d.inf(), 1e-14);
      EXPECT_TRUE(certainly(PN::squared_normal_deviation(n, p, shape) == Number(0)));
      EXPECT_TRUE(certainly(PN::squared_normal_deviation(-n, p, shape) == Number(0)));
      EXPECT_TRUE(certainly(PN::squared_normal_deviation(wrong, p, shape) > Number(0)));
    });
}

// Sums that rounding would lose: 2^-20 is above the precision of every type beside 4.
TYPED_TEST(Exact_checks, ValuesByHand)
{
  using FT = typename TypeParam::FT;
  using Number = PN::Deviation_number<FT>;
  const Shapes<TypeParam> s;
  const FT e = FT(1) / FT(1 << 20);
  const typename TypeParam::Sphere_3 sphere({0, 0, 0}, FT(25));
  const typename TypeParam::Point_3 p(3, 0, FT(4) + e);
  const Number t = Number(1) / Number(1 << 20), radial = Number(8) * t + t * t;
  EXPECT_TRUE(CGAL::possibly(PN::squared_deviation(p, sphere) == radial * radial / Number(100)));
  // twice the radius: (4 R^2 - R^2)^2 / 4 R^2; inside, at the center, R^2/4
  EXPECT_TRUE(
    CGAL::possibly(PN::squared_deviation(s.sphere.center() + typename TypeParam::Vector_3(4, 6, 12),
                                         s.sphere) == Number(441) / Number(4)));
  EXPECT_TRUE(
    CGAL::possibly(PN::squared_deviation(s.sphere.center(), s.sphere) == Number(49) / Number(4)));
  // 3 out of the plane and 6 + 3 from the axis instead of 6: (81 - 36)^2 / 144 + 9
  EXPECT_TRUE(CGAL::possibly(PN::squared_deviation(s.o + s.u + s.u + s.u + s.w, s.circle_3) ==
                             Number(2025) / Number(144) + Number(9)));
  // 45 degrees
  EXPECT_TRUE(CGAL::possibly(PN::squared_normal_deviation(s.u + s.w, s.o + s.u, s.cylinder) ==
                             Number(1) / Number(2)));
  EXPECT_TRUE(CGAL::possibly(PN::squared_normal_deviation(s.u + s.w, s.o + s.u, s.line_3) ==
                             Number(1) / Number(2)));
  EXPECT_TRUE(CGAL::possibly(PN::squared_normal_deviation(s.u + s.w, s.o + s.u, s.plane) ==
                             Number(1) / Number(2)));
  EXPECT_TRUE(certainly(PN::squared_normal_deviation(s.u, s.o, s.cylinder) == Number(1)));
}

// --- tolerances ---

template <class Shape, class Point>
bool near_only_from(const Point& p, const Shape& shape, double tolerance)
{
  return certainly(PN::is_on(p, shape, tolerance)) &&
         certainly(PN::is_on(p, shape, 2 * tolerance)) &&
         certainly_not(PN::is_on(p, shape, std::nextafter(tolerance, 0.)));
}

TEST(Tolerance, IsMetExactly)
{
  const Shapes<Rational> s;
  using Point = Rational::Point_3;
  EXPECT_TRUE(near_only_from(Point(14, 3, 14), s.sphere, 1));
  EXPECT_TRUE(near_only_from(s.sphere.center(), s.sphere, 1));
  EXPECT_TRUE(near_only_from(s.o + s.v / Q(2), s.cylinder, 0.75));
  EXPECT_TRUE(near_only_from(s.o + s.v * Q(3), s.cylinder, 0.5));
  EXPECT_TRUE(near_only_from(s.o + s.v * Q(2) + s.w, s.circle_3, 0.5));
  EXPECT_TRUE(near_only_from(s.o + s.v * Q(3), s.circle_3, 0.5));
  EXPECT_TRUE(near_only_from(s.o + s.v, s.circle_3, 0.5));
  EXPECT_TRUE(near_only_from(s.o + s.v * Q(2) - s.w * Q(100), s.circle_3, 50));
  EXPECT_TRUE(near_only_from(s.o + s.v + s.w / Q(4), s.plane, 0.75));
  EXPECT_TRUE(near_only_from(Rational::Point_2(6, 11), s.line_2, 5));
}

TEST(Tolerance, InUnitsOfTheLastPlace)
{
  // one unit of 2^-52 outside, and half of one inside
  const Double::Sphere_3 unit({0, 0, 0}, 1);
  EXPECT_TRUE(near_only_from(Double::Point_3(0, 1 + ulp, 0), unit, ulp));
  EXPECT_TRUE(near_only_from(Double::Point_3(0, 0, -1 + ulp / 2), unit, ulp / 2));
  EXPECT_FALSE(PN::is_on(Double::Point_3(0, 1 + ulp, 0), unit));
}

template <class Kernel>
void expect_ulps(typename Kernel::FT x, double expected)
{
  using FT = typename Kernel::FT;
  const typename Kernel::Point_3 far(7 + 8 * x, 0, 0); // from the middle of a sphere of radius 8
  const typename Kernel::Sphere_3 sphere({-1, 0, 0}, FT(64));
  const CGAL::Interval_nt<> d = PN::distance_in_ulps(far, sphere);
  EXPECT_LE(d.inf(), expected);
  EXPECT_GE(d.sup(), expected);
  EXPECT_LE(d.sup() - d.inf(), 1e-14 * expected);
}

TEST(Tolerance, DistancesInUnitsOfTheLastPlace)
{
  expect_ulps<Double>(3 * std::numeric_limits<double>::epsilon(), 3);
  expect_ulps<CGAL::Simple_cartesian<float>>(3 * std::numeric_limits<float>::epsilon(), 3);
  expect_ulps<CGAL::Simple_cartesian<long double>>(3 * std::numeric_limits<long double>::epsilon(),
                                                   3);
  expect_ulps<Rational>(Rational::FT(ulp) / 4, 0.25);
  const Double::Plane_3 plane(0, 0, 1, 0);
  EXPECT_EQ(PN::distance_in_ulps(Double::Point_3(5, 5, 2 * ulp), plane).sup(), 2);
}

TEST(Tolerance, IntervalsMayNotDecide)
{
  using I = CGAL::Interval_nt<>;
  const Interval::Sphere_3 unit({0, 0, 0}, I(1));
  const Interval::Point_3 p(I(1 - ulp, 1 + ulp), 0, 0), q(I(1 + ulp, 1 + 2 * ulp), 0, 0);
  EXPECT_TRUE(is_indeterminate(PN::is_on(p, unit)));
  EXPECT_TRUE(certainly_not(PN::is_on(q, unit)));
  EXPECT_TRUE(certainly(PN::is_on(p, unit, 8 * ulp)));
  EXPECT_TRUE(certainly(PN::is_on(q, unit, 8 * ulp)));
  EXPECT_TRUE(is_indeterminate(PN::is_on(q, unit, 1.5 * ulp)));
  EXPECT_TRUE(certainly(PN::is_on(Interval::Point_3(0, 1, 0), unit)));
  EXPECT_THROW(static_cast<void>(static_cast<bool>(PN::is_on(p, unit))),
               CGAL::Uncertain_conversion_exception);
}

// --- kernels that differ ---

TEST(MixedKernels, ARadiusWithoutAnExactDouble)
{
  const Q r = Q(11) / Q(10);
  const Rational::Sphere_3 exact({0, 0, 0}, r * r);
  const Double::Sphere_3 rounded({0, 0, 0}, 1.1 * 1.1);
  const Double::Point_3 p(0, 1.1, 0);
  const Q off = Q(1.1) - r;
  EXPECT_EQ(PN::squared_deviation(p, exact),
            CGAL::square(Q(off * (Q(2) * r + off))) / (Q(4) * r * r));
  EXPECT_NE(PN::squared_deviation(p, exact), PN::squared_deviation(p, rounded));
  const auto d = PN::distance_interval(p, exact);
  EXPECT_TRUE(Q(d.inf()) <= off && off <= Q(d.sup()));
  EXPECT_LT(d.sup() - d.inf(), 4 * ulp * d.sup());
  EXPECT_TRUE(
    is_indeterminate(PN::is_on(Interval::Point_3(0, CGAL::Interval_nt<>(1, 2), 0), exact)));
}

TEST(MixedKernels, NothingIsRounded)
{
  // 2^-60 beside 1, far from the origin
  using Long = CGAL::Simple_cartesian<long double>;
  const Long::Point_3 p(1 + std::ldexp(1.L, -60), 0, 0);
  const auto d = PN::distance_interval(p, Double::Sphere_3({0, 0, 0}, 1));
  EXPECT_TRUE(Q(d.inf()) <= power_of_2(-60) && power_of_2(-60) <= Q(d.sup()));
  EXPECT_LT(d.sup() - d.inf(), 4 * ulp * d.sup());
  // at 2^50 coordinates have steps of 1/4; both sums of squares need 101 bits
  const double far = std::ldexp(1., 50);
  const Double::Sphere_3 sphere({far, far, far}, 25);
  EXPECT_TRUE(PN::is_on(Double::Point_3(far + 3, far, far - 4), sphere));
  EXPECT_EQ(PN::squared_deviation(Double::Point_3(far + 3, far + 0.25, far - 4), sphere),
            power_of_2(-8) / Q(100));
  CGAL::Gmpfr::set_default_precision(100);
  using Fine = CGAL::Simple_cartesian<CGAL::Gmpfr>;
  const CGAL::Gmpfr tiny(std::ldexp(1., -90));
  const auto m = PN::squared_deviation(Fine::Point_3(CGAL::Gmpfr(1) + tiny, 0, 0),
                                       Double::Sphere_3({0, 0, 0}, 1));
  CGAL::Gmpfr::set_default_precision(53);
  EXPECT_EQ(m, CGAL::square(Q(power_of_2(-89) + power_of_2(-180))) / Q(4));
}

// --- meshes ---

// four points of the sphere of radius 3 about (5, 0, 0)
template <class K, class Mesh>
void add_tetrahedron(Mesh& mesh)
{
  using P = typename K::Point_3;
  CGAL::make_tetrahedron(P(8, 0, 0), P(6, 2, 2), P(3, 2, -1), P(4, -2, -2), mesh);
}

template <class K>
void expect_worst_vertex()
{
  using Mesh = CGAL::Surface_mesh<typename K::Point_3>;
  using FT = typename K::FT;
  Mesh mesh;
  add_tetrahedron<K>(mesh);
  const typename K::Point_3 center(5, 0, 0);
  const typename K::Sphere_3 sphere(center, FT(9));
  auto n = mesh
             .template add_property_map<CGAL::SM_Vertex_index, typename K::Vector_3>(
               "n", typename K::Vector_3(0, 0, 0))
             .first;
  const auto np = params::vertex_normal_map(n);
  auto d = PN::mesh_deviation(mesh, sphere, np);
  EXPECT_EQ(d.number_of_points, 4u);
  EXPECT_EQ(d.number_of_normals, 0u);
  EXPECT_TRUE(d.points_are_on_shape);
  EXPECT_EQ(d.squared_deviation, 0);
  EXPECT_EQ(d.distance.sup(), 0);
  EXPECT_STREQ(d.advice, "");

  for (auto v : mesh.vertices()) n[v] = mesh.point(v) - center;
  d = PN::mesh_deviation(mesh, sphere, np);
  EXPECT_EQ(d.number_of_normals, 4u);
  EXPECT_TRUE(d.normals_are_exact);
  EXPECT_EQ(d.normal_sine.sup(), 0);

  const CGAL::SM_Vertex_index one(1), two(2), three(3);
  mesh.point(one) = typename K::Point_3(6, 2, FT(2) + FT(1) / FT(16));
  mesh.point(two) = typename K::Point_3(FT(3), FT(2) - FT(1) / FT(16), FT(-1));
  n[three] = typename K::Vector_3(-1, -2, -1);
  d = PN::mesh_deviation(mesh, sphere, np);
  EXPECT_FALSE(certainly(d.points_are_on_shape));
  EXPECT_FALSE(certainly(d.normals_are_exact));
  EXPECT_EQ(is_indeterminate(d.points_are_on_shape), is_rounded_exact<FT>);
  EXPECT_EQ(std::string(d.advice).find("rational_unit_normal()") != std::string::npos,
            is_rounded_exact<FT>);
  EXPECT_EQ(d.farthest_point, one); // farther than the other by the square of 1/16
  EXPECT_EQ(d.squared_deviation, PN::squared_deviation(mesh.point(one), sphere));
  EXPECT_EQ(d.most_turned_normal, three);
  // |(1, 2, 2) x (1, 2, 1)|^2 = 4 + 1
  using Number = PN::Deviation_number<FT>;
  EXPECT_EQ(d.squared_normal_deviation, Number(5) / Number(54));
  EXPECT_LE(d.normal_sine.inf(), std::sqrt(5. / 54));
  EXPECT_GE(d.normal_sine.sup(), std::sqrt(5. / 54));
  const double expected = std::sqrt(1. + 4 + 2.0625 * 2.0625) - 3;
  EXPECT_NEAR(d.distance.inf(), expected, 1e-14);
  EXPECT_NEAR(d.distance.sup(), expected, 1e-14);
}

TEST(Meshes, TheWorstVertexIsFound)
{
  expect_worst_vertex<Double>();
  expect_worst_vertex<CGAL::Simple_cartesian<CGAL::Gmpq>>();
  expect_worst_vertex<CGAL::Exact_predicates_exact_constructions_kernel>();
}

// Without the header sqrt_extension_normals.h lengths of normals are rounded: a point near the sphere proves nothing.
TEST(Meshes, NumbersOfRoundedAveragesRefuteNothing)
{
  using K = CGAL::Simple_cartesian<CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq, CGAL::Tag_true>>;
  const K::Sphere_3 unit({0, 0, 0}, 1);
  CGAL::Surface_mesh<K::Point_3> mesh;
  mesh.add_vertex({0, 1, 0});
  EXPECT_TRUE(PN::mesh_deviation(mesh, unit).points_are_on_shape);
  const K::Point_3 near(K::FT(CGAL::Gmpq(1 + ulp)), 0, 0);
  mesh.add_vertex(near);
  EXPECT_TRUE(is_indeterminate(PN::is_on(near, unit)));
  EXPECT_TRUE(certainly_not(PN::is_on(near, unit, 0.)));
  const auto d = PN::mesh_deviation(mesh, unit);
  EXPECT_TRUE(is_indeterminate(d.points_are_on_shape));
  EXPECT_TRUE(certainly(d.normals_are_exact)); // there is none
  EXPECT_NE(std::string(d.advice).find("sqrt_extension_normals.h"), std::string::npos);
  EXPECT_NE(std::string(d.advice).find("rational_unit_normal()"), std::string::npos);
}

TEST(Meshes, OtherMeshTypesAndPointMaps)
{
  CGAL::Polyhedron_3<Double, CGAL::Polyhedron_items_with_id_3> mesh;
  add_tetrahedron<Double>(mesh);
  const Double::Sphere_3 sphere({5, 0, 0}, 9);
  EXPECT_TRUE(PN::mesh_deviation(mesh, sphere).points_are_on_shape);
  std::size_t id = 0;
  for (auto v : vertices(mesh)) v->id() = id++;
  std::vector<Double::Point_3> moved(4, Double::Point_3(5, 3, 0));
  moved[2] = Double::Point_3(5, 4, 0);
  const auto map = boost::make_iterator_property_map(moved.begin(), get(boost::vertex_index, mesh));
  const auto d = PN::mesh_deviation(mesh, sphere, params::vertex_point_map(map));
  EXPECT_FALSE(d.points_are_on_shape);
  EXPECT_EQ(d.farthest_point->id(), 2u);
}

// Each vertex has a square root of its own; numbers with two of them throw.
TEST(Meshes, NumbersOfDifferentFieldsDoNotMeet)
{
  CGAL::Surface_mesh<Rooted::Point_3> mesh;
  const auto root = [](int d, int r) { return One_root_number::root(CGAL::Gmpq(1, d), r); };
  mesh.add_vertex({root(2, 2), root(2, 2), 0});
  mesh.add_vertex({root(3, 3), root(3, 3), root(3, 3)});
  mesh.add_vertex({root(5, 5), CGAL::Gmpq(0), root(5, 20)});
  const Rooted::Sphere_3 unit({0, 0, 0}, 1);
  auto d = PN::mesh_deviation(mesh, unit);
  EXPECT_EQ(d.number_of_points, 3u);
  EXPECT_TRUE(d.points_are_on_shape);
  for (CGAL::SM_Vertex_index v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + Rooted::Vector_3(CGAL::Gmpq(int(v + 1), 1024), 0, 0);
  d = PN::mesh_deviation(mesh, unit);
  EXPECT_FALSE(d.points_are_on_shape);
  EXPECT_EQ(d.farthest_point, CGAL::SM_Vertex_index(2)); // 3/sqrt(5) > 2/sqrt(3) > 1/sqrt(2)
}

TEST(Meshes, IntervalsOfASubdividedMesh)
{
  CGAL::Surface_mesh<Interval::Point_3> mesh;
  add_tetrahedron<Interval>(mesh);
  auto n = mesh.add_property_map<CGAL::SM_Vertex_index, Interval::Vector_3>("n").first;
  for (auto v : mesh.vertices()) n[v] = mesh.point(v) - Interval::Point_3(5, 0, 0);
  const auto np = params::vertex_normal_map(n);
  PN::subdivide(mesh, PN::Loop_scheme(), np);
  auto d = PN::mesh_deviation(mesh, Interval::Sphere_3({5, 0, 0}, 9), np);
  EXPECT_TRUE(is_indeterminate(d.points_are_on_shape));
  EXPECT_TRUE(is_indeterminate(d.normals_are_exact));
  EXPECT_LT(d.distance.sup(), 1e-12);
  EXPECT_LT(d.normal_sine.sup(), 1e-6);
  d = PN::mesh_deviation(mesh, Interval::Sphere_3({5, 0, 0}, 9.0001), np);
  EXPECT_TRUE(certainly_not(d.points_are_on_shape));
}

// --- curves ---

TEST(Curves, ItemsOfAllKinds)
{
  using P = Double::Point_2;
  using V = Double::Vector_2;
  const Double::Circle_2 circle(P(1, 1), 25);
  const std::vector<P> points = {{4, 5}, {6, 1}, {5, 4}};
  const auto bare = PN::curve_deviation(points, circle);
  EXPECT_TRUE(bare.points_are_on_shape);
  EXPECT_EQ(bare.number_of_points, 3u);
  EXPECT_EQ(bare.number_of_normals, 0u);

  std::vector<std::pair<P, V>> pairs = {{{4, 5}, {3, 4}}, {{6, 1}, {0, 0}}, {{5, 4}, {4, 3.5}}};
  const auto d = PN::curve_deviation(pairs, circle);
  EXPECT_TRUE(d.points_are_on_shape);
  EXPECT_EQ(d.number_of_normals, 2u);
  EXPECT_FALSE(d.normals_are_exact);
  EXPECT_EQ(d.most_turned_normal, 2u);
  EXPECT_EQ(d.squared_normal_deviation, Q(4) / (Q(25) * Q(28.25))); // 4 * 3.5 - 3 * 4 = 2
  pairs[1].first = P(6.5, 1);
  EXPECT_EQ(PN::curve_deviation(pairs, circle).farthest_point, 1u);

  const std::vector<std::pair<V, P>> swapped = {{{3, 4}, {4, 5}}, {{1, 0}, {6, 1}}};
  using Item = std::pair<V, P>;
  const auto s = PN::curve_deviation(swapped, circle,
                                     params::point_map(CGAL::Second_of_pair_property_map<Item>())
                                       .normal_map(CGAL::First_of_pair_property_map<Item>()));
  EXPECT_TRUE(s.points_are_on_shape && s.normals_are_exact);
  EXPECT_EQ(s.number_of_normals, 2u);
}

TEST(Curves, NothingAtAll)
{
  const auto d = PN::curve_deviation(std::vector<Double::Point_3>(), Shapes<Double>().circle_3);
  EXPECT_EQ(d.number_of_points, 0u);
  EXPECT_TRUE(d.points_are_on_shape);
}

// --- errors ---

TEST(Errors, NameThePoint)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Double::Point_3> points = {{1, 2, 3}, {1, nan, 3}};
  messages::expect_refused([&] { PN::curve_deviation(points, Shapes<Double>().sphere); },
                           {"point 1 "});
  EXPECT_THROW(PN::is_on(points[1], Shapes<Double>().sphere), std::invalid_argument);
  // beyond the range of double, but a number
  using Long = CGAL::Simple_cartesian<long double>;
  EXPECT_TRUE(certainly_not(PN::is_on(Long::Point_3(1e400L, 0, 0), Shapes<Double>().sphere)));
}

TEST(Errors, WhatHasNoMeaning)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Double::Point_3 p(1, 2, 3);
  const Double::Sphere_3 sphere = Shapes<Double>().sphere;
  for (const double tolerance : {-1e-9, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(PN::is_on(p, sphere, tolerance), std::invalid_argument) << tolerance;
  EXPECT_THROW(PN::squared_normal_deviation(Double::Vector_3(0, 0, 0), p, sphere),
               std::invalid_argument);
  EXPECT_THROW(PN::is_on(p, Double::Sphere_3(Double::Point_3(nan, 0, 0), 1)),
               std::invalid_argument);
  EXPECT_THROW(PN::is_on(p, Double::Sphere_3(p, std::numeric_limits<double>::infinity())),
               std::invalid_argument);
}

TEST(Errors, DegenerateShapes)
{
  const Double::Point_3 p(1, 2, 3);
  EXPECT_THROW(PN::is_on(p, Double::Sphere_3(p, 0)), std::invalid_argument);
  const Double::Line_3 none(p, Double::Vector_3(0, 0, 0)), axis(p, Double::Vector_3(0, 0, 1));
  EXPECT_THROW(PN::is_on(p, PN::Cylinder_3<Double>(none, 1)), std::invalid_argument);
  EXPECT_THROW(PN::is_on(p, PN::Cylinder_3<Double>(axis, -1)), std::invalid_argument);
  EXPECT_THROW(PN::is_on(p, Double::Plane_3(0, 0, 0, 1)), std::invalid_argument);
}

} // namespace
