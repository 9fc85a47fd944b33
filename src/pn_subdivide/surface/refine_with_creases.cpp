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
namespace PN = CGAL::PN_subdivision_3;

namespace {

template <class S>
void refine(Surface& surface, const Wedge_normals& normals, const S& scheme,
            const Crease_maps& creases, const Refinement& refinement)
{
  PN::subdivide<Tag>(
    surface, PN::with_crease_tangents(PN::with_border(scheme, creases.border), creases.tangents),
    CGAL::parameters::number_of_iterations(refinement.levels)
      .vertex_normal_map(normals)
      .edge_is_constrained_map(creases.edges)
      .vertex_is_constrained_map(creases.vertices)
      .visitor(Round_visitor{refinement.round_done}),
    *refinement.attributes);
}

} // namespace

void refine_with_normals(Surface& surface, const Wedge_normals& normals, const Scheme& scheme,
                         const Crease_maps& creases, const Refinement& refinement)
{
  std::visit(
    [&](const auto& s) {
      if constexpr (can_crease<std::decay_t<decltype(s)>>)
        refine(surface, normals, s, creases, refinement);
    },
    scheme);
}

void refine_with_normal_scheme(Surface& surface, const Wedge_normals& normals, const Scheme& scheme,
                               const Scheme& normal_scheme, const Crease_maps& creases,
                               const Refinement& refinement)
{
  std::visit(
    [&](const auto& s, const auto& t) {
      using S = std::decay_t<decltype(s)>;
      using T = std::decay_t<decltype(t)>;
      if constexpr (can_crease<S> && can_crease<T>)
        if constexpr (go_together<S, T>)
          refine(surface, normals, PN::with_normal_scheme(s, t), creases, refinement);
    },
    scheme, normal_scheme);
}

} // namespace pn_subdivide
