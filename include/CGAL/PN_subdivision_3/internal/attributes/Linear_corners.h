// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_LINEAR_CORNERS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_LINEAR_CORNERS_H

#include <CGAL/PN_subdivision_3/hosts/Element_parent.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Carried_values.h>
#include <CGAL/PN_subdivision_3/internal/creases/Entry_row.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A round of the values of corners linearly inside faces, in a host that splits edges: old corners keep theirs,
// new ones get the mean of an edge or a face. Values are those of half-edges.
template <class FT, class Host>
class Linear_corners
{
public:
  using Index = Level_connectivity::Index;

  Linear_corners(const Host& host, const Level_connectivity& level, const Level_connectivity& child,
                 Row_values<FT>& values)
    : host_(host)
    , level_(level)
    , child_(child)
    , split_(level)
    , values_(values)
  {}

  void operator()(const For_chunks& for_chunks) const
  {
    for_chunks(level_.number_of_faces(), [&](Index begin, Index end) {
      Entry_row<FT> row;
      for (Index f = begin; f < end; ++f) face(f, row);
    });
  }

private:
  static constexpr Index null = Level_connectivity::null;
  using Kind = Element_parent::Kind;

  void face(Index f, Entry_row<FT>& row) const
  {
    const Index first = level_.halfedge_of_face(f);
    Index in_middle = null; // a new half-edge that leads to the middle of the face
    Index h = first;
    do {
      const Index n = level_.next(h), begin = split_.second_half(h);
      row.clear();
      row.add(h, FT(1));
      set(begin, row);
      for (Index g = child_.next(begin); g != begin; g = child_.next(g)) {
        const Element_parent parent = host_.parent_of_vertex(child_.target(g));
        if (parent.kind == Kind::face) {
          set_middle(g, h, in_middle, row);
          continue;
        }
        const bool is_behind = parent.index == Level_connectivity::edge(n);
        if (is_behind) // the other edge is behind the corner before
          set_behind(g, h, n, row);
      }
      h = n;
    } while (h != first);
  }

  void set(Index value, const Entry_row<FT>& row) const
  {
    values_.evaluate(value, row.begin(), row.end());
  }

  // g leads to the new vertex of the edge of n = next(h); so do other new half-edges inside the face
  void set_behind(Index g, Index h, Index n, Entry_row<FT>& row) const
  {
    const bool is_first =
      (n & 1u) == 0; // in one order on both sides of the edge, for the same bits
    row.clear();
    row.add(is_first ? h : n, FT(1) / FT(2));
    row.add(is_first ? n : h, FT(1) / FT(2));
    set(g, row);
    // round the new vertex, to the other half of the edge
    for (Index x = child_.next_around_target(g);
         x != g && child_.face(x) != null && is_inside(x, g); x = child_.next_around_target(x))
      values_.copy(g, x);
  }
  bool is_inside(Index x, Index g) const
  {
    return host_.parent_of_face(child_.face(x)).index == host_.parent_of_face(child_.face(g)).index;
  }

  void set_middle(Index g, Index h, Index& in_middle, Entry_row<FT>& row) const
  {
    if (in_middle != null) return values_.copy(in_middle, g);
    in_middle = g;
    const FT weight = FT(1) / FT(int(level_.degree(h)));
    row.clear();
    Index x = h;
    do {
      row.add(x, weight);
      x = level_.next(x);
    } while (x != h);
    set(g, row);
  }

  const Host& host_;
  const Level_connectivity& level_;
  const Level_connectivity& child_;
  const internal::Edge_split split_;
  Row_values<FT>& values_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_LINEAR_CORNERS_H
