// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What files of the command ask for, and the page has no use for: it reads no files of masks.

#include "curve/curve_schemes.h"

#include "io/Error.h"

namespace pn_subdivide {

Curve_scheme read_level_masks(const std::string& file)
{
  throw Error("masks cannot be read from " + file + " here");
}

} // namespace pn_subdivide
