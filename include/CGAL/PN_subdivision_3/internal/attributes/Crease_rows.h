// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CREASE_ROWS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CREASE_ROWS_H

#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_values.h>
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
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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
        for (const Index h : {2 * copy, 2 * copy + 1})
          row_.add(cut_.connectivity().target(h), FT(1) / FT(2));
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

// The values of corners in charts that are cut: a value for every slot, by the rows of the level cut open.
template <class FT>
class Smooth_corners
{
public:
  using Index = Level_connectivity::Index;

  Smooth_corners(Row_values<FT>& values, Charts<FT>&& charts)
    : values_(values)
    , creases_(std::move(charts.creases()))
    , rules_(std::make_shared<const Chart_rules>(std::move(charts.rules())))
  {}
  // the corners of a part, whose creases are given
  Smooth_corners(Row_values<FT>& values, Creases<FT>&& creases, const Smooth_corners& whole)
    : values_(values)
    , creases_(std::move(creases))
    , rules_(whole.rules_)
  {}

  const Creases<FT>& creases() const { return creases_; }

  // Takes the rows of the vertices of the level, and finds out where the charts need other rows: where a row reads a
  // vertex on a seam or crease.
  void begin_round(const Level_connectivity& level, Index number_of_new_vertices, bool takes_rows)
  {
    is_special_.assign(level.number_of_vertices(), takes_rows ? 0 : 1);
    for (const Crease_star& star : creases_.stars) is_special_[star.vertex] = 1;
    needs_own_row_.assign(number_of_new_vertices, takes_rows ? 0 : 1);
    refined_.emplace(creases_, level, number_of_new_vertices);
    values_.begin_round(refined_->creases.number_of_slots);
  }
  void evaluate(Index first, const Stencil_block<FT>& rows)
  {
    values_.evaluate(first, rows);
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r) {
      char special = 0;
      for (const auto* e = rows.begin(r); e != rows.end(r); ++e) special |= is_special_[e->vertex];
      needs_own_row_[first + r] = special;
    }
  }

  // Ends a round. `smooth_mask` is the mask of the uncut level; null if nothing there is less than infinitely sharp.
  template <class Scheme, class Plain_round, class Mask>
  void end_round(const Scheme& scheme, const Plain_round& round, const Level_connectivity& level,
                 const Mask* smooth_mask, const For_chunks& for_chunks)
  {
    const Cut_copy<FT> cut(level, creases_);
    const Mask mask = scheme.template mask<FT>(cut.connectivity(), round.number());
    evaluate_own_rows(round.host(), mask, for_chunks);
    Crease_rows<FT, Mask> rows(level, cut, creases_, *refined_, mask, smooth_mask, rules_.get());
    rows.for_each([&](Index slot, const Entry_row<FT>& row) {
      values_.evaluate(slot, row.begin(), row.end());
    });
    values_.end_round();
    creases_ = std::move(refined_->creases);
  }

  static void keep_values(Row_values<FT>& values, const std::vector<Index>& vertices)
  {
    Entry_row<FT> row;
    for (const Index v : vertices) {
      row.clear();
      row.add(v, FT(1));
      values.evaluate(v, row.begin(), row.end());
    }
  }

private:
  template <class Host, class Mask>
  void evaluate_own_rows(const Host& host, const Mask& mask, const For_chunks& for_chunks) const
  {
    for_chunks.in_precision<FT>(static_cast<Index>(needs_own_row_.size()),
                                [&](Index begin, Index end) {
                                  Stencil_block<FT> row;
                                  for (Index v = begin; v < end; ++v) {
                                    if (needs_own_row_[v] == 0) continue;
                                    row.clear();
                                    host.stencil(mask, v, row.row());
                                    row.close_row();
                                    values_.evaluate(v, row);
                                  }
                                });
  }

  Row_values<FT>& values_;
  Creases<FT> creases_;
  std::shared_ptr<const Chart_rules> rules_;
  // of a round
  std::vector<char> is_special_;    // old vertices on seams and creases
  std::vector<char> needs_own_row_; // new vertices whose row reads a special one
  std::optional<Refined_creases<FT>> refined_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CREASE_ROWS_H
