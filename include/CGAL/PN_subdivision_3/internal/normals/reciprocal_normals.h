// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_RECIPROCAL_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_RECIPROCAL_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/average/Unit_normal_traits.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/is_interval.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/normals/Inverted_fan.h>
#include <CGAL/Uncertain.h>

#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// N. Max, Weights for computing vertex normals from facet normals, 1999: the sum of the cross
// products of the inverted edges. Inversion at a point of a sphere maps the sphere to a plane; the
// inverted edges are a polygon in it, whose area vector this is. An open fan is closed through the
// vertex.

// the sum in the number type T: exact in exact types. Zero if the number type cannot tell.
template <class T, class Point_of>
Coordinates<T, 3> reciprocal_sum(const Level_connectivity& level, const Fan& fan,
                                 const Point_of& point)
{
  using Vector = Coordinates<T, 3>;
  const auto& p = point(level.target(fan.first));
  Vector sum{T(0), T(0), T(0)}, first = sum, before = sum;
  bool is_first = true, is_decided = true;
  const auto add = [&sum](const Vector& a, const Vector& b) {
    const Vector c = cross(b, a);
    for (int k = 0; k < 3; ++k) sum[k] += c[k];
  };
  for_each_halfedge(level, fan, [&](Level_connectivity::Index h) {
    const auto& q = point(level.source(h));
    Vector w{T(q[0]) - T(p[0]), T(q[1]) - T(p[1]), T(q[2]) - T(p[2])};
    const T squared = dot<T, 3>(w, w);
    if (CGAL::certainly(squared == T(0))) return;
    if (!CGAL::certainly(is_greater(squared, T(0)))) is_decided = false;
    for (T& x : w) x /= squared;
    if (is_first)
      first = w;
    else
      add(before, w);
    is_first = false;
    before = w;
  });
  if (fan.closed) add(before, first);
  if (!is_decided) return {T(0), T(0), T(0)};
  return sum;
}

// The unit reciprocal normal of a fan in double; zero if it vanishes.
template <class FT, class Point_of>
Coordinates<double, 3> reciprocal_normal(const Level_connectivity& level, const Fan& fan,
                                         const Point_of& point, const Inverted_fan<FT>& inverted)
{
  using T = Wide_number<FT>;
  Coordinates<double, 3> sum{0, 0, 0};
  double size = 0; // at least the sum of all |W||W'|
  for (const auto& ray : inverted.rays()) size += ray.squared;
  for (const auto& corner : inverted.corners())
    for (int k = 0; k < 3; ++k) sum[k] += corner.normal[k];
  double sum_length = std::sqrt(dot<double, 3>(sum, sum));
  if (!(sum_length > vanishing_tolerance<FT>() * size)) {
    size = 0;
    const auto& rays = inverted.rays();
    for (std::size_t i = 0; i < inverted.corners().size(); ++i)
      size += std::sqrt(rays[i].squared * rays[i + 1 < rays.size() ? i + 1 : 0].squared);
    if constexpr (!std::is_same_v<T, double>) {
      if (!(sum_length > vanishing_tolerance<FT>() * size)) {
        sum = to_double_3<T>(reciprocal_sum<T>(level, fan, point));
        sum_length = length(sum);
      }
    }
    const auto epsilon = static_cast<double>(CGAL::to_double(machine_epsilon<FT>()));
    if (!(sum_length > 4096 * epsilon * size) || !std::isfinite(sum_length)) return {0, 0, 0};
  }
  return quotient(sum, sum_length);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_RECIPROCAL_NORMALS_H
