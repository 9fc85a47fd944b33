// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CUT_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CUT_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A level cut open along its creases: its vertices are the slots, so that a mask reads in every face
// the values of that face's wedges, and meets a border where a crease is.
//
// Vertices, edges and faces keep their numbers. An inner crease edge gets a second copy behind all
// edges, with the face that was at its half-edge of side 1.
template <class FT>
class Cut_level
{
public:
  using Index = Level_connectivity::Index;

  Cut_level(const Level_connectivity& level, const Creases<FT>& creases)
    : level_(level)
    , creases_(creases)
    , cut_(level, size(level, creases))
  {
    split_edges();
    std::vector<Level_connectivity::Counted_valence> counted;
    for (const Crease_star& star : creases.stars) {
      const Index ends = star.number_of_ends;
      // these are not cut off: a dart counts by its valence, a corner inside a smooth surface not
      if (!star.is_border && ends <= 1) {
        const bool is_dart = creases.rule(star) == Vertex_rule::dart;
        counted.push_back({star.vertex, is_dart ? level.valence(star.vertex) : 0});
      }
      if (ends != 0 && (!star.is_border || star.number_of_wedges > 1)) cut(star);
    }
    cut_.set_counted_valences(std::move(counted));
  }

  const Level_connectivity& connectivity() const { return cut_; }
  // of an inner crease edge the second copy, with the face of the half-edge of side 1
  Index second_copy(Index crease) const { return copy_[crease]; }

private:
  static Level_size size(const Level_connectivity& level, const Creases<FT>& creases)
  {
    Level_size size = level.size();
    size.vertices = creases.number_of_slots;
    for (const Crease_edge<FT>& e : creases.edges)
      if (!e.is_border()) ++size.edges;
    return size;
  }

  void split_edges()
  {
    Index copy = level_.number_of_edges();
    for (const Crease_edge<FT>& e : creases_.edges) {
      copy_.push_back(copy);
      if (e.is_border()) continue;
      const Index old = e.halfedge(1), new_halfedge = 2 * copy + 1;
      const Index f = level_.face(old);
      cut_.set_face(new_halfedge, f);
      cut_.set_next(new_halfedge, level_.next(old));
      if (level_.halfedge_of_face(f) == old) cut_.set_halfedge_of_face(f, new_halfedge);
      cut_.set_border(old);
      cut_.set_border(2 * copy);
      ++copy;
    }
  }

  // what has become of the half-edge of a crease edge that has a face, or of a plain border edge
  Index moved(Index crease, Index side) const
  {
    const Crease_edge<FT>& e = creases_.edges[crease];
    return side == 0 || e.is_border() ? e.halfedge(side) : 2 * copy_[crease] + 1;
  }

  // the half-edges of every wedge lead to its slot; the border passes from its last edge to its first
  void cut(const Crease_star& star)
  {
    const Index k = star.number_of_ends;
    const Index border =
      star.is_border ? level_.halfedge_of_vertex(star.vertex) : Level_connectivity::null;
    if (star.is_border && !creases_.edge(creases_.end(star, 0)).is_border()) {
      const Index first = level_.next_around_target(border);
      cut_wedge(star.slot(0), first, first, creases_.end(star, 0));
    }
    for (Index i = 0; i < k; ++i) {
      const Crease_end& e = creases_.end(star, i);
      const Crease_edge<FT>& crease = creases_.edge(e);
      if (!crease.has_after(e.side)) continue;
      const Index first = moved(e.crease, e.side), slot = crease.after[e.side];
      if (i + 1 < k || !star.is_border)
        cut_wedge(slot, creases_.halfedge(e), first, creases_.end(star, i + 1 < k ? i + 1 : 0));
      else
        cut_wedge(slot, creases_.halfedge(e), first, Level_connectivity::opposite(border),
                  Level_connectivity::opposite(border));
    }
  }

  void cut_wedge(Index slot, Index first, Index moved_first, const Crease_end& last)
  {
    cut_wedge(slot, first, moved_first, Level_connectivity::opposite(creases_.halfedge(last)),
              moved(last.crease, 1 - last.side));
  }

  // `first` leads to the vertex, `last` from it along the other side of the wedge
  void cut_wedge(Index slot, Index first, Index moved_first, Index last, Index moved_last)
  {
    Index h = first, moved_h = moved_first;
    for (;;) {
      cut_.set_target(moved_h, slot);
      const Index n = level_.next(h);
      if (n == last) break;
      moved_h = h = Level_connectivity::opposite(n);
    }
    cut_.set_next(moved_h, moved_last);
    const Index border = Level_connectivity::opposite(moved_last);
    cut_.set_target(border, slot);
    cut_.set_next(border, Level_connectivity::opposite(moved_first));
    cut_.set_halfedge_of_vertex(slot, border);
  }

  const Level_connectivity& level_;
  const Creases<FT>& creases_;
  Level_connectivity cut_;
  std::vector<Index> copy_; // of the crease edges; meaningless for border edges
};

// Calls f(half-edge, slot) for every corner of the level: that of the half-edge's face at its target.
template <class Function>
void for_each_corner(const Level_connectivity& level, const Level_connectivity& cut,
                     const Function& f)
{
  using Index = Level_connectivity::Index;
  for (Index face = 0; face < level.number_of_faces(); ++face) {
    const Index first = level.halfedge_of_face(face);
    Index h = first, g = cut.halfedge_of_face(face); // the same one, and so on
    do {
      f(h, cut.target(g));
      h = level.next(h);
      g = cut.next(g);
    } while (h != first);
  }
}

// Calls f(half-edge, slot) for the corners of the level whose slot is not that of their vertex.
template <class FT, class Function>
void for_each_extra_corner(const Level_connectivity& level, const Creases<FT>& creases,
                           const Function& f)
{
  using Index = Level_connectivity::Index;
  for (const Crease_star& star : creases.stars) {
    if (star.number_of_wedges == 1) continue;
    for (Index i = 0; i < star.number_of_ends; ++i) {
      const Crease_end& e = creases.end(star, i);
      const Crease_edge<FT>& crease = creases.edge(e);
      if (!crease.has_after(e.side) || crease.after[e.side] == star.vertex) continue;
      // clockwise up to the next crease or the border
      const Index last =
        creases.halfedge(creases.end(star, i + 1 < star.number_of_ends ? i + 1 : 0));
      Index h = creases.halfedge(e);
      do {
        f(h, crease.after[e.side]);
        h = level.next_around_target(h);
      } while (h != last && !level.is_border(h));
    }
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CUT_LEVEL_H
