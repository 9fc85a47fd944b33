// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_HOSTS_DQQ_HOST_H
#define CGAL_PN_SUBDIVISION_3_HOSTS_DQQ_HOST_H

#include <CGAL/PN_subdivision_3/hosts/Element_parent.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <cstdint>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The dual quadrilateral quadrisection: every corner of a face becomes a new vertex, every face a
smaller face, every interior edge a quad and every interior vertex of valence n an n-gon. Border
edges, border vertices and vertices without edges leave nothing, so that the surface shrinks at its
border.

New vertices: the corners face by face, in a face from the target of its half-edge on. The mask has
to provide `corner(h)` for the corner of the face of `h` at the target of `h`. A smaller face keeps
the index of its face; then follow the quads and then the polygons, in the order of edges and
vertices.

\cgalModels{PNSubdivisionHost_3}
*/
class DQQ_host
{
public:
  using Index = Level_connectivity::Index;

  /// the refined faces have any degrees.
  static constexpr Index refined_degree = 0;
  /// no old vertex survives.
  static constexpr bool keeps_vertices = false;

  static Level_size refined_size(const Level_size& s, unsigned /*round*/)
  {
    const std::uint64_t border = s.border_halfedges(); // also the number of border vertices
    const std::uint64_t interior_edges = s.corners - s.edges;
    Level_size r;
    r.vertices = s.corners;
    r.edges = s.corners + 2 * interior_edges;
    r.faces = s.faces + interior_edges + (s.vertices - s.isolated_vertices - border);
    // every edge at a border vertex ends on the new border
    r.corners = r.halfedges() - (s.border_valences - border);
    r.border_valences = 4 * (s.border_valences - border) - 2 * border;
    return r;
  }

  /// any polygons are accepted.
  template <class Element_names>
  static void check(const Level_connectivity&, const Element_names&)
  {}

  DQQ_host(const Level_connectivity& level, unsigned /*round*/)
    : level_(level)
    , corner_(level.number_of_halfedges(), boost::container::default_init)
    , halfedge_(level.size().corners, boost::container::default_init)
  {
    number_corners();
    if (level.has_border() || level.size().isolated_vertices != 0) number_interior();
  }

  /// the new vertex of a corner, that of the face of `h` at the target of `h`.
  Index vertex_of_corner(Index h) const { return corner_[h]; }

  /// the corner that a new vertex comes from.
  Element_parent parent_of_vertex(Index new_vertex) const
  {
    return {Element_parent::Kind::corner, halfedge_[new_vertex]};
  }

  template <class Mask, class Stencil>
  void stencil(const Mask& mask, Index new_vertex, Stencil& s) const
  {
    mask.corner(parent_of_vertex(new_vertex).index, s);
  }

  template <class Child, class For_chunks>
  void connect(Child& child, const For_chunks& for_chunks) const
  {
    for_chunks(level_.number_of_faces(), [&](Index begin, Index end) {
      for (Index f = begin; f < end; ++f) connect_face(f, child);
    });
    for_chunks(level_.number_of_edges(), [&](Index begin, Index end) {
      for (Index e = begin; e < end; ++e) connect_edge(e, child);
    });
    for_chunks(level_.number_of_vertices(), [&](Index begin, Index end) {
      for (Index v = begin; v < end; ++v) connect_vertex(v, child);
    });
  }

private:
  static Index opposite(Index h) { return Level_connectivity::opposite(h); }

  // the half-edge before h in its face; the corners of a face are numbered one after the other
  Index preceding(Index h) const
  {
    const Index corner = corner_[h];
    if (corner != 0 && level_.next(halfedge_[corner - 1]) == h) return halfedge_[corner - 1];
    return level_.prev(h);
  }

  void number_corners()
  {
    Index corner = 0;
    for (Index f = 0; f < level_.number_of_faces(); ++f) {
      const Index first = level_.halfedge_of_face(f);
      Index h = first;
      do {
        corner_[h] = corner;
        halfedge_[corner++] = h;
        h = level_.next(h);
      } while (h != first);
    }
  }

  void number_interior()
  {
    edge_rank_.resize(level_.number_of_edges(), boost::container::default_init);
    Index rank = 0;
    for (Index e = 0; e < level_.number_of_edges(); ++e) {
      edge_rank_[e] = rank;
      if (!level_.is_border_edge(e)) ++rank;
    }
    vertex_rank_.resize(level_.number_of_vertices(), boost::container::default_init);
    rank = 0;
    for (Index v = 0; v < level_.number_of_vertices(); ++v) {
      vertex_rank_[v] = rank;
      if (is_interior_vertex(v)) ++rank;
    }
  }

  // New half-edges. An old half-edge h with a face has an inner one inside the smaller face, whose
  // opposite is the outer one. At its target, an interior one has a crossing to the corner of h in
  // the quad of the edge, whose opposite goes round the vertex.
  Index inner(Index h) const { return 2 * corner_[h]; }
  Index outer(Index h) const { return 2 * corner_[h] + 1; }
  Index crossing(Index h) const
  {
    const Index e = Level_connectivity::edge(h);
    const Index rank = edge_rank_.empty() ? e : edge_rank_[e];
    return 2 * (static_cast<Index>(level_.size().corners) + 2 * rank + (h & 1u));
  }
  Index around_vertex(Index h) const { return opposite(crossing(h)); }
  Index first_outside(Index h) const { return is_interior(h) ? around_vertex(h) : outer(h); }

  bool is_interior(Index h) const { return !level_.is_border_edge(Level_connectivity::edge(h)); }
  bool is_interior_vertex(Index v) const
  {
    return !level_.is_isolated(v) && !level_.is_border_vertex(v);
  }

  Index quad(Index e) const
  {
    return level_.number_of_faces() + (edge_rank_.empty() ? e : edge_rank_[e]);
  }
  Index polygon(Index v) const
  {
    const auto interior_edges = static_cast<Index>(level_.size().corners - level_.size().edges);
    return level_.number_of_faces() + interior_edges + (vertex_rank_.empty() ? v : vertex_rank_[v]);
  }

  template <class Child>
  void connect_face(Index f, Child& child) const
  {
    const Index first = level_.halfedge_of_face(f);
    Index h = first;
    do {
      const Index n = level_.next(h);
      child.set_next(inner(h), inner(n));
      child.set_face(inner(h), f);
      child.set_target(inner(h), corner_[h]);
      // outside of the corner at the target of h: the border if it is there
      child.set_halfedge_of_vertex(corner_[h],
                                   is_interior(n) ? around_vertex(opposite(n)) : outer(n));
      if (!is_interior(h)) connect_border(h, child);
      h = n;
    } while (h != first);
    child.set_halfedge_of_face(f, inner(first));
  }

  template <class Child>
  void connect_border(Index h, Child& child) const
  {
    const Index before = preceding(h);
    child.set_next(outer(h), first_outside(before));
    child.set_border(outer(h));
    child.set_target(outer(h), corner_[before]);
  }

  template <class Child>
  void connect_edge(Index e, Child& child) const
  {
    if (level_.is_border_edge(e)) return;
    for (Index h : {2 * e, 2 * e + 1}) {
      const Index o = opposite(h);
      child.set_next(outer(h), crossing(o));
      child.set_next(crossing(o), outer(o));
      child.set_face(outer(h), quad(e));
      child.set_face(crossing(o), quad(e));
      child.set_target(outer(h), corner_[preceding(h)]);
      child.set_target(crossing(o), corner_[o]);
      connect_outside(h, child);
    }
    child.set_halfedge_of_face(quad(e), outer(2 * e));
  }

  template <class Child>
  void connect_outside(Index h, Child& child) const
  {
    const Index beyond = preceding(opposite(h));
    const Index v = level_.target(h);
    child.set_next(around_vertex(h), first_outside(beyond));
    child.set_target(around_vertex(h), corner_[beyond]);
    if (is_interior_vertex(v))
      child.set_face(around_vertex(h), polygon(v));
    else
      child.set_border(around_vertex(h));
  }

  template <class Child>
  void connect_vertex(Index v, Child& child) const
  {
    if (is_interior_vertex(v))
      child.set_halfedge_of_face(polygon(v), around_vertex(level_.halfedge_of_vertex(v)));
  }

  const Level_connectivity& level_;
  boost::container::vector<Index> corner_, halfedge_;
  boost::container::vector<Index> edge_rank_, vertex_rank_;
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_HOSTS_DQQ_HOST_H
