// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ROUND_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ROUND_H

#include <CGAL/PN_subdivision_3/internal/creases/Crease_pass.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/ended_creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// the values of the listed new vertices, by their rows
template <class Plain_round>
std::vector<typename Plain_round::Value>
values_of_rows(const Plain_round& round, const std::vector<Level_connectivity::Index>& vertices,
               const typename Plain_round::Value* old, const For_chunks& for_chunks)
{
  using Index = Level_connectivity::Index;
  using Value = typename Plain_round::Value;
  std::vector<Value> values(vertices.size());
  evaluate_rows(round, vertices.data(), static_cast<Index>(vertices.size()), old, for_chunks,
                [&](const Index* first, const Value* v, Index n) {
                  std::copy(v, v + n, values.begin() + (first - vertices.data()));
                });
  return values;
}

// Calls f(position, vertex, value) for the vertices of slots with values; the slots of a vertex follow one
// another. A vertex of several slots has their mean normal.
template <class Average, class Function>
void for_each_crease_vertex(
  const std::vector<std::pair<Level_connectivity::Index, typename Average::Value>>& slot_values,
  Level_connectivity::Index number_of_vertices, const Function& f)
{
  using FT = typename Average::FT;
  using Value = typename Average::Value;
  constexpr bool has_normals = has_normal_v<Value>;
  for (std::size_t i = 0; i < slot_values.size();) {
    const std::size_t first = i;
    const auto v = slot_values[i].first;
    Value value = slot_values[i].second;
    int wedges = 1;
    for (++i; i < slot_values.size() && slot_values[i].first >= number_of_vertices; ++i, ++wedges)
      if constexpr (has_normals) add_multiple(value.normal, FT(1), slot_values[i].second.normal);
    if constexpr (has_normals)
      if (wedges > 1)
        name_undecided<FT>([&] { value.normal = unit_or_zero(value.normal, FT(wedges)); },
                           [&] { return "the mean normal of vertex " + std::to_string(v); });
    f(first, v, value);
  }
}

template <class Scheme, class Average>
class Round_without_fractions;

// One round of a scheme on a level with creases.
//
// The mask sees the level cut open, so that rows far from creases and beside them are the rows of an
// ordinary round, over slots. For new vertices on creases the crease pass replaces their values by the
// values of all slots.
//
// With point-normal schemes edges that end in the round merge their wedges, and the faces of the refined level that touch
// these edges get the roundness 0. Edges of the sharpness 0 < s < 1 are sharp in this round as a whole. Another round is made
// without them, and rows that reach them are blended, see Round_without_fractions.
//
// Where nothing can be sharp it is an ordinary round. What is defined behind the class may be compiled once.
template <class Scheme, class Average, class Level_creases>
class Crease_round
{
public:
  using Plain_round = Round<Scheme, Average>;
  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  using Slot_value = std::pair<Index, Value>;

  // `old` has the values of the slots; null until they are known, see read(). The level is cut open until close() is called.
  Crease_round(const Scheme& scheme, Level_connectivity& level, const Creases<FT>& creases,
               const Value* old, unsigned number);

  Crease_round(const Crease_round&) = delete;
  Crease_round& operator=(const Crease_round&) = delete;

  // the values of the slots
  void read(const Value* old) { old_ = old; }

  // the round of all new vertices; its values do not hold where crease_values() has others
  const Plain_round& round() const { return *round_; }
  Index number_of_vertices() const { return static_cast<Index>(refined_size_.vertices); }

  const Refined_creases<FT>& refined() const { return refined_; }

  // the values on the creases, for each of their slots, and beside them where creases end
  std::vector<Slot_value> crease_values(const For_chunks& for_chunks);

  // calls f(slot) for what the smooth rule of a dart reads
  template <class Function>
  void for_each_smooth_entry(const Crease_star& star, const Function& f) const
  {
    for (const auto* rows : {&smooth_rows_, &smooth_normal_rows_}) {
      if (!*rows) continue;
      const auto row = (*rows)->of_star(std::size_t(&star - creases_.stars.data()));
      for (const auto* e = row.first; e != row.second; ++e) f(e->vertex);
    }
  }

  // makes the level whole again; to be called before a host connects the child
  void close() { cut_->close(); }

  // the creases of the refined level, once crease_values() has made their tangents
  Creases<FT>& refined_creases() { return refined_.creases; }

  // the new vertices that crease_values() has values for, in increasing order
  std::vector<Index> vertices_of_values() const
  {
    std::vector<Index> all, on_creases = vertices_on_creases();
    std::merge(on_creases.begin(), on_creases.end(), others_.begin(), others_.end(),
               std::back_inserter(all));
    return all;
  }

private:
  using Host = typename Scheme::Host;
  static constexpr bool is_pn = !Is_linear<Scheme>::value;
  static constexpr bool may_end = is_pn && creases_may_end_v<Scheme>;

  static bool ends(const Crease_edge<FT>& e) { return !(refined_sharpness(e.sharpness) > 0); }

  std::vector<Index> vertices_on_creases() const
  {
    std::vector<Index> vertices;
    for (const Crease_star& star : creases_.stars) vertices.push_back(star.vertex);
    for (const Crease_edge<FT>& e : creases_.edges)
      vertices.push_back(round_->host().vertex_of_edge(e.edge));
    return vertices;
  }

  // vertices beside creases whose values do not come from their rows
  void find_others(const std::vector<Index>& on_creases)
  {
    std::vector<Index> all(ended_.begin(),
                           std::lower_bound(ended_.begin(), ended_.end(), number_of_vertices()));
    if constexpr (may_end)
      if (smooth_round_) {
        const std::vector<Index> blended = smooth_round_->vertices();
        all.insert(all.end(), blended.begin(), blended.end());
      }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::set_difference(all.begin(), all.end(), on_creases.begin(), on_creases.end(),
                        std::back_inserter(others_));
  }

  // on_creases and the values of others_, in the order of the vertices; the slots of a vertex follow one another
  std::vector<Slot_value> with_others(const std::vector<Slot_value>& on_creases,
                                      const std::vector<Value>& values) const
  {
    std::vector<Slot_value> all;
    all.reserve(on_creases.size() + values.size());
    std::size_t i = 0;
    const auto add_before = [&](Index end) {
      for (; i < others_.size() && others_[i] < end; ++i) all.emplace_back(others_[i], values[i]);
    };
    for (const Slot_value& v : on_creases) {
      if (v.first < number_of_vertices()) add_before(v.first);
      all.push_back(v);
    }
    add_before(Level_connectivity::null);
    return all;
  }

  // made from the mask of the whole level
  void make_smooth_rows(unsigned number)
  {
    count_valences(level_, creases_);
    const Plain_round smooth(scheme_, level_, number);
    const Corner_slots<FT> slot_of(level_, creases_);
    const auto needs_row = [this](const Crease_star& s) {
      return has_smooth_rule(creases_, refined_, s, !is_pn);
    };
    smooth_rows_.emplace(level_, creases_, slot_of, smooth.mask(), needs_row);
    if constexpr (Has_normal_mask<Scheme>::value)
      if (smooth.has_own_normals())
        smooth_normal_rows_.emplace(level_, creases_, slot_of, smooth.normal_mask(), needs_row);
  }

  const Scheme& scheme_;
  Level_connectivity& level_;
  const Creases<FT>& creases_;
  const Value* old_;
  const Level_size refined_size_;
  Refined_creases<FT> refined_;
  std::optional<Smooth_rows<FT>> smooth_rows_, smooth_normal_rows_;
  std::optional<Cut_in_place<FT>> cut_;
  std::optional<Plain_round> round_;
  std::vector<Index> ended_;  // new slots that are not round, by their numbers
  std::vector<Index> others_; // new vertices, by their numbers
  std::conditional_t<may_end, std::unique_ptr<Round_without_fractions<Scheme, Average>>,
                     std::nullptr_t>
    smooth_round_{};
};

template <class Scheme, class Average, class Level_creases>
Crease_round<Scheme, Average, Level_creases>::Crease_round(const Scheme& scheme,
                                                           Level_connectivity& level,
                                                           const Creases<FT>& creases,
                                                           const Value* old, unsigned number)
  : scheme_(scheme)
  , level_(level)
  , creases_(creases)
  , old_(old)
  , refined_size_(Host::refined_size(level.size(), number))
  , refined_(creases, level, number_of_vertices())
{
  if (has_smooth_rules(creases, refined_, !is_pn)) make_smooth_rows(number);
  if constexpr (may_end) {
    if (std::any_of(creases.edges.begin(), creases.edges.end(), ends))
      ended_ = slots_at_ended(Host(level, number), level, creases, refined_);
    if (has_fractions(creases))
      smooth_round_ =
        std::make_unique<Round_without_fractions<Scheme, Average>>(scheme, level, creases, number);
  }
  round_.emplace(scheme, level, number, [&] { cut_.emplace(level, creases); });
  const std::vector<Index> on_creases = vertices_on_creases();
  if constexpr (may_end) find_others(on_creases);
  if constexpr (!std::is_floating_point_v<FT>) round_->set_vertices_on_creases(on_creases);
}

template <class Scheme, class Average, class Level_creases>
auto Crease_round<Scheme, Average, Level_creases>::crease_values(const For_chunks& for_chunks)
  -> std::vector<Slot_value>
{
  const auto pointer = [](const auto& rows) { return rows ? &*rows : nullptr; };
  using Pass = Crease_pass<std::decay_t<decltype(round_->mask())>, Average>;
  const typename Pass::Data data{level_,
                                 creases_,
                                 round_->mask(),
                                 round_->average(),
                                 round_->number(),
                                 round_->host().vertex_of_edge(0),
                                 pointer(smooth_rows_),
                                 pointer(smooth_normal_rows_),
                                 old_};
  std::vector<Slot_value> values = Pass(data, refined_)(for_chunks);
  if constexpr (may_end) {
    if (!others_.empty())
      values = with_others(values, values_of_rows(*round_, others_, old_, for_chunks));
    if (!ended_.empty())
      for (Slot_value& v : values)
        if (std::binary_search(ended_.begin(), ended_.end(), v.first)) v.second.roundness = FT(0);
    if (smooth_round_) smooth_round_->blend(creases_, old_, refined_, values, for_chunks);
  }
  return values;
}

template <class Scheme, class Average>
class Crease_round<Scheme, Average, No_creases> : public Round<Scheme, Average>
{
public:
  using Plain_round = Round<Scheme, Average>;
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  using Slot_value = std::pair<Index, Value>;

  Crease_round(const Scheme& scheme, const Level_connectivity& level, No_creases, const Value*,
               unsigned number)
    : Plain_round(scheme, level, number)
    , refined_creases_(number_of_vertices())
  {}
  Crease_round(const Crease_round&) = delete;
  Crease_round& operator=(const Crease_round&) = delete;

  void read(const Value*) {}
  const Plain_round& round() const { return *this; }
  Index number_of_vertices() const { return static_cast<Index>(this->refined_size().vertices); }
  std::vector<Slot_value> crease_values(const For_chunks&) const { return {}; }
  void close() {}
  No_creases& refined_creases() { return refined_creases_; }
  std::vector<Index> vertices_of_values() const { return {}; }

private:
  No_creases refined_creases_;
};

} // namespace CGAL::PN_subdivision_3::internal

#include <CGAL/PN_subdivision_3/internal/creases/Round_without_fractions.h>

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ROUND_H
