// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_CURVE_LIMIT_POINTS_H
#define CGAL_PN_CURVES_CURVE_LIMIT_POINTS_H

#include <CGAL/PN_curves/internal/Curve_limits.h>
#include <CGAL/PN_curves/internal/Curve_subdivision.h>
#include <CGAL/PN_curves/subdivide_curve.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/number_type_basic.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Limit

The point of the limit curve that belongs to a vertex of a control polygon, or to an edge of it if the mask
is dual; see `curve_limit_points()`.

\tparam Point `Point_2` or `Point_3` of a \cgal Kernel
\tparam Vector `Vector_2` or `Vector_3` of it
*/
template <class Point, class Vector>
struct Curve_limit_point
{
  /// the number of the vertex; of the edge from vertex i to the next one i + 1/2.
  double parameter = 0;
  /// the limit of the points of the vertex or edge.
  Point point;
  /// an estimate of the distance of `point` from the limit; it is not a bound that is proved.
  double error = 0;
  /// the limit of the control normals, a unit vector; zero if there is none, and with linear masks. *It is
  /// in general not perpendicular to the curve.*
  Vector control_normal;
  /// the unit tangent of the limit curve in the sense of the polygon, if it was asked for and `has_tangent`;
  /// otherwise zero.
  Vector tangent;
  /// the unit normal of the limit curve that is nearest to the control normal, if `has_tangent`. Where there
  /// is no control normal it is in the plane on the right of the curve, and in space zero. Without tangent it
  /// is `control_normal`.
  Vector normal;
  /// an estimate of the error of `tangent`, in radians.
  double tangent_error = 0;
  /// whether the curve has a tangent there.
  bool has_tangent = false;
  /// the curvature, if it was asked for and `has_curvature`; signs are those of `discrete_curvature()`.
  double curvature = 0;
  /// whether the curve has a curvature there.
  bool has_curvature = false;
};

namespace internal {

// a limit as a user sees it
template <class Limit, class Subdivision, class Result>
Limit to_curve_limit_point(const Result& result, double parameter)
{
  using Point = decltype(Limit::point);
  using Vector = decltype(Limit::tangent);
  using Reals = decltype(result.tangent);
  constexpr int dimension = std::tuple_size_v<Reals>;
  const Reals &t = result.tangent, &k = result.curvature_vector;
  Limit l;
  l.parameter = parameter;
  l.point = from_coordinates<Point>(point_of(result.value));
  const auto control_normal = Subdivision::normal_of(result.value);
  l.control_normal = l.normal = from_coordinates<Vector>(control_normal);
  l.tangent = from_coordinates<Vector>(t);
  if (result.has_surface_normal) {
    Reals n;
    for (std::size_t c = 0; c < dimension; ++c) n[c] = close_double(control_normal[c]);
    add_multiple<double, dimension>(n, -dot(n, t), t);
    const double length = std::sqrt(dot(n, n));
    for (double& x : n) x = length > 1e-12 ? x / length : 0;
    if constexpr (dimension == 2)
      if (!(length > 1e-12)) n = {t[1], -t[0]};
    l.normal = from_coordinates<Vector>(n);
  }
  l.error = result.error;
  l.tangent_error = result.normal_error;
  l.has_tangent = result.has_surface_normal;
  l.has_curvature = result.has_curvature;
  l.curvature = std::sqrt(dot(k, k));
  if (dimension == 2 && t[0] * k[1] - t[1] * k[0] < 0) l.curvature = -l.curvature;
  return l;
}

// Of masks of which the last one is that of all further rounds these are the limits that it gives the points after the
// other rounds.
template <class Range, class Mask, class NamedParameters>
auto limits_of_curve(const Range& polygon, const Mask& mask, Curve_end end,
                     const NamedParameters& np)
{
  static_assert(!is_level_dependent_v<Mask> || is_listed_v<Mask>,
                "PN_subdivision_3: limits are known of masks that are the same from some round on: "
                "make the mask of a vector of masks, level_dependent_mask(masks)");
  using Parameters = Curve_parameters<Range, NamedParameters>;
  using FT = typename Parameters::FT;
  constexpr int dimension = Parameters::dimension;
  using Subdivision = Curve_subdivision<FT, dimension, Mask>;
  using Limits = Curve_limits<FT, dimension, Mask_in_round<Mask>>;
  using Limit = Curve_limit_point<typename Parameters::Point, typename Parameters::Vector>;

  const FT roundness = Parameters::roundness(np);
  Subdivision curve(mask, end, roundness);
  for_each_point_and_normal<Parameters, Limits::is_pn>(
    polygon, end, np, [&](const auto& p, const auto& n) { curve.add(p, n); });
  std::vector<std::int64_t> places(static_cast<std::size_t>(curve.size()));
  std::iota(places.begin(), places.end(), 0);
  unsigned rounds = 1;
  if constexpr (is_listed_v<Mask>) rounds = static_cast<unsigned>(mask.function.masks.size());
  const bool is_primal = curve.is_primal();
  for (unsigned k = 1; !places.empty(); ++k) {
    curve.begin_round(k);
    if (curve.is_primal() != is_primal)
      throw std::invalid_argument(
        "PN_subdivision_3: of the masks of the rounds some are primal and "
        "some dual, so that no limit belongs to a vertex or an edge");
    if (k == rounds) break;
    const auto left_out = curve.refine();
    for (std::int64_t& place : places) place = 2 * place - left_out;
  }
  const auto values =
    curve.template result<typename Limits::Value>(0, [](const auto& value) { return value; });
  if (!values.empty()) curve.range(curve.size()); // refuses polygons that are too short

  Limit_options options = limit_options(np);
  options.surface_normals = options.curve_normals || options.curvatures;
  const double box = box_size(values.size(), dimension, [&](std::size_t i, std::size_t c) {
    return CGAL::to_double(point_of(values[i])[c]);
  });
  const Limit_demand demand = limit_demand<FT>(options, box);
  Limits limits(mask_in_round(mask, rounds), end, demand, roundness);
  const auto [first, last] = limits.range(curve.size());
  std::vector<typename Limits::Result> results;
  std::vector<Limit> points;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] < first || places[i] >= last) continue;
    const auto name = [i] { return "point " + std::to_string(i); };
    results.emplace_back();
    name_undecided<FT>([&, i] { results.back() = limits(values, places[i]); },
                       [&] {
                         return "whether a normal next to " + name() +
                                " vanishes or is opposite to a neighbor's";
                       });
    check_in_range(point_of(results.back().value), [&] { return "the limit point of " + name(); });
    points.push_back(to_curve_limit_point<Limit, Subdivision>(
      results.back(), static_cast<double>(i) + (is_primal ? 0. : 0.5)));
  }
  return std::make_pair(std::move(points), limit_report(results, demand));
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Limit

computes the points of the limit curve of a mask that belong to the vertices of a control polygon: where they
would come to lie after infinitely many rounds. With a dual mask, such as `B_spline_mask` of an even degree,
they belong to the edges. The polygon may be of any level.

All is as in `limit_points()`. The limit mask l is a left eigenvector of the matrix that maps the points next to a
vertex to those of the next round. Its point-normal average over them is exact on circles, on circular cylinders and
with linear masks. Otherwise the neighborhood is refined by itself until the averages stay: their differences fall by
1/16 a round. The ends of an open polygon have matrices of their own.

<b>Tangents.</b> The left eigenvector of the eigenvalue 1/2 applied to the parts of the neighbors perpendicular
to the limit control normal and to their point-normal heights over the limit is the derivative. Its error falls
by 1/4 a round. B-splines of degree 2 and more and masks on 4 points and more have tangents; degree 1 and 2
points have none.

<b>Curvature</b> is computed if the eigenvalue 1/4 is simple and all after it are much smaller. This holds for
B-splines of degree 3 and more, but for the ends of dual ones, and for Dubuc-Deslauriers masks on 6 points and more.
Quadratic B-splines have another curvature on either side of their limit points, and that of 4 points does not
converge. Its error is not estimated; ten rounds are done.

Limit masks have the precision of the number type. Intervals contain the limits of linear and of interpolatory masks; others
are refused. In exact number types limit masks and the limit points of `linear()` masks are exact. With normals one
round is done at most about a vertex that is not near an end, so that the tolerance may be missed. Tangents,
curvatures and errors are computed in `double`, from differences in the number type.

<b>Masks that differ from round to round.</b> If the last mask is that of all further rounds, as of
`level_dependent_mask()` of a vector of masks, the polygon is refined by the others. The limits of the last one are
those of the curve. The masks are all primal or all dual.

\tparam Range a model of `ConstRange`, as for `subdivide_curve()`

\tparam Mask a model of `PNSubdivisionCurveMask`, or what `linear()` or `with_normal_mask()` makes of one, or
  `level_dependent_mask()` of a vector of these

\param polygon the control polygon
\param mask the mask
\param end whether the polygon is closed, and if not, what happens at its ends. With `Curve_end::none` only
  vertices and edges have limits whose neighborhoods do not leave the polygon.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`, `normal_map`,
   `geom_traits` and `roundness`, as for `subdivide_curve()`; normals of points that have none are estimated.
   Precision and kinds of results are set by `tolerance`, `normal_tolerance`, `max_depth`, `curve_normals` and
   `curvatures` of `CGAL::PN_subdivision_3::parameters`

\returns a pair: a `std::vector` with a `Curve_limit_point` for each vertex or edge that has one, in their order,
  and a `Limit_report`. A tolerance that cannot be met is no error.

\throws std::invalid_argument as `subdivide_curve()` does. Further reasons are a tolerance that is negative or not a
  number, an interval number type that is to contain an estimate, and powers of the mask's matrix that do not converge
\throws std::overflow_error if a limit point is out of the range of a floating point type
\throws std::domain_error if an interval number type leaves a comparison undecided

<br><b>Cost:</b> linear in the size of the polygon
*/
template <class Range, class Mask, class NamedParameters = parameters::Default_named_parameters>
auto curve_limit_points(const Range& polygon, const Mask& mask, Curve_end end,
                        const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::roundness_t, internal::tolerance_t,
                           internal::normal_tolerance_t, internal::max_depth_t,
                           internal::curve_normals_t, internal::curvatures_t>();
  using Parameters = internal::Curve_parameters<Range, NamedParameters>;
  if constexpr (internal::check_kernel<typename Parameters::Geom_traits>())
    return internal::limits_of_curve(polygon, mask, end, np);
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CURVES_CURVE_LIMIT_POINTS_H
