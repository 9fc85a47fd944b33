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
#include <utility>

namespace pn_subdivide {
namespace {

constexpr double degrees = 57.29577951308232; // a radian

std::string description(const Limit_summary& limits, const Limit_choice& choice)
{
  std::string s;
  if (choice.points)
    s = formatted("limit points: estimated error %.2g (%.2g of the box), %u %s", limits.error,
                  limits.box > 0 ? limits.error / limits.box : 0, limits.depth,
                  limits.depth == 1 ? "round" : "rounds");
  if (choice.normals) {
    s += formatted("%s%s normals: estimated error %.2g degrees", s.empty() ? "" : "; ",
                   choice.shape, limits.normal_error * degrees);
    if (limits.number_of_stand_ins > 0)
      s += ", control normals at " + plural(limits.number_of_stand_ins, "vertex", "vertices") +
           " where the scheme has none";
  }
  return s;
}

// empty if all is well
std::string warning(const Interpolation_report& report, Interpolation_mode mode)
{
  // of sliding points a thousandth of the box
  const double most = (mode == Interpolation_mode::slide ? 1e9 : 1) * report.tolerance;
  if (!(report.residual <= most))
    return formatted("the limit passes the points at a distance of up to %.2g (tolerance %.2g)",
                     report.residual, report.tolerance);
  if (report.left_out > 0)
    return plural(report.left_out, "vertex is", "vertices are") +
           " left out of the interpolation: no normal is known there";
  if (report.slip_of_edge > 0.25)
    return formatted("the mesh is coarse for its normals: limit points are up to %.2f edges away "
                     "from theirs; --interpolate points keeps them",
                     report.slip_of_edge);
  if (report.normal_angle > 60)
    return formatted(
      "the mesh is coarse for its normals: those of neighbors are up to %.0f degrees apart",
      report.normal_angle);
  return {};
}

} // namespace

void require_consistent(const Limit_choice& choice)
{
  if (!choice.tolerance) return;
  if (!choice.points) throw Usage_error("--limit-tolerance is for --limit, which is not given");
  if (!(*choice.tolerance > 0) || !std::isfinite(*choice.tolerance))
    throw Usage_error("--limit-tolerance must be greater than 0");
}

void Limit_summary::add(const Limit_summary& other)
{
  error = std::max(error, other.error);
  tolerance = std::max(tolerance, other.tolerance);
  box = std::max(box, other.box);
  normal_error = std::max(normal_error, other.normal_error);
  number_of_misses += other.number_of_misses;
  number_of_stand_ins += other.number_of_stand_ins;
  depth = std::max(depth, other.depth);
}

void Limit_summary::tell(const Limit_choice& choice, const std::string& name, Report& report) const
{
  report.note(description(*this, choice));
  Report::Row numbers;
  if (choice.points) numbers = {{"error", error}, {"tolerance", tolerance}};
  if (choice.normals) numbers.emplace_back("normal_error_in_degrees", normal_error * degrees);
  numbers.emplace_back("vertices_without_limit_normal", double(number_of_stand_ins));
  numbers.emplace_back("vertices_that_miss_the_tolerance", double(number_of_misses));
  report.set_limit(std::move(numbers));
  if (number_of_misses > 0)
    report.warn(
      name + ": the tolerance of the limit is missed at " +
      plural(number_of_misses, "vertex", "vertices") +
      formatted("; estimated errors: points %.2g (%.2g of the box, tolerance %.2g), normals "
                "%.2g degrees",
                error, box > 0 ? error / box : 0, box > 0 ? tolerance / box : 0,
                normal_error * degrees));
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

void tell(const Interpolation_report& interpolation, Interpolation_mode mode,
          const std::string& name, Report& report)
{
  report.note(formatted(
    "interpolation: %s the points: largest distance %.2g, estimated error %.2g, %u %s",
    interpolation.is_within_tolerance() ? "through" : "nearly through", interpolation.residual,
    interpolation.error, interpolation.steps, interpolation.steps == 1 ? "step" : "steps"));
  const std::string text = warning(interpolation, mode);
  if (!text.empty()) report.warn(name + ": " + text);
}

} // namespace pn_subdivide
