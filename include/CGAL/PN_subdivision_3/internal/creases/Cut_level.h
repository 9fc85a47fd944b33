// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CUT_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CUT_LEVEL_H

#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// For smooth rules on a level that is not cut open: crease vertices and corners are not extraordinary, darts
// count but have no rules of their own.
template <class FT>
void count_valences(Level_connectivity& level, const Creases<FT>& creases)
{
  std::vector<Level_connectivity::Counted_valence> counted;
  for (const Crease_star& star : creases.stars) {
    const bool is_dart = !star.is_border && creases.rule(star) == Vertex_rule::dart;
    counted.push_back({star.vertex, is_dart ? level.valence(star.vertex) : 0});
  }
  level.set_counted_valences(std::move(counted));
}

// the size of a level cut open
template <class FT>
Level_size size_when_cut(Level_size size, const Creases<FT>& creases)
{
  size.vertices = creases.number_of_slots;
  for (const Crease_edge<FT>& e : creases.edges)
    if (!e.is_border()) ++size.edges;
  return size;
}
inline Level_size size_when_cut(const Level_size& size, No_creases)
{
  return size;
}

// Cuts a level open along its creases: its vertices are then the slots, so that a mask reads in every
// face the values of that face's wedges, and meets a border where a crease is.
//
// Vertices, edges and faces keep their numbers. An inner crease edge gets a second copy behind all
// edges, with the face that was at its half-edge of side 1. The cut takes the time of the tagged part
// of the level if this has room for it.
template <class FT>
class Cut_in_place
{
public:
  using Index = Level_connectivity::Index;

  Cut_in_place(Level_connectivity& level, const Creases<FT>& creases)
    : level_(level)
    , creases_(creases)
    , old_size_(level.size())
  {
    level_.resize(size_when_cut(level.size(), creases));
    split_edges();
    std::vector<Level_connectivity::Counted_valence> counted;
    for (const Crease_star& star : creases.stars) {
      const Index ends = star.number_of_ends;
      // darts and corners inside a smooth surface are not cut off: a dart counts by its valence, a corner not
      if (!star.is_border && ends <= 1) {
        const bool is_dart = creases.rule(star) == Vertex_rule::dart;
        counted.push_back({star.vertex, is_dart ? level.valence(star.vertex) : 0});
      }
      if (ends != 0 && (!star.is_border || star.number_of_wedges > 1)) cut(star);
    }
    level_.set_counted_valences(std::move(counted));
  }
  Cut_in_place(const Cut_in_place&) = delete;
  Cut_in_place& operator=(const Cut_in_place&) = delete;

  // makes the level whole again
  void close()
  {
    for (auto c = changes_.rbegin(); c != changes_.rend(); ++c) (level_.*c->set)(c->index, c->old);
    changes_.clear();
    level_.resize(old_size_);
    level_.set_counted_valences({});
  }

  // the second copies of the inner crease edges, which have the faces of the half-edges of side 1
  const std::vector<Index>& second_copies() const { return copy_; }

private:
  using Level = Level_connectivity;
  using Get = Index (Level::*)(Index) const;
  using Set = void (Level::*)(Index, Index);

  struct Change
  {
    Set set;
    Index index, old;
  };

  // what close() takes back: get(index) of the level, and its new value
  void change(Get get, Set set, Index index, Index value)
  {
    changes_.push_back({set, index, (level_.*get)(index)});
    (level_.*set)(index, value);
  }
  void set_target(Index h, Index v) { change(&Level::target, &Level::set_target, h, v); }
  void set_next(Index h, Index n) { change(&Level::next, &Level::set_next, h, n); }

  void split_edges()
  {
    auto copy = static_cast<Index>(old_size_.edges);
    for (const Crease_edge<FT>& e : creases_.edges) {
      copy_.push_back(copy);
      if (e.is_border()) continue;
      const Index old = e.halfedge(1), new_halfedge = 2 * copy + 1;
      const Index f = level_.face(old);
      level_.set_face(new_halfedge, f);
      level_.set_next(new_halfedge, level_.next(old));
      if (level_.halfedge_of_face(f) == old)
        change(&Level::halfedge_of_face, &Level::set_halfedge_of_face, f, new_halfedge);
      change(&Level::face, &Level::set_face, old, Level_connectivity::null);
      level_.set_border(2 * copy);
      ++copy;
    }
  }

  // the half-edge that has now the face of a half-edge of a crease edge; a border edge keeps its half-edges
  Index moved(Index crease, Index side) const
  {
    const Crease_edge<FT>& e = creases_.edges[crease];
    return side == 0 || e.is_border() ? e.halfedge(side) : 2 * copy_[crease] + 1;
  }

  // makes the half-edges of every wedge lead to its slot; the border passes from the wedge's last edge to its first
  void cut(const Crease_star& star)
  {
    const Index k = star.number_of_ends;
    const Index border =
      star.is_border ? level_.halfedge_of_vertex(star.vertex) : Level_connectivity::null;
    if (star.is_border && !creases_.edge(creases_.end(star, 0)).is_border())
      cut_wedge(star.slot(0), level_.next_around_target(border), creases_.end(star, 0));
    for (Index i = 0; i < k; ++i) {
      const Crease_halfedge& e = creases_.end(star, i);
      const Crease_edge<FT>& crease = creases_.edge(e);
      if (!crease.has_after(e.side)) continue;
      const Index first = moved(e.crease, e.side), slot = crease.after[e.side];
      if (i + 1 < k || !star.is_border)
        cut_wedge(slot, first, creases_.end(star, i + 1 < k ? i + 1 : 0));
      else
        cut_wedge(slot, first, Level_connectivity::opposite(border),
                  Level_connectivity::opposite(border));
    }
  }

  void cut_wedge(Index slot, Index first, const Crease_halfedge& last)
  {
    cut_wedge(slot, first, Level_connectivity::opposite(creases_.halfedge(last)),
              moved(last.crease, 1 - last.side));
  }

  // `first` leads to the vertex; `last`, now moved, from it along the other side of the wedge. What is
  // between them has not been changed yet.
  void cut_wedge(Index slot, Index first, Index last, Index moved_last)
  {
    Index h = first;
    for (;;) {
      set_target(h, slot);
      const Index n = level_.next(h);
      if (n == last) break;
      h = Level_connectivity::opposite(n);
    }
    set_next(h, moved_last);
    const Index border = Level_connectivity::opposite(moved_last);
    set_target(border, slot);
    set_next(border, Level_connectivity::opposite(first));
    change(&Level::halfedge_of_vertex, &Level::set_halfedge_of_vertex, slot, border);
  }

  Level_connectivity& level_;
  const Creases<FT>& creases_;
  const Level_size old_size_;
  std::vector<Index> copy_; // of the crease edges; meaningless for border edges
  std::vector<Change> changes_;
};

// A copy of a level, cut open.
template <class FT>
class Cut_copy
{
public:
  Cut_copy(const Level_connectivity& level, const Creases<FT>& creases)
    : cut_(level, size_when_cut(level.size(), creases))
  {
    cut_.set_size(level.size());
    second_copies_ = Cut_in_place<FT>(cut_, creases).second_copies();
  }

  const Level_connectivity& connectivity() const { return cut_; }
  // the second copy of an inner crease edge
  Level_connectivity::Index second_copy(Level_connectivity::Index crease) const
  {
    return second_copies_[crease];
  }

private:
  Level_connectivity cut_;
  std::vector<Level_connectivity::Index> second_copies_;
};

// Calls f(half-edge, slot) for every corner of the level: the corner of the half-edge's face at its target.
template <class Function>
void for_each_corner(const Level_connectivity& level, const Level_connectivity& cut,
                     const Function& f)
{
  using Index = Level_connectivity::Index;
  for (Index face = 0; face < level.number_of_faces(); ++face) {
    Index g = cut.halfedge_of_face(face); // g is at the corner of h
    for (const Index h : halfedges_around_face(level, level.halfedge_of_face(face))) {
      f(h, cut.target(g));
      g = cut.next(g);
    }
  }
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CUT_LEVEL_H
