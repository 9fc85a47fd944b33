// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_SMOOTH_ROWS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_SMOOTH_ROWS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Slot_shares.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The rows of a mask, over slots, at the creases where smooth rules take part in a round. They are made
// from the whole level, before it is cut open.
template <class FT>
class Smooth_rows
{
public:
  using Index = Level_connectivity::Index;
  using Entry = typename Entry_row<FT>::Entry;
  using Range = std::pair<const Entry*, const Entry*>;

  // needs_row(star) says where
  template <class Mask, class Needs_row>
  Smooth_rows(const Level_connectivity& level, const Creases<FT>& creases,
              const Corner_slots<FT>& slots, const Mask& mask, const Needs_row& needs_row)
  {
    Slot_shares<FT, Mask> shares(level, slots, mask);
    for (const Crease_star& star : creases.stars) {
      if (needs_row(star)) shares.vertex(star.vertex, row_);
      close_row(star_end_);
    }
    for (const Crease_edge<FT>& e : creases.edges) {
      if (e.sharpness < 1) shares.edge(e.edge, row_);
      close_row(edge_end_);
    }
  }

  // of the star or crease edge at this position
  Range of_star(std::size_t i) const { return range(i == 0 ? 0 : star_end_[i - 1], star_end_[i]); }
  Range of_edge(std::size_t i) const
  {
    const std::size_t first = star_end_.empty() ? 0 : star_end_.back();
    return range(i == 0 ? first : edge_end_[i - 1], edge_end_[i]);
  }

private:
  void close_row(std::vector<std::size_t>& ends)
  {
    entries_.insert(entries_.end(), row_.begin(), row_.end());
    row_.clear();
    ends.push_back(entries_.size());
  }
  Range range(std::size_t begin, std::size_t end) const
  {
    return {entries_.data() + begin, entries_.data() + end};
  }

  Entry_row<FT> row_;
  std::vector<Entry> entries_;
  std::vector<std::size_t> star_end_, edge_end_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_SMOOTH_ROWS_H
