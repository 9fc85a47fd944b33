// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_PTQ_NUMBERING_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_PTQ_NUMBERING_H

#include <CGAL/PN_subdivision_3/hosts/Element_parent.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_halves.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The numbers of the children in the primal triangle quadrisection, and back.
//
// vertices: old ones, edges. Edges: halves of edges, three inner ones a face. Faces: the middle triangles,
// then three corner triangles a face. Corner i of a face is at the target of its half-edge number i, and the
// inner edge i closes the triangle there.
template <class Index>
class PTQ_numbering
{
public:
  using Parent = Basic_element_parent<Index>;

  explicit PTQ_numbering(const Level_size& size)
    : halves_(size)
    , faces_(static_cast<Index>(size.faces))
  {}

  const Edge_halves<Index>& halves() const { return halves_; }

  Index inner_edge(Index f, Index corner) const
  {
    return halves_.number_of_edges() + 3 * f + corner;
  }
  Index middle_triangle(Index f) const { return f; }
  Index corner_triangle(Index f, Index corner) const { return faces_ + 3 * f + corner; }

  Parent parent_of_vertex(Index child) const { return halves_.parent_of_vertex(child); }
  Parent parent_of_edge(Index child) const
  {
    if (child < halves_.number_of_edges()) return halves_.parent_of_edge(child);
    const Index i = child - halves_.number_of_edges();
    return {Parent::Kind::face, i / 3, i % 3};
  }
  // the middle triangle has the ordinal 0, that of corner i has i + 1
  Parent parent_of_face(Index child) const
  {
    if (child < faces_) return {Parent::Kind::face, child, 0};
    const Index i = child - faces_;
    return {Parent::Kind::face, i / 3, i % 3 + 1};
  }

private:
  Edge_halves<Index> halves_;
  Index faces_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_PTQ_NUMBERING_H
