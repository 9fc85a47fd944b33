// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_INTERPOLATION_CHOICE_H
#define PN_SUBDIVIDE_INTERPOLATION_CHOICE_H

#include <CGAL/PN_subdivision_3/interpolation/Limit_interpolation.h>

#include <optional>
#include <string>

namespace pn_subdivide {

using Interpolation_mode = CGAL::PN_subdivision_3::Limit_interpolation::Mode;
using Interpolation_report = CGAL::PN_subdivision_3::Limit_interpolation;

// slide | points, if the option --interpolate is given. Throws Usage_error.
std::optional<Interpolation_mode> parse_interpolation(const std::optional<std::string>& text);

// What the interpolation has reached.
std::string description(const Interpolation_report& report);
// What has to be said of it; empty if all is well.
std::string warning(const Interpolation_report& report);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_INTERPOLATION_CHOICE_H
