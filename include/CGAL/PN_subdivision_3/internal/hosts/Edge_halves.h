// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_EDGE_HALVES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_EDGE_HALVES_H

#include <CGAL/PN_subdivision_3/hosts/Element_parent.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The numbers that the primal quadrisections have in common: of the old vertices, the new vertex on
// every edge, and the halves of the edges. Edge e keeps its number on the half at the source of half-edge
// 2e; the other half is edge E + e.
template <class Index>
class Edge_halves
{
public:
  using Parent = Basic_element_parent<Index>;

  explicit Edge_halves(const Level_size& size)
    : vertices_(static_cast<Index>(size.vertices))
    , edges_(static_cast<Index>(size.edges))
  {}

  Index vertex_of_vertex(Index v) const { return v; }
  Index vertex_of_edge(Index e) const { return vertices_ + e; }
  // the vertices and edges that follow belong to faces
  Index number_of_vertices() const { return vertices_ + edges_; }
  Index number_of_edges() const { return 2 * edges_; }

  Index half_of_edge(Index e, Index ordinal) const { return ordinal == 0 ? e : edges_ + e; }

  // \pre child < number_of_vertices()
  Parent parent_of_vertex(Index child) const
  {
    if (child < vertices_) return {Parent::Kind::vertex, child};
    return {Parent::Kind::edge, child - vertices_};
  }
  // \pre child < number_of_edges()
  Parent parent_of_edge(Index child) const
  {
    if (child < edges_) return {Parent::Kind::edge, child, 0};
    return {Parent::Kind::edge, child - edges_, 1};
  }

private:
  Index vertices_, edges_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_EDGE_HALVES_H
