// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_LIMIT_CURVE_H
#define PN_SUBDIVIDE_LIMIT_CURVE_H

#include "curve/Curve_data.h"
#include "curve/curve_schemes.h"
#include "io/Limit_choice.h"

#include <string>

namespace pn_subdivide {

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

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_LIMIT_CURVE_H
