// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_LINEAR_CORNERS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_LINEAR_CORNERS_H

#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Crease_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// A round of the values of corners linearly inside faces, in a host that splits edges: old corners keep their values,
// new corners get the mean of an edge or a face. Values belong to half-edges.
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
    for_chunks.in_precision<FT>(level_.number_of_faces(), [&](Index begin, Index end) {
      Entry_row<FT> row;
      for (Index f = begin; f < end; ++f) face(f, row);
    });
  }

private:
  static constexpr Index null = Level_connectivity::null;
  using Kind = Element_parent::Kind;

  void face(Index f, Entry_row<FT>& row) const
  {
    Index in_middle = null; // a new half-edge that leads to the middle of the face
    for (const Index h : halfedges_around_face(level_, level_.halfedge_of_face(f))) {
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
    }
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
    for (const Index x : halfedges_around_face(level_, h)) row.add(x, weight);
    set(g, row);
  }

  const Host& host_;
  const Level_connectivity& level_;
  const Level_connectivity& child_;
  const internal::Edge_split split_;
  Row_values<FT>& values_;
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

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_LINEAR_CORNERS_H
