// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Rounds of curve masks against their closed forms: which points there are, the linear twins, the
// PN rule in its matrix form, another mask for the normals, masks of the user's own.

#include "Curve_cases.h"

#include "reference/PN_rule.h"
#include <CGAL/PN_curves/curve_limit_points.h>

using namespace curve_cases;

namespace {

const Curve_end all_ends[] = {Curve_end::closed, Curve_end::reflect, Curve_end::none};

// random points, unit normals and here and there none; coordinates below 1
Curve_3<Double> random_polygon(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(-1, 1);
  Curve_3<Double> polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const Double::Vector_3 v(1.5 + x(random), x(random), x(random));
    const Double::Vector_3 normal =
      i % 7 == 5 ? Double::Vector_3(0, 0, 0) : v / std::sqrt(v.squared_length());
    polygon.emplace_back(Double::Point_3(x(random), x(random), x(random)), normal);
  }
  return polygon;
}

// the largest difference in points and normals, infinite if their numbers differ
Real distance(const Curve_3<Double>& curve, const reference::Values& expected)
{
  const reference::Values v = values(curve);
  if (v.points.size() != expected.points.size()) return std::numeric_limits<Real>::infinity();
  Real d = 0;
  for (std::size_t i = 0; i < v.points.size(); ++i)
    for (const Real x :
         {(v.points[i] - expected.points[i]).norm(), (v.normals[i] - expected.normals[i]).norm()})
      if (!(x <= d)) d = x;
  return d;
}

TEST(Curves, NumberOfPoints)
{
  for (std::size_t n : {20u, 21u, 40u})
    for (const auto& s : schemes()) {
      const std::size_t m = static_cast<std::size_t>(s.parameter);
      const auto polygon = random_polygon(n, 1);
      EXPECT_EQ(refined(polygon, s, Curve_end::closed).size(), 2 * n) << name_of(s);
      EXPECT_EQ(refined(polygon, s, Curve_end::reflect).size(), 2 * n - (s.primal() ? 1 : 2))
        << name_of(s);
      EXPECT_EQ(refined(polygon, s, Curve_end::none).size(),
                s.interpolating ? 2 * n - 4 * m + 3 : 2 * n - m)
        << name_of(s);
    }
}

TEST(Curves, LinearTwinsAreKnotInsertionAndInterpolation)
{
  for (std::size_t n : {3u, 4u, 7u, 20u})
    for (const auto& s : schemes())
      for (Curve_end end : all_ends) {
        if (end == Curve_end::none && n < 20) continue;
        const auto polygon = random_polygon(n, 2);
        const auto matrix = reference::curve_matrix(s, static_cast<long>(n), reference_end(end));
        EXPECT_LE(distance(linearly_refined(polygon, s, end),
                           reference::linear_round(matrix, values(polygon))),
                  40 * ulp)
          << n << name_of(s, end);
      }
}

TEST(Curves, PointNormalRoundsAreTheMatrixForm)
{
  for (std::size_t n : {5u, 20u})
    for (const auto& s : schemes())
      for (Curve_end end : all_ends) {
        if (end == Curve_end::none && n < 20) continue;
        const auto polygon = random_polygon(n, 3);
        const auto matrix = reference::curve_matrix(s, static_cast<long>(n), reference_end(end));
        EXPECT_LE(distance(refined(polygon, s, end), reference::pn_round(matrix, values(polygon))),
                  1e-12L)
          << n << name_of(s, end);
      }
}

// p = q + w H n, w the same in all rounds; the normals are those of w = 1
TEST(Curves, RoundnessIsAFractionOfTheWay)
{
  for (const Real w : {Real(0), Real(1) / 4, Real(5) / 8, Real(1)})
    for (const auto& s : schemes())
      for (Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
        const auto polygon = random_polygon(14, 3);
        reference::Values expected = values(polygon);
        for (int k = 0; k < 2; ++k) {
          const auto matrix = reference::curve_matrix(s, static_cast<long>(expected.points.size()),
                                                      reference_end(end));
          const reference::Values linear = reference::linear_round(matrix, expected);
          expected = reference::pn_round(matrix, expected);
          for (std::size_t i = 0; i < linear.points.size(); ++i)
            expected.points[i] = linear.points[i] + w * (expected.points[i] - linear.points[i]);
        }
        const auto np = PN::parameters::roundness(static_cast<double>(w)).number_of_iterations(2);
        const auto curve = with_mask(
          s, [&](const auto& mask) { return PN::subdivide_curve(polygon, mask, end, np); });
        EXPECT_LE(distance(curve, expected), 1e-12L) << name_of(s, end) << ", roundness " << w;
        if (w == 1) {
          EXPECT_EQ(curve, refined(polygon, s, end, 2)) << name_of(s, end);
        }
        if (w != 0) continue;
        const auto linear = linearly_refined(polygon, s, end, 2);
        for (std::size_t i = 0; i < curve.size(); ++i)
          EXPECT_EQ(curve[i].first, linear[i].first) << name_of(s, end);
      }
}

TEST(Curves, RoundnessIsFromZeroToOne)
{
  const auto polygon = random_polygon(5, 3);
  for (const double w : {-0.1, 1.1, std::nan("")})
    EXPECT_THROW(PN::subdivide_curve(polygon, PN::B_spline_mask(3), Curve_end::closed,
                                     PN::parameters::roundness(w)),
                 std::invalid_argument)
      << w;
}

// Points of a circle, in the plane and in space, unevenly sampled and without normals, stay on it; so do the limits.
TEST(Curves, NormalsThatAreNotGivenAreEstimated)
{
  for (const bool closed : {true, false}) {
    const Curve_end end = closed ? Curve_end::closed : Curve_end::reflect;
    const auto angles = uneven_angles(9, 2, closed ? 2 * 3.141592653589793L : 2.5L, closed, 4);
    std::vector<Double::Point_2> plane;
    std::vector<Double::Point_3> space;
    for (const auto& [p, n] : circle_2(angles, 3)) {
      plane.push_back(p);
      space.emplace_back(0.6 * p.x() + 1, 0.8 * p.x() - 2, p.y() + 3);
    }
    const auto off = [](const auto& p, const auto& center) {
      return std::abs(std::sqrt(CGAL::squared_distance(p, center)) - 3);
    };
    const Double::Point_2 center_2(0, 0);
    const Double::Point_3 center_3(1, -2, 3);
    for (const auto& s : schemes())
      with_mask(s, [&](const auto& mask) {
        if (!closed && !s.primal()) return; // ends that are no mirror images
        const auto np = params::number_of_iterations(3);
        double largest = 0;
        std::size_t number = 0;
        const auto measure = [&](const auto& points, const auto& center) {
          for (const auto& item : PN::subdivide_curve(points, mask, end, np)) {
            largest = (std::max)(largest, off(item.first, center));
            ++number;
          }
          for (const auto& limit : PN::curve_limit_points(points, mask, end).first)
            largest = (std::max)(largest, off(limit.point, center));
        };
        measure(plane, center_2);
        measure(space, center_3);
        EXPECT_GE(number, 2u * 57u);
        if (closed) {
          EXPECT_LE(largest, 1e-12) << name_of(s, end);
        } else
          EXPECT_LE(largest, 0.5) << name_of(s, end);
        // linear masks need none
        EXPECT_EQ(PN::subdivide_curve(plane, PN::linear(mask), end, np).size(), number / 2);
      });
  }
}

TEST(Curves, NormalsByAnotherMask)
{
  const auto polygon = random_polygon(12, 4);
  for (Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
    const auto curve = PN::subdivide_curve(
      polygon, PN::with_normal_mask(PN::B_spline_mask(3), PN::Dubuc_Deslauriers_mask(4)), end);
    const auto a = reference::curve_matrix({false, 3}, 12, reference_end(end));
    const auto b = reference::curve_matrix({true, 2}, 12, reference_end(end));
    reference::Values expected;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      const auto value = reference::pn_rule(a.row(i), b.row(i), values(polygon));
      expected.points.push_back(value.point);
      expected.normals.push_back(value.normal);
    }
    EXPECT_LE(distance(curve, expected), 1e-13L);
  }
  // rows of both masks must exist: the 4-point mask's reach from old point 1 to 10, the cubic's are
  // more
  EXPECT_EQ(PN::subdivide_curve(
              polygon, PN::with_normal_mask(PN::B_spline_mask(3), PN::Dubuc_Deslauriers_mask(4)),
              Curve_end::none)
              .size(),
            19u);
}

TEST(Curves, ManyRoundsAreRoundsOneByOne)
{
  for (const auto& s : schemes())
    for (Curve_end end : all_ends) {
      const auto polygon = random_polygon(23, 5);
      auto curve = polygon;
      for (int k = 0; k < 4; ++k) curve = refined(curve, s, end);
      EXPECT_EQ(refined(polygon, s, end, 4), curve) << name_of(s, end);
    }
}

TEST(Curves, NoRoundsKeepThePolygon)
{
  const auto polygon = random_polygon(6, 6);
  EXPECT_EQ(refined(polygon, {false, 3}, Curve_end::closed, 0), polygon);
}

TEST(Curves, ReflectedRows)
{
  // the points are the unit vectors in turn: a point's coordinates are its weights
  const Curve_3<Double> polygon = {{{1, 0, 0}, {0, 0, 1}}, {{0, 1, 0}, {0, 0, 1}},
                                   {{0, 0, 1}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 1}},
                                   {{0, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 1}}};
  const auto four = linearly_refined(polygon, {true, 2}, Curve_end::reflect);
  EXPECT_EQ(four[1].first, Double::Point_3(7. / 16, 10. / 16, -1. / 16));
  const auto cubic = linearly_refined(polygon, {false, 3}, Curve_end::reflect);
  EXPECT_EQ(cubic[0].first, polygon[0].first);
  EXPECT_EQ(cubic[1].first, Double::Point_3(0.5, 0.5, 0));
  EXPECT_EQ(cubic[2].first, Double::Point_3(1. / 8, 6. / 8, 1. / 8));
}

TEST(Curves, PrimalMasksKeepTheEndsOfOpenPolygons)
{
  const auto polygon = random_polygon(9, 7);
  for (const auto& s : schemes()) {
    if (!s.primal()) continue;
    const auto curve = refined(polygon, s, Curve_end::reflect, 5);
    EXPECT_LE(CGAL::squared_distance(curve.front().first, polygon.front().first), 1e-28)
      << name_of(s);
    EXPECT_LE(CGAL::squared_distance(curve.back().first, polygon.back().first), 1e-28)
      << name_of(s);
  }
}

TEST(Curves, InterpolatoryMasksCopyOldPointsBitForBit)
{
  const auto polygon = random_polygon(11, 8);
  for (int half = 2; half <= 5; ++half) {
    const auto curve = refined(polygon, {true, half}, Curve_end::closed, 3);
    for (std::size_t i = 0; i < polygon.size(); ++i) EXPECT_EQ(curve[8 * i], polygon[i]);
  }
}

TEST(Curves, MasksGivenByTheirCoefficients)
{
  const auto polygon = random_polygon(10, 9);
  const PN::Univariate_mask<double> chaikin(-1, {0.25, 0.75, 0.75, 0.25});
  const PN::Univariate_mask<double> four(-3, {-1. / 16, 0, 9. / 16, 1, 9. / 16, 0, -1. / 16});
  for (Curve_end end : all_ends) {
    EXPECT_EQ(PN::subdivide_curve(polygon, chaikin, end), refined(polygon, {false, 2}, end));
    EXPECT_EQ(PN::subdivide_curve(polygon, four, end), refined(polygon, {true, 2}, end));
  }
  // the shifted mask makes the same points of a closed polygon
  const PN::Univariate_mask<double> later(1, {0.25, 0.75, 0.75, 0.25});
  const auto a = PN::subdivide_curve(polygon, chaikin, Curve_end::closed);
  const auto b = PN::subdivide_curve(polygon, later, Curve_end::closed);
  ASSERT_EQ(a.size(), b.size());
  bool found = false;
  for (std::size_t shift = 0; shift < a.size(); ++shift) {
    bool same = true;
    for (std::size_t i = 0; i < a.size(); ++i) same = same && a[(i + shift) % a.size()] == b[i];
    found = found || same;
  }
  EXPECT_TRUE(found);
}

TEST(Curves, ReversedNormalsKeepThePoints)
{
  const auto polygon = random_polygon(10, 10);
  auto reversed = polygon;
  for (auto& [p, n] : reversed) n = -n;
  const auto a = refined(polygon, {true, 2}, Curve_end::closed, 3);
  const auto b = refined(reversed, {true, 2}, Curve_end::closed, 3);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].first, b[i].first);
    EXPECT_EQ(a[i].second, -b[i].second);
  }
}

// trigonometric splines: a regular polygon whose edges span the angle stays one
auto trigonometric_mask(double angle)
{
  return PN::level_dependent_mask([angle](unsigned k) {
    const double c = std::cos(std::ldexp(angle, -static_cast<int>(k)));
    const double side = 1 / (4 + 4 * c);
    return PN::Univariate_mask<double>(-2, {side, 0.5, 1 - 2 * side, 0.5, side});
  });
}

TEST(Level_dependent_mask, KeepsRegularPolygonsWithoutNormals)
{
  // edge midpoints are at cos(angle / 2) of the radius, and the rule puts the vertices there, too
  using Point = CGAL::Simple_cartesian<double>::Point_2;
  using Vector = CGAL::Simple_cartesian<double>::Vector_2;
  const int n = 5;
  const double angle = 2 * std::acos(-1.) / n;
  std::vector<std::pair<Point, Vector>> polygon;
  for (int i = 0; i < n; ++i)
    polygon.emplace_back(Point(std::cos(i * angle), std::sin(i * angle)), Vector(0, 0));
  double radius = 1;
  for (unsigned k = 1; k <= 6; ++k) {
    radius *= std::cos(std::ldexp(angle, -static_cast<int>(k)));
    const auto np = CGAL::parameters::number_of_iterations(k);
    const auto curve =
      PN::subdivide_curve(polygon, trigonometric_mask(angle), PN::Curve_end::closed, np);
    const auto twin =
      PN::subdivide_curve(polygon, linear(trigonometric_mask(angle)), PN::Curve_end::closed, np);
    ASSERT_EQ(curve.size(), std::size_t(n) << k);
    EXPECT_EQ(curve, twin);
    for (const auto& item : curve)
      EXPECT_NEAR(std::sqrt((item.first - CGAL::ORIGIN).squared_length()), radius, 4e-16 * k);
  }
}

TEST(Level_dependent_mask, KeepsTheCircleWithNormals)
{
  using Point = CGAL::Simple_cartesian<double>::Point_2;
  using Vector = CGAL::Simple_cartesian<double>::Vector_2;
  std::vector<std::pair<Point, Vector>> samples;
  for (const double t : {0., 0.9, 1.7, 3.1, 4.4, 5.2})
    samples.emplace_back(Point(std::cos(t), std::sin(t)), Vector(std::cos(t), std::sin(t)));
  const auto curve = PN::subdivide_curve(samples, trigonometric_mask(1.5), PN::Curve_end::closed,
                                         CGAL::parameters::number_of_iterations(5));
  for (const auto& item : curve)
    EXPECT_NEAR((item.first - CGAL::ORIGIN).squared_length(), 1, 4e-15);
}

TEST(Level_dependent_mask, IsTheMaskWhereItDoesNotDepend)
{
  using Point = CGAL::Simple_cartesian<double>::Point_2;
  using Vector = CGAL::Simple_cartesian<double>::Vector_2;
  const std::vector<std::pair<Point, Vector>> open{{{0, 0}, {0, 1}},    {{1, 0.5}, {0.2, 1}},
                                                   {{2, 0}, {0.5, 1}},  {{3, 1}, {0, 1}},
                                                   {{4, 1}, {-0.3, 1}}, {{5, 3}, {-0.3, 1}}};
  const auto mask = PN::with_normal_mask(PN::B_spline_mask(3), PN::Dubuc_Deslauriers_mask(4));
  const auto dependent = PN::level_dependent_mask([&](unsigned) { return mask; });
  for (const auto end : {PN::Curve_end::closed, PN::Curve_end::reflect, PN::Curve_end::none}) {
    const auto np = CGAL::parameters::number_of_iterations(3);
    EXPECT_EQ(PN::subdivide_curve(open, dependent, end, np),
              PN::subdivide_curve(open, mask, end, np));
  }
  const auto wrong = PN::level_dependent_mask([](unsigned k) {
    return PN::with_normal_mask(PN::B_spline_mask(3), PN::B_spline_mask(k == 2 ? 2 : 3));
  });
  EXPECT_THROW(PN::subdivide_curve(open, wrong, PN::Curve_end::closed,
                                   CGAL::parameters::number_of_iterations(2)),
               std::invalid_argument);
}

} // namespace
