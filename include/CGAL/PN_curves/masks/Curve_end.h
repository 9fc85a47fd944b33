// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_MASKS_CURVE_END_H
#define CGAL_PN_CURVES_MASKS_CURVE_END_H

namespace CGAL {
namespace PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Curves
/// What happens at the ends of a control polygon.
enum class Curve_end {
  closed,  ///< the polygon is closed; its first point is not repeated
  reflect, ///< open; points beyond an end are reflected in it: p_{-i} = 2 p_0 - p_i
  none     ///< open; only points whose whole stencil exists are kept
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CURVES_MASKS_CURVE_END_H
