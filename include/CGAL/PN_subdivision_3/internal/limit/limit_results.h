// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_RESULTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_RESULTS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/average/Unit_normal_traits.h>
#include <CGAL/PN_subdivision_3/internal/average/checked_coordinates.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_tower.h>
#include <CGAL/PN_subdivision_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/limit/Limit_report.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

inline bool asks_for_points(const Limit_options& options)
{
  return options.points || !options.surface_normals;
}

template <class FT>
Limit_demand limit_demand(const Limit_options& options, double box)
{
  if (!(options.tolerance >= 0) || !(options.normal_tolerance >= 0))
    throw std::invalid_argument(
      "PN_subdivision_3: a tolerance must be a number that is not negative");
  Limit_demand demand;
  demand.tolerance = options.tolerance * box;
  demand.normal_tolerance = options.normal_tolerance;
  // exact numbers grow too long; the estimate needs one round
  demand.max_depth = is_exact_v<FT> ? 1 : (std::max)(1u, options.max_depth);
  demand.surface_normals = options.surface_normals;
  demand.points = asks_for_points(options);
  demand.curvatures = options.curvatures;
  return demand;
}

template <class Limit, class Average>
Limit to_limit_point(const Limit_result<Average>& result)
{
  using FT = typename Average::FT;
  using Point = std::decay_t<decltype(std::declval<Limit>().point)>;
  using Vector = std::decay_t<decltype(std::declval<Limit>().control_normal)>;
  Limit l;
  const Coordinates<FT, 3>& p = point_of(result.value);
  l.point = Point(p[0], p[1], p[2]);
  if constexpr (std::is_same_v<typename Average::Value, Point_normal<FT, 3>>) {
    const Coordinates<FT, 3>& m = result.value.normal;
    l.control_normal = Vector(m[0], m[1], m[2]);
  }
  const Coordinates<double, 3>& n = result.surface_normal;
  l.surface_normal =
    result.has_surface_normal ? Vector(FT(n[0]), FT(n[1]), FT(n[2])) : l.control_normal;
  l.error = result.error;
  l.normal_error = result.normal_error;
  l.has_surface_normal = result.has_surface_normal;
  l.gaussian = result.gaussian;
  l.mean = result.mean;
  l.has_curvature = result.has_curvature;
  return l;
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

template <class FT, class Results, class Name>
void check_limits(const Results& results, const Name& name)
{
  for (std::size_t i = 0; i < results.size(); ++i)
    check_in_range<FT, 3>(point_of(results[i].value),
                          [&] { return "the limit point of " + name(i); });
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_RESULTS_H
