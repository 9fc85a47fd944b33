// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_ANALYSIS_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_ANALYSIS_H

#include <CGAL/PN_curves/internal/Curve_points.h>
#include <CGAL/PN_curves/internal/Curve_subdivision.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Measures are taken in long double, so that they do not disturb what they measure.
template <int dimension>
using Real_coordinates = Coordinates<long double, dimension>;

template <class FT, std::size_t dimension>
std::array<FT, dimension> difference_of(const std::array<FT, dimension>& a,
                                        const std::array<FT, dimension>& b)
{
  std::array<FT, dimension> c;
  for (std::size_t i = 0; i < dimension; ++i) c[i] = a[i] - b[i];
  return c;
}

// The vector from p to the center of the circle through p + a, p and p + b, divided by the squared
// radius: zero if the three are on a line or two of them are the same.
template <int dimension>
Real_coordinates<dimension> curvature_vector(const Real_coordinates<dimension>& a,
                                             const Real_coordinates<dimension>& b)
{
  using Real = long double;
  const auto c = difference_of(a, b);
  const Real aa = dot<Real, dimension>(a, a), bb = dot<Real, dimension>(b, b),
             cc = dot<Real, dimension>(c, c), ab = dot<Real, dimension>(a, b);
  Real_coordinates<dimension> k{};
  if (aa == 0 || bb == 0 || cc == 0) return k;
  add_multiple<Real, dimension>(k, 2 * (1 - ab / aa) / cc, a);
  add_multiple<Real, dimension>(k, 2 * (1 - ab / bb) / cc, b);
  return k;
}

// The curvature vector k of a circle at one of its points becomes the one at another of them.
template <int dimension>
void move_curvature_vector(Real_coordinates<dimension>& k, const Real_coordinates<dimension>& from,
                           const Real_coordinates<dimension>& to)
{
  const auto square = dot<long double, dimension>(k, k);
  add_multiple<long double, dimension>(k, square, difference_of(from, to));
}

// f(a, b) for every vertex of a polygon, with a and b from it to its neighbors. Ends of an open one
// take the value next to them; zero, if there are less than three points.
template <class Result, class Point, class Function>
std::vector<Result> at_vertices(const std::vector<Point>& p, bool closed, const Function& f)
{
  const std::size_t n = p.size();
  std::vector<Result> result(n, Result{});
  if (n < 3) return result;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t m = closed ? i : (std::min)((std::max)(i, std::size_t(1)), n - 2);
    result[i] = f(difference_of(p[(m + n - 1) % n], p[m]), difference_of(p[(m + 1) % n], p[m]));
  }
  return result;
}

} // namespace internal

/*!
returns the discrete curvature at each point of a curve: one over the radius of the circle through
the point and its two neighbors, 0 up to rounding if they are on a line. In the plane it is positive where the curve
turns left; in space it is not negative. The ends of an open curve take the value of the point next
to them. Where a neighbor is the same point, or both neighbors are, the result is 0.

The circle through three points does not depend on their spacing: samples of a circle give its
curvature however uneven they are. Points of a curve of rounding error &epsilon; and spacing h
determine curvatures to about &epsilon;/h<sup>2</sup> only.

\tparam Range a model of `ConstRange` whose items are points, pairs with a point first as
`subdivide_curve()` returns them, or anything that the named parameter `point_map` makes a point of
\param curve the points of the curve, in the plane or in space
\param end whether the curve is closed; both other values mean open
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`
\throws std::invalid_argument if a point is not finite
*/
template <class Range, class NamedParameters = parameters::Default_named_parameters>
std::vector<double> discrete_curvature(const Range& curve, Curve_end end,
                                       const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  using Real = long double;
  constexpr int dimension = Points::dimension;
  const auto curvature = [](const auto& a, const auto& b) -> double {
    const auto k = internal::curvature_vector<dimension>(a, b);
    const Real length = std::sqrt(internal::dot<Real, dimension>(k, k));
    if constexpr (dimension == 2)
      return static_cast<double>(a[0] * b[1] - a[1] * b[0] > 0 ? -length : length);
    else
      return static_cast<double>(length);
  };
  return internal::at_vertices<double>(Points::template get_all<Real>(curve, np),
                                       end == Curve_end::closed, curvature);
}

/*!
returns the end points of the teeth of a curvature comb: from each point p of the curve a tooth of
length `scale` times the discrete curvature, away from the center of curvature.

The teeth are normal to the circles through three points, see `discrete_curvature()`, whatever the
normals of the curve are.

\param curve the points of the curve, in the plane or in space
\param end whether the curve is closed; both other values mean open
\param scale the length of a tooth where the curvature is 1
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`
\returns as many points as the curve has
\throws std::invalid_argument if a point is not finite
*/
template <class Range, class NamedParameters = parameters::Default_named_parameters>
auto curvature_comb(const Range& curve, Curve_end end, double scale,
                    const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  using Real = long double;
  constexpr int dimension = Points::dimension;
  const auto points = Points::template get_all<Real>(curve, np);
  auto k = internal::at_vertices<internal::Real_coordinates<dimension>>(
    points, end == Curve_end::closed, internal::curvature_vector<dimension>);
  if (end != Curve_end::closed && points.size() > 2) {
    internal::move_curvature_vector<dimension>(k.front(), points[1], points[0]);
    internal::move_curvature_vector<dimension>(k.back(), points.end()[-2], points.back());
  }
  std::vector<typename Points::Point> comb;
  comb.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto tip = points[i];
    internal::add_multiple<Real, dimension>(tip, -static_cast<Real>(scale), k[i]);
    comb.push_back(internal::from_coordinates<typename Points::Point>(tip));
  }
  return comb;
}

/*!
returns the divided differences &Delta;<sup>m</sup>p / 2<sup>-km</sup> of a curve after k rounds, as
vectors in the kernel of its points. As k grows they tend to the m-th derivative with respect to the
parameter of the control polygon if the curve is m times continuously differentiable; they converge
or not as the curve is smooth or not.

\param curve the points of the curve, in the plane or in space
\param end whether the curve is closed, then there are as many differences as points; both other
values mean open, then there are m less
\param order the order m
\param rounds the number k of rounds that made the curve
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`
\returns difference i begins at point i: for m = 2, p<sub>i+2</sub> - 2 p<sub>i+1</sub> +
p<sub>i</sub>; none if an open curve has no more than m points
\throws std::invalid_argument if a point is not finite
*/
template <class Range, class NamedParameters = parameters::Default_named_parameters>
auto divided_differences(const Range& curve, Curve_end end, unsigned order, unsigned rounds,
                         const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  using FT = typename Points::FT;
  auto d = Points::template get_all<FT>(curve, np);
  const FT scale(std::ldexp(1.0, static_cast<int>(rounds)));
  for (unsigned m = 0; m < order && !d.empty(); ++m) {
    const auto first = d.front();
    for (std::size_t i = 0; i < d.size(); ++i) {
      d[i] = internal::difference_of(i + 1 < d.size() ? d[i + 1] : first, d[i]);
      for (FT& x : d[i]) x *= scale;
    }
    if (end != Curve_end::closed) d.pop_back();
  }
  std::vector<typename Points::Vector> result;
  result.reserve(d.size());
  for (const auto& v : d) result.push_back(internal::from_coordinates<typename Points::Vector>(v));
  return result;
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_ANALYSIS_H
