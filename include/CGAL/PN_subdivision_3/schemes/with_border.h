// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_BORDER_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_BORDER_H

namespace CGAL {
namespace PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Schemes
/// what becomes of the border of a surface.
enum class Border {
  /// the border belongs to the surface: its points stay on a sphere or cylinder on which the data
  /// lie. A circular border does not stay a circle.
  surface,
  /// the border is a crease with the surface on one side: circles stay circles.
  curve,
  /// as `curve`, and border vertices with a single face are corners.
  corners,
  /// all border vertices stay where they are, edges are split in their midpoints.
  fixed
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_BORDER_H
