// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SUB_LEVEL_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SUB_LEVEL_H

#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_part.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

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
    for (const Index first : faces_) {
      Index h = first;
      do {
        const Index e = Level_connectivity::edge(h);
        if (place_of_edge_.insert(e, static_cast<Index>(edges_.size())))
          edges_.push_back(keeps_ == Keeps::nothing ? h : 2 * e);
        h = whole_.next(h);
      } while (h != first);
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
    : Sub_level(whole, whole_centers, Ring_candidates(whole, whole_centers, rings, keeps))
  {}

  // the centers' numbers in this level, in their order
  std::vector<Index> centers;

private:
  using Extraction = Piece_extraction<Ring_candidates>;

  Sub_level(const Level_connectivity& whole, const std::vector<Index>& whole_centers,
            const Ring_candidates& candidates)
    : Sub_level(whole, whole_centers, Extraction(whole, candidates, false))
  {}
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
