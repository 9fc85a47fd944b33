// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/make_pieces.h"

namespace pn_subdivide {

std::unique_ptr<Any_pieces> make_pieces_with_normals(const Surface& surface, Normal_map normals,
                                                     const Scheme& scheme, unsigned levels,
                                                     std::size_t number)
{
  return std::visit(
    [&](const auto& s) {
      return pieces_of_scheme(
        surface, s, number,
        CGAL::parameters::number_of_iterations(levels).vertex_normal_map(normals));
    },
    scheme);
}

} // namespace pn_subdivide
