// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_curves/curve_limit_points.h>

#include "polygon.h"
#include <CGAL/PN_curves/masks/curve_masks.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_limit_points(const Polygon& polygon)
{
  (void)curve_limit_points(polygon, B_spline_mask(3), Curve_end::closed);
}

} // namespace header_in_use
