// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERPOLATION_PRESCRIBED_CURVATURE_H
#define CGAL_PN_SUBDIVISION_3_INTERPOLATION_PRESCRIBED_CURVATURE_H

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Interpolation
The curvature that the limit surface shall have at a vertex, see `prescribe_limit_data()`: its principal
curvatures, or those in any two perpendicular directions between which the surface does not twist. Signs
are those of `Vertex_curvature`: positive where the surface bends away from its normal.

\tparam GeomTraits a model of `Kernel`
*/
template <class GeomTraits>
struct Prescribed_curvature
{
  /// the curvature in `direction`.
  double along = 0;
  /// the curvature perpendicular to `direction`.
  double across = 0;
  /// a vector of any length; its part in the tangent plane counts. Not used if both curvatures are equal.
  typename GeomTraits::Vector_3 direction{0, 0, 0};
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERPOLATION_PRESCRIBED_CURVATURE_H
