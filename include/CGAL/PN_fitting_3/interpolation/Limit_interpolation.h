// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERPOLATION_LIMIT_INTERPOLATION_H
#define CGAL_PN_FITTING_3_INTERPOLATION_LIMIT_INTERPOLATION_H

#include <CGAL/PN_subdivision_3/internal/package_parameters.h>

#include <cstddef>

namespace CGAL::PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Interpolation
/// What interpolation has reached, and how it can be asked for. Lengths are in the unit of the coordinates.
struct Limit_interpolation
{
  /// The way in which a vertex is interpolated.
  enum class Mode {
    /// the limit surface passes through the point, or nearly; control normals are the given ones, and the control
    /// point slides along them. The fairest, and exact on spheres and circular cylinders.
    slide,
    /// the limit point of each vertex is its point
    strict
  };

  /// Which control normals interpolation takes.
  enum class Normals {
    given,  ///< the given ones
    solved, ///< those of which the limit is the given ones, where they can be found
    natural ///< those that the interpolating surface has at the points, whatever is given; in mode `slide`, too
  };

  /// The rule for control points of vertices that are not interpolated.
  enum class Free {
    fixed, ///< they stay
    smooth ///< they move along, as smoothly as they can; for `Mode::strict`
  };

  /// the largest distance that remains: in mode `slide` that of a point from the limit surface or curve; in mode
  /// `strict` that of a point from its limit point.
  double residual = 0;
  /// `prescribe_limit_data()`: the largest angle between a prescribed normal and that of the surface, in
  /// radians.
  double normal_residual = 0;
  /// `prescribe_limit_data()`: the largest difference of a curvature of the surface from the prescribed
  /// one, over all directions, in the reciprocal unit.
  double curvature_residual = 0;
  /// an estimate of the error of `residual` that comes from evaluating the limit.
  double error = 0;
  /// what was asked for.
  double tolerance = 0;
  /// how often control points, or control normals that are solved for, were moved; `prescribe_limit_data()`: how many linear systems
  /// were solved. Zero: the limit surface of the data passed through them.
  unsigned steps = 0;
  /// `prescribe_limit_data()`: how many steps towards prescribed curvatures were taken.
  unsigned curvature_steps = 0;
  /// the most rounds of refinement about a vertex.
  unsigned depth = 0;
  /// the largest distance of a point from its own limit point.
  double slip = 0;
  /// the largest slip as a part of the mean length of the edges at the vertex; above 1/4 the net is too
  /// coarse for mode `slide`.
  double slip_of_edge = 0;
  /// the largest angle between the given normals of neighbors, in degrees; above 60 the net is too
  /// coarse for its normals.
  double normal_angle = 0;
  /// vertices that were to be interpolated but have no normal to slide along, or whose control normals
  /// could not be solved for and are the given ones.
  std::size_t left_out = 0;

  /// whether the residual is within the tolerance. If not, the surface passes the points nearly, at this distance.
  bool is_within_tolerance() const { return residual <= tolerance; }
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

namespace internal {

// a map
struct All_vertices
{
  template <class Vertex>
  friend bool get(const All_vertices&, const Vertex&)
  {
    return true;
  }
};

// how interpolation and what prescribes data proceed; parameters.h says more
struct Interpolation_options
{
  Limit_interpolation::Mode mode = Limit_interpolation::Mode::slide;
  Limit_interpolation::Normals normals = Limit_interpolation::Normals::given;
  Limit_interpolation::Free free = Limit_interpolation::Free::fixed;
  double tolerance = 1e-12;
  unsigned max_depth = 12;
  unsigned max_steps = 100;
  unsigned rings = 2;
  double curvature_tolerance = 1e-6;
  unsigned max_curvature_steps = 12;
};

template <class NamedParameters>
Interpolation_options interpolation_options(const NamedParameters& np)
{
  Interpolation_options o;
  o.mode = parameter_or<interpolation_mode_t>(np, o.mode);
  o.normals = parameter_or<interpolation_normals_t>(np, o.normals);
  o.free = parameter_or<free_vertices_t>(np, o.free);
  o.tolerance = parameter_or<tolerance_t>(np, o.tolerance);
  o.max_depth = parameter_or<max_depth_t>(np, o.max_depth);
  o.max_steps = parameter_or<max_steps_t>(np, o.max_steps);
  o.rings = parameter_or<rings_t>(np, o.rings);
  o.curvature_tolerance = parameter_or<curvature_tolerance_t>(np, o.curvature_tolerance);
  o.max_curvature_steps = parameter_or<max_curvature_steps_t>(np, o.max_curvature_steps);
  return o;
}

} // namespace internal

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_FITTING_3_INTERPOLATION_LIMIT_INTERPOLATION_H
