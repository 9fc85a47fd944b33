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
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

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
    const T squared = dot(w, w);
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
  using T = At_least_double<FT>;
  Coordinates<double, 3> sum{0, 0, 0};
  double size = 0; // at least the sum of all |W||W'|
  for (const auto& ray : inverted.rays()) size += ray.squared;
  for (const auto& corner : inverted.corners())
    for (int k = 0; k < 3; ++k) sum[k] += corner.normal[k];
  double sum_length = std::sqrt(dot(sum, sum));
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
      const auto x = dot(n, arc.direction);
      const auto d = dot(derivative, arc.direction);
      const double r = x + dot(arc.normal, arc.direction);
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
  add_multiple(a, -dot(a, tangent), tangent);
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
    add_multiple(n, std::sin(phi), b);
    if (std::abs(change) <= solved) break;
  }
  if (!(dot(n, open_normal) > least_agreement)) return std::nullopt;
  return n;
}

// What share a reciprocal or border normal n, a unit vector, has beside the angle-weighted one: all
// if no corner of the fan with an area is turned more than 40 degrees away from n, nothing from 60
// degrees on or if no corner has an area. A corner of nearly 180 degrees is turned far on a smooth
// shape, too; that of a polygon, up to 60 degrees, is turned no more than the polygon is. (From there
// to 90 degrees this fades out: reflex corners stay what they are.)
template <class FT, class Face_normal_of>
double blend_weight(const Coordinates<double, 3>& n, const Inverted_fan<FT>& fan,
                    Face_normal_of& face_normal)
{
  constexpr double cos_40 = 0.76604444311897803520, cos_60 = 0.5;
  double least = 2;
  for (std::size_t i = 0; i < fan.corners().size(); ++i) {
    const auto& corner = fan.corners()[i];
    if (!corner.has_area) continue;
    const auto d = dot(n, corner.normal);
    double turn = 1; // its cosine
    if (!(d > 0 && d * d >= cos_40 * cos_40 * corner.squared)) {
      turn = d / std::sqrt(corner.squared);
      if (turn > 0) {
        const double gain = dot(n, face_normal(fan.rays()[i].halfedge)) - turn;
        turn += smoothstep<double>(turn / cos_60) * (std::max)(gain, 0.);
      }
    }
    if (turn <= cos_60) return 0;
    least = (std::min)(least, turn);
  }
  if (least > 1) return 0;
  return smoothstep<double>((least - cos_60) / (cos_40 - cos_60));
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_RECIPROCAL_NORMALS_H
