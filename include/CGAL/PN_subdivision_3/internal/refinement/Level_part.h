// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_PART_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_PART_H

#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Some faces of a level as a level of their own. Elements have the order of the candidates, which also tell the orientation
// of edges, the first half-edge of faces, and, where all faces of a vertex are taken, its half-edge: a piece has these as the whole.
// Where faces are missing there is a border, the rim; a vertex between whose faces some are missing is there several times.
template <class Candidates>
class Piece_extraction
{
public:
  using Index = Level_connectivity::Index;
  // the vertex of the whole level for each vertex of the piece
  using Old_vertices = std::vector<Index>;

  // The whole level and the candidates must stay.
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
  // the edges and faces of the whole level for those of the piece
  std::vector<Index> old_edges() const
  {
    return old_elements(size_.edges, new_edge_, [this](Index i) { return candidates_.edge(i); });
  }
  std::vector<Index> old_faces() const
  {
    return old_elements(size_.faces, new_face_, [this](Index i) { return candidates_.face(i); });
  }

  // whether the face of a half-edge of the whole level is taken
  bool is_inside(Index h) const
  {
    return !whole_.is_border(h) && candidates_.is_taken(whole_.face(h));
  }
  Index new_halfedge(Index h) const
  {
    const Index place = candidates_.place_of_edge(Level_connectivity::edge(h));
    return 2 * new_edge_[place] + candidates_.side(place, h);
  }

private:
  using Numbers = boost::container::vector<Index>; // null: not taken

  static constexpr Index null = Level_connectivity::null;

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

  // a copy of v for each run of faces between two missing faces
  void add_sectors(Index v, Index outside)
  {
    Index h = outside;
    do {
      h = whole_.next_around_target(h);
      if (!is_inside(h)) continue;
      const Index copy = add_copy(v, null);
      const Index leaving = new_halfedge(Level_connectivity::opposite(h));
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

  template <class Element>
  static std::vector<Index> old_elements(std::size_t size, const Numbers& places,
                                         const Element& element)
  {
    std::vector<Index> old(size);
    for (Index i = 0; i < places.size(); ++i)
      if (places[i] != null) old[places[i]] = element(i);
    return old;
  }

  const Level_connectivity& whole_;
  const Candidates& candidates_;
  Level_size size_;
  Level_connectivity piece_;
  Numbers new_face_, new_edge_, halfedge_;
  Old_vertices old_vertex_;
};

// Some faces of a level as a level of their own, and the numbers of its elements in the whole level, by which values of
// elements are cut out of the whole.
struct Level_part
{
  using Index = Level_connectivity::Index;
  using Origins = std::vector<Index>;
  static constexpr Index null = Level_connectivity::null;

  Level_connectivity level;
  Origins vertices, edges, faces;

  // takes the level out of the extraction; lists_all: edges and faces, too, are listed
  template <class Candidates>
  Level_part(Piece_extraction<Candidates>& extraction, bool lists_all)
    : level(std::move(extraction.piece()))
    , vertices(extraction.take_old_vertices())
  {
    if (!lists_all) return;
    edges = extraction.old_edges();
    faces = extraction.old_faces();
  }

  Index halfedge(Index h) const { return 2 * edges[h / 2] + (h & 1u); }
  // the half-edge of the whole for each half-edge that has a face; null for border half-edges
  Origins corners() const
  {
    Origins result(level.number_of_halfedges(), null);
    for (Index h = 0; h < result.size(); ++h)
      if (!level.is_border(h)) result[h] = halfedge(h);
    return result;
  }

  // what is sharp there, with its tangents; edges keep their orientation
  template <class FT>
  Creases<FT> creases(const Creases<FT>& whole) const
  {
    return creases_among<FT>(
      whole, level, [&](Index e) { return whole.edge_at(edges[e]); },
      [&](Index v) { return whole.star_at(vertices[v]); });
  }
  // For each slot of the part its slot in the whole. Of wedges one corner tells it: that at the crease where they begin, or
  // any one where they do not begin at a crease.
  template <class FT>
  Origins slot_origins(const Creases<FT>& creases, const Corner_slots<FT>& whole) const
  {
    Origins result = vertices;
    result.resize(creases.number_of_slots);
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      if (level.is_isolated(v)) continue;
      const Index own = level.halfedge_of_vertex(v);
      result[v] = whole(halfedge(level.is_border(own) ? level.next_around_target(own) : own));
    }
    for (const Crease_star& star : creases.stars)
      for (const Crease_halfedge& e : creases.ends_of(star))
        if (creases.edge(e).has_after(e.side))
          result[creases.edge(e).after[e.side]] = whole(halfedge(creases.halfedge(e)));
    return result;
  }

  // The creases and slot origins of the part: if nothing is sharp, no creases and the vertices.
  template <class Level_creases>
  std::pair<Level_creases, Origins> creases_and_slots(const Level_connectivity& whole,
                                                      const Level_creases& of_whole) const
  {
    if constexpr (are_creases_v<Level_creases>)
      if (!of_whole.empty()) {
        Level_creases cut = creases(of_whole);
        Origins origins = slot_origins(cut, Corner_slots(whole, of_whole));
        return {std::move(cut), std::move(origins)};
      }
    return {Level_creases(static_cast<Index>(vertices.size())), vertices};
  }
};

// the values of a part
template <class Values>
Values values_of_part(const Values& whole, const Level_part::Origins& origins)
{
  Values part;
  part.reserve(origins.size());
  for (const Level_part::Index i : origins) part.push_back(whole[i]);
  return part;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_PART_H
