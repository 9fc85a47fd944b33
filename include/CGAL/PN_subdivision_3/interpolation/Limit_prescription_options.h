// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERPOLATION_LIMIT_PRESCRIPTION_OPTIONS_H
#define CGAL_PN_SUBDIVISION_3_INTERPOLATION_LIMIT_PRESCRIPTION_OPTIONS_H

namespace CGAL {
namespace PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Interpolation
/// Stands for a map when nothing of its kind is prescribed.
struct Nothing_prescribed
{};

/// \ingroup PkgPNSubdivision3Interpolation
/// How `prescribe_limit_data()` proceeds.
struct Limit_prescription_options
{
  /// how far limit points may be from the prescribed ones, as a part of the largest side of the bounding
  /// box of the control points.
  double tolerance = 1e-12;
  /// the most rounds of refinement about a vertex.
  unsigned max_depth = 12;
  /// control points move within so many rings of faces about the vertices with prescribed data.
  unsigned rings = 2;
  /// by how much curvatures may miss the prescribed ones, times the largest side of that box.
  double curvature_tolerance = 1e-6;
  /// the most steps towards prescribed curvatures.
  unsigned max_curvature_steps = 12;
};

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

#endif // CGAL_PN_SUBDIVISION_3_INTERPOLATION_LIMIT_PRESCRIPTION_OPTIONS_H
