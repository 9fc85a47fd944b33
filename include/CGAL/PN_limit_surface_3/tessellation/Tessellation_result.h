// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_TESSELLATION_TESSELLATION_RESULT_H
#define CGAL_PN_LIMIT_SURFACE_3_TESSELLATION_TESSELLATION_RESULT_H

#include <array>
#include <cstddef>

namespace CGAL::PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Limit
/// What `tessellate()` has reached.
struct Tessellation_result
{
  /// The reason why triangles are not within the tolerance.
  enum class Obstacle {
    none,      ///< it is reached
    rounds,    ///< there are faces about which as many rounds have been done as are allowed
    triangles, ///< more triangles than there may be would be needed
    digits     ///< coordinates have too few digits for it
  };

  /// the largest distance between the triangles and the limit surface, in the unit of the coordinates: an estimate, or a
  /// bound that is proved if `proven_bound` asks for it.
  double bound = 0;
  /// the number of the control face where `bound` is, in the order of `faces(control)`.
  std::size_t worst_face = 0;
  /// where that is, about.
  std::array<double, 3> worst_place{};
  /// whether `bound` is within the tolerance everywhere.
  bool reached = true;
  /// why not, of the triangles where `bound` is or of others.
  Obstacle obstacle = Obstacle::none;
  /// the number of vertices of the result.
  std::size_t number_of_vertices = 0;
  /// the number of its triangles.
  std::size_t number_of_triangles = 0;
  /// the most rounds of refinement that were done about a vertex.
  unsigned depth = 0;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_TESSELLATION_TESSELLATION_RESULT_H
