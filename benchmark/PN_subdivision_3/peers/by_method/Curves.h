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
#include <array>
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

// Ben-Zion Vardi, Dyn, Sharon, Geometric Hermite interpolation in R^n by refinements, Advances in Computational
// Mathematics 49(3), 2023: the point of a cubic with tangents at right angles to the normals
inline Curve_point hermite_average(const Curve_point& a, const Curve_point& b, double weight)
{
  const Plane::Vector_2 d = b.point - a.point;
  Plane::Vector_2 s = turned_left(a.normal), t = turned_left(b.normal);
  if (s * d < 0) s = -s;
  if (t * d < 0) t = -t;
  // of the angles of both tangents to the chord
  const double c = std::cos((std::abs(signed_angle(d, s)) + std::abs(signed_angle(d, t))) / 4);
  const double handle = std::sqrt(d.squared_length()) / (3 * c * c);
  const Plane::Vector_2 p1 = handle * s, p2 = d - handle * t;
  const double x = weight, y = 1 - x;
  const Plane::Vector_2 tangent = y * y * p1 + 2 * x * y * (p2 - p1) + x * x * (d - p2);
  Plane::Vector_2 normal = turned_left(tangent) / std::sqrt(tangent.squared_length());
  if (normal * (a.normal + b.normal) < 0) normal = -normal;
  return {a.point + 3 * x * y * y * p1 + 3 * x * x * y * p2 + x * x * x * d, normal};
}

// Reif, Weinmann, Clothoid fitting and geometric Hermite subdivision, Advances in Computational Mathematics 47, 2021: the
// point that divides the length of a clothoid, whose direction is quadratic, with these normals at its ends
inline Curve_point clothoid_average(const Curve_point& a, const Curve_point& b, double weight)
{
  const Plane::Vector_2 d = b.point - a.point;
  Plane::Vector_2 s = turned_left(a.normal), t = turned_left(b.normal);
  if (s * d < 0) s = -s;
  if (t * d < 0) t = -t;
  const double first = signed_angle(d, s), last = signed_angle(d, t);
  double bend = 3 * (first + last);
  const auto direction = [&](double u) { return first + u * (last - first - bend) + u * u * bend; };
  // of cosine, sine, and the derivative of the sine by bend, from 0 to u by Simpson's rule
  const auto integrals = [&](double u) {
    std::array<double, 3> sum{};
    constexpr int n = 32;
    for (int i = 0; i <= n; ++i) {
      const double w = (i == 0 || i == n ? 1
                        : i % 2          ? 4
                                         : 2) *
                       u / (3 * n),
                   v = u * i / n, x = direction(v);
      sum[0] += w * std::cos(x);
      sum[1] += w * std::sin(x);
      sum[2] += w * std::cos(x) * (v * v - v);
    }
    return sum;
  };
  for (int i = 0; i < 8; ++i) {
    const auto whole = integrals(1);
    bend -= whole[1] / whole[2];
  }
  const double length = 1 / integrals(1)[0];
  const auto part = integrals(weight);
  Plane::Vector_2 normal =
    turned(turned_left(d) / std::sqrt(d.squared_length()), direction(weight));
  if (normal * (a.normal + b.normal) < 0) normal = -normal;
  return {a.point + length * (part[0] * d + part[1] * turned_left(d)), normal};
}

// six rounds: each point doubled, and three times the means of neighbors
template <class Average>
std::vector<Plane::Point_2> cubic_by(const Average& average, Curve_points p, bool is_closed)
{
  for (int round = 0; round < 6; ++round) {
    Curve_points fine;
    for (const Curve_point& c : p) fine.insert(fine.end(), 2, c);
    for (int step = 0; step < 3; ++step) {
      Curve_points means;
      for (int i = 0; i < int(fine.size()) - !is_closed; ++i) {
        const Curve_point &a = fine[std::size_t(i)], b = at(fine, i + 1, is_closed);
        means.push_back(a.point == b.point ? a : average(a, b, .5));
      }
      fine = means;
    }
    p = fine;
  }
  return points_of(p);
}

// six rounds of the 4-point rule, as a mean of two extrapolated points
template <class Average>
std::vector<Plane::Point_2> four_point_by(const Average& average, Curve_points p, bool is_closed)
{
  for (int round = 0; round < 6; ++round) {
    Curve_points fine;
    for (int i = is_closed ? 0 : 1; i < int(p.size()) - (is_closed ? 0 : 2); ++i) {
      const Curve_point a = at(p, i - 1, is_closed), b = at(p, i, is_closed),
                        c = at(p, i + 1, is_closed), d = at(p, i + 2, is_closed);
      fine.push_back(b);
      fine.push_back(average(average(b, a, -1. / 8), average(c, d, -1. / 8), .5));
    }
    p = fine;
  }
  return points_of(p);
}

// Beccari, Casciola, Romani, A non-stationary uniform tension controlled interpolating 4-point scheme reproducing conics,
// CAGD 24(1), 2007, of the tension that keeps circles of steps of this angle; normals take no part
inline std::vector<Plane::Point_2> exponential_four_point(Curve_points p, bool is_closed,
                                                          double step)
{
  double v = std::cos(step);
  for (int round = 0; round < 6; ++round) {
    v = std::sqrt((1 + v) / 2);
    const double w = 1 / (8 * v * (1 + v));
    Curve_points fine;
    for (int i = is_closed ? 0 : 1; i < int(p.size()) - (is_closed ? 0 : 2); ++i) {
      const auto vector = [&](int j) { return at(p, i + j, is_closed).point - CGAL::ORIGIN; };
      fine.push_back(p[std::size_t(i)]);
      fine.push_back(
        {CGAL::ORIGIN + (.5 + w) * (vector(0) + vector(1)) - w * (vector(-1) + vector(2)),
         Plane::Vector_2(0, 0)});
    }
    p = fine;
  }
  return points_of(p);
}

// the cubics of the Hermite average, one for each edge
inline std::vector<Plane::Point_2> hermite(const Curve_points& p, bool is_closed)
{
  std::vector<Plane::Point_2> curve;
  for (int i = 0; i < int(p.size()) - !is_closed; ++i)
    for (int k = 0; k < 16; ++k)
      curve.push_back(hermite_average(at(p, i, is_closed), at(p, i + 1, is_closed), k / 16.).point);
  return curve;
}

} // namespace by_method

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_CURVES_H
