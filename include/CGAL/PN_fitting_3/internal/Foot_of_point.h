// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_FOOT_OF_POINT_H
#define CGAL_PN_FITTING_3_INTERNAL_FOOT_OF_POINT_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::PN_subdivision_3::internal {

// Where a piece of a surface or curve is nearest to a point.
struct Foot_in_piece
{
  double u = 0, v = 0, distance = std::numeric_limits<double>::infinity();
};

// A point whose distance from a surface or curve is sought, in better and better approximations of these. Their errors fall
// by 1/4 a round at least.
struct Foot_of_point
{
  std::array<double, 3> point{};
  std::uint32_t vertex = 0; // to which it belongs
  double distance = std::numeric_limits<double>::infinity(), error = distance, step = 0;

  void note(double next)
  {
    const double last_step = step;
    step = std::abs(next - distance);
    error = (std::max)(step, last_step / 8);
    distance = next;
  }
  bool is_settled(double tolerance) const { return error <= (std::max)(tolerance, distance / 64); }
};

// The largest of some distances, with its estimated error.
struct Farthest_point
{
  double distance = 0, error = 0;
  std::uint32_t vertex = 0;

  void add(const Foot_of_point& foot)
  {
    if (foot.distance > distance) *this = {foot.distance, foot.error, foot.vertex};
  }
};

// of Newton's method for the half square f of the length of r
inline std::array<double, 2> step_to_foot(const Jet_vector& r, const Jet& f)
{
  double a = 0, b = 0, c = 0;
  for (const Jet& x : r) a += x.u * x.u, b += x.u * x.v, c += x.v * x.v;
  if (f.uu > 0 && f.uu * f.vv - f.uv * f.uv > 1e-3 * a * c) a = f.uu, b = f.uv, c = f.vv;
  const double det = a * c - b * b;
  if (det > 0) return {(b * f.v - c * f.u) / det, (b * f.u - a * f.v) / det};
  return {a > 0 ? -f.u / a : 0., c > 0 ? -f.v / c : 0.};
}

// at(u, v): the Jet_average of the piece, over the unit square or the triangle u + v <= 1; of a curve v does not matter
template <class At>
Foot_in_piece foot_in_piece(const At& at, bool is_triangle, const std::array<double, 3>& point,
                            double u, double v)
{
  constexpr int most_steps = 16;
  const auto leaves = [](double x, double dx) { return (x <= 0 && dx < 0) || (x >= 1 && dx > 0); };
  const auto inside = [](double x) { return (std::min)(1., (std::max)(0., x)); };
  Foot_in_piece best;
  for (int i = 0; i < most_steps; ++i) {
    Jet_vector r = at(u, v).point;
    for (std::size_t k = 0; k < 3; ++k) r[k].value -= point[k];
    const Jet f = jet_product(r, r) * 0.5;
    if (const double distance = std::sqrt(2 * f.value); distance < best.distance)
      best = {u, v, distance};
    std::array<double, 2> d = step_to_foot(r, f);
    if (is_triangle && u + v >= 1 - 1e-15 && d[0] + d[1] > 0) {
      const double along = (f.v - f.u) / 2, size = f.uu / 2 - f.uv + f.vv / 2;
      d[0] = size > 0 ? along / size : 0;
      d[1] = -d[0];
    }
    if (leaves(u, d[0])) d = {0, f.vv > 0 ? -f.v / f.vv : 0};
    if (leaves(v, d[1])) d = {f.uu > 0 && !leaves(u, -f.u) ? -f.u / f.uu : 0, 0};
    const double last_u = u, last_v = v;
    u = inside(u + d[0]);
    v = inside(v + d[1]);
    if (is_triangle && u + v > 1) {
      u = inside(u - (u + v - 1) / 2);
      v = (std::min)(v, 1 - u);
    }
    if (!(std::abs(u - last_u) + std::abs(v - last_v) > 1e-15)) break;
  }
  return best;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_FOOT_OF_POINT_H
