// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Refiner_refinement.h"

#include <CGAL/PN_subdivision_3.h>

namespace pn_demo {

std::unique_ptr<Refinement> make_pn_refinement(const Control_mesh& mesh, const Scheme& scheme,
                                               unsigned rounds)
{
  return std::visit(
    [&](const auto& s) -> std::unique_ptr<Refinement> {
      using S = std::decay_t<decltype(s)>;
      if constexpr (pn_subdivide::Transfers_curvature<S>::value)
        return nullptr;
      else
        return std::make_unique<Refiner_refinement<S, false>>(mesh, s, rounds);
    },
    scheme);
}

} // namespace pn_demo
