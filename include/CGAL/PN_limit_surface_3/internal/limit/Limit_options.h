// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_OPTIONS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_OPTIONS_H

#include <CGAL/PN_subdivision_3/internal/numbers/is_interval.h>
#include <CGAL/PN_subdivision_3/internal/own_parameters.h>

#include <stdexcept>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// of limits that are estimated
template <class FT>
void refuse_intervals()
{
  if constexpr (is_interval_v<FT>)
    throw std::invalid_argument(
      "PN_subdivision_3: limits of point-normal schemes are estimated, so that intervals around "
      "them "
      "need not contain them: take linear() of the scheme, or a number type that is not an "
      "interval");
}

// what limits are to have, and how well; parameters.h says more
struct Limit_options
{
  double tolerance = 1e-9;
  bool points = true;
  double normal_tolerance = 1e-3;
  unsigned max_depth = 12;
  bool surface_normals = false;
  bool curve_normals = false;
  bool curvatures = false;
  unsigned rounds_done = 0;
};

template <class NamedParameters>
Limit_options limit_options(const NamedParameters& np)
{
  Limit_options o;
  o.tolerance = parameter_or<tolerance_t>(np, o.tolerance);
  o.points = parameter_or<points_t>(np, o.points);
  o.normal_tolerance = parameter_or<normal_tolerance_t>(np, o.normal_tolerance);
  o.max_depth = parameter_or<max_depth_t>(np, o.max_depth);
  o.surface_normals = parameter_or<surface_normals_t>(np, o.surface_normals);
  o.curve_normals = parameter_or<curve_normals_t>(np, o.curve_normals);
  o.curvatures = parameter_or<curvatures_t>(np, o.curvatures);
  o.rounds_done = parameter_or<rounds_done_t>(np, o.rounds_done);
  return o;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_OPTIONS_H
