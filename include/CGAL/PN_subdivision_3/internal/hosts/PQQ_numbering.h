// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_PQQ_NUMBERING_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_PQQ_NUMBERING_H

#include <CGAL/PN_subdivision_3/hosts/Element_parent.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_halves.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Face_corners.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The numbers of the children in the primal quadrilateral quadrisection, and back. Corners are numbered
// face by face, in a face from the target of its half-edge on: the corner at the target of h has the quad
// there and the spoke from the new vertex of h's edge.
//
// vertices: old ones, edges, faces. Edges: halves of edges, spokes by corners. Faces: the first quads of
// all faces, then the other ones.
template <class Index, class Corners = Face_corners<Index>>
class PQQ_numbering
{
public:
  using Parent = Basic_element_parent<Index>;

  // `corners` must stay
  PQQ_numbering(const Level_size& size, const Corners& corners)
    : halves_(size)
    , faces_(static_cast<Index>(size.faces))
    , corners_(corners)
  {}

  const Edge_halves<Index>& halves() const { return halves_; }

  Index vertex_of_face(Index f) const { return halves_.number_of_vertices() + f; }
  Index spoke(Index first_corner, Index ordinal) const
  {
    return halves_.number_of_edges() + first_corner + ordinal;
  }
  Index quad(Index f, Index first_corner, Index ordinal) const
  {
    return ordinal == 0 ? f : faces_ + (first_corner - f) + (ordinal - 1);
  }
  Index first_corner(Index f) const { return corners_.first(f); }

  Parent parent_of_vertex(Index child) const
  {
    if (child < halves_.number_of_vertices()) return halves_.parent_of_vertex(child);
    return {Parent::Kind::face, child - halves_.number_of_vertices()};
  }
  Parent parent_of_edge(Index child) const
  {
    if (child < halves_.number_of_edges()) return halves_.parent_of_edge(child);
    const auto [f, ordinal] = corners_.face_of_corner(child - halves_.number_of_edges());
    return {Parent::Kind::face, f, ordinal};
  }
  Parent parent_of_face(Index child) const
  {
    if (child < faces_) return {Parent::Kind::face, child, 0};
    const auto [f, ordinal] = corners_.face_of_later_corner(child - faces_);
    return {Parent::Kind::face, f, ordinal};
  }

private:
  Edge_halves<Index> halves_;
  Index faces_;
  const Corners& corners_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_PQQ_NUMBERING_H
