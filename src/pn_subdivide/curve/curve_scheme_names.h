// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
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
