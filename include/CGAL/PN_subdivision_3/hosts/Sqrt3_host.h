// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_HOSTS_SQRT3_HOST_H
#define CGAL_PN_SUBDIVISION_3_HOSTS_SQRT3_HOST_H

#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/config.hpp>
#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The \f$ \sqrt{3} \f$ refinement: every triangle gets a new vertex in its middle that is joined to
its corners, and every old interior edge is flipped to join the new vertices beside it.

Border edges are refined in the even rounds of a call only, counted from 1. A triangle at the border gets two new
vertices on its border edge instead of one in its middle, and is cut into three from its third corner. Calling k times
for one round hence never refines the border, and differs from one call for k rounds.

New vertices: the old vertices, then those of the faces in the order of the faces; of two in a face the one nearer to
the source of the border edge first. The mask has to provide `vertex()` and `face()`. The rounds that refine the
border also need `border_vertex(h)`, for the old vertex that the border half-edge `h` leads to. They need
`border_edge(h, i)`, i = 0, 1, for the two new vertices on the edge of `h`, a half-edge with a face. A face's
descriptor stays on one of its three triangles.

\cgalModels{PNSubdivisionHost_3}
*/
class Sqrt3_host
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// the degree of all refined faces.
  static constexpr Index refined_degree = 3;
  /// old vertices survive, in front of the new ones.
  static constexpr bool keeps_vertices = true;

  /// whether the border is refined in a round.
  static bool refines_border(unsigned round) { return round % 2 == 0; }

  /// the numbers of elements after a round.
  static Level_size refined_size(const Level_size& s, unsigned round)
  {
    const std::uint64_t border = refines_border(round) ? s.border_halfedges() : 0;
    Level_size r;
    r.vertices = s.vertices + s.faces + border;
    r.edges = s.edges + 3 * s.faces + border;
    r.faces = 3 * s.faces;
    r.corners = 9 * s.faces;
    return r;
  }

  /// refuses a face that is not a triangle.
  template <class Element_names>
  static void check(const Level_connectivity& level, const Element_names& names)
  {
    internal::check_triangles(level, names);
  }

  /// \throws std::invalid_argument if in an even round a triangle has two border edges, as none has
  /// after an odd round
  Sqrt3_host(const Level_connectivity& level, unsigned round)
    : level_(level)
    , vertices_(level.number_of_vertices())
    , edges_(level.number_of_edges())
    , faces_(level.number_of_faces())
    , corner_(level.number_of_halfedges(), boost::container::default_init)
  {
    number_corners();
    if (refines_border(round) && level.has_border()) number_border_faces();
  }
  Sqrt3_host(const Sqrt3_host&) = delete;
  Sqrt3_host& operator=(const Sqrt3_host&) = delete;

  /// the (first) new vertex of a face.
  Index vertex_of_face(Index f) const
  {
    return vertices_ + f + (has_refined_border() ? border_faces_before_[f] : 0);
  }

  /// \name Parents
  /// @{

  /// the old vertex, face or border edge that a new vertex comes from.
  Element_parent parent_of_vertex(Index new_vertex) const
  {
    if (new_vertex < vertices_) return {Kind::vertex, new_vertex};
    const Index rank = new_vertex - vertices_;
    if (!has_refined_border()) return {Kind::face, rank};
    const Index f = face_of_center_[rank], border = border_halfedge(f);
    if (border == Level_connectivity::null) return {Kind::face, f};
    return {Kind::border_edge, border, new_vertex - vertex_of_face(f)};
  }
  /// the old edge that was flipped to become a new edge, or that on the border stays, the old face inside
  /// which it lies and the corner that it leads to, or the border edge that it is a part of: part 0 at the target
  /// of the border half-edge, and so on.
  Element_parent parent_of_edge(Index new_edge) const
  {
    if (new_edge < edges_) {
      if (!has_refined_border() || !level_.is_border_edge(new_edge)) return {Kind::edge, new_edge};
      const Index h = 2 * new_edge;
      return {Kind::border_edge, level_.is_border(h) ? opposite(h) : h, 0};
    }
    const Index i = new_edge - edges_;
    Index f = i / 3, ordinal = i % 3;
    if (i >= 3 * faces_) { // the last part of a border edge
      const auto next =
        std::upper_bound(border_faces_before_.begin(), border_faces_before_.end(), i - 3 * faces_);
      f = static_cast<Index>(next - border_faces_before_.begin() - 1);
      ordinal = 3;
    }
    const Index border = refined_border_halfedge(f);
    if (border == Level_connectivity::null || ordinal < 2) return {Kind::face, f, ordinal};
    return {Kind::border_edge, border, ordinal - 1};
  }
  /// the old face with the half-edge that a new triangle lies at, and which of its half-edges it is. The triangle
  /// reaches beyond it, to the new vertex of the face on the other side.
  Element_parent parent_of_face(Index child) const
  {
    if (child < faces_) return {Kind::face, child, 0};
    const Index i = child - faces_;
    return {Kind::face, i / 2, i % 2 + 1};
  }
  /// whether the border is refined in this round.
  bool has_refined_border() const { return !border_faces_before_.empty(); }
  /// @}

  /// calls the function of the mask that gives the row of a new vertex.
  template <class Mask, class Stencil>
  void stencil(const Mask& mask, Index new_vertex, Stencil& s) const
  {
    const Element_parent parent = parent_of_vertex(new_vertex);
    if (parent.kind == Element_parent::Kind::vertex) {
      if (has_refined_border() && !level_.is_isolated(parent.index) &&
          level_.is_border_vertex(parent.index))
        mask.border_vertex(level_.halfedge_of_vertex(parent.index), s);
      else
        mask.vertex(parent.index, s);
    } else if (parent.kind == Element_parent::Kind::face)
      mask.face(parent.index, s);
    else
      mask.border_edge(parent.index, parent.ordinal, s);
  }

  /// sets the connectivity of the refined level.
  template <class Child, class For_chunks>
  void connect(Child& child, const For_chunks& for_chunks) const
  {
    internal::for_each_index(for_chunks, level_.number_of_vertices(), [&](Index v) {
      if (level_.is_isolated(v)) return child.set_isolated(v);
      const Index h = level_.halfedge_of_vertex(v);
      child.set_halfedge_of_vertex(v, level_.is_border(h) ? h : apex_over(h).to_target);
    });
    // by edges: both sides of an edge are read from the same place
    internal::for_each_index(for_chunks, level_.number_of_edges(),
                             [&](Index e) { connect_edge(2 * e, child); });
    // of two new vertices in a face, the triangle on the border sets the half-edges
    internal::for_each_index(for_chunks, level_.number_of_faces(), [&](Index f) {
      if (refined_border_halfedge(f) == Level_connectivity::null)
        child.set_halfedge_of_vertex(vertex_of_face(f), opposite(inner(f, 0)));
    });
  }

private:
  using Kind = Element_parent::Kind;

  static Index opposite(Index h) { return Level_connectivity::opposite(h); }

  // Half-edge i of face f is corner 4 f + i. Looking it up in one place keeps the jumps through the
  // memory of a large level few.
  void number_corners()
  {
    for (Index f = 0; f < level_.number_of_faces(); ++f) {
      Index h = level_.halfedge_of_face(f);
      for (Index i = 0; i < 3; ++i, h = level_.next(h)) corner_[h] = 4 * f + i;
    }
  }

  void number_border_faces()
  {
    border_faces_before_.resize(level_.number_of_faces(), boost::container::default_init);
    face_of_center_.reserve(level_.number_of_faces() + level_.size().border_halfedges());
    Index border_faces = 0;
    for (Index f = 0; f < level_.number_of_faces(); ++f) {
      border_faces_before_[f] = border_faces;
      face_of_center_.push_back(f);
      const Index h = border_halfedge(f);
      if (h == Level_connectivity::null) continue;
      if (level_.is_border(opposite(level_.next(h))) || level_.is_border(opposite(level_.prev(h))))
        throw std::invalid_argument("PN_subdivision_3: face number " + std::to_string(f) +
                                    " has two border edges: an even round of sqrt(3) cannot cut "
                                    "it; begin with an odd round");
      face_of_center_.push_back(f);
      ++border_faces;
    }
  }

  // the half-edge of a triangle whose opposite is on a border that is refined, null if there is
  // none
  Index border_halfedge(Index f) const
  {
    Index h = level_.halfedge_of_face(f);
    for (int i = 0; i < 3; ++i, h = level_.next(h))
      if (level_.is_border(opposite(h))) return h;
    return Level_connectivity::null;
  }
  Index refined_border_halfedge(Index f) const
  {
    return has_refined_border() ? border_halfedge(f) : Level_connectivity::null;
  }

  // New half-edges: those of old edges (flipped, or the first part of a refined border edge), three edges a face, the last
  // parts of refined border edges.
  Index inner(Index f, Index i) const { return 2 * (edges_ + 3 * f + i); }
  Index last_part(Index f) const { return 2 * (edges_ + 3 * faces_ + border_faces_before_[f]); }
  // New faces: the triangles at the first half-edges of all faces, then those at the second and third half-edges.
  Index triangle(Index h) const
  {
    const Index f = corner_[h] / 4, i = corner_[h] % 4;
    return i == 0 ? f : faces_ + 2 * f + i - 1;
  }

  // Seen from a half-edge h of a face: the new vertex that forms a triangle with h, and the
  // half-edges from it to the two ends of h. In an ordinary face these are the three spokes. In a
  // face whose border edge s->t is refined by n1, n2, third corner a: inner edges n1->a, n2->a, n1->n2;
  // n2->t is the last part, and the border half-edge keeps the part n1->s.
  struct Apex
  {
    Index vertex, to_source, to_target;
  };
  // In line: returning three 32 bit numbers costs more than computing them.
  BOOST_FORCEINLINE Apex apex_over(Index h) const
  {
    const Index f = corner_[h] / 4, i = corner_[h] % 4;
    if (refined_border_halfedge(f) == Level_connectivity::null)
      return {vertex_of_face(f), inner(f, i == 0 ? 2 : i - 1), inner(f, i)};
    return apex_at_refined_border(h, f);
  }
  Apex apex_at_refined_border(Index h, Index f) const
  {
    const Index border = border_halfedge(f);
    if (h == level_.next(border)) return {vertex_of_face(f) + 1, last_part(f), inner(f, 1)};
    return {vertex_of_face(f), inner(f, 0), opposite(border)};
  }

  template <class Child>
  void connect_edge(Index h, Child& child) const
  {
    if (level_.is_border(h)) h = opposite(h);
    if (level_.is_border(opposite(h)))
      return has_refined_border() ? connect_refined_border(h, child)
                                  : connect_kept_border(h, child);
    const Apex x = apex_over(h), y = apex_over(opposite(h));
    connect_flipped(h, x, y, child);
    connect_flipped(opposite(h), y, x, child);
  }

  // from `h1`, `h2`, `h3` to their targets
  template <class Child>
  void connect_triangle(Index t, Index h1, Index v1, Index h2, Index v2, Index h3, Index v3,
                        Child& child) const
  {
    child.set_next(h1, h2);
    child.set_next(h2, h3);
    child.set_next(h3, h1);
    child.set_target(h1, v1);
    child.set_target(h2, v2);
    child.set_target(h3, v3);
    for (Index h : {h1, h2, h3}) child.set_face(h, t);
    child.set_halfedge_of_face(t, h1);
  }

  // half-edge h now joins the new vertices of x on its side and of y on the other
  template <class Child>
  void connect_flipped(Index h, const Apex& x, const Apex& y, Child& child) const
  {
    connect_triangle(triangle(h), h, y.vertex, y.to_source, level_.target(h), opposite(x.to_target),
                     x.vertex, child);
  }

  template <class Child>
  void connect_kept_border(Index h, Child& child) const
  {
    const Apex x = apex_over(h);
    connect_triangle(triangle(h), h, level_.target(h), opposite(x.to_target), x.vertex, x.to_source,
                     level_.source(h), child);
    const Index b = opposite(h);
    child.set_border(b);
    child.set_target(b, level_.target(b));
    child.set_next(b, first_on_border(level_.next(b)));
  }

  template <class Child>
  void connect_refined_border(Index h, Child& child) const
  {
    const Index f = level_.face(h), b = opposite(h);
    const Index n1 = vertex_of_face(f), n2 = n1 + 1, third = level_.target(level_.next(h));
    const Index middle = inner(f, 2), last = last_part(f);
    connect_triangle(triangle(h), middle, n2, inner(f, 1), third, opposite(inner(f, 0)), n1, child);
    for (Index part : {b, opposite(middle), opposite(last)}) child.set_border(part);
    child.set_target(opposite(last), n2);
    child.set_target(opposite(middle), n1);
    child.set_target(b, level_.target(b));
    child.set_next(opposite(last), opposite(middle));
    child.set_next(opposite(middle), b);
    child.set_next(b, first_on_border(level_.next(b)));
    child.set_halfedge_of_vertex(n1, opposite(middle));
    child.set_halfedge_of_vertex(n2, opposite(last));
  }

  // the half-edge with which the old border half-edge b begins now
  Index first_on_border(Index b) const
  {
    if (!has_refined_border()) return b;
    return opposite(last_part(level_.face(opposite(b))));
  }

  const Level_connectivity& level_;
  Index vertices_, edges_, faces_; // how many there are
  boost::container::vector<Index> corner_;
  // In a round that refines the border: for each face how many before it have a border edge, and the faces of new
  // vertices; empty in other rounds.
  boost::container::vector<Index> border_faces_before_, face_of_center_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_HOSTS_SQRT3_HOST_H
