// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limits of curves against B-splines in closed form, against many rounds of the reference rules, on circles and
// cylinders, between levels, in exact numbers.

#include "Curve_cases.h"
#include "Extent.h"
#include "Messages.h"
#include "reference/Curve_limit.h"
#include "support/Options.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_curves/curve_limit_points.h>

namespace {

using namespace curve_cases;

constexpr Curve_end all_ends[] = {Curve_end::closed, Curve_end::reflect, Curve_end::none};

test_options::Curve_limit_options close(double tolerance, double normal_tolerance = 1e-7)
{
  test_options::Curve_limit_options options;
  options.tolerance = tolerance;
  options.normal_tolerance = normal_tolerance;
  options.max_depth = 30;
  options.curve_normals = options.curvatures = true;
  return options;
}

// a wave about a helix; its normals are turned to and fro
Curve_3<Double> wave(int n)
{
  Curve_3<Double> polygon;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * CGAL_PI * i / n + .1 * (i % 3), b = a + .12 * (i * i % 5 - 2);
    const double r = 1 + .1 * (i % 2);
    polygon.emplace_back(Double::Point_3(3 + r * std::cos(a), r * std::sin(a), .3 * (i % 4)),
                         Double::Vector_3(std::cos(b), std::sin(b), .1 * (i % 3)));
  }
  for (auto& item : polygon) item.second = item.second / std::sqrt(item.second.squared_length());
  return polygon;
}

template <class Point_or_vector>
reference::Vector to_vector(const Point_or_vector& p)
{
  return {p.x(), p.y(), p.z()};
}

// the cardinal B-spline about 0, and its derivatives
Real b_spline(int degree, Real x, int derivative = 0)
{
  if (derivative > 0)
    return b_spline(degree - 1, x + Real(1) / 2, derivative - 1) -
           b_spline(degree - 1, x - Real(1) / 2, derivative - 1);
  if (degree == 0) return x >= -Real(1) / 2 && x < Real(1) / 2 ? 1 : 0;
  const Real half = Real(degree + 1) / 2;
  return ((half + x) * b_spline(degree - 1, x + Real(1) / 2) +
          (half - x) * b_spline(degree - 1, x - Real(1) / 2)) /
         degree;
}

TEST(Curve_limits, OfLinearBSplinesAreThoseOfTheirPolynomials)
{
  const Curve_3<Double> polygon = wave(11);
  const reference::Values control = values(polygon);
  for (int degree = 2; degree <= 9; ++degree) {
    const auto [limits, report] = PN::curve_limit_points(
      polygon, PN::linear(PN::B_spline_mask(degree)), Curve_end::closed, close(1e-15).pack());
    ASSERT_EQ(limits.size(), 11u);
    EXPECT_EQ(report.error, 0);
    for (const auto& l : limits) {
      reference::Vector derivatives[3];
      for (int k = 0; k < 3; ++k) {
        derivatives[k].setZero();
        for (int j = -10; j < 21; ++j)
          if (degree > k)
            derivatives[k] += b_spline(degree, Real(l.parameter) - j, k) *
                              control.points[std::size_t((j + 11) % 11)];
      }
      const auto& [p, d, dd] = derivatives;
      EXPECT_LE(double((to_vector(l.point) - p).norm()), 20 * ulp) << degree;
      ASSERT_TRUE(l.has_tangent);
      EXPECT_LE(double((to_vector(l.tangent) - d.normalized()).norm()), 40 * ulp) << degree;
      EXPECT_EQ(l.has_curvature, degree >= 3);
      EXPECT_EQ(l.control_normal, CGAL::NULL_VECTOR);
      if (!l.has_curvature) continue;
      const Real curvature = d.cross(dd).norm() / (d.norm() * d.squaredNorm());
      EXPECT_NEAR(l.curvature, double(curvature), 1e-13 * (1 + double(curvature))) << degree;
    }
  }
}

struct Tolerances
{
  double point, tangent, curvature;
};

void expect_brute_force(
  const Curve_3<Double>& polygon,
  const std::vector<PN::Curve_limit_point<Double::Point_3, Double::Vector_3>>& limits,
  reference::Curve_limit_by_rounds& brute, Curve_end end, const Tolerances& tolerances,
  const std::string& name)
{
  const reference::Values control = values(polygon);
  for (const auto& l : limits) {
    const auto v = static_cast<long>(l.parameter);
    const reference::Curve_limit expected = brute(control, v, reference_end(end));
    const std::string at = name + " at " + std::to_string(l.parameter);
    EXPECT_LE(double((to_vector(l.point) - expected.point).norm()), tolerances.point) << at;
    EXPECT_LE(double((to_vector(l.control_normal) - expected.control_normal).norm()),
              tolerances.point)
      << at;
    if (l.has_tangent) {
      EXPECT_LE(double((to_vector(l.tangent) - expected.tangent).norm()), tolerances.tangent) << at;
      EXPECT_LE(std::abs(l.tangent * l.normal), 4 * ulp) << at;
    }
    if (l.has_curvature) {
      EXPECT_NEAR(l.curvature, double(expected.curvature),
                  tolerances.curvature * (1 + double(expected.curvature)))
        << at;
    }
  }
}

// Tangents to the same tolerance whatever the roundness, that is, they converge no slower than with 1.
void expect_limits_of_rounds(const reference::Curve_scheme& s, Curve_end end, double roundness)
{
  const Curve_3<Double> polygon = wave(12);
  const auto [limits, report] = with_mask(s, [&](const auto& mask) {
    return PN::curve_limit_points(
      polygon, mask, end,
      PN::parameters::join(close(1e-13).pack(), PN::parameters::roundness(roundness)));
  });
  ASSERT_FALSE(limits.empty());
  if (end != Curve_end::none) {
    EXPECT_EQ(limits.size(), end == Curve_end::closed || s.primal() ? 12u : 11u);
  }
  EXPECT_EQ(report.number_of_stand_ins, 0u);
  EXPECT_EQ(limits[limits.size() / 2].has_curvature, s.parameter > 2);
  reference::Curve_limit_by_rounds brute(s, s, false, Real(roundness));
  // the curvature of six points converges by 0.57 a round, and the others' by 1/4, at ends 1/2
  expect_brute_force(polygon, limits, brute, end, {2e-12, 1e-6, s.interpolating ? .02 : .002},
                     name_of(s, end));
}

TEST(Curve_limits, EqualBruteForce)
{
  for (const auto& s : schemes())
    for (const Curve_end end : all_ends) {
      if (end == Curve_end::none && s.parameter > (s.interpolating ? 3 : 5)) continue; // too short
      if (tests_are_full || s.parameter <= 4) expect_limits_of_rounds(s, end, 1);
    }
}

TEST(Curve_limits, OfARoundnessEqualBruteForce)
{
  for (const auto& s : schemes())
    for (const Curve_end end : {Curve_end::closed, Curve_end::reflect})
      if (tests_are_full || s.parameter <= 4) expect_limits_of_rounds(s, end, .5);
}

// tangents and curvatures, too, although those of a point-normal curve are found in another way
TEST(Curve_limits, OfRoundnessZeroAreThoseOfLinearTwins)
{
  const Curve_3<Double> polygon = wave(12);
  for (const auto& s : schemes())
    for (const Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
      const auto linear =
        with_mask(s, [&](const auto& mask) {
          return PN::curve_limit_points(polygon, PN::linear(mask), end, close(1e-13).pack());
        }).first;
      const auto limits =
        with_mask(s, [&](const auto& mask) {
          return PN::curve_limit_points(
            polygon, mask, end,
            PN::parameters::join(close(1e-13).pack(), PN::parameters::roundness(0.)));
        }).first;
      ASSERT_EQ(limits.size(), linear.size());
      for (std::size_t i = 0; i < limits.size(); ++i) {
        EXPECT_LE(CGAL::squared_distance(limits[i].point, linear[i].point), 1e-26);
        EXPECT_LE((limits[i].tangent - linear[i].tangent).squared_length(), 1e-16);
        EXPECT_NEAR(limits[i].curvature, linear[i].curvature, 1e-5) << name_of(s, end);
      }
    }
}

TEST(Curve_limits, OfLinearTwinsEqualBruteForce)
{
  const Curve_3<Double> polygon = wave(12);
  for (const auto& s : schemes())
    for (const Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
      const auto limits = with_mask(s, [&](const auto& mask) {
        return PN::curve_limit_points(polygon, PN::linear(mask), end, close(1e-13).pack()).first;
      });
      reference::Curve_limit_by_rounds brute(s, s, true);
      expect_brute_force(polygon, limits, brute, end, {2e-13, 1e-7, 2e-3}, name_of(s, end));
    }
}

TEST(Curve_limits, WithAnotherMaskForTheNormalsEqualBruteForce)
{
  const Curve_3<Double> polygon = wave(12);
  const auto expect = [&](const reference::Curve_scheme& of_points,
                          const reference::Curve_scheme& of_normals, const auto& mask,
                          const char* name) {
    for (const Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
      reference::Curve_limit_by_rounds brute(of_points, of_normals, false);
      expect_brute_force(polygon,
                         PN::curve_limit_points(polygon, mask, end, close(1e-13).pack()).first,
                         brute, end, {2e-12, 1e-6, .01}, name);
    }
  };
  const PN::B_spline_mask cubic(3), quintic(5);
  const PN::Dubuc_Deslauriers_mask four_points(4);
  expect({false, 3}, {true, 2}, PN::with_normal_mask(cubic, four_points),
         "cubic, normals by 4 points");
  expect({true, 2}, {false, 5}, PN::with_normal_mask(four_points, quintic),
         "4 points, normals by quintics");
}

TEST(Curve_limits, OfCirclesAreOnThem)
{
  for (const bool closed : {true, false}) {
    const Curve_2<Double> circle = circle_2(uneven_angles(9, 3, closed ? 6.28L : 4, closed, 3), 2);
    for (const auto& s : schemes()) {
      const auto limits = with_mask(s, [&](const auto& mask) {
        return PN::curve_limit_points(circle, mask, closed ? Curve_end::closed : Curve_end::reflect,
                                      close(1e-14).pack())
          .first;
      });
      for (const auto& l : limits) {
        const auto radial = (l.point - CGAL::ORIGIN) / 2;
        EXPECT_LE(double(radius_error(l.point, 2)), 4 * ulp) << name_of(s);
        EXPECT_LE((l.control_normal - radial).squared_length(), 64 * ulp * ulp) << name_of(s);
        ASSERT_TRUE(l.has_tangent);
        EXPECT_LE((l.normal - radial).squared_length(), 1e-16) << name_of(s);
        EXPECT_GT(l.tangent * Double::Vector_2(-radial.y(), radial.x()), 0); // counterclockwise
        if (!l.has_curvature) continue;
        EXPECT_NEAR(l.curvature, .5, s.interpolating ? 1e-3 : 1e-6) << name_of(s);
      }
    }
  }
}

TEST(Curve_limits, OfHelicesAreOnTheirCylinders)
{
  const Curve_3<Double> curve = helix(uneven_angles(9, 3, 9, false, 4), 2, .3L);
  for (const auto& s : schemes()) {
    const auto limits = with_mask(s, [&](const auto& mask) {
      return PN::curve_limit_points(curve, mask, Curve_end::reflect, close(1e-14).pack()).first;
    });
    for (const auto& l : limits)
      EXPECT_LE(double(cylinder_error(l.point, 2)), 8 * ulp) << name_of(s);
  }
}

// in the plane, with signs, and normals of linear curves on the right
TEST(Curve_limits, CurvatureHasASignInThePlane)
{
  Curve_2<Double> polygon = circle_2(uneven_angles(9, 2, 6.28L, true, 3), 2);
  const PN::B_spline_mask cubic(3);
  for (const bool reversed : {false, true}) {
    for (const auto& l :
         PN::curve_limit_points(polygon, cubic, Curve_end::closed, close(1e-12).pack()).first)
      EXPECT_NEAR(l.curvature, reversed ? -.5 : .5, 1e-6);
    for (const auto& l :
         PN::curve_limit_points(polygon, PN::linear(cubic), Curve_end::closed, close(1e-12).pack())
           .first)
      EXPECT_GT((reversed ? -1 : 1) * l.normal * (l.point - CGAL::ORIGIN), 0);
    std::reverse(polygon.begin(), polygon.end());
  }
}

TEST(Curve_limits, AreTheSameAtEveryLevel)
{
  const Curve_3<Double> polygon = wave(12);
  for (const auto& s : schemes())
    for (const Curve_end end : {Curve_end::closed, Curve_end::reflect})
      with_mask(s, [&](const auto& mask) {
        const auto base = PN::curve_limit_points(polygon, mask, end).first;
        const auto fine = PN::curve_limit_points(refined(polygon, s, end, 3), mask, end).first;
        for (std::size_t i = 0; i < base.size(); ++i)
          EXPECT_LE(CGAL::squared_distance(base[i].point, fine[8 * i].point), 4e-18)
            << name_of(s, end) << i;
      });
}

void expect_honest_errors(const reference::Curve_scheme& s, double roundness)
{
  const Curve_3<Double> polygon = wave(16);
  const auto np = PN::parameters::roundness(roundness);
  for (const Curve_end end : {Curve_end::closed, Curve_end::reflect})
    with_mask(s, [&](const auto& mask) {
      const auto exact =
        PN::curve_limit_points(polygon, mask, end, PN::parameters::join(close(1e-14).pack(), np))
          .first;
      for (const unsigned depth : {1u, 2u, 4u}) {
        test_options::Curve_limit_options options = close(0, 0);
        options.max_depth = depth;
        options.curvatures = false;
        const auto [limits, report] =
          PN::curve_limit_points(polygon, mask, end, PN::parameters::join(options.pack(), np));
        for (std::size_t i = 0; i < limits.size(); ++i) {
          EXPECT_LE(std::sqrt(CGAL::squared_distance(limits[i].point, exact[i].point)),
                    limits[i].error + 1e-13)
            << name_of(s, end) << i << " depth " << depth;
          EXPECT_LE(std::sqrt((limits[i].tangent - exact[i].tangent).squared_length()),
                    (depth == 1 ? 4 : 1) * limits[i].tangent_error + 1e-7)
            << name_of(s, end) << i << " depth " << depth;
        }
        EXPECT_GT(report.number_of_misses, 0u); // nothing is exact
      }
    });
}

TEST(Curve_limits, ErrorsAreNoLargerThanTheirEstimates)
{
  for (const auto& s : schemes()) expect_honest_errors(s, 1);
  for (const int degree : {2, 3}) expect_honest_errors({false, degree}, .5);
}

TEST(Curve_limits, HaveNoTangentsAtKinks)
{
  const Curve_3<Double> polygon = wave(7);
  for (const Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
    const auto [limits, report] =
      PN::curve_limit_points(polygon, PN::B_spline_mask(1), end, close(1e-9).pack());
    EXPECT_EQ(report.number_of_stand_ins, 7u);
    for (std::size_t i = 0; i < limits.size(); ++i) {
      EXPECT_FALSE(limits[i].has_tangent || limits[i].has_curvature);
      EXPECT_EQ(limits[i].point, polygon[i].first);
      EXPECT_EQ(limits[i].normal, polygon[i].second);
    }
  }
}

// The eigenvalues of this mask are 1, 1/2, 1/4 and 1/5: what 1/5 belongs to hardly dies out beside curvature.
TEST(Curve_limits, HaveNoCurvatureThatDoesNotSettle)
{
  const PN::Univariate_mask<double> mask(-4, {-.05, 0, .325, .5, .45, .5, .325, 0, -.05});
  for (const auto& l :
       PN::curve_limit_points(wave(12), mask, Curve_end::closed, close(1e-9).pack()).first) {
    EXPECT_TRUE(l.has_tangent);
    EXPECT_FALSE(l.has_curvature);
  }
}

// Eulerian numbers over 9!
TEST(Curve_limits, OfExactNumbersAreExact)
{
  using K = CGAL::Exact_predicates_exact_constructions_kernel;
  const int eulerian[] = {1, 502, 14608, 88234, 156190, 88234, 14608, 502, 1};
  Curve_2<K> polygon;
  for (int i = 0; i < 12; ++i)
    polygon.emplace_back(K::Point_2(K::FT(i * i % 7) / 3, K::FT(i % 5) / 7), K::Vector_2(0, 1));
  const auto limits =
    PN::curve_limit_points(polygon, PN::linear(PN::B_spline_mask(9)), Curve_end::closed).first;
  for (std::size_t i = 0; i < 12; ++i) {
    K::FT x(0), y(0);
    for (std::size_t j = 0; j < 9; ++j) {
      const auto& p = polygon[(i + j + 8) % 12].first;
      x += K::FT(eulerian[j]) / 362880 * p.x();
      y += K::FT(eulerian[j]) / 362880 * p.y();
    }
    EXPECT_EQ(limits[i].point, K::Point_2(x, y));
  }
}

TEST(Curve_limits, OfOtherNumbersAreClose)
{
  using E = CGAL::Exact_predicates_exact_constructions_kernel;
  using I = CGAL::Simple_cartesian<CGAL::Interval_nt<true>>;
  const Curve_2<Double> polygon = wavy<Double>(7);
  const Curve_2<Long_double> long_polygon = wavy<Long_double>(7);
  Curve_2<E> exact;
  Curve_2<I> intervals;
  for (const auto& [p, n] : polygon) {
    exact.emplace_back(E::Point_2(p.x(), p.y()), E::Vector_2(n.x(), n.y()));
    intervals.emplace_back(I::Point_2(p.x(), p.y()), I::Vector_2(n.x(), n.y()));
  }
  test_options::Curve_limit_options options;
  options.max_depth = 1;
  for (const int degree : {2, 3}) {
    const PN::B_spline_mask mask(degree);
    const auto end = Curve_end::reflect;
    const auto limits = PN::curve_limit_points(polygon, mask, end, options.pack()).first;
    const auto long_limits = PN::curve_limit_points(long_polygon, mask, end, options.pack()).first;
    const auto exact_limits = PN::curve_limit_points(exact, mask, end, options.pack()).first;
    const auto linear_limits =
      PN::curve_limit_points(polygon, PN::linear(mask), end, options.pack()).first;
    const auto interval_limits =
      PN::curve_limit_points(intervals, PN::linear(mask), end, options.pack()).first;
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const Double::Point_2& p = limits[i].point;
      EXPECT_NEAR(p.x(), double(long_limits[i].point.x()), 20 * ulp);
      EXPECT_NEAR(p.x(), CGAL::to_double(exact_limits[i].point.x()), 1e-13);
      EXPECT_NEAR(p.y(), CGAL::to_double(exact_limits[i].point.y()), 1e-13);
      EXPECT_LE(interval_limits[i].point.x().inf(), linear_limits[i].point.x() + 20 * ulp);
      EXPECT_GE(interval_limits[i].point.x().sup(), linear_limits[i].point.x() - 20 * ulp);
      for (const auto& n :
           {interval_limits[i].control_normal.x(), interval_limits[i].control_normal.y()})
        EXPECT_TRUE(n.inf() == 0 && n.sup() == 0) << n.inf() << ' ' << n.sup();
    }
  }
}

TEST(Curve_limits, OfFewPoints)
{
  const auto of = [](std::size_t n, int degree, Curve_end end) {
    Curve_3<Double> polygon = wave(12);
    polygon.resize(n);
    return PN::curve_limit_points(polygon, PN::B_spline_mask(degree), end, close(1e-12).pack())
      .first;
  };
  for (const Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
    EXPECT_TRUE(of(0, 3, end).empty());
    EXPECT_EQ(of(1, 3, end).at(0).point, wave(12)[0].first);
    EXPECT_FALSE(of(1, 3, end).at(0).has_tangent);
    for (std::size_t n = 2; n < 7; ++n)
      for (int degree = 2; degree <= 9; ++degree)
        EXPECT_EQ(of(n, degree, end).size(),
                  end == Curve_end::closed || degree % 2 == 1 ? n : n - 1);
  }
  EXPECT_TRUE(of(1, 2, Curve_end::reflect).empty());
  EXPECT_EQ(of(12, 3, Curve_end::none).size(), 10u);
  EXPECT_EQ(of(12, 3, Curve_end::none)[0].parameter, 1);
  EXPECT_EQ(of(12, 2, Curve_end::none).size(), 11u);
  EXPECT_EQ(of(12, 2, Curve_end::none)[0].parameter, .5);
  EXPECT_EQ(of(12, 4, Curve_end::none)[0].parameter, 1.5);
}

TEST(Curve_limits, AreFiniteForAnyNormals)
{
  for (const int kind : {0, 1, 2}) {
    Curve_3<Double> polygon = wave(9);
    for (std::size_t i = 0; i < 9; ++i) {
      if (kind == 0 && i % 2 == 0) polygon[i].second = -polygon[i].second;
      if (kind == 1 && i % 3 != 0) polygon[i].second = CGAL::NULL_VECTOR;
      if (kind == 2) polygon[i].first = Double::Point_3(1, 2, 3);
    }
    for (const auto& s : schemes()) {
      const auto limits = with_mask(s, [&](const auto& mask) {
        return PN::curve_limit_points(polygon, mask, Curve_end::reflect, close(1e-12).pack()).first;
      });
      for (const auto& l : limits) {
        for (const double x : {l.point.x(), l.point.y(), l.point.z(), l.control_normal.x(),
                               l.tangent.x(), l.normal.z(), l.curvature, l.error, l.tangent_error})
          EXPECT_TRUE(std::isfinite(x)) << name_of(s) << kind;
        EXPECT_TRUE(kind != 2 || CGAL::squared_distance(l.point, polygon[0].first) <= 1e-28);
      }
    }
  }
}

TEST(Curve_limits, IntervalsThatDecideNothingAreNamed)
{
  using I = CGAL::Simple_cartesian<CGAL::Interval_nt<true>>;
  const CGAL::Interval_nt<true> near_zero(-1e-3, 1e-3);
  const Curve_3<I> polygon = {{I::Point_3(1, 0, 0), I::Vector_3(1, 0, 0)},
                              {I::Point_3(0, 1, 0), I::Vector_3(0, 1, 0)},
                              {I::Point_3(-1, 0, 0), I::Vector_3(near_zero, near_zero, near_zero)}};
  messages::expect_refused<std::domain_error>(
    [&] { PN::curve_limit_points(polygon, PN::B_spline_mask(3), Curve_end::closed); }, {"point"});
}

TEST(Curve_limits, BadInputIsRefused)
{
  Curve_3<Double> polygon = wave(7);
  const PN::B_spline_mask cubic(3);
  test_options::Curve_limit_options options;
  options.tolerance = -1;
  EXPECT_THROW(PN::curve_limit_points(polygon, cubic, Curve_end::closed, options.pack()),
               std::invalid_argument);
  options.tolerance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(PN::curve_limit_points(polygon, cubic, Curve_end::closed, options.pack()),
               std::invalid_argument);
  const Curve_3<Double> short_polygon(polygon.begin(), polygon.begin() + 3);
  EXPECT_THROW(PN::curve_limit_points(short_polygon, PN::B_spline_mask(9), Curve_end::none),
               std::invalid_argument);
  EXPECT_TRUE(PN::curve_limit_points(polygon, PN::B_spline_mask(9), Curve_end::none).first.empty());
  EXPECT_THROW(PN::curve_limit_points(polygon, PN::with_normal_mask(cubic, PN::B_spline_mask(2)),
                                      Curve_end::closed),
               std::invalid_argument);
  // doubles the distance of neighbors in every round
  EXPECT_THROW(PN::curve_limit_points(polygon,
                                      PN::Univariate_mask<double>(-3, {-2, 0, 3, 1, 0, 0, 0}),
                                      Curve_end::closed),
               std::invalid_argument);
  polygon[3].first = Double::Point_3(0, std::numeric_limits<double>::infinity(), 0);
  messages::expect_refused([&] { PN::curve_limit_points(polygon, cubic, Curve_end::closed); },
                           {"point 3"});
}

} // namespace
