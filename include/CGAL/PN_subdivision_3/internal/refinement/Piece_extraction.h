// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_PIECE_EXTRACTION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_PIECE_EXTRACTION_H

#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Elements of one kind in a piece: their numbers in the whole level, and whether the piece owns them. Every
// element of the whole level has one owner.
class Numbered_elements
{
public:
  using Number = std::uint64_t;

  Numbered_elements() = default;
  explicit Numbered_elements(std::size_t size)
    : number_(size, boost::container::default_init)
    , is_owned_(size, boost::container::default_init)
  {}

  std::size_t size() const { return number_.size(); }
  Number number(std::size_t i) const { return number_[i]; }
  bool is_owned(std::size_t i) const { return is_owned_[i] != 0; }

  // different elements by different threads
  void set(std::size_t i, Number number, bool is_owned)
  {
    number_[i] = number;
    is_owned_[i] = is_owned ? 1 : 0;
  }

private:
  boost::container::vector<Number> number_;
  boost::container::vector<char> is_owned_;
};

// Those of a level of a piece, beside its connectivity. In all three kinds the numbers increase.
struct Piece_elements
{
  Numbered_elements vertices, edges, faces;
};

// Some faces of a level as a level of their own. Elements have the order of the candidates, which also tell the orientation
// of edges, the first half-edge of faces, and that of vertices if all their faces are taken: those of the whole in a piece.
// Where faces are missing there is a border, the rim; a vertex between whose faces some are missing is there several times.
template <class Candidates>
class Piece_extraction
{
public:
  using Index = Level_connectivity::Index;
  // tells the vertex of the whole level for each vertex
  using Old_vertices = std::vector<Index>;

  // Both must stay.
  Piece_extraction(const Level_connectivity& whole, const Candidates& candidates,
                   bool takes_isolated_vertices)
    : whole_(whole)
    , candidates_(candidates)
  {
    number_faces();
    number_edges();
    for (Index i = 0; i < candidates.number_of_vertices(); ++i) {
      const Index v = candidates.vertex(i);
      if (!whole.is_isolated(v))
        add_vertex(v, candidates.halfedge_of_vertex(i));
      else if (takes_isolated_vertices) {
        add_copy(v, Level_connectivity::null);
        ++size_.isolated_vertices;
      }
    }
    connect_faces();
    finish_vertices();
  }

  Level_connectivity& piece() { return piece_; }
  const Old_vertices& old_vertices() const { return old_vertex_; }
  Old_vertices take_old_vertices() { return std::move(old_vertex_); }
  // the same of edges and faces
  std::vector<Index> old_edges() const
  {
    std::vector<Index> old(size_.edges);
    for (Index i = 0; i < new_edge_.size(); ++i)
      if (new_edge_[i] != null) old[new_edge_[i]] = candidates_.edge(i);
    return old;
  }
  std::vector<Index> old_faces() const
  {
    std::vector<Index> old(size_.faces);
    for (Index i = 0; i < new_face_.size(); ++i)
      if (new_face_[i] != null) old[new_face_[i]] = candidates_.face(i);
    return old;
  }

  // of a half-edge of the whole level, whether its face is taken
  bool is_inside(Index h) const
  {
    return !whole_.is_border(h) && candidates_.is_taken(whole_.face(h));
  }
  Index new_halfedge(Index h) const
  {
    const Index place = candidates_.place_of_edge(Level_connectivity::edge(h));
    return 2 * new_edge_[place] + candidates_.side(place, h);
  }

  // of a vertex that is there several times the first one may be owned
  template <class Elements>
  Numbered_elements vertices(const Elements& whole) const
  {
    Numbered_elements part(old_vertex_.size());
    for (Index v = 0; v < part.size(); ++v) {
      const Index old = old_vertex_[v];
      const bool is_first = v == 0 || old_vertex_[v - 1] != old;
      part.set(v, whole.number(old), is_first && whole.is_owned(old));
    }
    return part;
  }
  template <class Elements>
  Numbered_elements edges(const Elements& whole) const
  {
    Numbered_elements part(size_.edges);
    for (Index i = 0; i < new_edge_.size(); ++i)
      set(part, new_edge_[i], whole, candidates_.edge(i));
    return part;
  }
  template <class Elements>
  Numbered_elements faces(const Elements& whole) const
  {
    Numbered_elements part(size_.faces);
    for (Index i = 0; i < new_face_.size(); ++i)
      set(part, new_face_[i], whole, candidates_.face(i));
    return part;
  }
  template <class Elements>
  Piece_elements elements(const Elements& whole) const
  {
    return {vertices(whole.vertices), edges(whole.edges), faces(whole.faces)};
  }

private:
  using Numbers = boost::container::vector<Index>; // null: not taken

  static constexpr Index null = Level_connectivity::null;
  static Index opposite(Index h) { return Level_connectivity::opposite(h); }

  void number_faces()
  {
    new_face_.resize(candidates_.number_of_faces(), boost::container::default_init);
    Index faces = 0;
    for (Index i = 0; i < new_face_.size(); ++i)
      new_face_[i] = candidates_.is_taken(candidates_.face(i)) ? faces++ : null;
    size_.faces = faces;
  }

  void number_edges()
  {
    new_edge_.resize(candidates_.number_of_edges(), boost::container::default_init);
    Index edges = 0;
    for (Index i = 0; i < new_edge_.size(); ++i) {
      const Index e = candidates_.edge(i);
      const int sides = int(is_inside(2 * e)) + int(is_inside(2 * e + 1));
      new_edge_[i] = sides != 0 ? edges++ : null;
      size_.corners += sides;
    }
    size_.edges = edges;
    piece_ = Level_connectivity(size_); // vertices come last
  }

  Index add_copy(Index v, Index halfedge)
  {
    old_vertex_.push_back(v);
    halfedge_.push_back(halfedge);
    return static_cast<Index>(old_vertex_.size() - 1);
  }

  void add_vertex(Index v, Index first)
  {
    bool any_inside = false;
    Index outside = null;
    const auto ring = halfedges_around_target(whole_, first);
    for (const Index h : ring)
      if (is_inside(h))
        any_inside = true;
      else
        outside = h;
    if (!any_inside) return;
    if (outside != null) return add_sectors(v, outside);
    const Index copy = add_copy(v, new_halfedge(first));
    for (const Index h : ring) piece_.set_target(new_halfedge(h), copy);
  }

  // a copy of v for each run of faces between two that are missing
  void add_sectors(Index v, Index outside)
  {
    Index h = outside;
    do {
      h = whole_.next_around_target(h);
      if (!is_inside(h)) continue;
      const Index copy = add_copy(v, null);
      const Index leaving = new_halfedge(opposite(h));
      Index valence = 1;
      for (; is_inside(h); h = whole_.next_around_target(h), ++valence)
        piece_.set_target(new_halfedge(h), copy);
      const Index arriving = new_halfedge(h);
      piece_.set_target(arriving, copy);
      piece_.set_next(arriving, leaving);
      piece_.set_border(arriving);
      halfedge_.back() = arriving;
      size_.border_valences += valence;
    } while (h != outside);
  }

  void connect_faces()
  {
    for (Index i = 0; i < new_face_.size(); ++i) {
      if (new_face_[i] == null) continue;
      const Index first = candidates_.halfedge_of_face(i);
      Index h = first, n = new_halfedge(h);
      piece_.set_halfedge_of_face(new_face_[i], n);
      do {
        h = whole_.next(h);
        const Index next = new_halfedge(h);
        piece_.set_next(n, next);
        piece_.set_face(n, new_face_[i]);
        n = next;
      } while (h != first);
    }
  }

  void finish_vertices()
  {
    size_.vertices = old_vertex_.size();
    piece_.resize(size_);
    piece_.set_uniform_degree(whole_.uniform_degree());
    for (Index v = 0; v < halfedge_.size(); ++v) piece_.set_halfedge_of_vertex(v, halfedge_[v]);
    Numbers().swap(halfedge_);
  }

  template <class Elements>
  static void set(Numbered_elements& part, Index i, const Elements& whole, Index old)
  {
    if (i != null) part.set(i, whole.number(old), whole.is_owned(old));
  }

  const Level_connectivity& whole_;
  const Candidates& candidates_;
  Level_size size_;
  Level_connectivity piece_;
  Numbers new_face_, new_edge_, halfedge_;
  Old_vertices old_vertex_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_PIECE_EXTRACTION_H
