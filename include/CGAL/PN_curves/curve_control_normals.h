// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_CURVE_CONTROL_NORMALS_H
#define CGAL_PN_CURVES_CURVE_CONTROL_NORMALS_H

#include <CGAL/PN_curves/internal/Curve_points.h>
#include <CGAL/PN_curves/internal/polygon_normals.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Curves

estimates the control normals of a polygon.

<b>In the plane</b> it is at each vertex the unit normal of the circle through the vertex and its two neighbors. It
points to the right of the direction of travel, hence outwards if the polygon runs counterclockwise. With the edges e,
f before and after a vertex, the tangent of that circle has the direction e/|e| weighted by |f| plus f/|f| weighted by
|e|: the shorter edge counts more. Hence samples of a circle get its exact normals, however uneven they are. An end of
an open polygon takes the normal of the circle through its last three points: the mirror image of its neighbor's.

<b>In space</b> it is the unit normal of that circle away from its center, where the radius is below
10<sup>6</sup> times the longer edge. Vertices in between, where the polygon is nearly straight, have the normal of
the vertex before, carried along by the smallest rotations from tangent to edge to tangent. It is turned about the
tangent, in proportion to the length, to meet the normal of the vertex after. The same rotations say which of two
normals point to the same side: past an inflection the normals point to the center, so that they do not flip.
Altogether more turns have their normals outside than inside; if as many, the first one has it outside. Round a closed
polygon the sides may not match (as on a Moebius strip); then the normals flip at one edge, where they differ most
anyway. The signs, the carried normals and what is nearly straight are computed in `double`; at the other vertices
normals of exact number types have their exact direction. A straight polygon in space gets zero vectors.

Neighbors are the nearest points that differ, so that repeated points share a normal; in the plane
an open polygon of two points gets the normal of its edge. If a tangent is not defined, for a single point or if both
neighbors are the same point, the result is zero: no control normal.

\tparam Range a model of `ConstRange` whose items are points, `Point_2` or `Point_3`, pairs with a
  point first, or anything that the named parameter `point_map` makes a point of
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param polygon the control polygon
\param end whether it is closed; both other values mean open
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`

\returns the points of the polygon with their normals, as `subdivide_curve()` takes them

\throws std::invalid_argument if a point is not finite (the message gives its position)

<br><b>Cost:</b> linear in the size of the polygon
*/
template <class Range, class NamedParameters = parameters::Default_named_parameters>
auto estimate_control_normals(const Range& polygon, Curve_end end,
                              const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  if constexpr (internal::check_kernel<typename Points::Kernel>()) {
    using FT = typename Points::FT;
    const auto points = Points::template get_all<FT>(polygon, np);
    const auto normals =
      internal::polygon_normals<FT, Points::dimension>(points, end == Curve_end::closed);
    std::vector<std::pair<typename Points::Point, typename Points::Vector>> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      result.emplace_back(internal::from_coordinates<typename Points::Point>(points[i]),
                          internal::from_coordinates<typename Points::Vector>(normals[i]));
    return result;
  }
}

/*!
\ingroup PkgPNSubdivision3Curves

takes the control normals of a polygon in space from a curve on the unit sphere. The curve is the image of the polygon
under the projection from a center, (p - c)/|p - c| for a point p. By Yang, Section 4.1 with Corollary 4.4, normals
need not be those of the curve, and the curve is as smooth as the less smooth one of the scheme and the spherical
curve.

A curve from points on a sphere about the center stays on the sphere, for every mask whose normals have the same weights as
its points. A point at the center gets the zero vector, "no control normal".

\tparam Range a model of `ConstRange` whose items are points, `Point_3`, pairs with a point first, or anything that the
  named parameter `point_map` makes a point of
\tparam Point the points of the polygon
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param polygon the control polygon
\param center the center c
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`

\returns the points of the polygon with their normals, as `subdivide_curve()` takes them

\throws std::invalid_argument if a point (the message gives its position) or the center is not finite

<br><b>Cost:</b> linear in the size of the polygon
*/
template <class Range, class Point, class NamedParameters = parameters::Default_named_parameters>
auto spherical_control_normals(const Range& polygon, const Point& center,
                               const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  static_assert(Points::dimension == 3,
                "PN_subdivision_3: spherical control normals are for curves in space");
  static_assert(std::is_same_v<Point, typename Points::Point>,
                "PN_subdivision_3: the center is not of the point type of the polygon");
  if constexpr (internal::check_kernel<typename Points::Kernel>()) {
    using FT = typename Points::FT;
    const Coordinates<FT, 3> c = internal::coordinates_3<FT>(center);
    internal::check_finite<FT, 3>(c, "position", [] { return std::string("the center"); });
    std::vector<std::pair<typename Points::Point, typename Points::Vector>> result;
    for (const Coordinates<FT, 3>& p : Points::template get_all<FT>(polygon, np)) {
      Coordinates<FT, 3> n = internal::difference(p, c);
      const auto name = [&] { return "point " + std::to_string(result.size()); };
      internal::check_finite<FT, 3>(n, "distance from the center", name);
      internal::normalize_control_normal<FT, 3>(n, name);
      result.emplace_back(internal::from_coordinates<typename Points::Point>(p),
                          internal::from_coordinates<typename Points::Vector>(n));
    }
    return result;
  }
}

/*!
\ingroup PkgPNSubdivision3Curves
rotates control normals in the plane counterclockwise.

\param polygon a range of pairs of `Point_2` and `Vector_2`
\param angle the angle in radians; its sine and cosine are `double`
\param positions the vertices whose normals are rotated
\throws std::invalid_argument if there is no such vertex; nothing has been changed then
*/
template <class Range>
void rotate_control_normals(Range& polygon, double angle, const std::vector<std::size_t>& positions)
{
  const auto size = static_cast<std::size_t>(std::distance(std::begin(polygon), std::end(polygon)));
  for (std::size_t i : positions)
    if (i >= size)
      throw std::invalid_argument("PN_subdivision_3: there is no vertex " + std::to_string(i) +
                                  " in a polygon of " + std::to_string(size));
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t i : positions) {
    auto& n = std::next(std::begin(polygon), static_cast<std::ptrdiff_t>(i))->second;
    using Vector = std::decay_t<decltype(n)>;
    using FT = std::decay_t<decltype(n.x())>;
    n = Vector(FT(c) * n.x() - FT(s) * n.y(), FT(s) * n.x() + FT(c) * n.y());
  }
}

/// \ingroup PkgPNSubdivision3Curves
/// rotates all control normals.
template <class Range>
void rotate_control_normals(Range& polygon, double angle)
{
  std::vector<std::size_t> all(
    static_cast<std::size_t>(std::distance(std::begin(polygon), std::end(polygon))));
  std::iota(all.begin(), all.end(), std::size_t(0));
  rotate_control_normals(polygon, angle, all);
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CURVES_CURVE_CONTROL_NORMALS_H
