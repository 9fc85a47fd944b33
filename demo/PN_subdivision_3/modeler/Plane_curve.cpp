// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Plane_curve.h"

#include "analysis/curve_analysis.h"
#include "curve/curve_schemes.h"

#include <CGAL/PN_curves/curve_control_normals.h>

#include <stdexcept>
#include <utility>
#include <variant>

namespace pn_demo {
namespace {

namespace PN = CGAL::PN_subdivision_3;
using pn_subdivide::Curve_2;
using Point_2 = pn_subdivide::Curve_kernel::Point_2;
using Vector_2 = pn_subdivide::Curve_kernel::Vector_2;

Curve_2 to_curve(const std::vector<double>& points, const std::vector<double>& normals)
{
  if (points.size() != normals.size())
    throw std::invalid_argument("a curve needs a normal for each point");
  Curve_2 curve;
  for (std::size_t i = 0; i + 1 < points.size(); i += 2)
    curve.emplace_back(Point_2(points[i], points[i + 1]), Vector_2(normals[i], normals[i + 1]));
  return curve;
}

void add_pair(std::vector<double>& array, const double x, const double y)
{
  array.push_back(x);
  array.push_back(y);
}

} // namespace

Plane_curve refine_plane_curve(const std::vector<double>& points,
                               const std::vector<double>& normals, const std::string& mask,
                               bool is_linear, bool is_closed, unsigned rounds, double roundness)
{
  pn_subdivide::Curve_rule rule{pn_subdivide::parse_curve_scheme("mask", mask), {}, is_linear};
  rule.end = is_closed ? PN::Curve_end::closed : PN::Curve_end::reflect;
  rule.roundness = roundness;
  pn_subdivide::Curve_data data;
  data.points = to_curve(points, normals);
  const pn_subdivide::Curve_data refined = pn_subdivide::refine_curve(data, rule, rounds);
  const Curve_2& curve = std::get<Curve_2>(refined.points);
  Plane_curve result;
  for (const auto& [p, n] : curve) {
    add_pair(result.points, p.x(), p.y());
    add_pair(result.normals, n.x(), n.y());
  }
  result.curvature = PN::discrete_curvature(curve, rule.end);
  for (const Point_2& p : PN::curvature_comb(curve, rule.end, 1))
    add_pair(result.comb, p.x(), p.y());
  return result;
}

std::vector<double> estimate_plane_normals(const std::vector<double>& points, bool is_closed)
{
  const Curve_2 curve = to_curve(points, std::vector<double>(points.size(), 0));
  std::vector<double> result;
  for (const auto& [p, n] : PN::estimate_control_normals(curve, is_closed ? PN::Curve_end::closed
                                                                          : PN::Curve_end::reflect))
    add_pair(result, n.x(), n.y());
  return result;
}

} // namespace pn_demo
