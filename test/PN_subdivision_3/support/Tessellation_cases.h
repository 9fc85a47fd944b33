// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the tests of tessellations share.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_TESSELLATION_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_TESSELLATION_CASES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace tessellation_cases {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Triangle = std::array<Point, 3>;

template <class Mesh>
std::vector<Triangle> triangles(const Mesh& mesh)
{
  const auto points = get(CGAL::vertex_point, mesh);
  const auto point = [&](auto v) {
    const auto& p = get(points, v);
    return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  };
  std::vector<Triangle> result;
  for (auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    result.push_back(
      {point(source(h, mesh)), point(target(h, mesh)), point(target(next(h, mesh), mesh))});
  }
  return result;
}

inline double distance(const Point& p, const std::vector<Triangle>& all)
{
  using Triangle_3 = CGAL::Simple_cartesian<double>::Triangle_3;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : all) {
    const double radius =
      std::sqrt((std::max)(CGAL::squared_distance(a, b), CGAL::squared_distance(a, c)));
    if (std::sqrt(CGAL::squared_distance(p, a)) - radius > least) continue;
    least = (std::min)(least, std::sqrt(CGAL::squared_distance(p, Triangle_3(a, b, c))));
  }
  return least;
}

// Every edge has two triangles, or one if it had one; as many pieces, holes and handles; no triangle without area.
template <class Mesh, class Control>
void expect_conforming(const Mesh& mesh, const Control& control)
{
  // CGAL calls none with isolated vertices valid
  EXPECT_EQ(CGAL::is_valid_polygon_mesh(mesh), CGAL::is_valid_polygon_mesh(control));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  const auto characteristic = [](const auto& m) {
    return static_cast<long>(vertices(m).size()) - static_cast<long>(edges(m).size()) +
           static_cast<long>(faces(m).size());
  };
  EXPECT_EQ(characteristic(mesh), characteristic(control));
  EXPECT_EQ(CGAL::is_closed(mesh), CGAL::is_closed(control));
  for (const auto& [a, b, c] : triangles(mesh)) {
    const double longest = (std::max)(
      {CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
    // two triangles on each other shrink to a point
    if (longest < 1e-28 * (a - CGAL::ORIGIN).squared_length()) continue;
    const double area = CGAL::cross_product(b - a, c - a).squared_length();
    EXPECT_GT(area, 1e-12 * longest * longest);
  }
}

// calls f(p) with points all over the triangles
template <class Function>
void for_each_sample(const std::vector<Triangle>& all, const Function& f)
{
  constexpr int n = 6;
  for (const auto& [a, b, c] : all)
    for (int i = 0; i <= n; ++i)
      for (int k = 0; i + k <= n; ++k)
        f(CGAL::ORIGIN +
          ((a - CGAL::ORIGIN) * i + (b - CGAL::ORIGIN) * k + (c - CGAL::ORIGIN) * (n - i - k)) / n);
}

} // namespace tessellation_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_TESSELLATION_CASES_H
