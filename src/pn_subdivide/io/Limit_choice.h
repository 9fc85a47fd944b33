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

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pn_subdivide {

namespace PN = CGAL::PN_subdivision_3;

// Throws Usage_error if there is nothing that the tolerance is for, or if it is none.
void require_consistent(const Limit_choice& choice);

struct Limit_summary : PN::Limit_report
{
  double box = 0; // the largest side of the bounding box

  // takes over what is worse in another one
  void add(const Limit_summary& other);

  std::string description(const Limit_choice& choice) const;
  // the same for --report
  Report::Row numbers(const Limit_choice& choice) const;
  // empty if all is well
  std::string warning() const;
};

using Interpolation_mode = PN::Limit_interpolation::Mode;
using Interpolation_report = PN::Limit_interpolation;

// slide | points, if the option --interpolate is given. Throws Usage_error.
std::optional<Interpolation_mode> parse_interpolation(const std::optional<std::string>& text);

// What the interpolation has reached.
std::string description(const Interpolation_report& report);
// What has to be said of it; empty if all is well.
std::string warning(const Interpolation_report& report, Interpolation_mode mode);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_LIMIT_CHOICE_H
