// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_VALENCES_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_VALENCES_H

namespace CGAL {
namespace PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Schemes
/// at which extraordinary vertices a modified scheme has rules of its own.
enum class Tuned_valences {
  /// at all.
  all,
  /// where the curvature of the linear scheme diverges: not at valence 3 of Catmull-Clark and valences
  /// 4 and 5 of Loop subdivision, where it is bounded.
  diverging
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_VALENCES_H
