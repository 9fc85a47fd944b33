// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_HOSTS_PTQ_HOST_H
#define CGAL_PN_SUBDIVISION_3_HOSTS_PTQ_HOST_H

#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

namespace CGAL::PN_subdivision_3 {
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
/*!
\ingroup PkgPNSubdivision3Schemes

The primal triangle quadrisection: a triangle becomes three corner triangles and the middle one.

New vertices: the old vertices, then one vertex per edge, each in the order of the old elements. The
mask has to provide `vertex()` and `edge()`. The middle triangle keeps the index of the face, the
half of an edge at the source of its first half-edge keeps that of the edge.

\cgalModels{PNSubdivisionHost_3}
*/
class PTQ_host
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// the degree of all refined faces.
  static constexpr Index refined_degree = 3;

  /// old vertices survive, in front of the new ones.
  static constexpr bool keeps_vertices = true;
  /// every old edge is split in halves; all else lies inside the old faces.
  static constexpr bool splits_edges = true;

  /// the numbers of elements after a round.
  static Level_size refined_size(const Level_size& s, unsigned /*round*/)
  {
    Level_size r;
    r.vertices = s.vertices + s.edges;
    r.edges = s.halfedges() + 3 * s.faces;
    r.faces = 4 * s.faces;
    r.corners = 12 * s.faces;
    return r;
  }

  /// refuses a face that is not a triangle.
  template <class Element_names>
  static void check(const Level_connectivity& level, const Element_names& names)
  {
    internal::check_triangles(level, names);
  }

  /// prepares a round on a level, which has to live as long.
  PTQ_host(const Level_connectivity& level, unsigned /*round*/)
    : level_(level)
    , split_(level)
    , numbering_(level.size())
  {}

  /// the new vertex of an edge.
  Index vertex_of_edge(Index e) const { return split_.vertex_of_edge(e); }

  /// \name Parents
  /// @{

  /// the old vertex or edge that a new vertex comes from.
  Element_parent parent_of_vertex(Index child) const { return numbering_.parent_of_vertex(child); }
  /// the old edge that a new edge is a half of, or the face that it lies in and the corner that it cuts off.
  Element_parent parent_of_edge(Index child) const { return numbering_.parent_of_edge(child); }
  /// the old face that a new face is a part of: the middle one first.
  Element_parent parent_of_face(Index child) const { return numbering_.parent_of_face(child); }
  /// @}

  /// calls the function of the mask that gives the row of a new vertex.
  template <class Mask, class Stencil>
  void stencil(const Mask& mask, Index new_vertex, Stencil& s) const
  {
    const Element_parent parent = parent_of_vertex(new_vertex);
    if (parent.kind == Element_parent::Kind::vertex)
      mask.vertex(parent.index, s);
    else
      mask.edge(parent.index, s);
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
    Index h[3];
    h[0] = level_.halfedge_of_face(f);
    h[1] = level_.next(h[0]);
    h[2] = level_.next(h[1]);
    const auto inner_edge = [&](Index i) { return 2 * numbering_.inner_edge(f, i); };
    const Index middle_triangle = numbering_.middle_triangle(f);
    for (Index i = 0; i < 3; ++i) {
      // the triangle of the corner at the target of h[i]; the inner edge closes it
      const Index n = h[(i + 1) % 3];
      const Index corner = numbering_.corner_triangle(f, i);
      const Index in = split_.second_half(h[i]), out = split_.first_half(n);
      const Index inner = inner_edge(i);
      const Index middle = Level_connectivity::opposite(inner);
      child.set_next(in, out);
      child.set_next(out, inner);
      child.set_next(inner, in);
      child.set_next(middle, Level_connectivity::opposite(inner_edge((i + 1) % 3)));
      child.set_face(in, corner);
      child.set_face(out, corner);
      child.set_face(inner, corner);
      child.set_face(middle, middle_triangle);
      child.set_target(in, level_.target(h[i]));
      child.set_target(out, split_.edge_vertex(n));
      child.set_target(inner, split_.edge_vertex(h[i]));
      child.set_target(middle, split_.edge_vertex(n));
      child.set_halfedge_of_face(corner, in);
    }
    child.set_halfedge_of_face(middle_triangle, Level_connectivity::opposite(inner_edge(0)));
  }

  const Level_connectivity& level_;
  internal::Edge_split split_;
  internal::PTQ_numbering<Index> numbering_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_HOSTS_PTQ_HOST_H
