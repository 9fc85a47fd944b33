// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_LIMIT_CHOICE_H
#define PN_SUBDIVIDE_LIMIT_CHOICE_H

#include "options.h"

#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>

#include <optional>
#include <string>

namespace pn_subdivide {

namespace PN = CGAL::PN_subdivision_3;

// Throws Usage_error if there is nothing that the tolerance is for, or if it is none.
void require_consistent(const Limit_choice& choice);

struct Limit_summary : PN::Limit_report
{
  double box = 0; // the largest side of the bounding box

  Limit_summary() = default;
  Limit_summary(const PN::Limit_report& reached, const Limit_choice& choice)
    : PN::Limit_report(reached)
    , box(reached.tolerance / choice.tolerance_or_default())
  {}

  // takes over what is worse in another one
  void add(const Limit_summary& other);

  // Notes it, also for --report, and warns of what is missed.
  void tell(const Limit_choice& choice, const std::string& name, Report& report) const;
};

using Interpolation_mode = PN::Limit_interpolation::Mode;
using Interpolation_report = PN::Limit_interpolation;

// slide | points, if the option --interpolate is given. Throws Usage_error.
std::optional<Interpolation_mode> parse_interpolation(const std::optional<std::string>& text);

// Notes what the interpolation has reached, and warns where that is not what one expects.
void tell(const Interpolation_report& interpolation, Interpolation_mode mode,
          const std::string& name, Report& report);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_LIMIT_CHOICE_H
