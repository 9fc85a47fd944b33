// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_RECOGNIZE_ARCS_H
#define CGAL_PN_RECOGNITION_3_RECOGNIZE_ARCS_H

#include <CGAL/PN_curves/curve_control_normals.h>
#include <CGAL/PN_curves/curve_corners.h>
#include <CGAL/PN_curves/internal/Curve_points.h>
#include <CGAL/PN_curves/internal/polygon_normals.h>
#include <CGAL/PN_recognition_3/internal/recognition.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Curves

a piece of a polygon that is tessellated from one line or circle, as `recognize_arcs()` finds it. Numbers are `double`, whatever the
kernel.
*/
struct Recognized_arc
{
  /// what the piece is. Pieces of kind `unknown` are none of the others.
  enum class Kind { unknown, line, circle };

  /// which it is.
  Kind kind = Kind::unknown;
  /// the position of its first vertex.
  std::size_t first = 0;
  /// the position of its last vertex, in a numbering that goes on behind the end of a closed polygon. A closed polygon that is one
  /// piece goes from 0 to its size.
  std::size_t last = 0;
  /// that of the circle; in the plane the third coordinate is 0.
  std::array<double, 3> center{};
  /// that of the circle.
  double radius = 0;
  /// the largest distance of its vertices from the line or circle.
  double residual = 0;
};

/*!
\ingroup PkgPNSubdivision3Curves

cuts a polygon in a plane into the lines and circular arcs of which it is a tessellation.

As in `recognize_surfaces()` the vertices of a drawing are on its lines and arcs up to the rounding of the file. Three points
in a row are extended as long as the next ones are on their line or circle up to the tolerance. Three points are
evidence of a line, five of an arc, six if edges beside them on both sides are unknown and go on smoothly. Four points
are enough for an arc that is tangent to the edge beside it, three for one that is tangent at both ends, unless the
points beyond leave them as slowly as those of a free-form curve do. A circle in fewer than `min_facets` steps a turn
whose ends are not both tangent has lines as sides. Chords that are much longer than all others are lines, too. One or
two edges between corners and recognized pieces are lines; a corner turns by more than 61 degrees. All other pieces
are `unknown`. If nothing is recognized, the whole polygon is one unknown piece, unless all of its vertices are
corners.

\tparam Range a model of `ConstRange` with random access, as for `estimate_control_normals()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param polygon the polygon, in the plane, or in space if it is in a plane there
\param end whether it is closed; both other values mean open
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`,
  `parameters::min_facets()` (default 8) and `parameters::surface_tolerance()`, by default twice the
  rounding of the coordinates, as `recognize_surfaces()` finds it, and \f$ 10^{-8} \f$ times the diagonal of the bounding box

\returns the pieces in their order; the first one of a closed polygon begins at its first corner

\throws std::invalid_argument if a point is not finite, if the polygon is in no plane up to twice the tolerance, or a
  parameter is out of its range

<br><b>Cost:</b> about linear in the size of the polygon
*/
template <class Range, class NamedParameters = parameters::Default_named_parameters>
std::vector<Recognized_arc> recognize_arcs(const Range& polygon, Curve_end end,
                                           const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::min_facets_t,
                           internal::surface_tolerance_t>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  const internal::Recognition_parameters<NamedParameters> options(np);
  const auto points = Points::template get_all<double>(polygon, np);
  const bool closed = end == Curve_end::closed;
  const internal::recognition::Plane_of_polygon plane(points, closed, options.tolerance);
  auto [distinct, position] = internal::distinct_neighbors(plane.points(), closed);
  std::vector<std::size_t> original(distinct.size());
  for (std::size_t i = points.size(); i-- > 0;) original[position[i]] = i;
  const auto position_of = [&](std::ptrdiff_t number) {
    const std::size_t i = std::size_t(number), n = original.size();
    if (!closed && i + 1 == n) return points.size() - 1;
    return i < n ? original[i] : original[i - n] + points.size();
  };
  std::vector<Recognized_arc> result;
  for (const internal::recognition::Arc_run& run : internal::recognition::find_arcs(
         std::move(distinct), closed, plane.tolerance(), options.min_facets)) {
    Recognized_arc& arc = result.emplace_back();
    arc.kind = Recognized_arc::Kind(int(run.kind));
    arc.first = position_of(run.first);
    arc.last = position_of(run.last);
    if (arc.kind == Recognized_arc::Kind::unknown) continue;
    arc.residual = plane.scale() * run.residual;
    if (arc.kind == Recognized_arc::Kind::line) continue;
    arc.center = plane.in_space(run.center);
    arc.radius = plane.scale() * run.radius;
  }
  return result;
}

namespace internal {

template <class Range, class NamedParameters>
class Split_at_arcs
{
  using Points = Curve_points<Range, NamedParameters>;
  using Vector = typename Points::Vector;
  using Part = std::vector<std::pair<typename Points::Point, Vector>>;
  using Kind = Recognized_arc::Kind;
  using Direction = std::array<double, 2>;

public:
  Split_at_arcs(const Range& polygon, bool closed, const std::vector<Recognized_arc>& arcs,
                const recognition::Plane_of_polygon& plane, const NamedParameters& np)
    : polygon_(polygon)
    , closed_(closed)
    , arcs_(arcs)
    , plane_(plane)
    , np_(np)
    , size_(plane.points().size())
  {
    for (const Recognized_arc& a : arcs)
      if (a.first > a.last || a.last > (closed ? 2 * size_ : size_ - 1))
        throw std::invalid_argument("PN_subdivision_3: a piece has vertices that there are not: "
                                    "take those of recognize_arcs() for this polygon");
  }

  std::vector<Part> operator()() const
  {
    std::vector<Part> parts;
    for (const Recognized_arc& a : arcs_)
      parts.push_back(a.kind == Kind::unknown ? unknown_part(a) : known_part(a));
    const std::size_t n = arcs_.size();
    for (std::size_t k = 0; k < n && n > 1; ++k) {
      if (arcs_[k].kind != Kind::unknown) continue;
      const std::size_t before = (k + n - 1) % n, after = (k + 1) % n;
      if ((closed_ || k > 0) && arcs_[before].kind != Kind::unknown)
        take_over(parts[before].back(), parts[k].front());
      if ((closed_ || after > 0) && arcs_[after].kind != Kind::unknown)
        take_over(parts[after].front(), parts[k].back());
    }
    return parts;
  }

private:
  const Direction& at(std::size_t i) const { return plane_.points()[i % size_]; }

  template <class Function>
  void for_each_position(const Recognized_arc& a, const Function& f) const
  {
    const std::size_t end = a.last + (closed_ && arcs_.size() == 1 ? 0 : 1);
    for (std::size_t i = a.first; i < end; ++i) f(i % size_);
  }
  const auto& item(std::size_t i) const
  {
    return *std::next(std::begin(polygon_), static_cast<std::ptrdiff_t>(i));
  }

  // on the right of the direction of travel
  Part known_part(const Recognized_arc& a) const
  {
    const Direction center = plane_.in_plane(a.center);
    std::size_t next = a.first + 1;
    while (next < a.last && at(next) == at(a.first)) ++next;
    const Direction line = difference(at(a.last), at(a.first));
    const Direction d = difference(at(next), at(a.first)), r = difference(at(a.first), center);
    const double side = r[0] * d[1] - r[1] * d[0] < 0 ? -1 : 1;
    Part part;
    for_each_position(a, [&](std::size_t i) {
      Direction n = a.kind == Kind::line ? Direction{line[1], -line[0]} : difference(at(i), center);
      const double length = (a.kind == Kind::line ? 1 : side) * std::hypot(n[0], n[1]);
      if (length != 0) n = {n[0] / length, n[1] / length};
      part.emplace_back(get(Points::point_map(np_), item(i)), vector(n));
    });
    return part;
  }

  Part unknown_part(const Recognized_arc& a) const
  {
    std::vector<typename Points::Point> points;
    for_each_position(
      a, [&](std::size_t i) { points.push_back(get(Points::point_map(np_), item(i))); });
    const bool closed = closed_ && arcs_.size() == 1;
    Part part = estimate_control_normals(points, closed ? Curve_end::closed : Curve_end::reflect);
    if constexpr (Points::has_normals) {
      std::size_t k = 0;
      for_each_position(
        a, [&](std::size_t i) { part[k++].second = get(Points::normal_map(np_), item(i)); });
    } else if (Points::dimension == 3 && arcs_.size() > 1) { // on the side of the other pieces
      std::vector<Direction> directions;
      for_each_position(a, [&](std::size_t i) { directions.push_back(at(i)); });
      const auto normals = polygon_normals<double, 2>(directions, false);
      for (std::size_t k = 0; k < part.size(); ++k) part[k].second = vector(normals[k]);
    }
    return part;
  }

  Vector vector(const Direction& n) const
  {
    if constexpr (Points::dimension == 2)
      return from_coordinates<Vector>(n);
    else
      return from_coordinates<Vector>(plane_.direction_in_space(n));
  }

  template <class Item>
  static void take_over(const Item& known, Item& end)
  {
    const double cosine = CGAL::to_double(known.second * end.second);
    const double lengths = std::sqrt(CGAL::to_double(known.second.squared_length()) *
                                     CGAL::to_double(end.second.squared_length()));
    if (cosine > std::cos(recognition::radians(30)) * lengths) end.second = known.second;
  }

  const Range& polygon_;
  bool closed_;
  const std::vector<Recognized_arc>& arcs_;
  const recognition::Plane_of_polygon& plane_;
  const NamedParameters& np_;
  std::size_t size_;
};

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Curves

splits a control polygon into the pieces that `recognize_arcs()` has found, each with the normals of its line or
circle. Refined with `Curve_end::reflect` and a primal mask these stay lines and arcs, and `join_at_corners()` makes
one curve of them again. It has the common normal of two pieces that touch, at corners the normalized sum of both.

Normals are to the right of the direction of travel, as those of `estimate_control_normals()` are; in space more turns of the polygon have
theirs outside. They replace normals given for lines and arcs. Unknown pieces keep theirs, or get estimated ones; where such a
piece meets a line or an arc at no more than 30 degrees, it takes over the normal there.

\tparam Range a model of `ConstRange` with random access, as for `split_at_corners()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param polygon, end the polygon as it was given to `recognize_arcs()`
\param arcs the result of `recognize_arcs()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map` and `normal_map`, and that of
  `recognize_arcs()`

\returns the parts in the order of the pieces, as `split_at_corners()` does. A closed polygon that is one piece is returned as it
  is, to be refined with `Curve_end::closed`

\throws std::invalid_argument as `recognize_arcs()`, and if a piece has vertices that there are not
*/
template <class Range, class NamedParameters = parameters::Default_named_parameters>
auto split_at_arcs(const Range& polygon, Curve_end end, const std::vector<Recognized_arc>& arcs,
                   const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::min_facets_t,
                           internal::surface_tolerance_t>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  const internal::Recognition_parameters<NamedParameters> options(np);
  const bool closed = end == Curve_end::closed;
  const internal::recognition::Plane_of_polygon plane(Points::template get_all<double>(polygon, np),
                                                      closed, options.tolerance);
  return internal::Split_at_arcs<Range, NamedParameters>(polygon, closed, arcs, plane, np)();
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_RECOGNITION_3_RECOGNIZE_ARCS_H
