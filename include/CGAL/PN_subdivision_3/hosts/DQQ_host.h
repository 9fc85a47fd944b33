// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_HOSTS_DQQ_HOST_H
#define CGAL_PN_SUBDIVISION_3_HOSTS_DQQ_HOST_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstdint>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// Numbers some of the elements of a level, in their order: closed if these are all.
class Ranks
{
public:
  using Index = Level_connectivity::Index;

  // all elements
  Ranks() = default;
  // the numbers below `number` for which is_counted(i) is true
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

} // namespace internal

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
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// the refined faces have any degrees.
  static constexpr Index refined_degree = 0;
  /// no old vertex survives.
  static constexpr bool keeps_vertices = false;

  /// the numbers of elements after a round.
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

  /// prepares a round on a level, which has to live as long.
  DQQ_host(const Level_connectivity& level, unsigned /*round*/)
    : level_(level)
    , corner_(level.number_of_halfedges(), boost::container::default_init)
    , halfedge_(level.size().corners, boost::container::default_init)
    , corners_(static_cast<Index>(level.size().corners))
    , faces_(level.number_of_faces())
    , quads_(corners_ - level.number_of_edges())
  {
    number_corners();
    if (!level.has_border() && level.size().isolated_vertices == 0) return;
    interior_edges_ =
      Ranks(level.number_of_edges(), [&](Index e) { return !level.is_border_edge(e); });
    interior_vertices_ =
      Ranks(level.number_of_vertices(), [&](Index v) { return is_interior_vertex(v); });
  }
  DQQ_host(const DQQ_host&) = delete;
  DQQ_host& operator=(const DQQ_host&) = delete;

  /// the new vertex of a corner, that of the face of `h` at the target of `h`.
  Index vertex_of_corner(Index h) const { return corner_[h]; }

  /// \name Parents
  /// @{

  /// the corner that a new vertex comes from.
  Element_parent parent_of_vertex(Index new_vertex) const
  {
    return {Element_parent::Kind::corner, halfedge_[new_vertex]};
  }
  /// of an edge of a smaller face the face's corner, of an edge between a quad and a polygon the edge that it
  /// crosses.
  Element_parent parent_of_edge(Index new_edge) const
  {
    if (new_edge < corners_) return {Element_parent::Kind::corner, halfedge_[new_edge]};
    const Index i = new_edge - corners_;
    return {Element_parent::Kind::edge, interior_edges_.element(i / 2), i % 2};
  }
  /// the old face, edge or vertex that a new face comes from.
  Element_parent parent_of_face(Index child) const
  {
    if (child < faces_) return {Element_parent::Kind::face, child};
    const Index i = child - faces_;
    if (i < quads_) return {Element_parent::Kind::edge, interior_edges_.element(i)};
    return {Element_parent::Kind::vertex, interior_vertices_.element(i - quads_)};
  }
  /// @}

  /// calls the function of the mask that gives the row of a new vertex.
  template <class Mask, class Stencil>
  void stencil(const Mask& mask, Index new_vertex, Stencil& s) const
  {
    mask.corner(parent_of_vertex(new_vertex).index, s);
  }

  /// sets the connectivity of the refined level.
  template <class Child, class For_chunks>
  void connect(Child& child, const For_chunks& for_chunks) const
  {
    internal::for_each_index(for_chunks, level_.number_of_faces(),
                             [&](Index f) { connect_face(f, child); });
    internal::for_each_index(for_chunks, level_.number_of_edges(),
                             [&](Index e) { connect_edge(e, child); });
    internal::for_each_index(for_chunks, level_.number_of_vertices(), [&](Index v) {
      if (is_interior_vertex(v))
        child.set_halfedge_of_face(polygon(v), around_vertex(level_.halfedge_of_vertex(v)));
    });
  }

private:
  using Ranks = internal::Ranks;

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
      for (const Index h : internal::halfedges_around_face(level_, level_.halfedge_of_face(f))) {
        corner_[h] = corner;
        halfedge_[corner++] = h;
      }
    }
  }

  // New half-edges. An old half-edge h with a face has an inner one inside the smaller face, whose
  // opposite is the outer one; their edges come first, by corners. At its target, an interior one has a crossing to the
  // corner of h in the quad of the edge, whose opposite goes round the vertex.
  Index inner(Index h) const { return 2 * corner_[h]; }
  Index outer(Index h) const { return inner(h) + 1; }
  Index crossing(Index h) const
  {
    return 2 * (corners_ + 2 * interior_edges_.rank(Level_connectivity::edge(h)) + (h & 1u));
  }
  Index around_vertex(Index h) const { return opposite(crossing(h)); }
  Index first_outside(Index h) const { return is_interior(h) ? around_vertex(h) : outer(h); }

  bool is_interior(Index h) const { return !level_.is_border_edge(Level_connectivity::edge(h)); }
  bool is_interior_vertex(Index v) const
  {
    return !level_.is_isolated(v) && !level_.is_border_vertex(v);
  }

  // new faces: the smaller ones keep their numbers
  Index quad(Index e) const { return faces_ + interior_edges_.rank(e); }
  Index polygon(Index v) const { return faces_ + quads_ + interior_vertices_.rank(v); }

  template <class Child>
  void connect_face(Index f, Child& child) const
  {
    const Index first = level_.halfedge_of_face(f);
    for (const Index h : internal::halfedges_around_face(level_, first)) {
      const Index n = level_.next(h);
      child.set_next(inner(h), inner(n));
      child.set_face(inner(h), f);
      child.set_target(inner(h), corner_[h]);
      // outside of the corner at the target of h: the border if it is there
      child.set_halfedge_of_vertex(corner_[h],
                                   is_interior(n) ? around_vertex(opposite(n)) : outer(n));
      if (!is_interior(h)) connect_border(h, child);
    }
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

  const Level_connectivity& level_;
  boost::container::vector<Index> corner_, halfedge_;
  Ranks interior_edges_, interior_vertices_;
  Index corners_, faces_, quads_; // how many there are
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_HOSTS_DQQ_HOST_H
