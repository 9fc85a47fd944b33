// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_SMOOTH_ROWS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_SMOOTH_ROWS_H

#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The slots of the corners of a whole level. Slots of further wedges are stored, star by star.
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
      for_each_extra_corner(level, creases, star,
                            [&](Index h, Index slot) { corners_.emplace_back(h, slot); });
      std::sort(corners_.begin() + std::ptrdiff_t(first), corners_.end());
    }
    begin_.push_back(corners_.size());
  }

  // the slot of the corner at the target of h in the face of h
  Index operator()(Index h) const
  {
    const Index v = level_.target(h);
    const Crease_star* const star = creases_.star_at(v);
    if (star == nullptr) return v;
    const auto i = std::size_t(star - creases_.stars.data());
    const auto end = corners_.begin() + std::ptrdiff_t(begin_[i + 1]);
    const auto corner =
      std::lower_bound(corners_.begin() + std::ptrdiff_t(begin_[i]), end, Corner(h, 0));
    return corner != end && corner->first == h ? corner->second : v;
  }

private:
  using Corner = std::pair<Index, Index>; // half-edge and slot

  const Level_connectivity& level_;
  const Creases<FT>& creases_;
  std::vector<Corner> corners_;
  std::vector<std::size_t> begin_; // of the stars
};

// The smooth rows of a mask, over slots. A row is a sum over the faces round the new vertex, and
// every face hands its share to the slots of its own corners: to the vertex itself and to the ends of
// an edge equal shares of every face, to a neighbor half of either face beside the edge to it, and to
// every corner what it has as such.
template <class FT, class Mask>
class Slot_shares
{
public:
  using Index = Level_connectivity::Index;
  using Row = Entry_row<FT>;

  // `level` is the level of the mask, `slot_of` tells the slots of its corners
  Slot_shares(const Level_connectivity& level, const Corner_slots<FT>& slot_of, const Mask& mask)
    : level_(level)
    , slots_(slot_of)
    , mask_(mask)
  {}

  // writes the row of vertex v; \pre it has edges
  void vertex(Index v, Row& row)
  {
    corners_.clear();
    const Index n = level_.valence(v);
    const Index first = level_.halfedge_of_vertex(v);
    const bool is_border = level_.is_border(first);
    for (const Index h : halfedges_around_target(level_, first))
      if (!level_.is_border(h)) {
        FT part(0);
        if constexpr (Has_face_parts<Mask>::value)
          if (!is_border) part = mask_.face_part_of_vertex(h, n);
        add_face(h, part,
                 [&](Index g) { return g == h || g == level_.next(h) || level_.next(g) == h; });
      }
    mask_row_.clear();
    mask_.vertex(v, mask_row_);
    share_out(row);
  }

  // writes the row of the inner edge e
  void edge(Index e, Row& row)
  {
    corners_.clear();
    for (const Index h : {2 * e, 2 * e + 1}) {
      FT part(0);
      if constexpr (Has_face_parts<Mask>::value) part = mask_.face_part_of_edge(h);
      add_face(h, part, [&](Index g) { return g == h || level_.next(g) == h; });
    }
    mask_row_.clear();
    mask_.edge(e, mask_row_);
    share_out(row);
  }

private:
  using Entry = typename Row::Entry;

  struct Corner
  {
    Index vertex, slot;
    FT part;
    bool takes_rest; // of the weight that is no part of a face
  };

  template <class Takes_rest>
  void add_face(Index h, const FT& part, const Takes_rest& takes_rest)
  {
    // corners come from the same one on, whatever h is
    for (const Index g : halfedges_around_face(level_, level_.halfedge_of_face(level_.face(h))))
      corners_.push_back({level_.target(g), slots_(g), part, takes_rest(g)});
  }

  void share_out(Row& row)
  {
    sort_stably(corners_, [](const Corner& c) { return c.vertex; });
    entries_.assign(mask_row_.begin(), mask_row_.end());
    sort_stably(entries_, [](const Entry& e) { return e.vertex; });
    shares_.clear();
    auto corner = corners_.begin();
    for (auto e = entries_.begin(); e != entries_.end();) {
      Entry sum = *e++;
      for (; e != entries_.end() && e->vertex == sum.vertex; ++e) sum.weight += e->weight;
      while (corner != corners_.end() && corner->vertex < sum.vertex) ++corner;
      auto end = corner;
      while (end != corners_.end() && end->vertex == sum.vertex) ++end;
      share_out(sum, corner, end);
      corner = end;
    }
    // the largest entry takes what rounding has left
    const auto largest =
      std::max_element(shares_.begin(), shares_.end(), [](const Entry& a, const Entry& b) {
        return approximate(a.weight) < approximate(b.weight);
      });
    for (auto e = shares_.begin(); e != shares_.end(); ++e)
      if (e != largest) row.add(e->vertex, e->weight);
    row.add_rest(largest->vertex);
  }

  static double approximate(const FT& x) { return double(CGAL::to_double(x)); }

  template <class Iterator>
  void share_out(const Entry& entry, Iterator begin, Iterator end)
  {
    if (begin == end) return shares_.push_back(entry);
    const auto other =
      std::find_if(begin, end, [&](const Corner& c) { return c.slot != begin->slot; });
    if (other == end) return shares_.push_back({begin->slot, entry.weight});
    FT rest = entry.weight;
    int takers = 0;
    for (Iterator c = begin; c != end; ++c) {
      rest -= c->part;
      takers += c->takes_rest;
    }
    const FT share = rest / FT(takers != 0 ? takers : int(end - begin));
    for (Iterator c = begin; c != end; ++c) {
      FT weight = c->part;
      if (takers == 0 || c->takes_rest) weight += share;
      shares_.push_back({c->slot, weight});
    }
  }

  const Level_connectivity& level_;
  const Corner_slots<FT>& slots_;
  const Mask& mask_;
  Row mask_row_;
  std::vector<Corner> corners_;
  std::vector<Entry> entries_, shares_;
};

// The rows of a mask, over slots, at the creases where smooth rules take part in a round. They are made
// from the whole level, before it is cut open.
template <class FT>
class Smooth_rows
{
public:
  using Index = Level_connectivity::Index;
  using Entry = typename Entry_row<FT>::Entry;
  using Range = std::pair<const Entry*, const Entry*>;

  // needs_row(star): whether the vertex of the star has a smooth rule
  template <class Mask>
  Smooth_rows(const Level_connectivity& level, const Creases<FT>& creases,
              const Corner_slots<FT>& slot_of, const Mask& mask,
              Function_ref<bool(const Crease_star&)> needs_row)
  {
    Slot_shares<FT, Mask> shares(level, slot_of, mask);
    for (const Crease_star& star : creases.stars) {
      if (needs_row(star)) shares.vertex(star.vertex, row_);
      close_row();
    }
    for (const Crease_edge<FT>& e : creases.edges) {
      if (e.sharpness < 1) shares.edge(e.edge, row_);
      close_row();
    }
    number_of_stars_ = creases.stars.size();
  }

  // the row of the star or crease edge at this position
  Range of_star(std::size_t i) const
  {
    return {entries_.data() + (i == 0 ? 0 : ends_[i - 1]), entries_.data() + ends_[i]};
  }
  Range of_edge(std::size_t i) const { return of_star(number_of_stars_ + i); }

private:
  void close_row()
  {
    entries_.insert(entries_.end(), row_.begin(), row_.end());
    row_.clear();
    ends_.push_back(entries_.size());
  }

  Entry_row<FT> row_;
  std::vector<Entry> entries_;
  std::vector<std::size_t> ends_; // of the rows: of the stars, then of the edges
  std::size_t number_of_stars_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_SMOOTH_ROWS_H
