// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/limit.h"

#include <CGAL/PN_subdivision_3.h>

#include <type_traits>

namespace pn_subdivide {

using Tag = CGAL::Parallel_if_available_tag;

Limit_report limits_with_normal_scheme(const Surface& surface, Normal_map normals,
                                       const Scheme& scheme, const Scheme& normal_scheme,
                                       const Limit_map& limits, const Limit_options& options)
{
  return std::visit(
    [&](const auto& s, const auto& t) -> Limit_report {
      using S = std::decay_t<decltype(s)>;
      using T = std::decay_t<decltype(t)>;
      if constexpr (S::Host::keeps_vertices && go_together<S, T>)
        return CGAL::PN_subdivision_3::limit_points<Tag>(
          surface, CGAL::PN_subdivision_3::with_normal_scheme(s, t), limits, options,
          CGAL::parameters::vertex_normal_map(normals));
      else
        return {};
    },
    scheme, normal_scheme);
}

} // namespace pn_subdivide
