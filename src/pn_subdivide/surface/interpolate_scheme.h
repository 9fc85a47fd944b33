// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_INTERPOLATE_SCHEME_H
#define PN_SUBDIVIDE_INTERPOLATE_SCHEME_H

#include "surface/interpolate.h"

// The definitions of Interpolating_scheme, for the sources that instantiate it; without Eigen there are none.
#if __has_include(<Eigen/Core>)

#  include <CGAL/PN_subdivision_3/interpolate_limit_points.h>

namespace pn_subdivide {

template <class S>
Interpolation_report Interpolating_scheme<S>::with_normals(Surface& surface, Normal_map normals,
                                                           const S& scheme,
                                                           const Interpolation& interpolation)
{
  using Tag = CGAL::Parallel_if_available_tag;
  CGAL::PN_subdivision_3::Limit_interpolation_options<> options;
  options.mode = interpolation.mode;
  if (interpolation.improves_normals)
    CGAL::PN_subdivision_3::natural_normals<Tag>(surface, scheme, normals);
  return CGAL::PN_subdivision_3::interpolate_limit_points<Tag>(
    surface, scheme, options, CGAL::parameters::vertex_normal_map(normals));
}

template <class S>
Interpolation_report Interpolating_scheme<S>::linearly(Surface& surface, const S& scheme,
                                                       Interpolation_mode mode)
{
  CGAL::PN_subdivision_3::Limit_interpolation_options<> options;
  options.mode = mode;
  return CGAL::PN_subdivision_3::interpolate_limit_points<CGAL::Parallel_if_available_tag>(
    surface, CGAL::PN_subdivision_3::linear(scheme), options);
}

} // namespace pn_subdivide

#endif // __has_include(<Eigen/Core>)

#endif // PN_SUBDIVIDE_INTERPOLATE_SCHEME_H
