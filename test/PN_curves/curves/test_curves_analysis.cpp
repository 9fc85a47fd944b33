// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Estimated, rotated and dropped control normals; curvature, combs, differences, deviations.

#include "Curve_cases.h"
#include "analysis/curve_analysis.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <boost/property_map/function_property_map.hpp>

using namespace curve_cases;

namespace {

using Point = Double::Point_2;
using Vector = Double::Vector_2;
using Points = std::vector<Point>;

// --- estimated normals ---

template <class K>
Real normal_error(Curve_end end, bool reversed)
{
  const bool closed = end == Curve_end::closed;
  auto angles = uneven_angles(9, 5, Real(closed ? 2 : 1.6) * Real(CGAL_PI), closed, 1);
  if (reversed) std::reverse(angles.begin(), angles.end());
  std::vector<typename K::Point_2> points;
  for (Real a : angles)
    points.emplace_back(double(3 + 2 * std::cos(a)), double(2 * std::sin(a) - 1));
  const auto polygon = PN::estimate_control_normals(points, end);
  Real error = polygon.size() == points.size() ? 0 : 1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (polygon[i].first != points[i]) error = 1;
    const Real sign = reversed ? -1 : 1;
    error = std::max(
      {error, std::abs(Real(CGAL::to_double(polygon[i].second.x())) - sign * std::cos(angles[i])),
       std::abs(Real(CGAL::to_double(polygon[i].second.y())) - sign * std::sin(angles[i]))});
  }
  return error;
}

TEST(CurveNormals, CirclesHaveTheirOwnOutwardsIfCounterclockwise)
{
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  for (Curve_end end : {Curve_end::closed, Curve_end::reflect, Curve_end::none})
    for (bool reversed : {false, true}) {
      EXPECT_LE(normal_error<Double>(end, reversed), 1e-14L);
      EXPECT_LE(normal_error<Long_double>(end, reversed), 1e-14L);
      EXPECT_LE(normal_error<Epeck>(end, reversed), 1e-13L);
    }
}

TEST(CurveNormals, RightAngle)
{
  const auto even = PN::estimate_control_normals(Points{{0, 0}, {1, 0}, {1, 1}}, Curve_end::none);
  EXPECT_NEAR(even[1].second.x(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(even[1].second.y(), -std::sqrt(0.5), 1e-15);
  // the circle's center is in the middle of the hypotenuse: (0, 0) to (4, 3), radius 5/2
  const auto uneven = PN::estimate_control_normals(Points{{0, 0}, {4, 0}, {4, 3}}, Curve_end::none);
  const Vector expected[] = {{-0.8, -0.6}, {0.8, -0.6}, {0.8, 0.6}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(uneven[i].second.x(), expected[i].x(), 1e-15);
    EXPECT_NEAR(uneven[i].second.y(), expected[i].y(), 1e-15);
  }
}

TEST(CurveNormals, FewPoints)
{
  EXPECT_TRUE(PN::estimate_control_normals(Points(), Curve_end::closed).empty());
  const Vector none(0, 0);
  for (Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
    for (std::size_t n : {1u, 4u}) {
      const auto same = PN::estimate_control_normals(Points(n, {2, 3}), end);
      ASSERT_EQ(same.size(), n);
      for (const auto& item : same) EXPECT_EQ(item, std::make_pair(Point(2, 3), none));
    }
  }
  for (const auto& item : PN::estimate_control_normals(Points{{0, 0}, {2, 0}}, Curve_end::reflect))
    EXPECT_EQ(item.second, Vector(0, -1));
  // to and fro: no side is the right one
  for (const auto& item : PN::estimate_control_normals(Points{{0, 0}, {2, 0}}, Curve_end::closed))
    EXPECT_EQ(item.second, none);
}

// --- in space ---

using Point_3 = Double::Point_3;
using Vector_3 = Double::Vector_3;

std::vector<Vector_3> space_normals(const std::vector<Point_3>& points, Curve_end end)
{
  std::vector<Vector_3> normals;
  for (const auto& item : PN::estimate_control_normals(points, end)) normals.push_back(item.second);
  return normals;
}

double distance(const Vector_3& a, const Vector_3& b)
{
  return std::sqrt((a - b).squared_length());
}

// circles in any plane, ends of open ones included, and one round keeps them
TEST(CurveNormalsInSpace, CirclesHaveTheirOwnOutwards)
{
  const Vector_3 u(1. / 3, 2. / 3, 2. / 3), v(2. / 3, 1. / 3, -2. / 3);
  for (Curve_end end : {Curve_end::closed, Curve_end::reflect})
    for (bool reversed : {false, true}) {
      auto angles = uneven_angles(9, 5, Real(end == Curve_end::closed ? 2 : 1.6) * Real(CGAL_PI),
                                  end == Curve_end::closed, 1);
      if (reversed) std::reverse(angles.begin(), angles.end());
      std::vector<Point_3> points;
      for (Real a : angles)
        points.push_back(Point_3(3, -1, 2) +
                         2 * (double(std::cos(a)) * u + double(std::sin(a)) * v));
      const auto polygon = PN::estimate_control_normals(points, end);
      for (const auto& [p, n] : polygon) EXPECT_LE(distance(n, (p - Point_3(3, -1, 2)) / 2), 4e-15);
      for (const auto& [p, n] :
           PN::subdivide_curve(polygon, PN::B_spline_mask(3), end, params::number_of_iterations(3)))
        EXPECT_NEAR(std::sqrt((p - Point_3(3, -1, 2)).squared_length()), 2, 1e-14);
    }
}

TEST(CurveNormalsInSpace, InflectionsDoNotFlipThem)
{
  std::vector<Point_3> points;
  for (int i = 0; i <= 20; ++i) points.emplace_back(0.4 * i, std::sin(0.8 * i), 0.3 * i);
  const auto n = space_normals(points, Curve_end::reflect);
  for (std::size_t i = 0; i + 1 < n.size(); ++i) EXPECT_GT(n[i] * n[i + 1], 0) << i;
}

// a quarter turn of the principal normal over a straight stretch: in proportion to the length
TEST(CurveNormalsInSpace, StraightStretchesInterpolate)
{
  const std::vector<Point_3> points = {{0, 1, 0}, {1, 0, 0}, {2, 0, 0},
                                       {4, 0, 0}, {5, 0, 0}, {6, 0, 1}};
  const auto n = space_normals(points, Curve_end::reflect);
  const auto angle = [&](std::size_t i) { return std::atan2(n[i].z(), n[i].y()); };
  const auto turn = [&](std::size_t i) { // from the first one on
    return std::remainder(angle(i) - angle(1), 2 * CGAL_PI);
  };
  EXPECT_NEAR(std::abs(turn(4)), CGAL_PI / 2, 1e-12);
  EXPECT_NEAR(turn(2), turn(4) / 4, 1e-12);
  EXPECT_NEAR(turn(3), turn(4) * 3 / 4, 1e-12);
  EXPECT_NEAR(n[2].x(), 0, 1e-15);
}

TEST(CurveNormalsInSpace, StraightAndShortOnesHaveNone)
{
  const Vector_3 none(0, 0, 0);
  const std::vector<Point_3> line = {{0, 0, 0}, {0.1, 0.3, 0.7}, {0.3, 0.9, 2.1}, {1, 3, 7}};
  for (std::size_t n = 0; n <= line.size(); ++n)
    for (Curve_end end : {Curve_end::closed, Curve_end::reflect})
      for (const auto& normal :
           space_normals({line.begin(), line.begin() + std::ptrdiff_t(n)}, end))
        EXPECT_EQ(normal, none);
  EXPECT_EQ(space_normals({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, Curve_end::closed)[1], none);
}

// Away from closing flips nothing depends on where a closed polygon begins or which way it runs.
TEST(CurveNormalsInSpace, StartAndDirectionHaveNoPart)
{
  std::vector<Point_3> points;
  for (int i = 0; i < 11; ++i) {
    const double t = 2 * CGAL_PI * (i + 0.2 * std::sin(3. * i)) / 11;
    points.emplace_back(2 * std::cos(t), std::sin(t), 0.3 * std::sin(2 * t));
  }
  const auto expected = space_normals(points, Curve_end::closed);
  auto other = points;
  std::rotate(other.begin(), other.begin() + 4, other.end());
  const auto rotated = space_normals(other, Curve_end::closed);
  std::reverse(other.begin(), other.end());
  const auto reversed = space_normals(other, Curve_end::closed);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_LE(distance(rotated[i], expected[(i + 4) % 11]), 1e-14);
    EXPECT_LE(distance(reversed[10 - i], expected[(i + 4) % 11]), 1e-14);
  }
}

TEST(CurveNormalsInSpace, TinyHugeAndExactPolygons)
{
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  const std::vector<Point_3> points = {{0, 0, 0}, {1, 0, 0.5}, {2, 1, 0}, {2, 2.5, 1}, {0, 3, 0}};
  const auto expected = space_normals(points, Curve_end::reflect);
  for (double scale : {1e-200, 1e200}) {
    auto scaled = points;
    for (Point_3& p : scaled) p = CGAL::ORIGIN + scale * (p - CGAL::ORIGIN);
    const auto n = space_normals(scaled, Curve_end::reflect);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_LE(distance(n[i], expected[i]), 1e-14);
  }
  std::vector<Epeck::Point_3> exact;
  for (const Point_3& p : points) exact.emplace_back(p.x(), p.y(), p.z());
  const auto polygon = PN::estimate_control_normals(exact, Curve_end::reflect);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto& n = polygon[i].second;
    EXPECT_LE(distance({CGAL::to_double(n.x()), CGAL::to_double(n.y()), CGAL::to_double(n.z())},
                       expected[i]),
              1e-14);
    if (i == 0 || i == 4) continue;
    // in the plane of the three points, exactly
    EXPECT_EQ(n * CGAL::cross_product(exact[i] - exact[i - 1], exact[i + 1] - exact[i]), 0);
  }
}

// --- corners ---

TEST(CurveCorners, PartsHaveOneSidedNormals)
{
  const Points house = {{0, 0}, {4, 0}, {4, 4}, {2, 6}, {0, 4}};
  const auto parts = PN::split_at_corners(house, Curve_end::closed, {4, 1, 2, 1});
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].size(), 2u);
  EXPECT_EQ(parts[1].size(), 3u);
  EXPECT_EQ(parts[2].size(), 3u);
  for (const auto& item : parts[0]) EXPECT_EQ(item.second, Vector(1, 0));
  EXPECT_EQ(parts[1][0].first, Point(4, 4));
  EXPECT_NEAR(parts[1][1].second.y(), 1, 1e-15);
  const auto curve = PN::join_at_corners(parts, Curve_end::closed);
  ASSERT_EQ(curve.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(curve[i].first, house[(i + 1) % 5]);
}

TEST(CurveCorners, GivenNormalsServeBothSides)
{
  const Vector n(0.6, 0.8);
  const Curve_2<Double> polygon = {{{0, 0}, {0, 1}}, {{1, 0}, n}, {{2, 1}, {1, 0}}};
  const auto parts = PN::split_at_corners(polygon, Curve_end::reflect, {1});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0][1].second, n);
  EXPECT_EQ(parts[1][0].second, n);
  EXPECT_EQ(PN::join_at_corners(parts, Curve_end::reflect), polygon);
}

// The sides of a square have one normal each: a corner gets the direction of its diagonal, wherever it is joined.
TEST(CurveCorners, SharedPointsGetTheMeanOfBothNormals)
{
  const Points square = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const auto parts = PN::split_at_corners(square, Curve_end::closed, {0, 1, 2, 3});
  const auto curve = PN::join_at_corners(parts, Curve_end::closed);
  ASSERT_EQ(curve.size(), 4u);
  for (const auto& [p, n] : curve) {
    EXPECT_NEAR(n.x(), p.x() * std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(n.y(), p.y() * std::sqrt(0.5), 1e-15);
  }
  auto turned = parts; // opposite normals have no mean
  turned[3].back().second = -parts[0].front().second;
  EXPECT_EQ(PN::join_at_corners(turned, Curve_end::closed)[0].second, Vector(0, 0));
}

TEST(CurveCorners, WhatCannotBeSplit)
{
  const Points square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_THROW(PN::split_at_corners(square, Curve_end::closed, {}), std::invalid_argument);
  EXPECT_THROW(PN::split_at_corners(square, Curve_end::reflect, {4}), std::invalid_argument);
  EXPECT_TRUE(PN::split_at_corners(Points(), Curve_end::reflect, {}).empty());
  EXPECT_EQ(PN::split_at_corners(Points{{1, 2}}, Curve_end::reflect, {0}).size(), 1u);
  EXPECT_EQ(PN::split_at_corners(square, Curve_end::closed, {2}).front().size(), 5u);
}

TEST(CurveNormals, RepeatedPointsShareTheNormalOfOne)
{
  const Points once = {{0, 0}, {3, 0}, {4, 2}, {1, 5}};
  const Points twice = {{0, 0}, {3, 0}, {3, 0}, {3, 0}, {4, 2}, {1, 5}, {1, 5}, {0, 0}};
  const std::size_t position[] = {0, 1, 1, 1, 2, 3, 3, 0};
  const auto a = PN::estimate_control_normals(once, Curve_end::closed);
  const auto b = PN::estimate_control_normals(twice, Curve_end::closed);
  ASSERT_EQ(b.size(), twice.size());
  for (std::size_t i = 0; i < b.size(); ++i) EXPECT_EQ(b[i], a[position[i]]) << i;
}

TEST(CurveNormals, TinyAndHugePolygons)
{
  for (double scale : {1e-200, 1e200}) {
    Points points;
    for (Real a : uneven_angles(7, 3, 2 * Real(CGAL_PI), true, 2))
      points.emplace_back(scale * double(std::cos(a)), scale * double(std::sin(a)));
    for (const auto& [p, n] : PN::estimate_control_normals(points, Curve_end::closed)) {
      EXPECT_NEAR(n.x(), p.x() / scale, 1e-13);
      EXPECT_NEAR(n.y(), p.y() / scale, 1e-13);
    }
  }
}

// --- rotating ---

TEST(CurveNormals, Rotate)
{
  const auto polygon = circle_2<>(uneven_angles(7, 2, Real(6), true, 1), 1);
  auto rotated = polygon;
  PN::rotate_control_normals(rotated, CGAL_PI / 2, {1, 3, 5});
  for (std::size_t i = 0; i < 7; ++i) {
    const Vector n = polygon[i].second;
    const Vector expected = i % 2 == 1 ? Vector(-n.y(), n.x()) : n; // counterclockwise
    EXPECT_NEAR(rotated[i].second.x(), expected.x(), 1e-15);
    EXPECT_NEAR(rotated[i].second.y(), expected.y(), 1e-15);
    EXPECT_EQ(rotated[i].first, polygon[i].first);
  }
  PN::rotate_control_normals(rotated, -0.5);
  for (std::size_t i = 0; i < 7; ++i)
    EXPECT_NEAR(polygon[i].second * rotated[i].second,
                std::cos((i % 2 == 1 ? CGAL_PI / 2 : 0) - 0.5), 1e-15);
}

TEST(CurveNormals, VerticesThatAreNotThere)
{
  const auto polygon = circle_2<>(uneven_angles(5, 2, Real(6), true, 1), 1);
  auto changed = polygon;
  EXPECT_THROW(PN::rotate_control_normals(changed, 1, {1, 5}), std::invalid_argument);
  EXPECT_EQ(changed, polygon);
}

// --- curvature ---

TEST(CurveAnalysis, CurvatureOfCirclesWithItsSign)
{
  for (Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
    auto angles = uneven_angles(9, 5, Real(5), end == Curve_end::closed, 1);
    const auto circle = circle_2<>(angles, Real(0.25));
    for (double k : PN::discrete_curvature(circle, end)) EXPECT_NEAR(k, 4, 1e-13);
    std::reverse(angles.begin(), angles.end());
    for (double k : PN::discrete_curvature(circle_2<>(angles, Real(0.25)), end))
      EXPECT_NEAR(k, -4, 1e-13);
    for (double k : PN::discrete_curvature(helix<>(angles, Real(0.25), 0), end))
      EXPECT_NEAR(k, 4, 1e-13);
  }
}

TEST(CurveAnalysis, CurvatureOfAParabolaAndAHelixToSecondOrder)
{
  // y = x^2/2 has curvature (1 + x^2)^(-3/2); the helix r/(r^2 + p^2)
  for (double h : {1e-2, 1e-3}) {
    Points parabola;
    std::vector<Real> angles;
    for (int i = -50; i <= 50; ++i) {
      parabola.emplace_back(1 + h * i, (1 + h * i) * (1 + h * i) / 2);
      angles.push_back(h * i);
    }
    EXPECT_NEAR(PN::discrete_curvature(parabola, Curve_end::none)[50], std::pow(2, -1.5), h * h);
    EXPECT_NEAR(PN::discrete_curvature(helix<>(angles, 2, 1), Curve_end::none)[50], 0.4, h * h);
  }
}

TEST(CurveAnalysis, CurvatureWhereThereIsNone)
{
  const Points line = {{0, 0}, {1, 2}, {4, 8}, {5, 10}};
  for (double k : PN::discrete_curvature(line, Curve_end::none)) EXPECT_NEAR(k, 0, 1e-17);
  const Points repeated = {{0, 0}, {1, 0}, {1, 0}, {0, 0}};
  for (double k : PN::discrete_curvature(repeated, Curve_end::closed)) EXPECT_EQ(k, 0);
  for (std::size_t n : {0u, 1u, 2u})
    EXPECT_EQ(PN::discrete_curvature(Points(n, {1, 1}), Curve_end::closed),
              std::vector<double>(n, 0));
}

TEST(CurveAnalysis, CombsOfCirclesAreCircles)
{
  for (Curve_end end : {Curve_end::closed, Curve_end::reflect}) {
    const auto angles = uneven_angles(9, 5, Real(5), end == Curve_end::closed, 1);
    // teeth of 0.3 times 1/2 outwards from the radius 2
    const auto comb = PN::curvature_comb(circle_2<>(angles, 2), end, 0.3);
    ASSERT_EQ(comb.size(), 9u);
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_NEAR(comb[i].x(), double(2.15L * std::cos(angles[i])), 1e-13);
      EXPECT_NEAR(comb[i].y(), double(2.15L * std::sin(angles[i])), 1e-13);
    }
    for (const auto& p : PN::curvature_comb(helix<>(angles, 2, 0), end, 0.3)) {
      EXPECT_LE(cylinder_error(p, Real(2.15)), 1e-13L);
      EXPECT_NEAR(double(height(p)), 0, 1e-13);
    }
  }
  // the middle tooth of a right angle: curvature 2/5, away from the center at (2, 3/2)
  const auto comb = PN::curvature_comb(Points{{0, 0}, {4, 0}, {4, 3}}, Curve_end::none, 10);
  EXPECT_NEAR(comb[1].x(), 4 + 4 * 0.8, 1e-14);
  EXPECT_NEAR(comb[1].y(), -4 * 0.6, 1e-14);
}

// Maps need not be default constructible: those of lambdas are not.
TEST(CurveAnalysis, MapsMadeOfLambdas)
{
  const Points points = {{0, 0}, {4, 0}, {4, 3}, {1, 5}};
  const std::vector<std::size_t> items = {0, 1, 2, 3};
  const auto np = CGAL::parameters::point_map(
    boost::make_function_property_map<std::size_t>([&points](std::size_t i) { return points[i]; }));
  const Curve_end end = Curve_end::closed;
  EXPECT_EQ(PN::estimate_control_normals(items, end, np),
            PN::estimate_control_normals(points, end));
  EXPECT_EQ(PN::discrete_curvature(items, end, np), PN::discrete_curvature(points, end));
  EXPECT_EQ(PN::curvature_comb(items, end, 2, np), PN::curvature_comb(points, end, 2));
  EXPECT_EQ(PN::divided_differences(items, end, 1, 0, np),
            PN::divided_differences(points, end, 1, 0));
}

// --- differences ---

TEST(CurveAnalysis, DifferencesOfPolynomials)
{
  // (t, t^3) at t = i/8: third differences (0, 6), second ones (0, 6 t) at the middle
  Points points;
  for (int i = 0; i < 10; ++i) points.emplace_back(i / 8., i * i * i / 512.);
  const auto second = PN::divided_differences(points, Curve_end::none, 2, 3);
  ASSERT_EQ(second.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(second[i], Vector(0, 6 * (double(i) + 1) / 8));
  const auto third = PN::divided_differences(points, Curve_end::none, 3, 3);
  ASSERT_EQ(third.size(), 7u);
  for (const Vector& v : third) EXPECT_EQ(v, Vector(0, 6));
  const auto closed = PN::divided_differences(points, Curve_end::closed, 1, 0);
  ASSERT_EQ(closed.size(), 10u);
  EXPECT_EQ(closed[9], points[0] - points[9]);
  EXPECT_EQ(PN::divided_differences(points, Curve_end::none, 0, 3)[4], points[4] - CGAL::ORIGIN);
  EXPECT_TRUE(PN::divided_differences(points, Curve_end::none, 10, 3).empty());
}

} // namespace
