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
namespace PN = CGAL::PN_subdivision_3;

Limit_report move_to_limits_with_normals(Surface& surface, Corner_normal_map normals,
                                         const Scheme& scheme, const Crease_maps& creases,
                                         const Limit_options& options)
{
  return std::visit(
    [&](const auto& s) -> Limit_report {
      if constexpr (can_crease<std::decay_t<decltype(s)>>)
        return PN::move_to_limit<Tag>(
          surface, PN::with_crease_tangents(PN::with_border(s, creases.border), creases.tangents),
          options,
          CGAL::parameters::vertex_normal_map(normals)
            .edge_is_constrained_map(creases.edges)
            .vertex_is_constrained_map(creases.vertices));
      else
        return {};
    },
    scheme);
}

} // namespace pn_subdivide
