// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef PN_SUBDIVIDE_LEVEL_MASKS_H
#define PN_SUBDIVIDE_LEVEL_MASKS_H

#include "curve/curve_schemes.h"

#include <string>

namespace pn_subdivide {

// The scheme of --scheme levels:FILE: a line for each round, FIRST_INDEX c0 c1 ..., the last of which counts for all
// further rounds. Throws Error, with the line, if the weights of a new point do not sum to 1.
Curve_scheme read_level_masks(const std::string& file);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_LEVEL_MASKS_H
