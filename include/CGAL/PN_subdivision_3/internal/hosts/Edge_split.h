// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_EDGE_SPLIT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_EDGE_SPLIT_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_halves.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What the primal quadrisections share: every edge is split by a new vertex. Half-edges of its halves
// have the direction, and so the last bit, of the half-edge that they are parts of.
class Edge_split
{
public:
  using Index = Level_connectivity::Index;

  explicit Edge_split(const Level_connectivity& level)
    : level_(level)
    , halves_(level.size())
  {}

  // the halves of h: from its source to the edge vertex, from there to its target
  Index first_half(Index h) const { return half(h, h & 1u); }
  Index second_half(Index h) const { return half(h, 1 - (h & 1u)); }
  Index vertex_of_edge(Index e) const { return halves_.vertex_of_edge(e); }
  Index edge_vertex(Index h) const { return vertex_of_edge(Level_connectivity::edge(h)); }

  // sets the half-edges of the old and the edge vertices, and all of the border
  template <class Child, class For_chunks>
  void connect(Child& child, const For_chunks& for_chunks) const
  {
    for_chunks(level_.number_of_vertices(), [&](Index begin, Index end) {
      for (Index v = begin; v < end; ++v) connect_vertex(v, child);
    });
    for_chunks(level_.number_of_edges(), [&](Index begin, Index end) {
      for (Index e = begin; e < end; ++e) connect_edge(e, child);
    });
  }

private:
  Index half(Index h, Index ordinal) const
  {
    return 2 * halves_.half_of_edge(Level_connectivity::edge(h), ordinal) + (h & 1u);
  }

  template <class Child>
  void connect_vertex(Index v, Child& child) const
  {
    if (level_.is_isolated(v))
      child.set_isolated(v);
    else
      child.set_halfedge_of_vertex(v, second_half(level_.halfedge_of_vertex(v)));
  }

  template <class Child>
  void connect_edge(Index e, Child& child) const
  {
    Index h = Level_connectivity::halfedge_of_edge(e);
    if (level_.has_border()) {
      if (level_.is_border(Level_connectivity::opposite(h))) h = Level_connectivity::opposite(h);
      if (level_.is_border(h)) connect_border(h, child);
    }
    child.set_halfedge_of_vertex(edge_vertex(h), first_half(h));
  }

  template <class Child>
  void connect_border(Index h, Child& child) const
  {
    const Index first = first_half(h), second = second_half(h);
    child.set_border(first);
    child.set_border(second);
    child.set_target(first, edge_vertex(h));
    child.set_target(second, level_.target(h));
    child.set_next(first, second);
    child.set_next(second, first_half(level_.next(h)));
  }

  const Level_connectivity& level_;
  // copies the sizes of the level, which may be cut open while new vertices are computed
  const Edge_halves<Index> halves_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_EDGE_SPLIT_H
