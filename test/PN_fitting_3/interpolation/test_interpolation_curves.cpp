// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Interpolation by curves.

#include "support/Options.h"
#include <CGAL/PN_curves/curve_corners.h>
#include <CGAL/PN_fitting_3/internal/find_root.h>
#include <CGAL/PN_fitting_3/interpolate_curve.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_2 = Kernel::Point_2;
using Vector_2 = Kernel::Vector_2;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Curve_2 = std::vector<std::pair<Point_2, Vector_2>>;
using Curve_3 = std::vector<std::pair<Point_3, Vector_3>>;
using Options = test_options::Limit_interpolation_options<>;

const PN::B_spline_mask cubic(3);
constexpr double pi = 3.14159265358979323846;

Options strict()
{
  Options options;
  options.mode = PN::Limit_interpolation::Mode::strict;
  return options;
}

// of uneven steps
Curve_2 ellipse(int n, double a, double b, bool uneven = true)
{
  Curve_2 curve;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi / n * (i + (uneven ? 0.3 * std::sin(5. * i) : 0));
    const Vector_2 normal(std::cos(t) / a, std::sin(t) / b);
    curve.emplace_back(Point_2(a * std::cos(t), b * std::sin(t)),
                       normal / std::sqrt(normal.squared_length()));
  }
  return curve;
}

// where a vertex of the control polygon comes to lie after many rounds
template <class Curve, class Mask>
auto limit_by_rounds(const Curve& net, const Mask& mask, PN::Curve_end end, std::size_t vertex,
                     double roundness = 1)
{
  // its neighborhood, refined again and again
  Curve curve = net;
  if (end == PN::Curve_end::closed) { // away from where it is cut open
    std::rotate(curve.begin(), curve.begin() + std::ptrdiff_t(vertex), curve.end());
    std::rotate(curve.begin(), curve.begin() + std::ptrdiff_t(curve.size() / 2), curve.end());
    vertex = curve.size() - curve.size() / 2;
  }
  for (int k = 0; k < 40; ++k) {
    if (curve.size() > 64) {
      const std::size_t from = vertex > 16 ? vertex - 16 : 0;
      const std::size_t to = (std::min)(curve.size(), vertex + 17);
      curve = Curve(curve.begin() + std::ptrdiff_t(from), curve.begin() + std::ptrdiff_t(to));
      vertex -= from;
      end = PN::Curve_end::reflect;
    }
    curve = PN::subdivide_curve(curve, mask, end, PN::parameters::roundness(roundness));
    vertex *= 2;
  }
  return curve[vertex].first;
}

TEST(Interpolating_curves, CirclesAreTheirOwnPolygons)
{
  const Curve_2 data = ellipse(7, 1, 1);
  for (const auto end : {PN::Curve_end::closed, PN::Curve_end::reflect}) {
    const auto [net, report] = PN::interpolate_curve(data, cubic, end);
    EXPECT_EQ(report.steps, 0u);
    EXPECT_LE(report.residual, 2e-15);
    EXPECT_EQ(net, data);
    // linear interpolation is far off
    const auto linear = PN::interpolate_curve(data, PN::linear(cubic), end);
    double off = 0;
    for (const auto& [p, n] : PN::subdivide_curve(linear.first, PN::linear(cubic), end,
                                                  CGAL::parameters::number_of_iterations(6)))
      off = (std::max)(off, std::abs(std::hypot(p.x(), p.y()) - 1));
    EXPECT_GT(off, 1e-2);
  }
  Curve_3 circle; // in space
  for (const auto& [p, n] : data)
    circle.emplace_back(Point_3(p.x(), 0.6 * p.y(), 0.8 * p.y()),
                        Vector_3(n.x(), 0.6 * n.y(), 0.8 * n.y()));
  const auto [net, report] = PN::interpolate_curve(circle, cubic, PN::Curve_end::closed);
  EXPECT_EQ(report.steps, 0u);
  EXPECT_EQ(net, circle);
}

TEST(Interpolating_curves, StrictLimitsAreThePoints)
{
  const Curve_2 data = ellipse(12, 2, 1);
  for (const auto end : {PN::Curve_end::closed, PN::Curve_end::reflect})
    for (const auto normals :
         {PN::Limit_interpolation::Normals::given, PN::Limit_interpolation::Normals::solved}) {
      Options options = strict();
      options.normals = normals;
      const auto [net, report] = PN::interpolate_curve(data, cubic, end, options.pack());
      EXPECT_TRUE(report.is_within_tolerance());
      for (std::size_t i = 0; i < data.size(); ++i)
        EXPECT_LE(CGAL::squared_distance(limit_by_rounds(net, cubic, end, i), data[i].first), 1e-22)
          << i;
    }
}

// The system of classic interpolation, solved here.
TEST(Interpolating_curves, StrictLimitsOfAnyRoundnessAreThePoints)
{
  const Curve_2 data = ellipse(9, 3, 1);
  for (const double w : {0., .5})
    for (const auto end : {PN::Curve_end::closed, PN::Curve_end::reflect}) {
      const auto [net, report] = PN::interpolate_curve(
        data, cubic, end, PN::parameters::join(strict().pack(), PN::parameters::roundness(w)));
      EXPECT_LE(report.residual, report.tolerance);
      for (std::size_t i = 0; i < data.size(); ++i)
        EXPECT_LE(
          std::sqrt(CGAL::squared_distance(limit_by_rounds(net, cubic, end, i, w), data[i].first)),
          1e-9);
    }
}

TEST(Interpolating_curves, LinearIsClassicInterpolation)
{
  const Curve_2 data = ellipse(9, 2, 1);
  for (const bool closed : {true, false}) {
    const auto n = Eigen::Index(data.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n), b(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
      b.row(i) << data[std::size_t(i)].first.x(), data[std::size_t(i)].first.y();
      if (!closed && (i == 0 || i == n - 1)) {
        matrix(i, i) = 1;
        continue;
      }
      matrix(i, i) = 4. / 6;
      matrix(i, (i + 1) % n) = matrix(i, (i + n - 1) % n) = 1. / 6;
    }
    const Eigen::MatrixXd expected = matrix.partialPivLu().solve(b);
    const auto [net, report] = PN::interpolate_curve(
      data, PN::linear(cubic), closed ? PN::Curve_end::closed : PN::Curve_end::reflect,
      strict().pack());
    EXPECT_LE(report.steps, closed ? 5u : 8u); // as many as the matrix has eigenvalues
    for (Eigen::Index i = 0; i < n; ++i) {
      EXPECT_NEAR(net[std::size_t(i)].first.x(), expected(i, 0), 1e-13);
      EXPECT_NEAR(net[std::size_t(i)].first.y(), expected(i, 1), 1e-13);
    }
  }
}

double distance_from_ellipse(const Point_2& p, double a, double b)
{
  const double x = p.x() / a, y = p.y() / b;
  return std::abs(x * x + y * y - 1) / (2 * std::hypot(x / a, y / b));
}

TEST(Interpolating_curves, SlideIsCloseToUnevenSamples)
{
  double last = 0;
  for (const int n : {16, 32}) {
    const Curve_2 data = ellipse(n, 2, 1);
    const auto error = [&](const auto& mask) {
      const auto [net, report] = PN::interpolate_curve(data, mask, PN::Curve_end::closed);
      EXPECT_LE(report.residual, 2e-3);
      double largest = 0;
      for (const auto& [p, normal] : PN::subdivide_curve(net, mask, PN::Curve_end::closed,
                                                         CGAL::parameters::number_of_iterations(9)))
        largest = (std::max)(largest, distance_from_ellipse(p, 2, 1));
      return largest;
    };
    const double pn = error(cubic);
    EXPECT_LT(pn, error(PN::linear(cubic)));
    if (last > 0) {
      EXPECT_GT(last / pn, 8);
    }
    last = pn;
  }
}

// Without normals they are estimated; in space the curve slides along two directions.
TEST(Interpolating_curves, InSpaceFromPointsAlone)
{
  std::vector<Point_3> data;
  for (int i = 0; i < 24; ++i) {
    const double t = 0.3 * i + 0.05 * std::sin(3. * i);
    data.emplace_back(std::cos(t), 1.3 * std::sin(t), 0.2 * t + 0.03 * t * t);
  }
  const auto [net, report] = PN::interpolate_curve(data, cubic, PN::Curve_end::reflect);
  ASSERT_GT(report.steps, 0u);
  const auto curve = PN::subdivide_curve(net, cubic, PN::Curve_end::reflect,
                                         CGAL::parameters::number_of_iterations(8));
  double farthest = 0;
  for (const Point_3& p : data) {
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
      nearest = (std::min)(
        nearest, CGAL::squared_distance(p, Kernel::Segment_3(curve[i].first, curve[i + 1].first)));
    EXPECT_LE(std::sqrt(nearest), 5e-4); // the slip is up to 0.04
    farthest = (std::max)(farthest, std::sqrt(nearest));
  }
  EXPECT_NEAR(report.residual, farthest, 0.02 * farthest);
  EXPECT_FALSE(report.is_within_tolerance());
}

TEST(Interpolating_curves, CornersPartByPart)
{
  const Curve_2 data = ellipse(12, 2, 1);
  auto parts = PN::split_at_corners(data, PN::Curve_end::closed, {0, 5});
  for (auto& part : parts) {
    const Curve_2 before = part;
    part = PN::interpolate_curve(part, cubic, PN::Curve_end::reflect, strict().pack()).first;
    EXPECT_EQ(part.front(), before.front());
    EXPECT_EQ(part.back(), before.back());
  }
  EXPECT_EQ(PN::join_at_corners(parts, PN::Curve_end::closed).size(), data.size());
}

TEST(Interpolating_curves, SmallAndStrangeInput)
{
  for (const auto end : {PN::Curve_end::closed, PN::Curve_end::reflect})
    for (const Options& options : {Options(), strict()}) {
      for (int n = 0; n <= 4; ++n)
        for (const bool same : {false, true}) {
          Curve_2 data = ellipse(n, same ? 0 : 1, same ? 0 : 1);
          for (auto& item : data) item.second = same ? Vector_2(0, 0) : item.second;
          const auto [net, report] = PN::interpolate_curve(data, cubic, end, options.pack());
          ASSERT_EQ(net.size(), data.size());
          EXPECT_TRUE(std::isfinite(report.residual));
          for (const auto& [p, normal] : net)
            EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()));
        }
      const Curve_2 data = ellipse(8, 2, 1);
      EXPECT_EQ(
        PN::interpolate_curve(data, PN::Dubuc_Deslauriers_mask(4), end, options.pack()).first,
        data);
    }
}

TEST(Interpolating_curves, WhatCannotBeIsRefused)
{
  const Curve_2 data = ellipse(8, 2, 1);
  const auto closed = PN::Curve_end::closed;
  EXPECT_THROW(PN::interpolate_curve(data, PN::B_spline_mask(2), closed), std::invalid_argument);
  EXPECT_THROW(PN::interpolate_curve(data, PN::B_spline_mask(5), closed), std::invalid_argument);
  EXPECT_THROW(PN::interpolate_curve(data, cubic, PN::Curve_end::none), std::invalid_argument);
  Options options = strict();
  options.free = PN::Limit_interpolation::Free::smooth;
  EXPECT_THROW(PN::interpolate_curve(data, cubic, closed, options.pack()), std::invalid_argument);
  Curve_2 infinite = data;
  infinite[3].first = Point_2(HUGE_VAL, 0);
  EXPECT_THROW(PN::interpolate_curve(infinite, cubic, closed), std::invalid_argument);
}

// Of linear residuals the steps are those of GMRES: as many as unknowns, behind a first one without a direction.
TEST(Interpolating_curves, RootsOfLinearResidualsTakeAFewSteps)
{
  Eigen::Matrix3d matrix;
  matrix << 1, 0.3, 0.1, -0.2, 0.6, 0.3, 0.1, 0.4, 0.8;
  const Eigen::Vector3d b(1, 2, 3), expected = matrix.partialPivLu().solve(b);
  for (const std::size_t most_kept : {20, 2, 1}) {
    const PN::internal::Root root = PN::internal::find_root(
      Eigen::VectorXd::Zero(3),
      [&](auto& x, auto& r) {
        r = b - matrix * x;
        return r.norm();
      },
      1e-12, 60, 60, most_kept);
    if (most_kept == 20) {
      EXPECT_LE(root.steps, 4u);
    }
    EXPECT_LT((root.x - expected).norm(), 1e-11) << most_kept;
  }
}

// In double, whatever the number type; points that stay keep all their digits.
TEST(Interpolating_curves, ExactNumbers)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  std::vector<std::pair<Exact::Point_2, Exact::Vector_2>> data;
  const Curve_2 same = ellipse(8, 2, 1);
  for (const auto& [p, n] : same)
    data.emplace_back(Exact::Point_2(p.x(), p.y()), Exact::Vector_2(n.x(), n.y()));
  data[0].first = Exact::Point_2(Exact::FT(2) + Exact::FT(1) / 3 / 1e20, 0);
  const auto [net, report] =
    PN::interpolate_curve(data, cubic, PN::Curve_end::reflect, strict().pack());
  EXPECT_EQ(net[0].first, data[0].first);
  const auto [expected, expected_report] =
    PN::interpolate_curve(same, cubic, PN::Curve_end::reflect, strict().pack());
  for (std::size_t i = 1; i < net.size(); ++i)
    EXPECT_NEAR(CGAL::to_double(net[i].first.x()), expected[i].first.x(), 1e-14);
}

} // namespace
