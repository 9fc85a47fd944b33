// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CORNER_SLOTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CORNER_SLOTS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The slots of the corners of a whole level. Those of further wedges are stored, star by star.
template <class FT>
class Corner_slots
{
public:
  using Index = Level_connectivity::Index;

  Corner_slots(const Level_connectivity& level, const Creases<FT>& creases)
    : level_(level)
    , creases_(creases)
  {
    for (const Crease_star& star : creases.stars) {
      const std::size_t first = corners_.size();
      begin_.push_back(first);
      for (Index i = 0; i < star.number_of_ends; ++i) add_wedge(star, i);
      std::sort(corners_.begin() + std::ptrdiff_t(first), corners_.end());
    }
    begin_.push_back(corners_.size());
  }

  // of the corner at the target of h in the face of h
  Index operator()(Index h) const
  {
    const Index v = level_.target(h);
    const auto star =
      std::lower_bound(creases_.stars.begin(), creases_.stars.end(), v,
                       [](const Crease_star& s, Index vertex) { return s.vertex < vertex; });
    if (star == creases_.stars.end() || star->vertex != v) return v;
    const auto i = std::size_t(star - creases_.stars.begin());
    const auto end = corners_.begin() + std::ptrdiff_t(begin_[i + 1]);
    const auto corner =
      std::lower_bound(corners_.begin() + std::ptrdiff_t(begin_[i]), end, Corner(h, 0));
    return corner != end && corner->first == h ? corner->second : v;
  }

private:
  using Corner = std::pair<Index, Index>; // half-edge and slot

  // the wedge behind the end, up to the next end or the border
  void add_wedge(const Crease_star& star, Index i)
  {
    const Crease_end& end = creases_.end(star, i);
    const Crease_edge<FT>& crease = creases_.edge(end);
    if (!crease.has_after(end.side) || crease.after[end.side] == star.vertex) return;
    const Index next =
      creases_.halfedge(creases_.end(star, i + 1 < star.number_of_ends ? i + 1 : 0));
    Index h = creases_.halfedge(end);
    do {
      corners_.emplace_back(h, crease.after[end.side]);
      h = level_.next_around_target(h);
    } while (h != next && !level_.is_border(h));
  }

  const Level_connectivity& level_;
  const Creases<FT>& creases_;
  std::vector<Corner> corners_;
  std::vector<std::size_t> begin_; // of the stars
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CORNER_SLOTS_H
