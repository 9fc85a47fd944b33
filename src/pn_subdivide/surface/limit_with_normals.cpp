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

Limit_report limits_with_normals(const Surface& surface, Normal_map normals, const Scheme& scheme,
                                 const Limit_map& limits, const Limit_options& options)
{
  return std::visit(
    [&](const auto& s) -> Limit_report {
      using S = std::decay_t<decltype(s)>;
      if constexpr (S::Host::keeps_vertices)
        return CGAL::PN_subdivision_3::limit_points<Tag>(
          surface, s, limits, options, CGAL::parameters::vertex_normal_map(normals));
      else
        return {};
    },
    scheme);
}

} // namespace pn_subdivide
