// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "curve/curve_schemes.h"

#include "io/Error.h"

#include <CGAL/PN_curves/curve_limit_points.h>

#include <utility>

#if __has_include(<Eigen/Core>)
#  include <CGAL/PN_fitting_3/interpolate_curve.h>
#endif

namespace pn_subdivide {
namespace {

template <class Curve, class Limits>
void write(Curve& curve, const Limits& limits, const Limit_choice& choice)
{
  if (choice.points) curve.resize(limits.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (choice.points) curve[i].first = limits[i].point;
    curve[i].second = choice.normals ? limits[i].normal : limits[i].control_normal;
  }
}

} // namespace

void require_limits_of_points(const std::string& scheme, const Curve_rule& rule,
                              const Limit_choice& choice)
{
  if (!choice.normals || choice.points) return;
  if (!rule.scheme.primal)
    throw Usage_error("--curve-normals: the limit points of " + scheme +
                      " belong to the edges, not to the points; give --limit, too");
  if (rule.end == PN::Curve_end::none)
    throw Usage_error("--curve-normals: with --end none points at the ends have no limit; give "
                      "--limit, too");
}

Limit_summary set_limits(Curve_data& curve, const Curve_rule& rule, unsigned rounds,
                         const Limit_choice& choice)
{
  if (choice.normals && rule.linear && std::holds_alternative<Curve_3>(curve.points))
    throw Error("--curve-normals: a curve in space has no normals of its own, and in linear "
                "schemes control normals take no part; leave out --linear");
  PN::Limit_report report;
  std::visit(
    [&](auto& points) {
      with_mask(rule, rounds, [&](const auto& mask) {
        auto limits =
          PN::curve_limit_points(points, mask, rule.end,
                                 PN::parameters::tolerance(choice.tolerance_or_default())
                                   .curve_normals(choice.normals)
                                   .roundness(rule.roundness));
        write(points, limits.first, choice);
        report = limits.second;
      });
    },
    curve.points);
  if (choice.normals) curve.has_normals = true;
  return {report, choice};
}

void require_interpolation(const std::string& scheme, const Curve_rule& rule)
{
  if (!rule.scheme.interpolates && scheme != "bspline:3")
    throw Usage_error("--interpolate: curves of " + scheme +
                      " cannot be made to pass through points; take bspline:3");
  if (rule.normal_scheme)
    throw Usage_error(
      "--interpolate and --normal-scheme exclude each other: interpolation is for one "
      "scheme of points and normals");
}

#if __has_include(<Eigen/Core>)
Interpolation_report interpolate_curve(Curve_data& curve, const Curve_rule& rule,
                                       Interpolation_mode mode)
{
  if (rule.scheme.interpolates) return {};
  const Curve_mask& mask = rule.scheme.mask;
  return std::visit(
    [&](auto& points) {
      const auto np = PN::parameters::interpolation_mode(mode).roundness(rule.roundness);
      auto result = rule.linear ? PN::interpolate_curve(points, PN::linear(mask), rule.end, np)
                                : PN::interpolate_curve(points, mask, rule.end, np);
      points = std::move(result.first);
      return result.second;
    },
    curve.points);
}
#else // parse_interpolation() has refused
Interpolation_report interpolate_curve(Curve_data&, const Curve_rule&, Interpolation_mode)
{
  return {};
}
#endif

Interpolation_report joined(const Interpolation_report& a, const Interpolation_report& b)
{
  // of two parts the one that misses its tolerance by more
  const bool is_a = a.residual * b.tolerance > b.residual * a.tolerance;
  Interpolation_report worst = is_a ? a : b;
  worst.error = std::max(a.error, b.error);
  worst.steps = std::max(a.steps, b.steps);
  worst.slip_of_edge = std::max(a.slip_of_edge, b.slip_of_edge);
  worst.left_out = a.left_out + b.left_out;
  return worst;
}

} // namespace pn_subdivide
