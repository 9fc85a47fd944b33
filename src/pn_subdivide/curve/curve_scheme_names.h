// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CURVE_SCHEME_NAMES_H
#define PN_SUBDIVIDE_CURVE_SCHEME_NAMES_H

#include <string>

namespace pn_subdivide {

// As in "bspline:DEGREE (DEGREE 2 to 9), ...".
std::string curve_scheme_names();

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CURVE_SCHEME_NAMES_H
