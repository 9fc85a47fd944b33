// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_OPTIONS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_OPTIONS_H

#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/package_parameters.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// of limits that are estimated
template <class FT>
void refuse_intervals()
{
  if constexpr (is_interval_v<FT>)
    throw std::invalid_argument(
      "PN_subdivision_3: limits of point-normal schemes are estimated, so that intervals around "
      "them "
      "need not contain them: take linear() of the scheme, or a number type that is not an "
      "interval");
}

// The largest side of the box of some points, of which coordinate(i, c) is a coordinate.
template <class Coordinate>
double box_size(std::size_t number, std::size_t dimension, const Coordinate& coordinate)
{
  double size = 0;
  for (std::size_t c = 0; c < dimension; ++c) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (std::size_t i = 0; i < number; ++i) {
      const double x = coordinate(i, c);
      least = (std::min)(least, x);
      greatest = (std::max)(greatest, x);
    }
    size = (std::max)(size, greatest - least);
  }
  return size;
}

// what limits are to have, and how well; parameters.h says more
struct Limit_options
{
  double tolerance = 1e-9;
  bool points = true;
  double normal_tolerance = 1e-3;
  unsigned max_depth = 12;
  bool surface_normals = false;
  bool curve_normals = false;
  bool curvatures = false;
  unsigned rounds_done = 0;
};

template <class NamedParameters>
Limit_options limit_options(const NamedParameters& np)
{
  Limit_options o;
  o.tolerance = parameter_or<tolerance_t>(np, o.tolerance);
  o.points = parameter_or<points_t>(np, o.points);
  o.normal_tolerance = parameter_or<normal_tolerance_t>(np, o.normal_tolerance);
  o.max_depth = parameter_or<max_depth_t>(np, o.max_depth);
  o.surface_normals = parameter_or<surface_normals_t>(np, o.surface_normals);
  o.curve_normals = parameter_or<curve_normals_t>(np, o.curve_normals);
  o.curvatures = parameter_or<curvatures_t>(np, o.curvatures);
  o.rounds_done = parameter_or<rounds_done_t>(np, o.rounds_done);
  return o;
}

// What of limits is compiled besides points and control normals: nothing, surface normals, or curvatures, too.
enum class Limit_kinds { points, normals, all };

constexpr bool has_normals(Limit_kinds kinds)
{
  return kinds != Limit_kinds::points;
}

// What a call names. The library is for all calls.
template <class NamedParameters>
constexpr Limit_kinds limit_kinds()
{
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
  return Limit_kinds::all;
#else
  if (is_given_v<curvatures_t, NamedParameters>) return Limit_kinds::all;
  return is_given_v<surface_normals_t, NamedParameters> ? Limit_kinds::normals
                                                        : Limit_kinds::points;
#endif
}

// What is asked of the limit.
struct Limit_demand
{
  double tolerance = 0; // absolute
  double normal_tolerance = 0;
  unsigned max_depth = 0;
  bool points = true; // if they are not asked for, one average of the limit mask may do
  bool surface_normals = false, curvatures = false; // of a curve its tangents
  // where some vertices are asked for: whether so are the neighbors of all whose normals count
  bool has_neighbors = false;
};

inline bool asks_for_points(const Limit_options& options)
{
  return options.points || !options.surface_normals;
}

inline double check_tolerance(double tolerance)
{
  if (!(tolerance >= 0))
    throw std::invalid_argument("PN_subdivision_3: a tolerance must be a number that is not "
                                "negative, not " +
                                std::to_string(tolerance));
  return tolerance;
}

template <class FT>
Limit_demand limit_demand(const Limit_options& options, double box)
{
  Limit_demand demand;
  demand.tolerance = check_tolerance(options.tolerance) * box;
  demand.normal_tolerance = check_tolerance(options.normal_tolerance);
  // exact numbers grow too long; the estimate needs one round
  demand.max_depth = is_exact_v<FT> ? 1 : (std::max)(1u, options.max_depth);
  demand.surface_normals = options.surface_normals;
  demand.points = asks_for_points(options);
  demand.curvatures = options.curvatures;
  return demand;
}

template <class Result>
Limit_report limit_report(const std::vector<Result>& results, const Limit_demand& demand)
{
  Limit_report report;
  report.tolerance = demand.tolerance;
  for (const Result& r : results) {
    const bool counts = demand.points || !r.has_surface_normal;
    if (counts) report.error = (std::max)(report.error, r.error);
    report.normal_error = (std::max)(report.normal_error, r.normal_error);
    report.depth = (std::max)(report.depth, r.depth);
    if ((counts && !(r.error <= demand.tolerance)) || !(r.normal_error <= demand.normal_tolerance))
      ++report.number_of_misses;
    if (demand.surface_normals && !r.has_surface_normal) ++report.number_of_stand_ins;
  }
  return report;
}

// Floating point keeps more digits of a ring or window about the origin; intervals would only grow.
template <class Value, class FT, std::size_t dimension>
Value relative(Value v, [[maybe_unused]] const std::array<FT, dimension>& center,
               [[maybe_unused]] const FT& sign)
{
  if constexpr (std::is_floating_point_v<FT>) add_multiple(point_of(v), sign, center);
  return v;
}

// Averages L_k of a limit mask come closer to the limit by steps |L_{k+1} - L_k|, which become a geometric
// series of some ratio. An estimate of |limit - L_{k+1}| / |L_{k+1} - L_k|: 3/2 of the sum of that series, and
// 1 at least, while it is not one yet; up to 0.8 was measured then.
inline double limit_error_factor(double ratio)
{
  return (std::max)(1., 1.5 * ratio / (1 - ratio));
}

// The error after a step. A step may be small by chance, two in a row hardly are.
inline double limit_error(double factor, double ratio, double step, double& last_step)
{
  const double error = factor * (std::max)(step, ratio * last_step);
  last_step = step;
  return error;
}

// Decides when the averages of a limit mask over values that are refined by themselves have come close
// enough to the limit.
template <class FT, int dimension = 3>
class Convergence
{
public:
  // ratio: that of the differences in a row; is_exact: whether the first average is the limit
  Convergence(const Limit_demand& demand, bool is_exact, double ratio)
    : demand_(demand)
    , is_exact_(is_exact)
    , ratio_(ratio)
  {
    if (!is_exact) refuse_intervals<FT>();
  }

  // takes the averages one after the other; whether it is the last one where all else is found
  bool is_last(const Coordinates<FT, dimension>& limit, bool is_all_else_found = true)
  {
    const bool is_first = std::exchange(is_first_, false);
    if (!is_first) ++depth_;
    if (!is_first && !is_exact_) {
      Coordinates<double, 3> step{};
      for (std::size_t c = 0; c < dimension; ++c) step[c] = close_double(FT(limit[c] - last_[c]));
      error_ = limit_error(limit_error_factor(ratio_), ratio_, length(step), last_step_);
    }
    last_ = limit;
    const bool is_close = is_exact_ || (!is_first && error_ <= demand_.tolerance);
    return (is_close && is_all_else_found) || (!is_first && depth_ >= demand_.max_depth);
  }

  // estimated
  double error() const { return error_; }
  // rounds done
  unsigned depth() const { return depth_; }

private:
  const Limit_demand& demand_;
  const bool is_exact_;
  const double ratio_;
  bool is_first_ = true;
  Coordinates<FT, dimension> last_{};
  double last_step_ = 0, error_ = 0;
  unsigned depth_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_OPTIONS_H
