// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Circles, cylinders and lines are kept, also where opposite normals fade.

#include "Curve_cases.h"
#include "reference/PN_rule.h"

using namespace curve_cases;

namespace {

constexpr unsigned rounds = 12;

// the number of coefficients of a mask, from the first to the last
std::size_t mask_length(const reference::Curve_scheme& s)
{
  return static_cast<std::size_t>(s.interpolating ? 4 * s.parameter - 1 : s.parameter + 2);
}

template <class K>
Real radius_error_2(const Curve_2<K>& curve, Real radius)
{
  return largest(curve, [=](const auto& item) { return radius_error(item.first, radius); });
}

// from the cylinder and, relative as well, from the plane through the origin
Real circle_error_3(const Curve_3<Double>& curve, Real radius)
{
  return largest(curve, [=](const auto& item) {
    return std::max(cylinder_error(item.first, radius), std::abs(height(item.first)) / radius);
  });
}

TEST(CurveReproduction, UnevenCirclesInThePlane)
{
  for (const auto& s : schemes())
    for (Curve_end end : {Curve_end::closed, Curve_end::reflect, Curve_end::none})
      for (unsigned seed = 1; seed <= 2; ++seed) {
        const bool closed = end == Curve_end::closed;
        const auto angles = uneven_angles(2 * mask_length(s), 3,
                                          Real(closed ? 2 : 1.7) * Real(CGAL_PI), closed, seed);
        for (Real radius : {Real(1), Real(3.7)}) {
          const auto curve = refined(circle_2<>(angles, radius), s, end, rounds);
          ASSERT_GT(curve.size(), 8000u);
          EXPECT_LE(radius_error_2<Double>(curve, radius), 5 * Real(ulp))
            << name_of(s, end) << " in ulps: " << radius_error_2<Double>(curve, radius) / ulp;
        }
      }
}

TEST(CurveReproduction, UnevenCirclesInATiltedPlane)
{
  for (const auto& s : schemes())
    for (Curve_end end : {Curve_end::closed, Curve_end::reflect, Curve_end::none}) {
      const bool closed = end == Curve_end::closed;
      const auto angles =
        uneven_angles(2 * mask_length(s), 3, Real(closed ? 2 : 1.7) * Real(CGAL_PI), closed, 3);
      const auto curve = refined(helix<>(angles, Real(1.3), 0), s, end, rounds);
      ASSERT_GT(curve.size(), 8000u);
      EXPECT_LE(circle_error_3(curve, Real(1.3)), 5 * Real(ulp))
        << name_of(s, end) << " in ulps: " << circle_error_3(curve, Real(1.3)) / ulp;
    }
}

// the share that an entry keeps, and the largest of sum |a|/|N| and 1/d over a round's stencils
Real amplification(const Curve_2<Double>& curve, const reference::Curve_scheme& s, Curve_end end)
{
  const reference::Curve_rows rows(s, static_cast<long>(curve.size()), reference_end(end));
  Real result = 1;
  for (long i = 0; i < rows.size(); ++i) {
    const auto row = rows[i];
    if (row.size() == 1) continue;
    Real x = 0, y = 0, sum = 0;
    for (const auto& [j, a] : row) {
      const auto& n = curve[static_cast<std::size_t>(j)].second;
      x += a * Real(n.x());
      y += a * Real(n.y());
      sum += std::abs(a);
    }
    const Real length = std::hypot(x, y);
    result = std::max(result, sum / length);
    for (const auto& [j, a] : row) {
      const auto& n = curve[static_cast<std::size_t>(j)].second;
      const Real d = 1 + (x * Real(n.x()) + y * Real(n.y())) / length;
      if (d > Real(3) / 32) result = std::max(result, 1 / d);
    }
  }
  return result;
}

TEST(CurveReproduction, ShortAndWildPolygonsAsTheirStencilsAllow)
{
  for (const auto& s : schemes())
    for (Curve_end end : {Curve_end::closed, Curve_end::reflect})
      for (std::size_t n : {4u, 5u, 7u})
        for (unsigned seed = 1; seed <= 3; ++seed) {
          const bool closed = end == Curve_end::closed;
          auto curve = circle_2<>(
            uneven_angles(n, 8, Real(closed ? 2 : 1.5) * Real(CGAL_PI), closed, seed), 1);
          Real factor = 1;
          for (unsigned k = 0; k < 8; ++k) {
            factor = std::max(factor, amplification(curve, s, end));
            curve = refined(curve, s, end);
          }
          EXPECT_LE(radius_error_2<Double>(curve, 1), 5 * Real(ulp) * factor)
            << name_of(s, end) << ' ' << n << ' ' << seed << " factor " << factor << " in ulps "
            << radius_error_2<Double>(curve, 1) / ulp;
        }
}

TEST(CurveReproduction, HelixSamplesStayOnTheCylinder)
{
  for (const auto& s : schemes())
    for (Curve_end end : {Curve_end::reflect, Curve_end::none}) {
      const auto angles = uneven_angles(2 * mask_length(s), 3, Real(9), false, 4);
      const auto polygon = helix<>(angles, Real(1), Real(0.2));
      const auto curve = refined(polygon, s, end, 8);
      // coordinates along the axis reach 2
      EXPECT_LE(largest(curve, [](const auto& item) { return cylinder_error(item.first, 1); }),
                16 * Real(ulp))
        << name_of(s, end);
      EXPECT_GT(std::abs(height(curve.back().first) - height(curve.front().first)), 0.5L);
    }
}

TEST(CurveReproduction, LinesStayLines)
{
  // 3 x + 4 y = 5 with the normal (3, 4)/5
  Curve_2<Double> polygon;
  for (int i = 0; i < 24; ++i) {
    const double t = 0.5 * i + 0.2 * (i * i % 4);
    polygon.emplace_back(Double::Point_2(0.6 + 0.8 * t, 0.8 - 0.6 * t), Double::Vector_2(0.6, 0.8));
  }
  for (const auto& s : schemes())
    for (Curve_end end : {Curve_end::reflect, Curve_end::none}) {
      const auto curve = refined(polygon, s, end, 6);
      ASSERT_GT(curve.size(), 64u);
      EXPECT_LE(largest(curve,
                        [](const auto& item) {
                          const Real x = item.first.x(), y = item.first.y();
                          return std::abs(Real(0.6) * x + Real(0.8) * y - 1);
                        }),
                40 * Real(ulp))
        << name_of(s, end);
      EXPECT_LE(largest(curve,
                        [](const auto& item) {
                          return std::hypot(Real(item.second.x()) - Real(0.6),
                                            Real(item.second.y()) - Real(0.8));
                        }),
                4 * Real(ulp))
        << name_of(s, end);
    }
}

// --- the fade of opposite normals ---

const reference::Curve_scheme four_point = {true, 2};
constexpr unsigned fade_rounds = 6;

std::vector<Real> three_angles(Real a, Real b, Real c)
{
  const Real third = 2 * Real(CGAL_PI) / 3;
  return {a, third + b, 2 * third + c};
}

TEST(CurveFade, FourPointsOnThreeEquidistantSamples)
{
  for (int k = 0; k < 50; ++k) {
    const Real turn = Real(k) / 20;
    const auto curve = refined(circle_2<>(three_angles(turn, turn, turn), 1), four_point,
                               Curve_end::closed, fade_rounds);
    EXPECT_LE(radius_error_2<Double>(curve, 1), 8 * Real(ulp)) << k;
  }
}

TEST(CurveFade, FourPointsOnThreeSamples)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> moved(-0.4, 0.4);
  std::size_t in_the_window = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto polygon = circle_2<>(three_angles(moved(random), moved(random), moved(random)), 1);
    const auto curve = refined(polygon, four_point, Curve_end::closed, fade_rounds);
    EXPECT_LE(radius_error_2<Double>(curve, 1), 128 * Real(ulp)) << k;
    auto one = polygon;
    Real factor = 0;
    for (unsigned r = 0; r < fade_rounds; ++r) {
      factor = std::max(factor, amplification(one, four_point, Curve_end::closed));
      one = refined(one, four_point, Curve_end::closed);
    }
    if (factor > Real(256) / 75) ++in_the_window;
  }
  EXPECT_GT(in_the_window, 5u); // the fade takes part
}

// Three samples moved by angles, and their normals turned by further ones.
Curve_2<Double> perturbed_polygon(const std::array<Real, 6>& a)
{
  auto polygon = circle_2<>(three_angles(a[0], a[1], a[2]), 1);
  const auto angles = three_angles(a[0] + a[3], a[1] + a[4], a[2] + a[5]);
  for (std::size_t i = 0; i < 3; ++i)
    polygon[i].second = Double::Vector_2(double(std::cos(angles[i])), double(std::sin(angles[i])));
  return polygon;
}

Curve_2<Double> perturbed(const std::array<Real, 6>& a)
{
  return refined(perturbed_polygon(a), four_point, Curve_end::closed, fade_rounds);
}

std::array<Real, 6> random_angles(std::mt19937& random, double sample = 0.4, double normal = 0.4)
{
  std::uniform_real_distribution<double> moved(-1, 1);
  std::array<Real, 6> a;
  for (std::size_t i = 0; i < 6; ++i) a[i] = Real((i < 3 ? sample : normal) * moved(random));
  return a;
}

TEST(CurveFade, RoundsAreTheMatrixForm)
{
  std::mt19937 random(4);
  for (int k = 0; k < 300; ++k) {
    auto curve = perturbed_polygon(random_angles(random));
    for (unsigned r = 0; r < 3; ++r) {
      const auto matrix = reference::curve_matrix(four_point, static_cast<long>(curve.size()),
                                                  reference::End::closed);
      reference::Values old;
      for (const auto& [p, n] : curve) {
        old.points.push_back({Real(p.x()), Real(p.y()), 0});
        old.normals.push_back({Real(n.x()), Real(n.y()), 0});
      }
      const auto expected = reference::pn_round(matrix, old);
      curve = refined(curve, four_point, Curve_end::closed);
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const auto& p = curve[i].first;
        EXPECT_LE((expected.points[i] - reference::Vector(p.x(), p.y(), 0)).norm(), 1e-10L) << k;
      }
    }
  }
}

// the largest distance of a curve from the middle of its control polygon's box, by the box's sides
double reach(const std::array<Real, 6>& a)
{
  CGAL::Bbox_2 box;
  for (const auto& [p, n] : perturbed_polygon(a)) box += p.bbox();
  const double x = (box.xmin() + box.xmax()) / 2, y = (box.ymin() + box.ymax()) / 2;
  double result = 0;
  for (const auto& [p, n] : perturbed(a)) {
    EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()));
    EXPECT_TRUE(std::isfinite(n.x()) && std::isfinite(n.y()));
    result = std::max({result, std::abs(p.x() - x) / (box.xmax() - box.xmin()),
                       std::abs(p.y() - y) / (box.ymax() - box.ymin())});
  }
  return result;
}

TEST(CurveFade, PerturbedCurvesStayFiniteAndNear)
{
  std::mt19937 random(2);
  // 1 is twice the box
  for (int k = 0; k < 2000; ++k) EXPECT_LE(reach(random_angles(random, 0, 0.05)), 1) << k;
  for (int k = 0; k < 2000; ++k) EXPECT_LE(reach(random_angles(random)), 2.5) << k;
}

Real distance(const Curve_2<Double>& a, const Curve_2<Double>& b)
{
  Real d = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    d = std::max(d, Real(std::sqrt(CGAL::squared_distance(a[i].first, b[i].first))));
  return d;
}

// Follows the larger of both halves' changes down to an interval of 2^-halvings.
Real change_after(const std::array<Real, 6>& from, const std::array<Real, 6>& to, int halvings)
{
  auto a = from, b = to;
  for (int h = 0; h < halvings; ++h) {
    std::array<Real, 6> c;
    for (std::size_t i = 0; i < 6; ++i) c[i] = (a[i] + b[i]) / 2;
    const auto middle = perturbed(c);
    (distance(perturbed(a), middle) > distance(middle, perturbed(b)) ? b : a) = c;
  }
  return distance(perturbed(a), perturbed(b));
}

TEST(CurveFade, PerturbedCurvesChangeContinuously)
{
  std::mt19937 random(3);
  for (int k = 0; k < 100; ++k) {
    const auto a = random_angles(random), b = random_angles(random);
    EXPECT_LE(change_after(a, b, 36), 1e-5L) << k;
  }
}

} // namespace
