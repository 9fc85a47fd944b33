// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the tests of curves share: masks beside their references, control polygons, calls.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_CURVE_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_CURVE_CASES_H

#include "reference/Curve.h"
#include "reference/PN_rule.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>

namespace curve_cases {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using PN::Curve_end;
using reference::Real;

constexpr double ulp = std::numeric_limits<double>::epsilon(); // 2^-52

using Double = CGAL::Simple_cartesian<double>;
using Long_double = CGAL::Simple_cartesian<long double>;

template <class K>
using Curve_2 = std::vector<std::pair<typename K::Point_2, typename K::Vector_2>>;
template <class K>
using Curve_3 = std::vector<std::pair<typename K::Point_3, typename K::Vector_3>>;

inline reference::End reference_end(Curve_end end)
{
  return end == Curve_end::closed    ? reference::End::closed
         : end == Curve_end::reflect ? reference::End::reflect
                                     : reference::End::none;
}

inline std::vector<reference::Curve_scheme> schemes()
{
  std::vector<reference::Curve_scheme> all;
  for (int degree = 2; degree <= 9; ++degree) all.push_back({false, degree});
  for (int half = 2; half <= 5; ++half) all.push_back({true, half});
  return all;
}

inline std::string name_of(const reference::Curve_scheme& s, Curve_end end = Curve_end::closed)
{
  const char* const ends[] = {" closed", " reflect", " none"};
  return (s.interpolating ? std::to_string(2 * s.parameter) + "-point"
                          : "B-spline " + std::to_string(s.parameter)) +
         ends[static_cast<int>(end)];
}

// f(mask) with the mask of a scheme
template <class Function>
auto with_mask(const reference::Curve_scheme& s, const Function& f)
{
  return s.interpolating ? f(PN::Dubuc_Deslauriers_mask(2 * s.parameter))
                         : f(PN::B_spline_mask(s.parameter));
}

template <class Curve>
Curve refined(const Curve& polygon, const reference::Curve_scheme& s, Curve_end end,
              unsigned rounds = 1)
{
  return with_mask(s, [&](const auto& mask) {
    return PN::subdivide_curve(polygon, mask, end, params::number_of_iterations(rounds));
  });
}

template <class Curve>
Curve linearly_refined(const Curve& polygon, const reference::Curve_scheme& s, Curve_end end,
                       unsigned rounds = 1)
{
  return with_mask(s, [&](const auto& mask) {
    return PN::subdivide_curve(polygon, PN::linear(mask), end,
                               params::number_of_iterations(rounds));
  });
}

// --- control polygons ---

// angles of n samples, whose distances have ratios up to `ratio`, on an arc of the given length
inline std::vector<Real> uneven_angles(std::size_t n, double ratio, Real arc, bool closed,
                                       unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(1, ratio);
  std::vector<Real> angles = {Real(0.1)};
  Real sum = 0;
  for (std::size_t i = 1; i < n + (closed ? 1 : 0); ++i) {
    sum += Real(i == 1 ? ratio : i == 2 ? 1. : step(random)); // the ratio occurs
    angles.push_back(Real(0.1) + sum);
  }
  for (Real& a : angles) a *= arc / sum;
  angles.resize(n);
  return angles;
}

template <class K = Double>
Curve_2<K> circle_2(const std::vector<Real>& angles, Real radius)
{
  using FT = typename K::FT;
  Curve_2<K> polygon;
  for (Real a : angles)
    polygon.emplace_back(typename K::Point_2(FT(radius * std::cos(a)), FT(radius * std::sin(a))),
                         typename K::Vector_2(FT(std::cos(a)), FT(std::sin(a))));
  return polygon;
}

// An orthonormal frame that no coordinate plane is parallel to.
struct Frame
{
  std::array<Real, 3> u, v, axis;

  Frame()
  {
    const Real x = std::sqrt(Real(2)), y = std::sqrt(Real(3)), z = std::sqrt(Real(6));
    u = {1 / x, -1 / x, 0};
    v = {1 / z, 1 / z, -2 / z};
    axis = {1 / y, 1 / y, 1 / y};
  }
};

// Samples of a helix, or of a circle if the pitch is 0, with the normals of its cylinder.
template <class K = Double>
Curve_3<K> helix(const std::vector<Real>& angles, Real radius, Real pitch)
{
  using FT = typename K::FT;
  const Frame f;
  Curve_3<K> polygon;
  for (Real a : angles) {
    std::array<FT, 3> p, n;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real r = std::cos(a) * f.u[i] + std::sin(a) * f.v[i];
      n[i] = FT(r);
      p[i] = FT(radius * r + pitch * a * f.axis[i]);
    }
    polygon.emplace_back(typename K::Point_3(p[0], p[1], p[2]),
                         typename K::Vector_3(n[0], n[1], n[2]));
  }
  return polygon;
}

// A wavy closed polygon; its normals are those of the circle, turned to and fro.
template <class K>
Curve_2<K> wavy(std::size_t n)
{
  using FT = typename K::FT;
  Curve_2<K> polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const FT a = FT(2 * CGAL_PI) * FT(i) / FT(n), r = FT(2) + FT(i % 3) / FT(4),
             b = a + FT(0.2) * FT(int(i * i % 5) - 2);
    polygon.emplace_back(typename K::Point_2(r * std::cos(a), r * std::sin(a)),
                         typename K::Vector_2(std::cos(b), std::sin(b)));
  }
  return polygon;
}

// --- measures, in long double ---

inline reference::Values values(const Curve_3<Double>& curve)
{
  reference::Values v;
  for (const auto& [p, n] : curve) {
    v.points.push_back({Real(p.x()), Real(p.y()), Real(p.z())});
    v.normals.push_back({Real(n.x()), Real(n.y()), Real(n.z())});
  }
  return v;
}

template <class Point>
Real radius_error(const Point& p, Real radius)
{
  return std::abs(std::hypot(Real(p.x()), Real(p.y())) / radius - 1);
}

// distance from the cylinder about the frame's axis
template <class Point>
Real cylinder_error(const Point& p, Real radius)
{
  const Frame f;
  const Real x[3] = {Real(p.x()), Real(p.y()), Real(p.z())};
  Real u = 0, v = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    u += x[i] * f.u[i];
    v += x[i] * f.v[i];
  }
  return std::abs(std::hypot(u, v) / radius - 1);
}

template <class Point>
Real height(const Point& p)
{
  const Frame f;
  return Real(p.x()) * f.axis[0] + Real(p.y()) * f.axis[1] + Real(p.z()) * f.axis[2];
}

template <class Curve, class Function>
Real largest(const Curve& curve, const Function& f)
{
  Real result = 0;
  for (const auto& item : curve) {
    const Real x = f(item);
    if (!(x <= result)) result = x;
  }
  return result;
}

} // namespace curve_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_CURVE_CASES_H
