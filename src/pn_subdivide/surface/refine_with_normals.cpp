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

void refine_with_normals(Surface& surface, Normal_map normals, const Scheme& scheme,
                         const Refinement& refinement)
{
  std::visit(
    [&](const auto& s) {
      CGAL::PN_subdivision_3::subdivide<Tag>(
        surface, s,
        CGAL::parameters::number_of_iterations(refinement.levels)
          .vertex_normal_map(normals)
          .visitor(Round_visitor{refinement.round_done}),
        *refinement.attributes);
    },
    scheme);
}

} // namespace pn_subdivide
