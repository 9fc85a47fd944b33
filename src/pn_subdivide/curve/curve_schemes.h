// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CURVE_SCHEMES_H
#define PN_SUBDIVIDE_CURVE_SCHEMES_H

#include "curve/Curve_data.h"
#include "io/Limit_choice.h"

#include <CGAL/PN_subdivision_curve.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pn_subdivide {

using Curve_mask = PN::Univariate_mask<double>; // of whatever scheme, so that one is compiled

// A mask with what the command has to know about it.
struct Curve_scheme
{
  std::string name; // for people
  Curve_mask mask;
  bool primal;
  std::size_t lost_points; // of 2n, in a round without the stencils that leave an open polygon
  bool interpolates = false;
  // of the first rounds, if masks differ; the last one is `mask`, and that of all others
  std::vector<Curve_mask> levels = {};
};

// The number that a word is; none if it is anything else.
std::optional<int> to_int(const std::string& word);

// Throws Usage_error, which begins with the option, if there is no such scheme.
Curve_scheme parse_curve_scheme(const std::string& option, const std::string& name);

struct Curve_rule
{
  Curve_scheme scheme;
  std::optional<Curve_scheme> normal_scheme;
  bool linear = false;
  double roundness = 1; // of all vertices
  PN::Curve_end end = PN::Curve_end::closed;
};

// function(mask) with the mask that a rule has after some rounds
template <class Function>
auto with_mask(const Curve_rule& rule, std::size_t rounds, const Function& function)
{
  const Curve_mask& mask = rule.scheme.mask;
  const std::vector<Curve_mask>& all = rule.scheme.levels;
  if (!all.empty()) { // none has other normals
    const auto first = std::ptrdiff_t((std::min)(rounds, all.size() - 1));
    const auto masks =
      PN::level_dependent_mask(std::vector<Curve_mask>(all.begin() + first, all.end()));
    return rule.linear ? function(PN::linear(masks)) : function(masks);
  }
  if (rule.linear) return function(PN::linear(mask));
  if (rule.normal_scheme) return function(PN::with_normal_mask(mask, rule.normal_scheme->mask));
  return function(mask);
}

// The refined curve. Throws Error if it would have more points than can be numbered, and what the
// library throws.
Curve_data refine_curve(const Curve_data& curve, const Curve_rule& rule, unsigned levels);

// Throws Usage_error if normals of the curve are asked for at points that have no limit.
void require_limits_of_points(const std::string& scheme, const Curve_rule& rule,
                              const Limit_choice& choice);

// Puts the points of a refined curve on the limit curve, of a dual scheme one for each edge; gives them its
// normals; or both. Throws Error if there are no such normals, and passes on the library's exceptions.
// The curve is that of some rounds.
Limit_summary set_limits(Curve_data& curve, const Curve_rule& rule, unsigned rounds,
                         const Limit_choice& choice);

// Throws Usage_error if curves of the rule cannot be made to pass through points.
void require_interpolation(const std::string& scheme, const Curve_rule& rule);

// Makes a polygon the control polygon of a curve through its points. Passes on the library's exceptions.
Interpolation_report interpolate_curve(Curve_data& curve, const Curve_rule& rule,
                                       Interpolation_mode mode);

// The worst of both.
Interpolation_report joined(const Interpolation_report& a, const Interpolation_report& b);

// The scheme of --scheme levels:FILE: a line for each round, FIRST_INDEX c0 c1 ..., the last of which counts for all
// further rounds. Throws Error, with the line, if the weights of a new point do not sum to 1.
Curve_scheme read_level_masks(const std::string& file);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CURVE_SCHEMES_H
