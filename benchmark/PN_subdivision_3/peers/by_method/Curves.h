// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_CURVES_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_CURVES_H

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Other methods that make a plane curve of points with unit normals. Written from the papers that are named.
namespace by_method {

using Plane = CGAL::Simple_cartesian<double>;

struct Curve_point
{
  Plane::Point_2 point;
  Plane::Vector_2 normal;
};
using Curve_points = std::vector<Curve_point>;

inline Plane::Vector_2 turned_left(const Plane::Vector_2& v)
{
  return {-v.y(), v.x()};
}

inline Plane::Vector_2 turned(const Plane::Vector_2& v, double angle)
{
  return std::cos(angle) * v + std::sin(angle) * turned_left(v);
}

inline double signed_angle(const Plane::Vector_2& a, const Plane::Vector_2& b)
{
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a * b);
}

// Lipovetsky, Dyn, A weighted binary average of point-normal pairs with application to subdivision schemes, CAGD
// 48, 2016: the point divides an arc between the points whose angle is that of the normals
inline Curve_point circle_average(const Curve_point& a, const Curve_point& b, double weight)
{
  const double turn = signed_angle(a.normal, b.normal);
  const Plane::Vector_2 d = b.point - a.point, normal = turned(a.normal, weight * turn);
  Plane::Vector_2 side = turned_left(d);
  if (side * (a.normal + b.normal) < 0) side = -side;
  const double sign = (b.normal - a.normal) * d < 0 ? -1 : 1, half = sign * std::abs(turn) / 2;
  if (std::abs(half) < 1e-9) return {a.point + weight * d, normal};
  const double r = 1 / (2 * std::sin(half)), x = r * std::sin((2 * weight - 1) * half) + .5,
               y = r * (std::cos((2 * weight - 1) * half) - std::cos(half));
  return {a.point + x * d + y * side, normal};
}

// the places of a closed curve, or within an open one
inline Curve_point at(const Curve_points& p, int i, bool is_closed)
{
  const int n = int(p.size());
  return p[std::size_t(is_closed ? (i % n + n) % n : (std::min)((std::max)(i, 0), n - 1))];
}

inline std::vector<Plane::Point_2> points_of(const Curve_points& p)
{
  std::vector<Plane::Point_2> points;
  for (const Curve_point& c : p) points.push_back(c.point);
  return points;
}

// six rounds: each point doubled, and three times the means of neighbors
inline std::vector<Plane::Point_2> circle_average_cubic(Curve_points p, bool is_closed)
{
  for (int round = 0; round < 6; ++round) {
    Curve_points fine;
    for (const Curve_point& c : p) fine.insert(fine.end(), 2, c);
    for (int step = 0; step < 3; ++step) {
      Curve_points means;
      for (int i = 0; i < int(fine.size()) - !is_closed; ++i)
        means.push_back(circle_average(fine[std::size_t(i)], at(fine, i + 1, is_closed), .5));
      fine = means;
    }
    p = fine;
  }
  return points_of(p);
}

// six rounds of the 4-point rule, as a mean of two extrapolated points
inline std::vector<Plane::Point_2> circle_average_four_point(Curve_points p, bool is_closed)
{
  for (int round = 0; round < 6; ++round) {
    Curve_points fine;
    for (int i = 0; i < int(p.size()); ++i) {
      const Curve_point a = at(p, i - 1, is_closed), b = at(p, i, is_closed),
                        c = at(p, i + 1, is_closed), d = at(p, i + 2, is_closed);
      fine.push_back(b);
      fine.push_back(
        circle_average(circle_average(b, a, -1. / 8), circle_average(c, d, -1. / 8), .5));
    }
    p = fine;
  }
  return points_of(p);
}

// a cubic for each edge, perpendicular to the normals at its ends, with handles as for an arc
inline std::vector<Plane::Point_2> hermite(const Curve_points& p, bool is_closed)
{
  std::vector<Plane::Point_2> curve;
  for (int i = 0; i < int(p.size()) - !is_closed; ++i) {
    const Curve_point a = at(p, i, is_closed), b = at(p, i + 1, is_closed);
    const Plane::Vector_2 d = b.point - a.point;
    const double c = std::cos(signed_angle(a.normal, b.normal) / 4);
    const double handle = std::sqrt(d.squared_length()) / (3 * c * c);
    Plane::Vector_2 s = turned_left(a.normal), t = turned_left(b.normal);
    if (s * d < 0) s = -s;
    if (t * d < 0) t = -t;
    const Plane::Vector_2 p1 = handle * s, p2 = d - handle * t;
    for (int k = 0; k < 16; ++k) {
      const double x = k / 16., y = 1 - x;
      curve.push_back(a.point + 3 * x * y * y * p1 + 3 * x * x * y * p2 + x * x * x * d);
    }
  }
  return curve;
}

} // namespace by_method

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_CURVES_H
