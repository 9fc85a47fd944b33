// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "curve/limit_curve.h"

#include "io/Error.h"

#include <CGAL/PN_subdivision_3/curve_limit_points.h>

#include <type_traits>
#include <utility>

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;

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
  const double tolerance = choice.tolerance.value_or(1e-9);
  PN::Limit_report report;
  std::visit(
    [&](auto& points) {
      with_mask(rule, rounds, [&](const auto& mask) {
        auto limits = PN::curve_limit_points(points, mask, rule.end,
                                             PN::parameters::tolerance(tolerance)
                                               .curve_normals(choice.normals)
                                               .roundness(rule.roundness));
        write(points, limits.first, choice);
        report = limits.second;
      });
    },
    curve.points);
  if (choice.normals) curve.has_normals = true;
  return {report, report.tolerance / tolerance};
}

} // namespace pn_subdivide
