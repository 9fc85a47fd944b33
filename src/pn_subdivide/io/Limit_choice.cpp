// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Limit_choice.h"

#include "io/Error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pn_subdivide {
namespace {

constexpr double degrees = 57.29577951308232; // a radian

} // namespace

void require_consistent(const Limit_choice& choice)
{
  if (!choice.tolerance) return;
  if (!choice.points) throw Usage_error("--limit-tolerance is for --limit, which is not given");
  if (!(*choice.tolerance > 0) || !std::isfinite(*choice.tolerance))
    throw Usage_error("--limit-tolerance must be greater than 0");
}

Limit_summary::Limit_summary(const CGAL::PN_subdivision_3::Limit_report& report, double box_size)
  : error(report.error)
  , tolerance(report.tolerance)
  , box(box_size)
  , normal_error(report.normal_error)
  , misses(report.number_of_misses)
  , stand_ins(report.number_of_stand_ins)
  , depth(report.depth)
{}

void Limit_summary::add(const Limit_summary& other)
{
  error = std::max(error, other.error);
  tolerance = std::max(tolerance, other.tolerance);
  box = std::max(box, other.box);
  normal_error = std::max(normal_error, other.normal_error);
  misses += other.misses;
  stand_ins += other.stand_ins;
  depth = std::max(depth, other.depth);
}

std::string Limit_summary::description(const Limit_choice& choice) const
{
  char text[200];
  const double of_box = box > 0 ? error / box : 0;
  std::snprintf(text, sizeof text, "limit points: estimated error %.2g (%.2g of the box), %u %s",
                error, of_box, depth, depth == 1 ? "round" : "rounds");
  std::string s = choice.points ? text : "";
  if (choice.normals) {
    std::snprintf(text, sizeof text, "%s normals: estimated error %.2g degrees", choice.shape,
                  normal_error * degrees);
    s += (s.empty() ? "" : "; ") + std::string(text);
    if (stand_ins > 0)
      s += ", control normals at " + std::to_string(stand_ins) +
           (stand_ins == 1 ? " vertex" : " vertices") + " where the scheme has none";
  }
  return s;
}

std::vector<Report::Number> Limit_summary::numbers(const Limit_choice& choice) const
{
  std::vector<Report::Number> numbers;
  if (choice.points) numbers = {{"error", error}, {"tolerance", tolerance}};
  if (choice.normals) numbers.emplace_back("normal_error_in_degrees", normal_error * degrees);
  numbers.emplace_back("vertices_without_limit_normal", double(stand_ins));
  numbers.emplace_back("vertices_that_miss_the_tolerance", double(misses));
  return numbers;
}

std::string Limit_summary::warning() const
{
  if (misses == 0) return {};
  char text[200];
  std::snprintf(
    text, sizeof text,
    "the tolerance of the limit is missed at %zu %s; estimated errors: points %.2g (%.2g "
    "of the box, tolerance %.2g), normals %.2g degrees",
    misses, misses == 1 ? "vertex" : "vertices", error, box > 0 ? error / box : 0,
    box > 0 ? tolerance / box : 0, normal_error * degrees);
  return text;
}

std::optional<Interpolation_mode> parse_interpolation(const std::optional<std::string>& text)
{
  if (!text) return std::nullopt;
#if !__has_include(<Eigen/Core>)
  throw Usage_error("--interpolate: this program was built without Eigen");
#endif
  if (*text == "slide") return Interpolation_mode::slide;
  if (*text == "points") return Interpolation_mode::strict;
  throw Usage_error("--interpolate '" + *text + "': it takes slide or points");
}

std::string description(const Interpolation_report& report)
{
  char text[200];
  std::snprintf(text, sizeof text,
                "interpolation: %s the points: largest distance %.2g, estimated error %.2g, %u %s",
                report.is_within_tolerance() ? "through" : "nearly through", report.residual,
                report.error, report.steps, report.steps == 1 ? "step" : "steps");
  return text;
}

std::string warning(const Interpolation_report& report, Interpolation_mode mode)
{
  // of sliding points a thousandth of the box
  const double most = (mode == Interpolation_mode::slide ? 1e9 : 1) * report.tolerance;
  char text[200] = "";
  if (!(report.residual <= most))
    std::snprintf(text, sizeof text,
                  "the limit passes the points at a distance of up to %.2g (tolerance %.2g)",
                  report.residual, report.tolerance);
  else if (report.left_out > 0)
    std::snprintf(text, sizeof text,
                  "%zu %s left out of the interpolation: no normal is known there", report.left_out,
                  report.left_out == 1 ? "vertex is" : "vertices are");
  else if (report.slip_of_edge > 0.25)
    std::snprintf(text, sizeof text,
                  "the mesh is coarse for its normals: limit points are up to %.2f edges away from "
                  "theirs; --interpolate points keeps them",
                  report.slip_of_edge);
  else if (report.normal_angle > 60)
    std::snprintf(
      text, sizeof text,
      "the mesh is coarse for its normals: those of neighbors are up to %.0f degrees apart",
      report.normal_angle);
  return text;
}

} // namespace pn_subdivide
