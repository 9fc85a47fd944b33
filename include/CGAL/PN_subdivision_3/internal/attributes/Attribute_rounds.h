// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_ROUNDS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_ROUNDS_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_origins.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Crease_rows.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_part.h>
#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Values of vertices of the last round may be put as they are computed, or when put() is called.
enum class Kind_of_round { inner, last_put_at_once, last_put_later };

// Attributes through the rounds of a call: begin_round(), the rows() and the child() of the round, end_round();
// after the last one put(). What is defined behind the class may be compiled once.
template <class FT>
class Attribute_rounds
{
public:
  using Index = Level_connectivity::Index;
  using Rows_sink = Function_ref<void(Index, const Stencil_block<FT>&)>;
  using Child_sink = Function_ref<void(const Level_connectivity&)>;
  using Kinds = Level_origins::Kinds;
  using Indices = Level_part::Origins;
  using Chart_slots = std::vector<Corner_slots<FT>>;

  // `kept` tells what the host keeps; `extra_slots` has the vertices of the further slots, see Creases; `visited` the origins
  // that a visitor asks for
  Attribute_rounds(Control_attributes<FT>&& attributes, Kept_elements kept, Kinds visited,
                   const Level_connectivity& level, const std::vector<Index>& extra_slots,
                   const Control_sharpness& sharpness, const Element_names& names,
                   const For_chunks& for_chunks);
  // The attributes of a part of a level between two rounds, whose slots in the whole are given. `whole` must stay, and so must
  // `chart_slots`, see slots_of_charts().
  Attribute_rounds(const Attribute_rounds& whole, const Level_part& part, const Indices& slot_ids,
                   const Chart_slots& chart_slots);
  Attribute_rounds(const Attribute_rounds&) = delete;
  Attribute_rounds& operator=(const Attribute_rounds&) = delete;

  // `level` is the whole one, for smooth rules; it stays until the round ends
  template <class Scheme, class Level_round, class Level_creases>
  void begin_round(const Scheme& scheme, const Level_round& round, const Level_connectivity& level,
                   const Level_creases& creases, Kind_of_round kind);

  // null if there is nothing to do with the rows, or the child, of a round
  const Rows_sink* rows() const
  {
    return by_rows_.empty() && smooth_.empty() ? nullptr : &rows_sink_;
  }
  const Child_sink* child() const
  {
    return linear_.empty() && smooth_.empty() ? nullptr : &child_sink_;
  }
  // whether put() needs the refined level
  bool needs_refined_level() const { return !attributes_.corners.empty(); }

  void end_round();

  // where the elements of the last round come from
  template <class Plain_round>
  auto rules(const Plain_round& last, const Level_connectivity& level) const
  {
    using Host = typename Plain_round::Host;
    return Origin_rules<Host>(last.host(), level, origins_.origins(), last.number());
  }

  // puts everything for the elements of the refined mesh, which has been made large enough
  void put(const Level_size& size, const Level_connectivity* refined, const Origin_source& rules);
  void commit() noexcept { attributes_.commit(); }
  // from which lists that have been put are taken
  Control_attributes<FT>& attributes() { return attributes_; }

  // puts the attributes of a part after all rounds
  Control_attributes<FT>& put_part(const Level_part& part)
  {
    put(part.level.size(), &part.level, origins_.origins());
    return attributes_;
  }
  // whether charts are cut, so that their rules look at more faces than the rules of the scheme
  bool has_charts() const { return !smooth_.empty(); }
  // the slots of corners in each chart of the level, for its parts
  Chart_slots slots_of_charts(const Level_connectivity& level) const
  {
    Chart_slots chart_slots;
    chart_slots.reserve(smooth_.size());
    for (const Smooth_corners<FT>& smooth : smooth_)
      chart_slots.emplace_back(level, smooth.creases());
    return chart_slots;
  }

private:
  static constexpr Index null = Level_connectivity::null;

  struct By_rows
  {
    Row_values<FT>* values;
    std::vector<Index> kept_vertices;
    bool is_of_vertices;
  };
  struct Evaluate_rows
  {
    void operator()(Index first, const Stencil_block<FT>& rows) const
    {
      for (const By_rows& by_rows : self.by_rows_) by_rows.values->evaluate(first, rows);
      if (self.charts_take_rows_)
        for (Smooth_corners<FT>& corners : self.smooth_) corners.evaluate(first, rows);
    }
    Attribute_rounds& self;
  };

  // `kept` is sorted
  static Indices kept_in(const Level_part& part, const Indices& kept)
  {
    Indices result;
    for (Index v = 0; v < part.vertices.size() && !kept.empty(); ++v)
      if (std::binary_search(kept.begin(), kept.end(), part.vertices[v])) result.push_back(v);
    return result;
  }

  [[noreturn]] static void refuse(const std::string& what)
  {
    throw std::invalid_argument(
      "PN_subdivision_3: " + what +
      " scheme keeps no edges: refine without this attribute, or by a scheme that splits edges");
  }

  void begin_corners(Row_values<FT>& values, Corner_rule rule, const Level_connectivity& level,
                     const std::vector<Index>& slot_vertices, const Control_sharpness& sharpness,
                     const Element_names& names)
  {
    if (rule == Corner_rule::all) {
      if (!kept_.edges) refuse("an attribute of corners is linear, but the");
      values.begin(faced_halfedges(level));
      linear_.push_back(&values);
      corner_kinds_.push_back({Corner_kind::linear, 0});
      return;
    }
    Charts<FT> charts(level, rule, sharpness,
                      [&](Index h, Index g) { return values.are_equal(h, g); });
    std::vector<Index> corner_of_slots = charts.corner_of_slots();
    if (charts.is_cut()) {
      if (!kept_.edges)
        refuse(charts.has_seams() ? "an attribute of corners has a seam at the edge of " +
                                      names.halfedge_name(2 * charts.first_seam()) + ", but the"
                                  : "an attribute of corners has straight borders, but the");
      values.begin(corner_of_slots);
      corner_kinds_.push_back({Corner_kind::smooth, smooth_.size()});
      smooth_.emplace_back(values, std::move(charts));
      return;
    }
    for (std::size_t slot = corner_of_slots.size(); slot < slot_vertices.size(); ++slot)
      corner_of_slots.push_back(corner_of_slots[slot_vertices[slot]]);
    values.begin(corner_of_slots);
    by_rows_.push_back(
      {&values, kept_.vertices ? charts.kept_vertices() : std::vector<Index>(), false});
    corner_kinds_.push_back({Corner_kind::by_rows, 0});
  }

  // what charts and linear corners do when the child is known
  template <class Scheme, class Plain_round, class Mask>
  void begin_corners_of_round(const Scheme& scheme, const Plain_round& round,
                              const Level_connectivity& level,
                              const std::shared_ptr<const Mask>& smooth_mask)
  {
    for (Smooth_corners<FT>& corners : smooth_)
      corners.begin_round(level, static_cast<Index>(round.refined_size().vertices),
                          charts_take_rows_);
    for (Row_values<FT>* values : linear_)
      values->begin_round(static_cast<std::size_t>(round.refined_size().halfedges()));
    using Linear = Linear_corners<FT, typename Plain_round::Host>;
    end_corners_ = [&scheme, &round, &level, smooth_mask, this](const Level_connectivity& child) {
      for (Row_values<FT>* values : linear_)
        Linear(round.host(), level, child, *values)(for_chunks_);
      for (Smooth_corners<FT>& corners : smooth_)
        corners.end_round(scheme, round, level, smooth_mask.get(), for_chunks_);
    };
  }

  // the rows of new vertices on creases, and the slots that have the values of their vertices
  template <class Level_round, class Mask>
  void make_crease_rows(const Level_round& round, const Level_connectivity& level,
                        const Creases<FT>& creases, const Mask* smooth_mask)
  {
    const auto& refined = round.refined();
    const Cut_copy<FT> cut(level, creases);
    Crease_rows<FT, Mask> rows(level, cut, creases, refined, round.round().mask(), smooth_mask);
    rows.for_each([&](Index slot, const Entry_row<FT>& row) {
      if (slot < round.number_of_vertices()) crease_rows_.emplace_back(slot, row);
    });
    for (const Crease_star& star : refined.creases.stars)
      for (Index w = 1; w < star.number_of_wedges; ++w)
        copies_.emplace_back(star.vertex, star.slot(w));
  }

  static std::vector<Index> faced_halfedges(const Level_connectivity& level)
  {
    std::vector<Index> result(level.number_of_halfedges(), null);
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (!level.is_border(h)) result[h] = h;
    return result;
  }

  std::vector<Index> values_of_corners(std::size_t i, const Level_connectivity& refined) const
  {
    const auto [kind, rank] = corner_kinds_[i];
    std::vector<Index> values = faced_halfedges(refined);
    if (kind != Corner_kind::linear)
      for (Index& h : values)
        if (h != null) h = refined.target(h);
    if (kind == Corner_kind::smooth)
      for_each_extra_corner(refined, smooth_[rank].creases(),
                            [&](Index h, Index slot) { values[h] = slot; });
    return values;
  }

  enum class Corner_kind { by_rows, smooth, linear };

  Control_attributes<FT> attributes_;
  const For_chunks for_chunks_;
  Kept_elements kept_;
  Origin_rounds origins_;
  std::vector<By_rows> by_rows_;
  std::vector<Smooth_corners<FT>> smooth_;
  std::vector<Row_values<FT>*> linear_;
  std::vector<std::pair<Corner_kind, std::size_t>> corner_kinds_; // the rank in smooth_
  bool charts_take_rows_ = true;
  std::function<void(const Level_connectivity&)> end_corners_;
  std::vector<std::pair<Index, Entry_row<FT>>> crease_rows_;
  std::vector<std::pair<Index, Index>> copies_;
  const Evaluate_rows evaluate_rows_{*this};
  const Rows_sink rows_sink_{evaluate_rows_};
  const Child_sink child_sink_{end_corners_};
};

template <class FT>
Attribute_rounds<FT>::Attribute_rounds(Control_attributes<FT>&& attributes, Kept_elements kept,
                                       Kinds visited, const Level_connectivity& level,
                                       const std::vector<Index>& extra_slots,
                                       const Control_sharpness& sharpness,
                                       const Element_names& names, const For_chunks& for_chunks)
  : attributes_(std::move(attributes))
  , for_chunks_(for_chunks)
  , kept_(kept)
  , origins_(level, attributes_.needed_origins(visited), kept.edges)
{
  std::vector<Index> slot_vertices = first_indices(level.number_of_vertices());
  slot_vertices.insert(slot_vertices.end(), extra_slots.begin(), extra_slots.end());
  for (auto& values : attributes_.vertices) {
    values->begin(slot_vertices);
    by_rows_.push_back({values.get(), {}, true});
  }
  for (std::size_t i = 0; i < attributes_.corners.size(); ++i)
    begin_corners(*attributes_.corners[i], attributes_.corner_rules[i], level, slot_vertices,
                  sharpness, names);
  if (!kept_.edges && !attributes_.edges.empty()) refuse("there is an attribute of edges, but the");
}

template <class FT>
Attribute_rounds<FT>::Attribute_rounds(const Attribute_rounds& whole, const Level_part& part,
                                       const Indices& slot_ids, const Chart_slots& chart_slots)
  : for_chunks_(whole.for_chunks_)
  , kept_(whole.kept_)
  , origins_(whole.origins_, part, whole.for_chunks_)
{
  for (const auto& values : whole.attributes_.vertices) {
    attributes_.vertices.push_back(values->part(slot_ids));
    by_rows_.push_back({attributes_.vertices.back().get(), {}, true});
  }
  std::size_t rank_by_rows = whole.attributes_.vertices.size();
  for (std::size_t i = 0; i < whole.attributes_.corners.size(); ++i) {
    const auto [kind, rank] = whole.corner_kinds_[i];
    const auto add = [&](const Indices& sources) -> Row_values<FT>& {
      attributes_.corners.push_back(whole.attributes_.corners[i]->part(sources));
      return *attributes_.corners.back();
    };
    corner_kinds_.push_back({kind, rank});
    if (kind == Corner_kind::linear)
      linear_.push_back(&add(part.corners()));
    else if (kind == Corner_kind::by_rows)
      by_rows_.push_back(
        {&add(slot_ids), kept_in(part, whole.by_rows_[rank_by_rows++].kept_vertices), false});
    else {
      const Smooth_corners<FT>& smooth = whole.smooth_[rank];
      Creases<FT> creases = part.creases(smooth.creases());
      Row_values<FT>& values = add(part.slot_origins(creases, chart_slots[rank]));
      smooth_.emplace_back(values, std::move(creases), smooth);
    }
  }
  attributes_.take_parts_of_columns(whole.attributes_);
}

template <class FT>
template <class Scheme, class Level_round, class Level_creases>
void Attribute_rounds<FT>::begin_round(const Scheme& scheme, const Level_round& round,
                                       const Level_connectivity& level,
                                       const Level_creases& creases, Kind_of_round kind)
{
  constexpr bool are_creases = are_creases_v<Level_creases>;
  const auto& plain = round.round();
  using Plain_round = std::decay_t<decltype(plain)>;
  using Mask = std::decay_t<decltype(plain.mask())>;
  std::shared_ptr<const Mask> smooth_mask;
  std::size_t number_of_values = round.number_of_vertices();
  charts_take_rows_ = !are_creases; // rows are of slots of the creases
  crease_rows_.clear();
  copies_.clear();
  if constexpr (are_creases) {
    number_of_values = round.refined().creases.number_of_slots;
    if (has_smooth_rules(creases, round.refined(), true))
      smooth_mask = std::make_shared<const Mask>(scheme.template mask<FT>(level, plain.number()));
    if (!by_rows_.empty()) make_crease_rows(round, level, creases, smooth_mask.get());
  }
  for (const By_rows& by_rows : by_rows_)
    if (kind == Kind_of_round::last_put_at_once && by_rows.is_of_vertices)
      by_rows.values->begin_last_round(number_of_values, round.number_of_vertices(),
                                       for_chunks_.has_threads());
    else
      by_rows.values->begin_round(number_of_values);
  if constexpr (Splits_edges<typename Plain_round::Host>::value)
    begin_corners_of_round(scheme, plain, level, smooth_mask);
  if (kind == Kind_of_round::inner)
    origins_.begin_round(rules(plain, level), plain.refined_size(), for_chunks_);
}

template <class FT>
void Attribute_rounds<FT>::end_round()
{
  for (const By_rows& by_rows : by_rows_) {
    for (const auto& [slot, row] : crease_rows_)
      by_rows.values->evaluate(slot, row.begin(), row.end());
    for (const auto& [from, to] : copies_) by_rows.values->copy(from, to);
    Smooth_corners<FT>::keep_values(*by_rows.values, by_rows.kept_vertices);
    by_rows.values->end_round();
  }
  for (Row_values<FT>* values : linear_) values->end_round();
  origins_.end_round();
}

template <class FT>
void Attribute_rounds<FT>::put(const Level_size& size, const Level_connectivity* refined,
                               const Origin_source& rules)
{
  for (auto& values : attributes_.vertices)
    if (!values->is_put()) values->put(first_indices(size.vertices));
  for (std::size_t i = 0; i < attributes_.corners.size(); ++i)
    attributes_.corners[i]->put(values_of_corners(i, *refined));
  origins_.put(attributes_, size, rules);
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_ROUNDS_H
