// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/move_to_limits.h"

namespace pn_subdivide {

Limit_report move_to_limits_with_normals(Surface& surface, Corner_normal_map normals,
                                         const Scheme& scheme, const Crease_maps& creases,
                                         const Limit_options& options)
{
  return std::visit(
    [&](const auto& s) -> Limit_report {
      if constexpr (can_crease<std::decay_t<decltype(s)>>)
        return move_to_limits(surface, normals, with_creases(s, creases), creases, options);
      else
        return {};
    },
    scheme);
}

} // namespace pn_subdivide
