// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_DQQ_NUMBERING_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_DQQ_NUMBERING_H

#include <CGAL/PN_subdivision_3/hosts/Element_parent.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Numbers some of the elements of a level, in their order: closed if these are all.
template <class Index>
class Ranks
{
public:
  // all elements
  Ranks() = default;
  // those of `number` for which is_counted(i) is true
  template <class Is_counted>
  Ranks(Index number, const Is_counted& is_counted)
  {
    rank_.resize(number, boost::container::default_init);
    Index rank = 0;
    for (Index i = 0; i < number; ++i) {
      rank_[i] = rank;
      if (is_counted(i)) ++rank;
    }
  }

  // \pre the element is counted
  Index rank(Index i) const { return rank_.empty() ? i : rank_[i]; }
  // the element that is counted and has this rank: the last one with it
  Index element(Index rank) const
  {
    if (rank_.empty()) return rank;
    const auto next = std::upper_bound(rank_.begin(), rank_.end(), rank);
    return static_cast<Index>(next - rank_.begin() - 1);
  }

private:
  boost::container::vector<Index> rank_;
};

// The numbers of the children in the dual quadrilateral quadrisection, and back. Corners are numbered face
// by face.
//
// vertices: corners. Edges: one a corner, on the smaller face; two for every interior edge, that cross
// it. Faces: smaller faces, quads of interior edges, polygons of interior vertices.
template <class Index, class Any_ranks = Ranks<Index>>
class DQQ_numbering
{
public:
  using Parent = Basic_element_parent<Index>;

  // the ranks are those of the interior edges and vertices, and must stay
  DQQ_numbering(const Level_size& size, const Any_ranks& edges, const Any_ranks& vertices)
    : corners_(static_cast<Index>(size.corners))
    , faces_(static_cast<Index>(size.faces))
    , interior_edges_(static_cast<Index>(size.corners - size.edges))
    , edges_(edges)
    , vertices_(vertices)
  {}

  Index edge_of_corner(Index corner) const { return corner; }
  // at the target of half-edge 2e + side
  Index crossing_edge(Index e, Index side) const { return corners_ + 2 * edges_.rank(e) + side; }
  Index face_of_face(Index f) const { return f; }
  Index face_of_edge(Index e) const { return faces_ + edges_.rank(e); }
  Index face_of_vertex(Index v) const { return faces_ + interior_edges_ + vertices_.rank(v); }

  bool is_edge_of_corner(Index child) const { return child < corners_; }
  // \pre not is_edge_of_corner(child)
  Parent parent_of_crossing_edge(Index child) const
  {
    const Index i = child - corners_;
    return {Parent::Kind::edge, edges_.element(i / 2), i % 2};
  }
  Parent parent_of_face(Index child) const
  {
    if (child < faces_) return {Parent::Kind::face, child};
    if (child < faces_ + interior_edges_)
      return {Parent::Kind::edge, edges_.element(child - faces_)};
    return {Parent::Kind::vertex, vertices_.element(child - faces_ - interior_edges_)};
  }

private:
  Index corners_, faces_, interior_edges_;
  const Any_ranks& edges_;
  const Any_ranks& vertices_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_DQQ_NUMBERING_H
