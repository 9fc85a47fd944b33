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
#include <CGAL/PN_curves/subdivide_curve.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/internal/average/checked_coordinates.h>
#include <CGAL/PN_subdivision_3/internal/average/kernel_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

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

// A polygon in the number type of its computations, checked, with unit normals.
template <class Limits, class Parameters, class Range, class NamedParameters>
std::vector<typename Limits::Value> limit_polygon(const Range& polygon, Curve_end end,
                                                  const NamedParameters& np)
{
  using FT = typename Parameters::FT;
  constexpr int dimension = Parameters::dimension;
  std::vector<typename Limits::Value> values;
  const auto add = [&](const auto& point, const auto& normal) {
    const auto name = [&] { return "point " + std::to_string(values.size()); };
    Point_normal<FT, dimension> v;
    for (std::size_t c = 0; c < dimension; ++c) {
      v.point[c] = FT(point.cartesian(static_cast<int>(c)));
      v.normal[c] = FT(normal.cartesian(static_cast<int>(c)));
    }
    check_finite<FT, dimension>(v.point, "position", name);
    check_finite<FT, dimension>(v.normal, "normal", name);
    if constexpr (Limits::is_pn) {
      normalize_control_normal<FT, dimension>(v.normal, name);
      values.push_back(v);
    } else
      values.push_back(v.point);
  };
  for_each_point_and_normal<Parameters, Limits::is_pn>(polygon, end, np, add);
  return values;
}

// The results as a user sees them.
template <class Point, class Vector, class FT, int dimension>
class Curve_limit_maker
{
  using Reals = Coordinates<double, dimension>;

public:
  using Limit = Curve_limit_point<Point, Vector>;

  template <class Average>
  static Limit make(const Curve_limit_result<Average, dimension>& result, double parameter)
  {
    Limit l;
    l.parameter = parameter;
    Reals n{};
    if constexpr (std::is_same_v<typename Average::Value, Point_normal<FT, dimension>>) {
      l.point = to<Point>(result.value.point);
      l.control_normal = to<Vector>(result.value.normal);
      for (std::size_t c = 0; c < dimension; ++c) n[c] = close_double(result.value.normal[c]);
    } else {
      l.point = to<Point>(result.value);
      l.control_normal = to<Vector>(internal::zero_vector<FT, dimension>());
    }
    l.error = result.error;
    l.tangent_error = result.tangent_error;
    l.has_tangent = result.has_tangent;
    l.tangent = to<Vector>(result.tangent);
    l.normal = result.has_tangent ? to<Vector>(normal(n, result.tangent)) : l.control_normal;
    l.has_curvature = result.has_curvature;
    if (l.has_curvature) l.curvature = curvature(result);
    return l;
  }

private:
  template <class Point_or_vector, class Number>
  static Point_or_vector to(const Coordinates<Number, dimension>& c)
  {
    if constexpr (dimension == 2)
      return Point_or_vector(FT(c[0]), FT(c[1]));
    else
      return Point_or_vector(FT(c[0]), FT(c[1]), FT(c[2]));
  }

  static Reals normal(Reals n, const Reals& tangent)
  {
    add_multiple<double, dimension>(n, -dot<double, dimension>(n, tangent), tangent);
    const double length = std::sqrt(dot<double, dimension>(n, n));
    if (length > 1e-12) {
      for (double& x : n) x /= length;
      return n;
    }
    if constexpr (dimension == 2)
      return {tangent[1], -tangent[0]};
    else
      return {};
  }

  template <class Average>
  static double curvature(const Curve_limit_result<Average, dimension>& result)
  {
    const Reals &k = result.curvature_vector, &t = result.tangent;
    const double length = std::sqrt(dot<double, dimension>(k, k));
    if constexpr (dimension == 2)
      return t[0] * k[1] - t[1] * k[0] < 0 ? -length : length;
    else
      return length;
  }
};

template <class FT>
Curve_limit_demand curve_limit_demand(const Limit_options& options, double box)
{
  if (!(options.tolerance >= 0) || !(options.normal_tolerance >= 0))
    throw std::invalid_argument(
      "PN_subdivision_3: a tolerance must be a number that is not negative");
  Curve_limit_demand demand;
  demand.tolerance = options.tolerance * box;
  demand.normal_tolerance = options.normal_tolerance;
  // exact numbers grow too long; the estimate needs one round
  demand.max_depth = is_exact_v<FT> ? 1 : (std::max)(1u, options.max_depth);
  demand.normals = options.curve_normals || options.curvatures;
  demand.curvatures = options.curvatures;
  return demand;
}

// the largest side of the box of the points
template <class Limits>
double box_size(const std::vector<typename Limits::Value>& values)
{
  double size = 0;
  for (std::size_t c = 0; c < Limits::dimension; ++c) {
    double least = 0, greatest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double x = CGAL::to_double(Limits::point_of(values[i])[c]);
      least = i == 0 ? x : (std::min)(least, x);
      greatest = i == 0 ? x : (std::max)(greatest, x);
    }
    size = (std::max)(size, greatest - least);
  }
  return size;
}

inline void add_to_report(const Curve_limit_demand& demand, double error, double tangent_error,
                          unsigned depth, bool has_tangent, Limit_report& report)
{
  report.error = (std::max)(report.error, error);
  report.normal_error = (std::max)(report.normal_error, tangent_error);
  report.depth = (std::max)(report.depth, depth);
  if (!(error <= demand.tolerance) || !(tangent_error <= demand.normal_tolerance))
    ++report.number_of_misses;
  if (demand.normals && !has_tangent) ++report.number_of_stand_ins;
}

// What has a limit, by its number in the polygon that is looked at and its parameter in the user's.
struct Place_of_limit
{
  std::int64_t number;
  double parameter;
};

// places(first, how many) chooses among those that have limits.
template <class Range, class Mask, class NamedParameters, class Places>
auto limits_at_places(const Range& polygon, const Mask& mask, Curve_end end,
                      const Limit_options& options, const NamedParameters& np, const Places& places)
{
  using Parameters = Curve_parameters<Range, NamedParameters>;
  using FT = typename Parameters::FT;
  constexpr int dimension = Parameters::dimension;
  using Limits = Curve_limits<FT, dimension, Mask>;
  using Maker =
    Curve_limit_maker<typename Parameters::Point, typename Parameters::Vector, FT, dimension>;
  const auto values = limit_polygon<Limits, Parameters>(polygon, end, np);
  const Curve_limit_demand demand =
    curve_limit_demand<FT>(options, internal::box_size<Limits>(values));
  Limits limits(mask, end, demand, Parameters::roundness(np));
  std::vector<typename Maker::Limit> result;
  Limit_report report;
  report.tolerance = demand.tolerance;
  const auto [first, number] = limits.range(static_cast<std::int64_t>(values.size()));
  for (const Place_of_limit& place : places(first, number)) {
    const auto l = limits(values, place.number);
    check_in_range<FT, dimension>(Limits::point_of(l.value), [v = place.parameter] {
      return "the limit point of point " + std::to_string(static_cast<std::int64_t>(v));
    });
    add_to_report(demand, l.error, l.tangent_error, l.depth, l.has_tangent, report);
    result.push_back(Maker::make(l, place.parameter + (limits.is_primal() ? 0. : 0.5)));
  }
  return std::make_pair(std::move(result), report);
}

// by how many places a round leaves out new points at the beginning
template <class FT, class Mask>
std::int64_t left_out_points(const Mask& mask, std::size_t n, Curve_end end)
{
  const Univariate_rows<FT> rows(mask);
  const auto size = static_cast<std::int64_t>(n);
  std::int64_t first = rows.range(size, end).first;
  if constexpr (Normal_rows<FT, Mask>::differ)
    first = (std::max)(first, Normal_rows<FT, Mask>(mask).rows.range(size, end).first);
  return first - rows.first_point();
}

// Of masks of which the last one is that of all further rounds: the limits that it gives the points after the other rounds.
template <class Range, class Mask, class NamedParameters>
auto limits_of_listed_masks(const Range& polygon, const std::vector<Mask>& masks, Curve_end end,
                            const Limit_options& options, const NamedParameters& np)
{
  using Parameters = Curve_parameters<Range, NamedParameters>;
  using FT = typename Parameters::FT;
  const bool is_primal = Univariate_rows<FT>(masks.front()).is_primal();
  for (const Mask& mask : masks)
    if (Univariate_rows<FT>(mask).is_primal() != is_primal)
      throw std::invalid_argument(
        "PN_subdivision_3: of the masks of the rounds some are primal and "
        "some dual, so that no limit belongs to a vertex or an edge");
  auto refined = subdivide_curve(polygon, masks.front(), end,
                                 PN_subdivision_3::parameters::shared(parameters::join(
                                   CGAL::parameters::number_of_iterations(0), np)));
  std::vector<Place_of_limit> places;
  for (std::size_t i = 0; i < refined.size(); ++i)
    places.push_back({static_cast<std::int64_t>(i), static_cast<double>(i)});
  const auto traits = PN_subdivision_3::parameters::roundness(Parameters::roundness(np))
                        .geom_traits(typename Parameters::Geom_traits());
  for (std::size_t k = 0; k + 1 < masks.size() && !refined.empty(); ++k) {
    const std::int64_t left_out = left_out_points<FT>(masks[k], refined.size(), end);
    for (Place_of_limit& place : places) place.number = 2 * place.number - left_out;
    refined = subdivide_curve(refined, masks[k], end, traits);
  }
  return limits_at_places(
    refined, masks.back(), end, options, traits, [&](std::int64_t first, std::int64_t number) {
      const auto is_none = [=](const Place_of_limit& place) {
        return place.number < first || place.number >= first + number;
      };
      places.erase(std::remove_if(places.begin(), places.end(), is_none), places.end());
      return places;
    });
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Limit

computes the points of the limit curve of a mask that belong to the vertices of a control polygon: where they
would come to lie after infinitely many rounds. With a dual mask, such as `B_spline_mask` of an even degree,
they belong to the edges. The polygon may be of any level.

All is as in `limit_points()`. The limit mask l is a left eigenvector of the matrix that maps the points next to
a vertex to those of the next round; its point-normal average over them is exact on circles, on circular
cylinders and with linear masks, and otherwise the neighborhood is refined by itself until the averages no
longer change: their differences fall by 1/16 a round. The ends of an open polygon have matrices of their own.

<b>Tangents.</b> The left eigenvector of the eigenvalue 1/2 applied to the parts of the neighbors perpendicular
to the limit control normal and to their point-normal heights over the limit is the derivative. Its error falls
by 1/4 a round. B-splines of degree 2 and more and masks on 4 points and more have tangents; degree 1 and 2
points have none.

<b>Curvature</b> is computed where the eigenvalue 1/4 is simple and all after it are much smaller: with B-splines of
degree 3 and more, but for the ends of dual ones, and Dubuc-Deslauriers masks on 6 points and more. Quadratic B-splines have another curvature on either
side of their limit points, and that of 4 points does not converge. Its error is not estimated; ten rounds
are done.

Limit masks have the precision of the number type. Intervals contain the limits of linear and of interpolatory masks; others
are refused. In exact number types limit masks are exact, the limit points of `linear()` masks, too; with normals one round is
done at most about a vertex that is not near an end, so that the tolerance may be missed. Tangents, curvatures
and errors are computed in `double`, from differences in the number type.

<b>Masks that differ from round to round.</b> Where the last of them is that of all further rounds, as of
`level_dependent_mask()` of a vector of masks, the polygon is refined by the others, and the limits of the last one are those
of the curve. The masks are all primal or all dual.

\tparam Range a model of `ConstRange`, as for `subdivide_curve()`

\tparam Mask a model of `PNSubdivisionCurveMask`, or what `linear()` or `with_normal_mask()` makes of one, or
  `level_dependent_mask()` of a vector of these

\param polygon the control polygon
\param mask the mask
\param end whether the polygon is closed, and if not, what happens at its ends. With `Curve_end::none` only
  vertices and edges have limits whose neighborhoods do not leave the polygon.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`, `normal_map`,
   `geom_traits` and `roundness`, as for `subdivide_curve()`; normals of points that have none are estimated. What is
   computed, and how well, is said by `tolerance`, `normal_tolerance`, `max_depth`, `curve_normals` and `curvatures` of
   `CGAL::PN_subdivision_3::parameters`

\returns a pair: a `std::vector` with a `Curve_limit_point` for each vertex or edge that has one, in their order,
  and a `Limit_report`. A tolerance that cannot be met is no error.

\throws std::invalid_argument as `subdivide_curve()` does, if a tolerance is negative or not a number, if an interval number type is
  to contain an estimate, and if the powers of the mask's matrix do not converge
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
  if constexpr (internal::check_kernel<typename Parameters::Geom_traits>()) {
    if constexpr (internal::Is_listed<Mask>::value)
      return internal::limits_of_listed_masks(polygon, mask.function.masks, end,
                                              internal::limit_options(np), np);
    else
      return internal::limits_at_places(polygon, mask, end, internal::limit_options(np), np,
                                        [](std::int64_t first, std::int64_t number) {
                                          std::vector<internal::Place_of_limit> places;
                                          for (std::int64_t v = first; v < first + number; ++v)
                                            places.push_back({v, static_cast<double>(v)});
                                          return places;
                                        });
  }
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CURVES_CURVE_LIMIT_POINTS_H
