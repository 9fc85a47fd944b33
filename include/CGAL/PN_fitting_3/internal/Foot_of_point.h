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

// at(u, v): the Jet_average of the piece, over the unit square or the triangle u + v <= 1; of a curve v does not matter
template <class At>
Foot_in_piece foot_in_piece(const At& at, bool is_triangle, const std::array<double, 3>& point,
                            double u, double v)
{
  constexpr int most_steps = 16;
  Foot_in_piece best;
  for (int i = 0; i < most_steps; ++i) {
    Jet_vector r = at(u, v).point;
    for (std::size_t k = 0; k < 3; ++k) r[k].value -= point[k];
    if (const double distance = std::sqrt(jet_product(r, r).value); distance < best.distance)
      best = {u, v, distance};
    const auto [next_u, next_v] = next_foot(r, is_triangle, u, v);
    if (!(std::abs(next_u - u) + std::abs(next_v - v) > 1e-15)) break;
    u = next_u;
    v = next_v;
  }
  return best;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_FOOT_OF_POINT_H
