// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Creased_refinement.h"

namespace pn_demo {

std::unique_ptr<Refinement> make_pn_refinement_with_creases(const Control_mesh& mesh,
                                                            const Scheme& scheme, unsigned rounds)
{
  return std::visit(
    [&](const auto& s) -> std::unique_ptr<Refinement> {
      if constexpr (pn_subdivide::can_crease<std::decay_t<decltype(s)>>) {
        const auto chosen = s;
        using S = std::decay_t<decltype(chosen)>;
        return std::make_unique<Creased_refinement<S, false>>(mesh, chosen, rounds);
      } else
        return nullptr;
    },
    scheme);
}

} // namespace pn_demo
