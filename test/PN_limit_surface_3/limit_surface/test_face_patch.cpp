// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// The patch of a face: spheres, cylinders, planes, and what is not in it.

#include <CGAL/PN_limit_surface_3/Face_patch.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Patch = CGAL::PN_subdivision_3::Face_patch<Kernel>;

Vector unit(const Vector& v)
{
  return v / std::sqrt(v.squared_length());
}
double length(const Vector& v)
{
  return std::sqrt(v.squared_length());
}

template <class Function>
void for_each_place(const Patch& patch, const Function& f)
{
  for (int i = 0; i <= 7; ++i)
    for (int j = 0; j <= (patch.number_of_corners() == 3 ? 7 - i : 7); ++j) f(i / 7., j / 7.);
}

TEST(FacePatch, Spheres)
{
  const Point center(3, -1, 2);
  const std::vector<Vector> normals = {unit({1, 0.2, 0.3}), unit({0.3, 1, 0.1}),
                                       unit({-0.2, 0.8, 0.9}), unit({0.4, 0.1, 1})};
  for (const std::size_t n : {3u, 4u}) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i) points.push_back(center + 2.5 * normals[i]);
    const Patch patch(points,
                      std::vector<Vector>(normals.begin(), normals.begin() + std::ptrdiff_t(n)));
    for_each_place(patch, [&](double u, double v) {
      const Vector r = (patch.point(u, v) - center) / 2.5;
      EXPECT_NEAR(length(r), 1, 1e-14);
      EXPECT_LE(length(patch.normal(u, v) - r), 1e-12);
      EXPECT_LE(length(patch.average_normal(u, v) - r), 1e-12);
    });
  }
}

TEST(FacePatch, Cylinders)
{
  std::vector<Point> points;
  std::vector<Vector> normals;
  for (const auto& [angle, z] :
       {std::pair(0.1, 0.), std::pair(0.9, 0.3), std::pair(1.2, 2.), std::pair(0.3, 1.6)}) {
    normals.emplace_back(std::cos(angle), std::sin(angle), 0);
    points.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), z);
  }
  const Patch patch(points, normals);
  for_each_place(patch, [&](double u, double v) {
    const Point p = patch.point(u, v);
    EXPECT_NEAR(std::hypot(p.x(), p.y()), 3, 1e-14);
    EXPECT_LE(length(patch.normal(u, v) - Vector(p.x() / 3, p.y() / 3, 0)), 1e-12);
  });
}

TEST(FacePatch, WithoutNormalsItIsLinear)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0.5}, {1.5, 1, 0}, {0, 1, 0.2}};
  const Patch patch(points, std::vector<Vector>(4, CGAL::NULL_VECTOR));
  for_each_place(patch, [&](double u, double v) {
    Vector sum = CGAL::NULL_VECTOR;
    const double a[] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    for (std::size_t i = 0; i < 4; ++i) sum += a[i] * (points[i] - CGAL::ORIGIN);
    EXPECT_LE(length(patch.point(u, v) - CGAL::ORIGIN - sum), 1e-15);
  });
}

// the normal is that of the points around, of any data
TEST(FacePatch, NormalsAreThoseOfThePatch)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0.2}, {1.1, 1, 0}, {0, 1, 0.3}};
  const std::vector<Vector> normals = {unit({0.3, 0.1, 1}), unit({-0.2, 0.2, 1}),
                                       unit({0.1, -0.3, 1}), unit({0, 0.4, 1})};
  const Patch patch(points, normals);
  for (const auto& [u, v] : {std::pair(0.3, 0.4), std::pair(0.8, 0.1)}) {
    constexpr double h = 1e-5;
    const Vector du = patch.point(u + h, v) - patch.point(u - h, v),
                 dv = patch.point(u, v + h) - patch.point(u, v - h);
    EXPECT_LE(length(patch.normal(u, v) - unit(CGAL::cross_product(du, dv))), 1e-8);
  }
}

TEST(FacePatch, AnEdgeDependsOnItsEndsAlone)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0.5}, {1.5, 1, 0}, {0, 1, 0.2}};
  const std::vector<Vector> normals = {unit({0.3, 0.1, 1}), unit({-0.2, 0.2, 1}),
                                       unit({0.1, -0.3, 1}), unit({0, 0.4, 1})};
  const Patch quad(points, normals);
  const Patch triangle(std::vector<Point>{points[1], points[0], {0.4, -1, 0}},
                       std::vector<Vector>{normals[1], normals[0], unit({0.5, 0.5, 1})});
  for (int i = 0; i <= 8; ++i)
    EXPECT_LE(length(quad.point(i / 8., 0) - triangle.point(1 - i / 8., 0)), 1e-15);
}

TEST(FacePatch, WrongNumbersOfCornersAreRefused)
{
  const std::vector<Point> points(5, Point(0, 0, 0));
  const std::vector<Vector> normals(5, Vector(0, 0, 1));
  const auto patch = [&](std::size_t p, std::size_t n) {
    return Patch(std::vector<Point>(points.begin(), points.begin() + std::ptrdiff_t(p)),
                 std::vector<Vector>(normals.begin(), normals.begin() + std::ptrdiff_t(n)));
  };
  EXPECT_THROW(patch(5, 5), std::invalid_argument);
  EXPECT_THROW(patch(2, 2), std::invalid_argument);
  EXPECT_THROW(patch(4, 3), std::invalid_argument);
  EXPECT_NO_THROW(patch(3, 3));
}

} // namespace
