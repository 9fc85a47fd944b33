// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_LIMIT_LIMIT_POINT_H
#define CGAL_PN_LIMIT_SURFACE_3_LIMIT_LIMIT_POINT_H

#include <cstddef>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Limit

The point of the limit surface that belongs to a vertex of a control mesh, see `limit_points()`.

\tparam GeomTraits a model of `Kernel`
*/
template <class GeomTraits>
struct Limit_point
{
  /// the limit of the points of the vertex.
  typename GeomTraits::Point_3 point{0, 0, 0};
  /// an estimate of the distance of `point` from the limit; it is not a bound that is proved.
  double error = 0;
  /// the limit of the control normals of the vertex, a unit vector; zero if there is none, and with
  /// linear schemes. *It is not the normal of the surface.*
  typename GeomTraits::Vector_3 control_normal{0, 0, 0};
  /// the unit normal of the limit surface, if it was asked for and `has_surface_normal`; otherwise
  /// `control_normal`.
  typename GeomTraits::Vector_3 surface_normal{0, 0, 0};
  /// an estimate of the error of `surface_normal`, in radians.
  double normal_error = 0;
  /// whether the ring matrix determines a tangent plane of the surface.
  bool has_surface_normal = false;
  /// \name Curvature
  /// if it was asked for and `has_curvature`; signs are those of `Vertex_curvature`.
  /// @{

  /// the Gaussian curvature.
  double gaussian = 0;
  /// the mean curvature.
  double mean = 0;
  /// whether the surface has curvatures there.
  bool has_curvature = false;
  /// @}
};

/// \ingroup PkgPNSubdivision3Limit
/// What `limit_points()` and `curve_limit_points()` have reached.
struct Limit_report
{
  /// the largest estimated error of a limit point, in the unit of the coordinates.
  double error = 0;
  /// the largest estimated error of a surface normal or a tangent, in radians.
  double normal_error = 0;
  /// the largest error that the options allow, in the unit of the coordinates.
  double tolerance = 0;
  /// how many limit points, surface normals or tangents are estimated not to meet their tolerances.
  std::size_t number_of_misses = 0;
  /// at how many vertices the control normal stands in for the normal of the surface or curve.
  std::size_t number_of_stand_ins = 0;
  /// the most rounds of refinement that were done about a vertex or an edge.
  unsigned depth = 0;

  /// whether the estimated error is within the tolerance.
  bool is_within_tolerance() const { return number_of_misses == 0; }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_LIMIT_LIMIT_POINT_H
