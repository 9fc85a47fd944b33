// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/refine.h"

#include <CGAL/PN_subdivision_3.h>

namespace pn_subdivide {

using Tag = CGAL::Parallel_if_available_tag;

void refine_linearly(Surface& surface, const Scheme& scheme, const Crease_maps& creases,
                     const Refinement& refinement)
{
  namespace PN = CGAL::PN_subdivision_3;
  std::visit(
    [&](const auto& s) {
      if constexpr (can_crease<std::decay_t<decltype(s)>>)
        PN::subdivide<Tag>(surface, PN::linear(PN::with_border(s, creases.border)),
                           CGAL::parameters::number_of_iterations(refinement.levels)
                             .edge_is_constrained_map(creases.edges)
                             .vertex_is_constrained_map(creases.vertices)
                             .visitor(Round_visitor{refinement.round_done}),
                           *refinement.attributes);
    },
    scheme);
}

} // namespace pn_subdivide
