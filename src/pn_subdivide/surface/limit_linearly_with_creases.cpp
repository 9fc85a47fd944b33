// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/move_to_limits.h"

namespace pn_subdivide {

namespace PN = CGAL::PN_subdivision_3;

Limit_report move_to_linear_limits(Surface& surface, Corner_normal_map normals,
                                   const Scheme& scheme, const Crease_maps& creases,
                                   const Limit_options& options)
{
  return std::visit(
    [&](const auto& s) -> Limit_report {
      if constexpr (can_crease<std::decay_t<decltype(s)>>)
        return move_to_limits(surface, normals, PN::linear(PN::with_border(s, creases.border)),
                              creases, options);
      else
        return {};
    },
    scheme);
}

} // namespace pn_subdivide
