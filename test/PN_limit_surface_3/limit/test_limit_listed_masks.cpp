// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Masks that differ in the first rounds: their limits against the reference rules; and normals of curves from a sphere.

#include "Curve_cases.h"
#include "reference/Curve_limit.h"
#include "support/Exact_rational.h"

#include <CGAL/PN_curves/curve_limit_points.h>

namespace {

using namespace curve_cases;
using Mask = PN::Univariate_mask<double>;
using Schemes = std::vector<reference::Curve_scheme>;

Mask listed(const reference::Curve_scheme& s)
{
  return with_mask(s, [](const auto& mask) {
    return Mask(mask.first_index(), mask.template coefficients<double>());
  });
}

std::vector<Mask> listed(const Schemes& schemes)
{
  std::vector<Mask> masks;
  for (const auto& s : schemes) masks.push_back(listed(s));
  return masks;
}

Curve_3<Double> wave(int n)
{
  Curve_3<Double> polygon;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * CGAL_PI * i / n + .1 * (i % 3), b = a + .12 * (i * i % 5 - 2);
    polygon.emplace_back(Double::Point_3(3 + std::cos(a), std::sin(a), .3 * (i % 4)),
                         Double::Vector_3(std::cos(b), std::sin(b), 0));
  }
  return polygon;
}

auto close()
{
  return PN::parameters::tolerance(1e-13).max_depth(30u).curve_normals(true);
}

template <class Vector>
reference::Vector to_vector(const Vector& p)
{
  return {p.x(), p.y(), p.z()};
}

const Schemes lists[] = {{{false, 3}},
                         {{false, 5}, {false, 3}},
                         {{true, 2}, {false, 3}, {true, 3}, {false, 5}},
                         {{false, 2}, {false, 4}},
                         {{false, 4}, {false, 2}, {false, 2}}};

TEST(Limits_of_listed_masks, AreThoseOfTheReference)
{
  const Curve_3<Double> polygon = wave(12);
  for (const Schemes& schemes : lists)
    for (const Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
      const auto [limits, report] =
        PN::curve_limit_points(polygon, PN::level_dependent_mask(listed(schemes)), end, close());
      const bool is_primal = schemes.front().primal();
      ASSERT_EQ(limits.size(), end == Curve_end::closed || is_primal ? 12u : 11u);
      reference::Values values;
      for (const auto& [p, n] : polygon) {
        values.points.push_back(to_vector(p));
        values.normals.push_back(to_vector(n).normalized());
      }
      for (std::size_t k = 0; k + 1 < schemes.size(); ++k)
        values = reference::pn_round(
          reference::curve_matrix(schemes[k], long(values.points.size()), reference_end(end)),
          values);
      reference::Curve_limit_by_rounds brute(schemes.back(), schemes.back(), false);
      for (std::size_t i = 0; i < limits.size(); ++i) {
        const auto& l = limits[i];
        EXPECT_EQ(l.parameter, double(i) + (is_primal ? 0 : .5));
        if (i % 3 == 1) continue; // the reference takes its time
        const auto expected = brute(values, long(i) << (schemes.size() - 1), reference_end(end));
        EXPECT_LE(double((to_vector(l.point) - expected.point).norm()), 2e-12) << i;
        EXPECT_LE(double((to_vector(l.control_normal) - expected.control_normal).norm()), 2e-12);
        if (l.has_tangent) {
          EXPECT_LE(double((to_vector(l.tangent) - expected.tangent).norm()), 2e-3);
        }
      }
    }
}

// whole stencils only: where these reach, ends make no difference
TEST(Limits_of_listed_masks, AwayFromOpenEndsAreThoseOfReflectedOnes)
{
  const Curve_3<Double> polygon = wave(24);
  for (const Schemes& schemes : lists) {
    const auto mask = PN::level_dependent_mask(listed(schemes));
    std::map<double, Double::Point_3> reflected;
    for (const auto& l : PN::curve_limit_points(polygon, mask, Curve_end::reflect, close()).first)
      reflected.emplace(l.parameter, l.point);
    const auto limits = PN::curve_limit_points(polygon, mask, Curve_end::none, close()).first;
    ASSERT_GE(limits.size(), 10u);
    ASSERT_LT(limits.size(), reflected.size());
    double last = -1;
    for (const auto& l : limits) {
      EXPECT_GT(l.parameter, last);
      last = l.parameter;
      ASSERT_EQ(reflected.count(l.parameter), 1u) << l.parameter;
      EXPECT_LE((l.point - reflected.at(l.parameter)).squared_length(), 1e-24) << l.parameter;
    }
  }
}

TEST(Limits_of_listed_masks, LinearAndExact)
{
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  Curve_3<Exact> polygon;
  for (int i = 0; i < 8; ++i)
    polygon.emplace_back(Exact::Point_3(i, i * i % 5, i % 3), Exact::Vector_3(0, 0, 0));
  const auto mask = PN::linear(PN::level_dependent_mask(
    std::vector<PN::B_spline_mask>{PN::B_spline_mask(1), PN::B_spline_mask(3)}));
  const auto limits = PN::curve_limit_points(polygon, mask, Curve_end::closed).first;
  ASSERT_EQ(limits.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) { // (a + 4 b + c)/6 of a middle, the point and a middle
    const auto &p = polygon[(i + 7) % 8].first, &q = polygon[i].first,
               &r = polygon[(i + 1) % 8].first;
    for (int k = 0; k < 3; ++k) EXPECT_EQ(limits[i].point[k], (p[k] + 10 * q[k] + r[k]) / 12);
  }
  const auto curve =
    PN::subdivide_curve(polygon, mask, Curve_end::closed, params::number_of_iterations(3));
  EXPECT_EQ(
    curve, PN::subdivide_curve(
             PN::subdivide_curve(polygon, PN::linear(PN::B_spline_mask(1)), Curve_end::closed),
             PN::linear(PN::B_spline_mask(3)), Curve_end::closed, params::number_of_iterations(2)));
}

TEST(Limits_of_listed_masks, AreRefused)
{
  EXPECT_THROW(PN::level_dependent_mask(std::vector<Mask>()), std::invalid_argument);
  const auto mixed = PN::level_dependent_mask(listed(Schemes{{false, 3}, {false, 2}}));
  EXPECT_THROW(PN::curve_limit_points(wave(8), mixed, Curve_end::closed), std::invalid_argument);
  const auto mask = PN::level_dependent_mask(listed(lists[1]));
  EXPECT_TRUE(PN::curve_limit_points(Curve_3<Double>(), mask, Curve_end::closed).first.empty());
}

// --- normals from a sphere ---

TEST(Spherical_control_normals, KeepTheSphere)
{
  const Double::Point_3 center(1, -2, .5);
  std::vector<Double::Point_3> points;
  for (int i = 0; i < 9; ++i) { // a curve that goes up and down on the sphere of radius 3
    const double a = 2 * CGAL_PI * i / 9 + .2 * (i % 2), z = .4 * std::sin(2 * a + .3);
    const double r = std::sqrt(1 - z * z);
    points.push_back(center + 3 * Double::Vector_3(r * std::cos(a), r * std::sin(a), z));
  }
  const auto polygon = PN::spherical_control_normals(points, center);
  for (const auto& [p, n] : polygon) EXPECT_LE((n - (p - center) / 3).squared_length(), 1e-30);
  for (const Curve_end end : {Curve_end::closed, Curve_end::reflect})
    for (const auto& [p, n] :
         PN::subdivide_curve(polygon, PN::B_spline_mask(3), end, params::number_of_iterations(5))) {
      EXPECT_NEAR((p - center).squared_length(), 9, 1e-13);
      EXPECT_LE((n - (p - center) / 3).squared_length(), 1e-28);
    }
  const auto listed_masks = PN::level_dependent_mask(listed(lists[2]));
  for (const auto& l : PN::curve_limit_points(polygon, listed_masks, Curve_end::closed).first)
    EXPECT_NEAR((l.point - center).squared_length(), 9, 1e-13);
}

TEST(Spherical_control_normals, AreDirectionsFromTheCenter)
{
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const std::vector<std::pair<Exact::Point_3, Exact::Vector_3>> polygon{
    {{1, 2, 3}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 1}}, {{3, 0, 4}, {1, 0, 0}}};
  const auto found = PN::spherical_control_normals(polygon, Exact::Point_3(0, 0, 0));
  ASSERT_EQ(found.size(), 3u);
  for (const auto& [p, n] : found)
    EXPECT_EQ(CGAL::cross_product(n, p - CGAL::ORIGIN), CGAL::NULL_VECTOR);
  EXPECT_EQ(found[1].second, CGAL::NULL_VECTOR);
  EXPECT_NEAR(CGAL::to_double(found[0].second.squared_length()), 1, 1e-15);
  EXPECT_NEAR(CGAL::to_double(found[2].second.z()), .8, 1e-15);
  EXPECT_TRUE(PN::spherical_control_normals(Curve_3<Double>(), Double::Point_3(0, 0, 0)).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(PN::spherical_control_normals(wave(3), Double::Point_3(0, nan, 0)),
               std::invalid_argument);
  EXPECT_THROW(PN::spherical_control_normals(std::vector<Double::Point_3>{{0, 0, 0}, {0, nan, 0}},
                                             Double::Point_3(0, 0, 0)),
               std::invalid_argument);
}

} // namespace
