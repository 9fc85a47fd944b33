// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SUB_LEVEL_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SUB_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_part.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// How many rings of faces a vertex needs around it for a round to come out right, again and again, in the rings that
// the round after it needs: c rings of new faces lie in c/2 of old ones, and these need the ghost rings around them, so
// c is twice as many; rings of sqrt(3) grow by the root of 3 only. A scheme that does not tell has as many as Kobbelt's.
template <class Scheme>
unsigned cut_rings(const Scheme& scheme)
{
  constexpr unsigned least = 4, times = std::is_same_v<typename Scheme::Host, Sqrt3_host> ? 4 : 2;
  const unsigned ghosts = facts_of(scheme).ghost_rings;
  return ghosts == 0 ? 8 : (std::max)(least, times * ghosts);
}

// Crease vertices read more of what is around them.
template <class Scheme, class Level_creases>
unsigned cut_rings(const Scheme& scheme, const Level_creases& creases)
{
  return cut_rings(scheme) + (creases.empty() ? 0 : is_pn_v<Scheme> ? 2 : 1);
}

// Whether the target of h has n edges. Cost: n
inline bool has_valence(const Level_connectivity& level, Level_connectivity::Index h,
                        Level_connectivity::Index n)
{
  const Level_connectivity::Index first = h;
  for (Level_connectivity::Index i = 0; i < n; ++i, h = level.next_around_target(h))
    if (i != 0 && h == first) return false;
  return h == first;
}

// Tells whether the neighborhood of a vertex of a level is settled, or will be once the rules are those
// of all later rounds, too.
template <class Scheme>
class Has_final_rules
{
public:
  using Index = Level_connectivity::Index;
  using Host = typename Scheme::Host;

  static constexpr Index degree = Host::refined_degree;
  static constexpr Index regular_valence = degree == 4 ? 4 : 6;

  // rules_are_final: whether the next round has the rules that all later ones have
  Has_final_rules(const Scheme& scheme, const Level_connectivity& level, bool rules_are_final)
    : level_(level)
    , neighborhood_(facts_of(scheme).limit_neighborhood)
    , has_next_ring_(may_have_next_ring && neighborhood_.regular_rings <= 1 &&
                     neighborhood_.takes_border && !facts_of(scheme).transfers_curvature)
    , rules_are_final_(rules_are_final)
  {}

  // \pre v has edges
  bool operator()(Index v) const
  {
    const bool at_border = level_.is_border_vertex(v);
    const Index first = level_.halfedge_of_vertex(v);
    if (!rules_are_final_ && !at_border && !has_valence(level_, first, regular_valence))
      return false;
    for (const Index h : halfedges_around_target(level_, first))
      if (!level_.is_border(h) && !has_final_face(h, at_border)) return false;
    return neighborhood_.regular_rings < 2 || are_regular_beyond(first, at_border);
  }

  // Whether the vertices that a vertex gets around it in the next round may decide on it, they alone, and
  // are found from the elements of this level. What transfers do to them is not.
  static constexpr bool may_have_next_ring =
    std::is_same_v<Host, PQQ_host> || std::is_same_v<Host, PTQ_host>;

  // Whether the neighborhood of v will be settled after one round because the new vertices of edges and
  // faces around it are all regular, if the rules are final then.
  // \pre v has edges
  bool in_next_ring(Index v) const
  {
    if (!has_next_ring_) return false;
    for (const Index h : halfedges_around_target(level_, level_.halfedge_of_vertex(v)))
      if (!level_.is_border(h) && !level_.has_degree(h, degree)) return false;
    return true;
  }

private:
  // h leads to the vertex
  bool has_final_face(Index h, bool at_border) const
  {
    if (!level_.has_degree(h, degree)) return false;
    if constexpr (std::is_same_v<Host, Sqrt3_host>)
      // the border of the vertex itself goes by rules of its own
      if (!at_border && level_.is_border(Level_connectivity::opposite(level_.next(level_.next(h)))))
        return false;
    if (neighborhood_.regular_rings > 0)
      for (Index g = level_.next(h); g != h; g = level_.next(g))
        if (!is_regular(level_.target(g), at_border)) return false;
    return true;
  }

  // the vertices of the faces around the neighbors and diagonal vertices
  bool are_regular_beyond(Index first, bool at_border) const
  {
    const Index v = level_.target(first);
    for (const Index h : halfedges_around_target(level_, first)) {
      if (level_.is_border(h)) continue;
      for (Index g = level_.next(h); g != h; g = level_.next(g))
        for (const Index k : halfedges_around_target(level_, g)) {
          if (level_.is_border(k)) continue;
          if (!level_.has_degree(k, degree)) return false;
          for (Index c = level_.next(k); c != k; c = level_.next(c))
            if (level_.target(c) != v && !is_regular(level_.target(c), at_border)) return false;
        }
    }
    return true;
  }

  bool is_regular(Index v, bool at_border) const
  {
    // a dart is cut open, but counts by its valence
    if (const auto* counted = counted_valence(level_, v); counted != nullptr)
      return neighborhood_.takes_border &&
             (counted->valence == 0 || counted->valence == regular_valence);
    if (level_.is_border_vertex(v))
      return neighborhood_.takes_border ||
             (at_border && level_.valence(v) == (degree == 4 ? 3 : 4));
    return has_valence(level_, level_.halfedge_of_vertex(v), regular_valence);
  }

  const Level_connectivity& level_;
  const Limit_neighborhood neighborhood_;
  const bool has_next_ring_, rules_are_final_;
};

// Numbers that some elements of a level get: in a table of all if they may be many, and otherwise at the first free place
// from that of a hash on. With std::unordered_map cutting a few faces out takes two to three times as long.
class Element_numbers
{
public:
  using Index = Level_connectivity::Index;

  Element_numbers(std::size_t all, bool are_many)
    : is_table_(are_many)
    , entries_(are_many ? all : few)
  {}

  // whether the element had no number
  bool insert(Index element, Index number)
  {
    if (!is_table_ && 2 * size_ >= entries_.size()) grow();
    Entry& entry = entries_[place(element)];
    if (entry.number != null) return false;
    entry = {element, number};
    ++size_;
    return true;
  }
  // null: it has none
  Index find(Index element) const { return entries_[place(element)].number; }

private:
  static constexpr Index null = Level_connectivity::null;
  static constexpr std::size_t few = 256;

  struct Entry
  {
    Index element = null, number = null;
  };

  std::size_t place(Index element) const
  {
    if (is_table_) return element;
    const std::size_t last = entries_.size() - 1;
    std::size_t i = (element ^ (element >> 6)) & last;
    while (entries_[i].number != null && entries_[i].element != element) i = (i + 1) & last;
    return i;
  }
  void grow()
  {
    std::vector<Entry> old(2 * entries_.size());
    old.swap(entries_);
    for (const Entry& entry : old)
      if (entry.number != null) entries_[place(entry.element)] = entry;
  }

  const bool is_table_;
  std::vector<Entry> entries_;
  std::size_t size_ = 0;
};

// The elements of the faces within some rings about the center vertices of a level, in the order in which they are found.
class Ring_candidates
{
public:
  using Index = Level_connectivity::Index;

  // What is kept of the whole level: edges their orientation and faces their first half-edge, or, with walks, inner
  // vertices their half-edge, too, from which rows and stars go on; or nothing, so that about a single center all goes by
  // its half-edge.
  enum class Keeps { order, walks, nothing };

  Ring_candidates(const Level_connectivity& whole, const std::vector<Index>& centers,
                  unsigned rings, Keeps keeps)
    : whole_(whole)
    , keeps_(keeps)
    , are_many_(16 * centers.size() >= whole.number_of_vertices())
    , is_taken_(whole.number_of_faces(), are_many_)
    , place_of_edge_(whole.number_of_edges(), are_many_)
  {
    list_faces(centers, rings);
    list_edges();
    list_vertices();
  }

  // the elements of the faces that are marked, in increasing order
  Ring_candidates(const Level_connectivity& whole, const Face_marks& marks)
    : whole_(whole)
    , keeps_(Keeps::walks)
    , are_many_(true)
    , is_taken_(whole.number_of_faces(), true)
    , place_of_edge_(whole.number_of_edges(), true)
  {
    for (Index f = 0; f < marks.size(); ++f)
      if (marks[f] != 0) {
        is_taken_.insert(f, 0);
        faces_.push_back(whole.halfedge_of_face(f));
      }
    const auto is_inside = [&](Index h) {
      return !whole.is_border(h) && marks[whole.face(h)] != 0;
    };
    for (Index e = 0; e < whole.number_of_edges(); ++e)
      if (is_inside(2 * e) || is_inside(2 * e + 1)) {
        place_of_edge_.insert(e, static_cast<Index>(edges_.size()));
        edges_.push_back(2 * e);
      }
    list_vertices();
    std::sort(vertices_.begin(), vertices_.end(),
              [&](Index h, Index g) { return whole.target(h) < whole.target(g); });
  }

  bool is_taken(Index f) const { return is_taken_.find(f) != Level_connectivity::null; }

  Index number_of_vertices() const { return static_cast<Index>(vertices_.size()); }
  Index number_of_edges() const { return static_cast<Index>(edges_.size()); }
  Index number_of_faces() const { return static_cast<Index>(faces_.size()); }
  Index vertex(Index i) const { return whole_.target(vertices_[i]); }
  Index edge(Index i) const { return Level_connectivity::edge(edges_[i]); }
  Index face(Index i) const { return whole_.face(faces_[i]); }
  Index place_of_edge(Index e) const { return place_of_edge_.find(e); }
  Index halfedge_of_vertex(Index i) const
  {
    return keeps_ == Keeps::walks ? whole_.halfedge_of_vertex(vertex(i)) : vertices_[i];
  }
  Index halfedge_of_face(Index i) const { return faces_[i]; }
  Index side(Index place, Index h) const { return (h ^ edges_[place]) & 1u; }

private:
  void list_faces(const std::vector<Index>& centers, unsigned rings)
  {
    std::vector<Index> ring = centers, next_ring;
    Element_numbers known(whole_.number_of_vertices(), are_many_);
    for (const Index v : centers) known.insert(v, 0);
    for (unsigned r = 0; r < rings; ++r) {
      next_ring.clear();
      for (const Index v : ring)
        for_each_halfedge_to(whole_, v, [&](Index h) {
          if (whole_.is_border(h) || !is_taken_.insert(whole_.face(h), 0)) return;
          faces_.push_back(keeps_ == Keeps::nothing ? h : whole_.halfedge_of_face(whole_.face(h)));
          for (Index g = whole_.next(h); g != h; g = whole_.next(g))
            if (known.insert(whole_.target(g), 0)) next_ring.push_back(whole_.target(g));
        });
      ring.swap(next_ring);
    }
  }

  void list_edges()
  {
    for (const Index first : faces_)
      for (const Index h : halfedges_around_face(whole_, first)) {
        const Index e = Level_connectivity::edge(h);
        if (place_of_edge_.insert(e, static_cast<Index>(edges_.size())))
          edges_.push_back(keeps_ == Keeps::nothing ? h : 2 * e);
      }
  }

  void list_vertices()
  {
    Element_numbers known(whole_.number_of_vertices(), are_many_);
    for (const Index e : edges_)
      for (const Index h : {e, Level_connectivity::opposite(e)})
        if (known.insert(whole_.target(h), 0)) vertices_.push_back(h);
  }

  const Level_connectivity& whole_;
  const Keeps keeps_;
  const bool are_many_;
  Element_numbers is_taken_, place_of_edge_;
  // half-edges: the first one of each face, the one of each edge that gets an even number, the first one to each vertex
  std::vector<Index> faces_, edges_, vertices_;
};

// The faces within some rings about the center vertices of a level, as a level of its own. Rounds of
// a scheme on it are those of the whole level but near the border that cutting it out has made.
class Sub_level : public Level_part
{
public:
  using Keeps = Ring_candidates::Keeps;

  // `whole_centers` has no vertex twice, and none without edges
  Sub_level(const Level_connectivity& whole, const std::vector<Index>& whole_centers,
            unsigned rings, Keeps keeps = Keeps::order)
    : Sub_level(whole, whole_centers,
                Extraction(whole, Ring_candidates(whole, whole_centers, rings, keeps), false))
  {}

  // the centers' numbers in this level, in their order
  std::vector<Index> centers;

private:
  using Extraction = Piece_extraction<Ring_candidates>;

  Sub_level(const Level_connectivity& whole, const std::vector<Index>& whole_centers,
            Extraction&& extraction)
    : Level_part(extraction, true)
  {
    for (const Index v : whole_centers)
      centers.push_back(level.target(extraction.new_halfedge(whole.halfedge_of_vertex(v))));
  }
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SUB_LEVEL_H
