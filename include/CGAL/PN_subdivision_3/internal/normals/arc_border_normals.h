// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ARC_BORDER_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ARC_BORDER_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>

#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// an arc from a border vertex to a neighbor whose normal is known
struct Border_arc
{
  Coordinates<double, 3> direction, normal; // unit vectors
};

// The sum of the squares of r_j = (n + n_j).u_j at a normal n(phi): half its first and second
// derivative by phi. Where the arcs fit, r_j = 0, Newton's step is that of Gauss and Newton; where
// they contradict each other, the latter runs to and fro.
struct Border_arcs_sum
{
  using Vector = Coordinates<double, 3>;

  Border_arcs_sum(const std::vector<Border_arc>& arcs, const Vector& n, const Vector& derivative)
  {
    for (const Border_arc& arc : arcs) {
      const auto x = dot<double, 3>(n, arc.direction);
      const auto d = dot<double, 3>(derivative, arc.direction);
      const double r = x + dot<double, 3>(arc.normal, arc.direction);
      slope += d * d;
      first += r * d;
      second += d * d - r * x; // the second derivative of n is -n
    }
  }

  double newton_step(double longest) const
  {
    if (first == 0) return 0;
    if (second * longest > std::abs(first)) return -first / second;
    return std::copysign(longest, -first);
  }

  double slope = 0, first = 0, second = 0;
};

// The PN height between two points is zero if (n_i + n_j).(p_j - p_i) = 0; all pairs of points of a
// sphere or a circular cylinder fulfil it. The border normal is the one orthogonal to the tangent
// of the border that fulfils it best:
//   n = cos(phi) a + sin(phi) (a x t) minimizing the sum of (((n + n_j).e_j)/|e_j|)^2,
// where a is the open fan's normal made orthogonal to t. Returns nothing where that does not
// determine n. The open fan's normal and the tangent are unit vectors, or zero if there is none.
inline std::optional<Coordinates<double, 3>>
arc_border_normal(const Coordinates<double, 3>& open_normal, const Coordinates<double, 3>& tangent,
                  const std::vector<Border_arc>& arcs)
{
  using Vector = Coordinates<double, 3>;
  constexpr int most_steps = 8;
  constexpr double longest_step = 0.5, least_slope = 1e-12, least_agreement = 0.3;
  constexpr double solved = 0x1p-40; // its square is below all rounding

  if (is_zero(open_normal) || is_zero(tangent)) return std::nullopt;
  Vector a = open_normal;
  add_multiple<double, 3>(a, -dot<double, 3>(a, tangent), tangent);
  const double a_length = length(a);
  if (!(a_length > solved)) return std::nullopt;
  a = quotient(a, a_length);
  const Vector b = cross(a, tangent);

  double phi = 0;
  Vector n = a;
  for (int step = 0; step < most_steps; ++step) {
    const Border_arcs_sum sum(arcs, n, cross(n, tangent));
    if (!(sum.slope > least_slope)) {
      if (step == 0) return std::nullopt;
      break;
    }
    const double change = sum.newton_step(longest_step);
    phi += change;
    n = multiple(std::cos(phi), a);
    add_multiple<double, 3>(n, std::sin(phi), b);
    if (std::abs(change) <= solved) break;
  }
  if (!(dot<double, 3>(n, open_normal) > least_agreement)) return std::nullopt;
  return n;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ARC_BORDER_NORMALS_H
