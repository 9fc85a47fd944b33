// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_HOSTS_PQQ_HOST_H
#define CGAL_PN_SUBDIVISION_3_HOSTS_PQQ_HOST_H

#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// The numbers of the children in the primal quadrilateral quadrisection, and back. Corners are numbered
// face by face, in a face from the target of its half-edge on: the corner at the target of h has the quad
// there and the spoke from the new vertex of h's edge.
//
// vertices: old ones, edges, faces. Edges: halves of edges, spokes by corners. Faces: the first quads of
// all faces, then the other ones.
template <class Index>
class PQQ_numbering
{
public:
  using Parent = Basic_element_parent<Index>;

  // `corners` must stay
  PQQ_numbering(const Level_size& size, const Face_corners<Index>& corners)
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
  const Face_corners<Index>& corners_;
};

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Schemes

The primal quadrilateral quadrisection: a polygon with m corners becomes m quads that meet in a new face vertex. The
quad of a corner has the corner, the new vertices of the two edges beside it and the face vertex.

New vertices: the old vertices, then one vertex per edge, then one per face, each in the order of
the old elements. The mask has to provide `vertex()`, `edge()` and `face()`. The first quad of a
face keeps the index of the face, the half of an edge at the source of its first half-edge keeps
that of the edge.

\cgalModels{PNSubdivisionHost_3}
*/
class PQQ_host
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// the degree of all refined faces.
  static constexpr Index refined_degree = 4;

  /// old vertices survive, in front of the new ones.
  static constexpr bool keeps_vertices = true;
  /// every old edge is split in halves; all else lies inside the old faces.
  static constexpr bool splits_edges = true;

  /// the numbers of elements after a round.
  static Level_size refined_size(const Level_size& s, unsigned /*round*/)
  {
    Level_size r;
    r.vertices = s.vertices + s.edges + s.faces;
    r.edges = s.halfedges() + s.corners;
    r.faces = s.corners;
    r.corners = 4 * s.corners;
    return r;
  }

  /// any polygons are accepted.
  template <class Element_names>
  static void check(const Level_connectivity&, const Element_names&)
  {}

  /// prepares a round on a level, which has to live as long.
  PQQ_host(const Level_connectivity& level, unsigned /*round*/)
    : level_(level)
    , split_(level)
    , corners_(level)
    , numbering_(level.size(), corners_)
  {}
  PQQ_host(const PQQ_host&) = delete;
  PQQ_host& operator=(const PQQ_host&) = delete;

  /// the new vertex of an edge.
  Index vertex_of_edge(Index e) const { return split_.vertex_of_edge(e); }
  /// the new vertex of a face.
  Index vertex_of_face(Index f) const { return numbering_.vertex_of_face(f); }

  /// \name Parents
  /// @{

  /// the old vertex, edge or face that a new vertex comes from.
  Element_parent parent_of_vertex(Index child) const { return numbering_.parent_of_vertex(child); }
  /// the old edge that a new edge is a half of, or the face that it lies in. The new edge of corner i of the face, counted
  /// from the target of its half-edge on, begins at the edge that leads to the corner.
  Element_parent parent_of_edge(Index child) const { return numbering_.parent_of_edge(child); }
  /// the old face that a new face is a part of, and its corner.
  Element_parent parent_of_face(Index child) const { return numbering_.parent_of_face(child); }
  /// @}

  /// calls the function of the mask that gives the row of a new vertex.
  template <class Mask, class Stencil>
  void stencil(const Mask& mask, Index new_vertex, Stencil& s) const
  {
    const Element_parent parent = parent_of_vertex(new_vertex);
    if (parent.kind == Element_parent::Kind::vertex)
      mask.vertex(parent.index, s);
    else if (parent.kind == Element_parent::Kind::edge)
      mask.edge(parent.index, s);
    else
      mask.face(parent.index, s);
  }

  /// sets the connectivity of the refined level.
  template <class Child, class For_chunks>
  void connect(Child& child, const For_chunks& for_chunks) const
  {
    split_.connect(child, for_chunks);
    internal::for_each_index(for_chunks, level_.number_of_faces(),
                             [&](Index f) { connect_face(f, child); });
  }

private:
  template <class Child>
  void connect_face(Index f, Child& child) const
  {
    const Index face_vertex = vertex_of_face(f);
    const Index first_corner = numbering_.first_corner(f);
    const Index first_spoke = 2 * numbering_.spoke(first_corner, 0);
    const Index first = level_.halfedge_of_face(f);
    Index spoke = first_spoke;
    Index h = first;
    Index corner = 0;
    do {
      // the quad of the corner at the target of h; a spoke leads from an edge vertex to the face
      // vertex
      const Index n = level_.next(h);
      const Index quad = numbering_.quad(f, first_corner, corner++);
      const Index next_spoke =
        n == first ? first_spoke : 2 * numbering_.spoke(first_corner, corner);
      const Index in = split_.second_half(h), out = split_.first_half(n);
      const Index back = Level_connectivity::opposite(spoke);
      child.set_next(in, out);
      child.set_next(out, next_spoke);
      child.set_next(next_spoke, back);
      child.set_next(back, in);
      child.set_face(in, quad);
      child.set_face(out, quad);
      child.set_face(next_spoke, quad);
      child.set_face(back, quad);
      child.set_target(in, level_.target(h));
      child.set_target(out, split_.edge_vertex(n));
      child.set_target(next_spoke, face_vertex);
      child.set_target(back, split_.edge_vertex(h));
      child.set_halfedge_of_face(quad, in);
      spoke = next_spoke;
      h = n;
    } while (h != first);
    child.set_halfedge_of_vertex(face_vertex, first_spoke);
  }

  const Level_connectivity& level_;
  internal::Edge_split split_;
  internal::Face_corners<Index> corners_;
  internal::PQQ_numbering<Index> numbering_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_HOSTS_PQQ_HOST_H
