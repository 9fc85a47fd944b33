// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/refine.h"

#include <CGAL/PN_subdivision_3.h>

#include <type_traits>

namespace pn_subdivide {

using Tag = CGAL::Parallel_if_available_tag;

void refine_with_normal_scheme(Surface& surface, Normal_map normals, const Scheme& scheme,
                               const Scheme& normal_scheme, const Refinement& refinement)
{
  std::visit(
    [&](const auto& s, const auto& t) {
      using S = std::decay_t<decltype(s)>;
      using T = std::decay_t<decltype(t)>;
      if constexpr (go_together<S, T>)
        CGAL::PN_subdivision_3::subdivide<Tag>(
          surface, CGAL::PN_subdivision_3::with_normal_scheme(s, t),
          CGAL::parameters::number_of_iterations(refinement.levels)
            .vertex_normal_map(normals)
            .visitor(Round_visitor{refinement.round_done}),
          *refinement.attributes);
    },
    scheme, normal_scheme);
}

} // namespace pn_subdivide
