// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASES_OF_PART_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASES_OF_PART_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Slot_shares.h>
#include <CGAL/PN_subdivision_3/internal/creases/control_creases.h>
#include <CGAL/PN_subdivision_3/schemes/with_border.h>

#include <algorithm>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The creases of some faces of a level as a level of their own, with their tangents. At its rim, but not at the border
// of the whole, the rules are those of a smooth border. The origins are the numbers in the whole; edges keep their
// orientation.
template <class FT, class Edge_origin, class Vertex_origin>
Creases<FT> creases_of_part(const Creases<FT>& whole, const Level_connectivity& part,
                            const Edge_origin& edge_origin, const Vertex_origin& vertex_origin)
{
  using Index = Level_connectivity::Index;
  const auto crease_at = [&](Index e) -> const Crease_edge<FT>* {
    const Index origin = edge_origin(e);
    const auto it = std::lower_bound(whole.edges.begin(), whole.edges.end(), origin,
                                     [](const Crease_edge<FT>& c, Index i) { return c.edge < i; });
    return it != whole.edges.end() && it->edge == origin ? &*it : nullptr;
  };
  const auto edge_sharpness = [&](Index e) {
    const Crease_edge<FT>* crease = crease_at(e);
    return crease == nullptr ? 0 : crease->sharpness;
  };
  const auto vertex_sharpness = [&](Index v) {
    const Index origin = vertex_origin(v);
    const auto it = std::lower_bound(whole.stars.begin(), whole.stars.end(), origin,
                                     [](const Crease_star& s, Index i) { return s.vertex < i; });
    return it != whole.stars.end() && it->vertex == origin ? it->sharpness : 0;
  };
  Creases<FT> creases = Make_creases<FT>(part, Border::surface)(edge_sharpness, vertex_sharpness);
  creases.has_fixed_border = whole.has_fixed_border;
  for (Crease_edge<FT>& e : creases.edges) e.tangent_from = crease_at(e.edge)->tangent_from;
  return creases;
}

// Puts the values of the slots of a part, of which those of isolated vertices are not looked at. Wedges that begin at
// a crease are told from the others by this; `slots` are those of the whole.
template <class FT, class Halfedge_origin, class Whole_values, class Values>
void take_slot_values(const Level_connectivity& part, const Creases<FT>& creases,
                      const Halfedge_origin& halfedge_origin, const Corner_slots<FT>& slots,
                      const Whole_values& whole_values, Values& values)
{
  using Index = Level_connectivity::Index;
  for (Index v = 0; v < part.number_of_vertices(); ++v) {
    if (part.is_isolated(v)) continue;
    const Index own = part.halfedge_of_vertex(v);
    const Index h = part.is_border(own) ? part.next_around_target(own) : own;
    values[v] = whole_values[slots(halfedge_origin(h))];
  }
  for (const Crease_star& star : creases.stars)
    for (Index i = 0; i < star.number_of_ends; ++i) {
      const Crease_end& e = creases.end(star, i);
      if (creases.edge(e).has_after(e.side))
        values[creases.edge(e).after[e.side]] =
          whole_values[slots(halfedge_origin(creases.halfedge(e)))];
    }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASES_OF_PART_H
