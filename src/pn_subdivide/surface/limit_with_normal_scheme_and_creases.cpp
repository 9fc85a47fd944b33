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

Limit_report move_to_limits_with_normal_scheme(Surface& surface, Corner_normal_map normals,
                                               const Scheme& scheme, const Scheme& normal_scheme,
                                               const Crease_maps& creases,
                                               const Limit_options& options)
{
  return std::visit(
    [&](const auto& s, const auto& t) -> Limit_report {
      using S = std::decay_t<decltype(s)>;
      using T = std::decay_t<decltype(t)>;
      if constexpr (can_crease<S> && can_crease<T>)
        if constexpr (go_together<S, T>)
          return move_to_limits(surface, normals,
                                with_creases(PN::with_normal_scheme(s, t), creases), creases,
                                options);
      return {};
    },
    scheme, normal_scheme);
}

} // namespace pn_subdivide
