// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_DIVERGING_COLORS_H
#define PN_SUBDIVIDE_DIVERGING_COLORS_H

#include "io/Mesh_data.h"

namespace pn_subdivide {

// The color of a value between -1 and 1, beyond which it stays: blue, white at 0, red. Lightness and
// hue change evenly (linear in CIELAB); the ends are equally dark, and those of Moreland, "Diverging
// Color Maps for Scientific Visualization" (2009). scripts/render.py draws with the same colors.
Color diverging_color(double value);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_DIVERGING_COLORS_H
