// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/interpolate.h"

#include <CGAL/PN_subdivision_3/interpolate_limit_points.h>

namespace pn_subdivide {

namespace PN = CGAL::PN_subdivision_3;
using Tag = CGAL::Parallel_if_available_tag;

Interpolation_report interpolate_with_normals(Surface& surface, Normal_map normals,
                                              const Scheme& scheme,
                                              const Interpolation& interpolation)
{
  PN::Limit_interpolation_options<> options;
  options.mode = interpolation.mode;
  return std::visit(
    [&](const auto& s) -> Interpolation_report {
      if constexpr (can_interpolate<std::decay_t<decltype(s)>>) {
        if (interpolation.improves_normals) PN::natural_normals<Tag>(surface, s, normals);
        return PN::interpolate_limit_points<Tag>(surface, s, options,
                                                 CGAL::parameters::vertex_normal_map(normals));
      } else
        return {};
    },
    scheme);
}

} // namespace pn_subdivide
