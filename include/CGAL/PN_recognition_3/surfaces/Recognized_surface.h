// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_SURFACES_RECOGNIZED_SURFACE_H
#define CGAL_PN_RECOGNITION_3_SURFACES_RECOGNIZED_SURFACE_H

#include <array>
#include <cstddef>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

a surface of which a polygon mesh has facets, as `recognize_surfaces()` finds it. Numbers are `double`, whatever the kernel.
*/
struct Recognized_surface
{
  /// the kinds of surfaces. Facets of kind `unknown` are of none of the others.
  enum class Kind { unknown, plane, cylinder, cone, sphere, torus };
  static constexpr std::array<const char*, 6> kind_names{
    "unknown", "plane", "cylinder", "cone", "sphere", "torus"}; ///< the kinds' names, in order

  Kind kind = Kind::unknown; ///< which it is
  /// a point of the plane, of the axis of the cylinder, the apex of the cone, the center of the sphere or torus.
  std::array<double, 3> point{};
  /// the unit normal of the plane, or the direction of the axis; zero for spheres and what is unknown.
  std::array<double, 3> direction{};
  /// that of the cylinder or sphere, or of the circle of the centers of the torus' tube.
  double radius = 0;
  /// that of the tube of the torus.
  double tube_radius = 0;
  /// the angle between the cone and its axis, in radians.
  double half_angle = 0;
  /// the largest distance of its vertices from it.
  double residual = 0;
  /// how many faces have been found to belong to it.
  std::size_t number_of_faces = 0;
  /// the widest angle that a facet spans about the axis, of a sphere between corners seen from the center; 2 pi divided by it is
  /// the number of even facets a turn. Planes that are sides of a prism or pyramid of few sides have its angle, all else 0.
  double widest_step = 0;
  /// the same about the center of the tube of a torus.
  double widest_meridian_step = 0;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_RECOGNITION_3_SURFACES_RECOGNIZED_SURFACE_H
