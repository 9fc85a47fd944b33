// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_INTERPOLATION_OPTIONS_H
#define CGAL_PN_FITTING_3_INTERNAL_INTERPOLATION_OPTIONS_H

#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_subdivision_3/internal/own_parameters.h>

namespace CGAL::PN_subdivision_3::internal {

struct All_vertices
{};

// how interpolation and what prescribes data proceed; parameters.h says more
struct Interpolation_options
{
  Limit_interpolation::Mode mode = Limit_interpolation::Mode::slide;
  Limit_interpolation::Normals normals = Limit_interpolation::Normals::given;
  Limit_interpolation::Free free = Limit_interpolation::Free::fixed;
  double tolerance = 1e-12;
  unsigned max_depth = 12;
  unsigned max_steps = 60;
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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_INTERPOLATION_OPTIONS_H
