// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_CURVE_CORNERS_H
#define CGAL_PN_CURVES_CURVE_CORNERS_H

#include <CGAL/PN_curves/curve_control_normals.h>
#include <CGAL/PN_curves/internal/Curve_points.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// The first and the last position of each part, in a numbering that goes on behind the end of a
// closed polygon.
inline std::vector<std::pair<std::size_t, std::size_t>>
parts_between_corners(std::size_t size, Curve_end end, std::vector<std::size_t> corners)
{
  for (std::size_t i : corners)
    if (i >= size)
      throw std::invalid_argument("PN_subdivision_3: there is no vertex " + std::to_string(i) +
                                  " in a polygon of " + std::to_string(size));
  if (end != Curve_end::closed && size > 0) {
    corners.push_back(0);
    corners.push_back(size - 1);
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (end == Curve_end::closed) {
    if (corners.empty())
      throw std::invalid_argument(
        "PN_subdivision_3: a closed polygon without corners has no parts: "
        "give at least one corner, or subdivide it as it is");
    corners.push_back(corners.front() + size);
  }
  std::vector<std::pair<std::size_t, std::size_t>> parts;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    parts.emplace_back(corners[k], corners[k + 1]);
  if (corners.size() == 1) parts.emplace_back(corners.front(), corners.front());
  return parts;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Curves

splits a control polygon at corners into open polygons, each from one corner to the next. Refined with
`Curve_end::reflect` and a primal mask they keep their end points, and `join_at_corners()` makes one
curve of them again, with a sharp corner.

A control normal given at a corner serves the parts on both sides. If the items of the polygon have no normals, these
are estimated part by part as by `estimate_control_normals()`: a corner then has a normal for each side.

\tparam Range a model of `ConstRange` with random access, as for `subdivide_curve()` or, without
  normals, for `estimate_control_normals()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param polygon the control polygon
\param end whether it is closed; both other values mean open, and its ends are corners, too
\param corners positions of vertices, in any order
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map` and
  `normal_map`

\returns the parts in their order, those of a closed polygon from the first corner on; each is a vector
  of pairs of points and normals, as `subdivide_curve()` takes them

\throws std::invalid_argument if there is no such vertex, if a closed polygon has no corner, or if a
  point is not finite
*/
template <class Range, class NamedParameters = parameters::Default_named_parameters>
auto split_at_corners(const Range& polygon, Curve_end end, const std::vector<std::size_t>& corners,
                      const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  using Part = std::vector<std::pair<typename Points::Point, typename Points::Vector>>;
  const auto first = std::begin(polygon);
  const auto size = static_cast<std::size_t>(std::distance(first, std::end(polygon)));
  const auto point_map = Points::point_map(np);
  std::vector<Part> parts;
  for (const auto& [from, to] : internal::parts_between_corners(size, end, corners)) {
    const auto for_each_item = [&, begin = from, last = to](const auto& f) {
      for (std::size_t i = begin; i <= last; ++i)
        f(*std::next(first, static_cast<std::ptrdiff_t>(i % size)));
    };
    if constexpr (Points::has_normals) {
      const auto normal_map = Points::normal_map(np);
      Part& part = parts.emplace_back();
      for_each_item(
        [&](const auto& item) { part.emplace_back(get(point_map, item), get(normal_map, item)); });
    } else {
      std::vector<typename Points::Point> points;
      for_each_item([&](const auto& item) { points.push_back(get(point_map, item)); });
      parts.push_back(estimate_control_normals(points, Curve_end::reflect));
    }
  }
  return parts;
}

/*!
\ingroup PkgPNSubdivision3Curves

joins parts of a curve, each of which begins where the one before ends. The point that two parts share
appears once; if its normals differ, it has their normalized sum (zero if they are opposite).

\param parts vectors of pairs of points and normals
\param end `Curve_end::closed` if the last part ends where the first one begins; the curve then begins
  there and does not repeat this point

\returns a vector of pairs of points and normals
*/
template <class Point, class Vector>
std::vector<std::pair<Point, Vector>>
join_at_corners(const std::vector<std::vector<std::pair<Point, Vector>>>& parts, Curve_end end)
{
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  constexpr int dimension = CGAL::Ambient_dimension<Point>::value;
  const auto shared_normal = [](const Vector& a, const Vector& b) {
    if (a == b) return a;
    auto n = internal::coordinates_of<FT, dimension>(a + b);
    const FT tolerance = Unit_normal_traits<FT>::vanishing_tolerance();
    if (internal::dot(n, n) <= tolerance * tolerance) return Vector(NULL_VECTOR);
    internal::normalize_control_normal<FT, dimension>(n);
    return internal::from_coordinates<Vector>(n);
  };
  std::vector<std::pair<Point, Vector>> curve;
  for (const auto& part : parts)
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (i == 0 && !curve.empty() && curve.back().first == part[0].first)
        curve.back().second = shared_normal(curve.back().second, part[0].second);
      else
        curve.push_back(part[i]);
    }
  if (end == Curve_end::closed && curve.size() > 1 && curve.front().first == curve.back().first) {
    curve.front().second = shared_normal(curve.back().second, curve.front().second);
    curve.pop_back();
  }
  return curve;
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CURVES_CURVE_CORNERS_H
