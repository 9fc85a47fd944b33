// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ATTRIBUTES_CORNER_RULE_H
#define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_CORNER_RULE_H

namespace CGAL {
namespace PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Attributes
/// how the values of corners are refined.
enum class Corner_rule {
  /// by the scheme's linear rows inside the charts, that is where values agree. Seams and borders of charts are
  /// refined as borders of the surface, and corners of charts stay.
  smooth,
  /// linearly inside every face.
  linear
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_ATTRIBUTES_CORNER_RULE_H
