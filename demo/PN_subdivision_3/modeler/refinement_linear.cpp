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

std::unique_ptr<Refinement> make_linear_refinement(const Control_mesh& mesh, const Scheme& scheme,
                                                   unsigned rounds)
{
  return std::visit(
    [&](const auto& s) -> std::unique_ptr<Refinement> {
      const auto linear = CGAL::PN_subdivision_3::linear(s);
      using S = std::decay_t<decltype(linear)>;
      return std::make_unique<Refiner_refinement<S, true>>(mesh, linear, rounds);
    },
    scheme);
}

} // namespace pn_demo
