// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_EDGE_SPLIT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_EDGE_SPLIT_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

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

// What the primal quadrisections share: every edge is split by a new vertex. Half-edges of the halves
// have the direction, and so the last bit, of the old half-edge of which they are a part.
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
    for_each_index(for_chunks, level_.number_of_vertices(), [&](Index v) {
      if (level_.is_isolated(v)) return child.set_isolated(v);
      child.set_halfedge_of_vertex(v, second_half(level_.halfedge_of_vertex(v)));
    });
    for_each_index(for_chunks, level_.number_of_edges(), [&](Index e) { connect_edge(e, child); });
  }

private:
  Index half(Index h, Index ordinal) const
  {
    return 2 * halves_.half_of_edge(Level_connectivity::edge(h), ordinal) + (h & 1u);
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

// The corners of a level numbered face by face: closed forms if all faces have the same degree, else
// from the first corners of the faces.
template <class Index>
class Face_corners
{
public:
  explicit Face_corners(Index uniform_degree = 0)
    : degree_(uniform_degree)
  {}
  explicit Face_corners(const Level_connectivity& level)
    : degree_(level.uniform_degree())
  {
    if (degree_ != 0) return;
    first_.resize(level.number_of_faces(), boost::container::default_init);
    Index corner = 0;
    for (Level_connectivity::Index f = 0; f < level.number_of_faces(); ++f) {
      first_[f] = corner;
      corner += level.degree(level.halfedge_of_face(f));
    }
  }

  Index first(Index f) const { return degree_ != 0 ? degree_ * f : first_[f]; }

  // the face of a corner, and which of its corners it is
  std::pair<Index, Index> face_of_corner(Index corner) const
  {
    if (degree_ != 0) return {corner / degree_, corner % degree_};
    const auto next = std::upper_bound(first_.begin(), first_.end(), corner);
    const auto f = static_cast<Index>(next - first_.begin() - 1);
    return {f, corner - first_[f]};
  }
  // the same if the first corner of every face is left out of the numbering; the result is at least 1
  std::pair<Index, Index> face_of_later_corner(Index rank) const
  {
    if (degree_ != 0) return {rank / (degree_ - 1), rank % (degree_ - 1) + 1};
    std::size_t begin = 0, end = first_.size(); // the last face with first_[f] - f <= rank
    while (end - begin > 1) {
      const std::size_t middle = begin + (end - begin) / 2;
      (first_[middle] - middle <= rank ? begin : end) = middle;
    }
    const auto f = static_cast<Index>(begin);
    return {f, rank - (first_[f] - f) + 1};
  }

private:
  Index degree_; // 0 if they differ
  boost::container::vector<Index> first_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_EDGE_SPLIT_H
