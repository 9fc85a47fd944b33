// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/make_pieces.h"

#include <type_traits>

namespace pn_subdivide {

std::unique_ptr<Any_pieces> make_pieces_with_normal_scheme(const Surface& surface,
                                                           Normal_map normals, const Scheme& scheme,
                                                           const Scheme& normal_scheme,
                                                           unsigned levels, std::size_t number)
{
  std::unique_ptr<Any_pieces> pieces;
  std::visit(
    [&](const auto& s, const auto& t) {
      using S = std::decay_t<decltype(s)>;
      using T = std::decay_t<decltype(t)>;
      if constexpr (go_together<S, T>)
        pieces = pieces_of_scheme(
          surface, CGAL::PN_subdivision_3::with_normal_scheme(s, t), number,
          CGAL::parameters::number_of_iterations(levels).vertex_normal_map(normals));
    },
    scheme, normal_scheme);
  return pieces;
}

} // namespace pn_subdivide
