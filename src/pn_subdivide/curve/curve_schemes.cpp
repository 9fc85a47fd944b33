// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "curve/curve_schemes.h"

#include "io/Error.h"

#include <boost/algorithm/string/predicate.hpp>

#include <charconv>

namespace pn_subdivide {
namespace {

template <class Mask>
Curve_mask by_coefficients(const Mask& mask)
{
  return {mask.first_index(), mask.template coefficients<double>()};
}

Curve_scheme b_spline(int degree)
{
  const char* const names[] = {"quadratic", "cubic", "quartic", "quintic"};
  const std::string name = degree < 6 ? names[degree - 2] : "degree " + std::to_string(degree);
  return {name + " B-spline", by_coefficients(PN::B_spline_mask(degree)), degree % 2 != 0,
          static_cast<std::size_t>(degree)};
}

Curve_scheme interpolatory(int points)
{
  return {std::to_string(points) + "-point", by_coefficients(PN::Dubuc_Deslauriers_mask(points)),
          true, static_cast<std::size_t>(2 * points - 3), true};
}

std::size_t refined_size(std::size_t n, const Curve_rule& rule)
{
  using End = PN::Curve_end;
  std::size_t lost = 0;
  if (rule.end == End::reflect) lost = rule.scheme.primal ? 1 : 2;
  if (rule.end == End::none) lost = rule.scheme.lost_points;
  return 2 * n > lost ? 2 * n - lost : 0;
}

// The library notices this in the last round only, when memory is long gone.
void require_possible_size(std::size_t n, const Curve_rule& rule, unsigned levels)
{
  for (unsigned k = 0; k < levels; ++k) {
    const std::size_t refined = refined_size(n, rule);
    if (refined >= UINT32_MAX)
      throw Error("round " + std::to_string(k + 1) + " of " + std::to_string(levels) +
                  " would make " + std::to_string(refined) +
                  " points, more than can be numbered: ask for fewer rounds");
    if (refined <= n) return; // does not grow
    n = refined;
  }
}

} // namespace

std::optional<int> to_int(const std::string& word)
{
  int n = 0;
  const char* const end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, n);
  if (word.empty() || result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return n;
}

std::string curve_scheme_names()
{
  return std::string(PN::B_spline_mask::name()) + " (DEGREE 2 to 9), chaikin (bspline:2), " +
         PN::Dubuc_Deslauriers_mask::name() + " (POINTS even, 2 to " +
         std::to_string(PN::Dubuc_Deslauriers_mask::greatest_number_of_points) +
         ", as in 4-point), or levels:FILE (a mask a round)";
}

Curve_scheme parse_curve_scheme(const std::string& option, const std::string& name)
{
  if (name == "chaikin") return b_spline(2);
  if (boost::algorithm::starts_with(name, "bspline:")) {
    const std::optional<int> degree = to_int(name.substr(8));
    if (degree && *degree >= 2 && *degree <= 9) return b_spline(*degree);
    throw Usage_error(option + " '" + name + "': B-splines have a degree from 2 to 9");
  }
  if (boost::algorithm::starts_with(name, "levels:")) return read_level_masks(name.substr(7));
  if (boost::algorithm::ends_with(name, "-point")) {
    const std::optional<int> points = to_int(name.substr(0, name.size() - 6));
    if (points && *points >= 2 &&
        *points <= PN::Dubuc_Deslauriers_mask::greatest_number_of_points && *points % 2 == 0)
      return interpolatory(*points);
    throw Usage_error(option + " '" + name + "': the number of points is even and at most 20");
  }
  throw Usage_error(option + " '" + name + "': there is no such scheme, only " +
                    curve_scheme_names());
}

Curve_data refine_curve(const Curve_data& curve, const Curve_rule& rule, unsigned levels)
{
  require_possible_size(curve.size(), rule, levels);
  Curve_data refined;
  refined.has_normals = !rule.linear;
  std::visit(
    [&](const auto& points) {
      refined.points = with_mask(rule, 0, [&](const auto& mask) {
        return PN::subdivide_curve(
          points, mask, rule.end,
          PN::parameters::roundness(rule.roundness).number_of_iterations(levels));
      });
    },
    curve.points);
  return refined;
}

} // namespace pn_subdivide
