// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CREASE_ROWS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CREASE_ROWS_H

#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_rules.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/ended_creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

// The linear rows of new vertices on creases, by slots: what Crease_pass does with points where there are no
// tangents. Values of a slot may be the vertex's own in every wedge, or differ from wedge to wedge.
template <class FT, class Mask>
class Crease_rows
{
public:
  using Index = Level_connectivity::Index;
  using Row = Entry_row<FT>;
  using Entry = typename Row::Entry;

  // `mask` is the mask of the cut level, `smooth_mask` of the uncut level, or null if no rule needs it. `charts` are
  // the rules of charts, or null if the values have none.
  Crease_rows(const Level_connectivity& level, const Cut_copy<FT>& cut, const Creases<FT>& creases,
              const Refined_creases<FT>& refined, const Mask& mask, const Mask* smooth_mask,
              const Chart_rules* charts = nullptr)
    : level_(level)
    , cut_(cut)
    , creases_(creases)
    , refined_(refined)
    , mask_(mask)
    , charts_(charts)
  {
    if (smooth_mask == nullptr) return;
    slots_.emplace(level, creases);
    shares_.emplace(level, *slots_, *smooth_mask);
  }

  // calls f(new slot, row) for all slots of new vertices on creases; the slots of a vertex follow one another
  void for_each(Function_ref<void(Index, const Row&)> f)
  {
    for (std::size_t i = 0; i < creases_.stars.size(); ++i) star(static_cast<Index>(i), f);
    for (std::size_t i = 0; i < creases_.edges.size(); ++i) edge(static_cast<Index>(i), f);
  }

private:
  static constexpr Index null = Level_connectivity::null;

  void star(Index i, Function_ref<void(Index, const Row&)> f)
  {
    const Crease_star& star = creases_.stars[i];
    const bool is_on_seam = charts_ != nullptr && charts_->is_on_seam(creases_, star);
    const Wedge_merge merge =
      merge_wedges<FT>(creases_, star, [&](const Crease_halfedge& e) { return remains(e); });
    const Index new_star = refined_.star[i];
    const Index wedges = new_star == null ? 1 : refined_.creases.stars[new_star].number_of_wedges;
    for (Index w = 0; w < wedges; ++w) {
      const auto old = std::find(merge.wedge.begin(), merge.wedge.end(), w);
      const auto wedge = static_cast<Index>(old - merge.wedge.begin());
      if (is_on_rim(star))
        vertex_row(star, star.slot(wedge), Vertex_rule::corner);
      else if (is_on_seam)
        vertex_on_seam(star, wedge);
      else
        vertex(star, star.slot(wedge), merge, w);
      f(new_star == null ? star.vertex : refined_.creases.stars[new_star].slot(w), row_);
    }
  }
  // Charts have all of their border among the creases, but not the rim of a part, where values do not matter.
  bool is_on_rim(const Crease_star& star) const
  {
    const Index k = star.number_of_ends;
    return charts_ != nullptr && star.is_border &&
           (k < 2 || creases_.is_inner(creases_.end(star, 0)) ||
            creases_.is_inner(creases_.end(star, k - 1)));
  }
  bool remains(const Crease_halfedge& e) const { return refined_.rank[e.crease] != null; }

  void vertex(const Crease_star& star, Index slot, const Wedge_merge& merge, Index wedge)
  {
    const bool is_kept =
      charts_ != nullptr && star.is_border && charts_->is_kept(creases_, star, 0);
    const Vertex_rule parent = is_kept ? Vertex_rule::corner : creases_.rule(star);
    const Vertex_rule child = is_kept
                                ? Vertex_rule::corner
                                : vertex_rule(refined_sharpness(star.sharpness), merge.ends.size(),
                                              star.is_border && merge.has_inner_end);
    vertex_row(star, slot, parent);
    blend_rules(star, parent, child, [&] { child_row(star, slot, child, merge, wedge); });
  }
  void vertex_row(const Crease_star& star, Index slot, Vertex_rule rule)
  {
    row_.clear();
    if (rule == Vertex_rule::corner)
      row_.add(slot, FT(1));
    else if (rule == Vertex_rule::crease)
      mask_.vertex(slot, row_);
    else
      shares_->vertex(star.vertex, row_);
  }

  void vertex_on_seam(const Crease_star& star, Index wedge)
  {
    const Index slot = star.slot(wedge);
    const Chart_span span = charts_->span(creases_, star, wedge);
    const Vertex_rule parent = charts_->rule(creases_, star, span, star.sharpness,
                                             [](const Crease_halfedge&) { return true; });
    const Vertex_rule child = charts_->rule(creases_, star, span, refined_sharpness(star.sharpness),
                                            [&](const Crease_halfedge& e) { return remains(e); });
    vertex_row(star, slot, parent);
    blend_rules(star, parent, child, [&] {
      along_crease(star, slot, creases_.far_after(creases_.end(star, span.first)),
                   creases_.far_before(creases_.end(star, span.last)));
    });
  }

  // make_child_row() makes the row of the child rule
  void blend_rules(const Crease_star& star, Vertex_rule parent, Vertex_rule child,
                   Function_ref<void()> make_child_row)
  {
    if (is_same_rule(parent, child)) return;
    const double part = weight_of_parent_rule(creases_, star);
    if (!(part < 1)) return;
    blended_ = row_;
    make_child_row();
    blend(FT(part));
  }

  // the row as if only the ends of `merge` existed
  void child_row(const Crease_star& star, Index slot, Vertex_rule rule, const Wedge_merge& merge,
                 Index wedge)
  {
    if (rule != Vertex_rule::crease || merge.ends.size() == star.number_of_ends)
      return vertex_row(star, slot, rule);
    const std::array<Crease_halfedge, 2> ends{creases_.end(star, merge.ends[0]),
                                              creases_.end(star, merge.ends[1])};
    const Crease_edge<FT>& first = creases_.edge(ends[0]);
    const bool is_behind_first =
      first.has_after(ends[0].side) && merge.wedge[star.wedge(first.after[ends[0].side])] == wedge;
    along_crease(star, slot,
                 is_behind_first ? creases_.far_after(ends[0]) : creases_.far_before(ends[0]),
                 is_behind_first ? creases_.far_before(ends[1]) : creases_.far_after(ends[1]));
  }
  void along_crease(const Crease_star& star, Index slot, Index a, Index b)
  {
    row_.clear();
    mask_.vertex(star.vertex, row_); // its weights are those of any crease
    const std::array<FT, 3> weights = crease_weights(row_, star.vertex);
    row_.clear();
    row_.add(a, weights[0]);
    row_.add(b, weights[1]);
    row_.add(slot, weights[2]);
  }

  void edge(Index i, Function_ref<void(Index, const Row&)> f)
  {
    const Crease_edge<FT>& e = creases_.edges[i];
    const Index rank = refined_.rank[i];
    const Index vertex = level_.number_of_vertices() + e.edge;
    const Crease_star* star =
      rank == null ? nullptr : &refined_.creases.stars[refined_.first_edge_star + rank];
    const Index wedges = star == nullptr ? 1 : star->number_of_wedges;
    for (Index w = 0; w < wedges; ++w) {
      row_.clear();
      const Index copy = w == 0 ? e.edge : cut_.second_copy(i);
      if (charts_ != nullptr && charts_->has_straight_bounds() && charts_->is_bound(e))
        middle(copy);
      else
        mask_.edge(copy, row_);
      if (e.sharpness < 1) {
        blended_ = row_;
        row_.clear();
        shares_->edge(e.edge, row_);
        blend(FT(e.sharpness));
      }
      f(star == nullptr ? vertex : star->slot(w), row_);
    }
  }

  void middle(Index e)
  {
    for (const Index h : {2 * e, 2 * e + 1}) row_.add(cut_.connectivity().target(h), FT(1) / FT(2));
  }

  // row becomes part * blended + (1 - part) * row
  void blend(const FT& part)
  {
    Row other;
    std::swap(row_, other);
    for (const Entry* e = blended_.begin(); e != blended_.end(); ++e)
      row_.add(e->vertex, FT(part * e->weight));
    for (const Entry* e = other.begin(); e != other.end(); ++e)
      row_.add(e->vertex, FT(FT(FT(1) - part) * e->weight));
  }

  const Level_connectivity& level_;
  const Cut_copy<FT>& cut_;
  const Creases<FT>& creases_;
  const Refined_creases<FT>& refined_;
  const Mask& mask_;
  const Chart_rules* charts_;
  std::optional<Corner_slots<FT>> slots_;
  std::optional<Slot_shares<FT, Mask>> shares_;
  Row row_, blended_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CREASE_ROWS_H
