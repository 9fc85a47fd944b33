// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_STORED_ROUNDS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_STORED_ROUNDS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_round.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/Wedge_estimation.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/refiner/Stored_refinement.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// whether two values are the same, bit by bit; other numbers are not compared
template <class FT>
bool is_same_value(const Coordinates<FT, 3>& a, const Coordinates<FT, 3>& b)
{
  if constexpr (std::is_floating_point_v<FT>)
    return std::equal(a.begin(), a.end(), b.begin(),
                      [](FT x, FT y) { return x == y && std::signbit(x) == std::signbit(y); });
  else
    return false;
}
template <class FT>
bool is_same_value(const Point_normal<FT, 3>& a, const Point_normal<FT, 3>& b)
{
  return is_same_value<FT>(a.point, b.point) && is_same_value<FT>(a.normal, b.normal) &&
         a.roundness == b.roundness;
}

// The rounds of a scheme on a control level with its creases, kept with their levels. What is kept of the last
// round is the round's old level: new values go to a sink. Levels with creases are kept cut open, with values
// of slots. Vertices on creases are evaluated as a whole in every call, which goes on from where they have changed.
template <class Scheme, class Average, class Level_creases>
class Stored_rounds final : public Stored_refinement<Average>
{
  using Base = Stored_refinement<Average>;
  using FT = typename Average::FT;
  using Host = typename Scheme::Host;

public:
  using typename Base::Corner_sink;
  using typename Base::Index;
  using typename Base::List_sink;
  using typename Base::Sink;
  using typename Base::Value;
  using Control = Control_values<Average>;
  using Level_round = Crease_round<Scheme, Average, Level_creases>;

  Stored_rounds(const Scheme& scheme, Level_connectivity&& control, Level_creases&& creases,
                unsigned number_of_rounds, [[maybe_unused]] Control& values,
                const For_chunks& for_chunks)
    : Base(for_chunks)
    , scheme_(scheme)
    , creases_(std::move(creases))
  {
    if constexpr (are_creases_v<Level_creases>)
      if (!creases_.empty()) {
        whole_control_ = control;
        std::vector<Index> several;
        for (const Crease_star& star : creases_.stars)
          if (star.number_of_wedges > 1) several.push_back(star.vertex);
        values.set_vertices_with_several_normals(std::move(several));
      }
    Level_connectivity level = std::move(control);
    const Level_creases* of_level = &creases_;
    for (unsigned k = 1; k <= number_of_rounds; ++k) {
      // before the round, which cuts its level open
      Level_connectivity child;
      if (k < number_of_rounds)
        child = child_level<Host>(level, k, this->for_chunks_);
      else if (!creases_.empty())
        whole_last_ = level;
      levels_.emplace_back(std::move(level), of_level->number_of_slots);
      levels_.back().round.emplace(scheme_, levels_.back().connectivity, *of_level, nullptr, k);
      of_level = &levels_.back().round->refined_creases();
      level = std::move(child);
    }
    if (number_of_rounds == 0) levels_.emplace_back(std::move(level), creases_.number_of_slots);
  }

  Level_size refined_size() const override
  {
    const Level& last = levels_.back();
    return last.round ? last.round->round().refined_size() : last.connectivity.size();
  }
  Level_connectivity refined_level() const override
  {
    const Level& last = levels_.back();
    if (!last.round) return last.connectivity;
    return child_level<Host>(whole_last_ ? *whole_last_ : last.connectivity,
                             static_cast<unsigned>(levels_.size()), this->for_chunks_);
  }

  std::vector<Index> take(Control& control) override
  {
    if constexpr (are_creases_v<Level_creases>)
      if (!creases_.empty()) return take_slots(control);
    control.update_estimate(levels_.front().connectivity);
    std::vector<Index> changed = control.changes();
    control.forget_changes();
    for (Index v : changed) levels_.front().values[v] = control[v];
    return changed;
  }

  void evaluate(Sink sink) override
  {
    if (!levels_.back().round) {
      const auto& values = levels_.front().values;
      return sink(0, values.data(), static_cast<Index>(values.size()));
    }
    for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
      auto& refined = levels_[k + 1].values;
      const Slot_values on_creases =
        evaluate_round(levels_[k], [&](Index first, const Value* values, Index n) {
          std::copy(values, values + n, refined.begin() + first);
        });
      for (const auto& [slot, value] : on_creases) refined[slot] = value;
    }
    last_on_creases_ = evaluate_round(levels_.back(), sink);
    for_each_crease_vertex<Average>(
      last_on_creases_, number_of_refined_vertices(),
      [&](std::size_t, Index v, const Value& value) { sink(v, &value, 1); });
  }

  std::vector<Index> evaluate_from(std::vector<Index> changed, List_sink sink) override
  {
    if (!levels_.back().round) {
      for (const Index& v : changed) sink(&v, &levels_.front().values[v], 1);
      return changed;
    }
    for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
      auto& refined = levels_[k + 1].values;
      const Slot_values on_creases = evaluate_round_from(
        levels_[k], changed, [&](const Index* vertices, const Value* values, Index n) {
          for (Index i = 0; i < n; ++i) refined[vertices[i]] = values[i];
        });
      for (const auto& [slot, value] : on_creases) {
        if (is_same_value<FT>(refined[slot], value)) continue;
        refined[slot] = value;
        changed.push_back(slot);
      }
    }
    Slot_values on_creases = evaluate_round_from(levels_.back(), changed, sink);
    const auto end_of_others = static_cast<std::ptrdiff_t>(changed.size());
    for_each_crease_vertex<Average>(on_creases, number_of_refined_vertices(),
                                    [&](std::size_t i, Index v, const Value& value) {
                                      if (is_as_before(on_creases, i)) return;
                                      sink(&v, &value, 1);
                                      changed.push_back(v);
                                    });
    last_on_creases_ = std::move(on_creases);
    std::inplace_merge(changed.begin(), changed.begin() + end_of_others, changed.end());
    return changed;
  }

  void for_each_corner(const Level_connectivity& refined, Corner_sink sink) const override
  {
    if constexpr (are_creases_v<Level_creases>)
      if (!creases_.empty()) {
        const Creases<FT>& creases = levels_.back().round->refined().creases;
        std::vector<const Value*> of_slots(creases.number_of_slots, nullptr);
        for (const auto& [slot, value] : last_on_creases_) of_slots[slot] = &value;
        const Cut_copy<FT> cut(refined, creases);
        internal::for_each_corner(refined, cut.connectivity(),
                                  [&](Index h, Index slot) { sink(h, of_slots[slot]); });
        return;
      }
    for (Index h = 0; h < refined.number_of_halfedges(); ++h)
      if (!refined.is_border(h)) sink(h, nullptr);
  }

  std::size_t memory() const override
  {
    std::size_t sum = last_on_creases_.capacity() * sizeof(last_on_creases_.front());
    for (const std::optional<Level_connectivity>* whole : {&whole_control_, &whole_last_})
      if (*whole) sum += memory(**whole);
    for (const Level& level : levels_)
      sum +=
        memory(level.connectivity) + sizeof(Value) * level.values.size() + level.readers.memory();
    return sum;
  }

private:
  using Slot_values = std::vector<typename Level_round::Slot_value>;

  struct Level
  {
    Level(Level_connectivity&& level, std::size_t number_of_slots)
      : connectivity(std::move(level))
      , values(number_of_slots, boost::container::default_init)
    {}

    Level_connectivity connectivity; // cut open
    boost::container::vector<Value> values;
    std::optional<Level_round> round; // refers to the connectivity; none if there are no rounds
    Row_readers readers;
  };

  static std::size_t memory(const Level_connectivity& level)
  {
    const Level_size& size = level.size();
    return sizeof(Index) * (3 * size.halfedges() + size.vertices + size.faces);
  }

  Index number_of_refined_vertices() const { return static_cast<Index>(refined_size().vertices); }

  // \name Control values of slots

  std::vector<Index> take_slots(Control& control)
  {
    const std::vector<Index> set = control.changes();
    if (set.empty()) return {};
    const std::vector<Value> values = values_of_slots(control);
    control.forget_changes();
    auto& stored = levels_.front().values;
    std::vector<Index> changed;
    for (Index s = 0; s < values.size(); ++s) {
      if (set.size() != control.size() && is_same_value<FT>(stored[s], values[s])) continue;
      stored[s] = values[s];
      changed.push_back(s);
    }
    return changed;
  }

  // makes the tangents of the control creases, too
  std::vector<Value> values_of_slots(Control& control)
  {
    if constexpr (Control::has_normals)
      keep_without_fractions<FT>(*whole_control_, creases_, [&](Creases<FT>& others) {
        return values_of_slots(control, control.slots_without_fractions(), others);
      });
    const std::vector<Value> values = values_of_slots(control, control.given_slots(), creases_);
    if constexpr (Control::has_normals) {
      for (Index v = 0; v < whole_control_->number_of_vertices(); ++v)
        if (!control.is_given(v)) control.put_estimate(v, values[v].normal);
      put_mean_normals(values, control);
    }
    return values;
  }
  std::vector<Value> values_of_slots(const Control& control,
                                     const typename Control::Given_slots& given_slots,
                                     Creases<FT>& creases) const
  {
    const Index n = whole_control_->number_of_vertices();
    std::vector<Value> values(creases.number_of_slots);
    for (Index v = 0; v < n; ++v) values[v] = control[v];
    const std::vector<Index> extra = vertices_of_extra_slots(creases, n);
    for (std::size_t i = 0; i < extra.size(); ++i) values[n + i] = control[extra[i]];
    if constexpr (Control::has_normals) {
      std::vector<bool> is_given(values.size(), false);
      for (Index v = 0; v < n; ++v)
        if (const auto* given = control.given_normal(v)) {
          is_given[v] = true;
          values[v].normal = *given;
        }
      for (const Crease_star& star : creases.stars)
        if (star.number_of_wedges > 1) is_given[star.vertex] = false;
      for (std::size_t s = 0; s < values.size(); ++s)
        if (!is_given[s]) values[s].normal = zero_vector<FT, 3>();
      // the normals of wedges, if they are given
      for (Index s = 0; s < given_slots.values.size(); ++s)
        if (control.has_several_normals(s < n ? s : extra[s - n])) {
          values[s].normal = given_slots.values[s].normal;
          values[s].roundness = given_slots.values[s].roundness;
          is_given[s] = true;
        }
      for (Crease_edge<FT>& e : creases.edges) e.tangent_from.fill(zero_vector<FT, 3>());
      if (!given_slots.values.empty())
        make_control_tangents(*whole_control_, creases, values, given_slots.tell_of_tangents,
                              normal_estimate(scheme_) == Control_normal_estimate::coherent);
      estimate_wedges<FT>(*whole_control_, creases, values, is_given, normal_estimate(scheme_));
      for (Index s = 0; s < values.size(); ++s) {
        const Index v = s < n ? s : extra[s - n];
        if (control.has_given_roundness(v)) values[s].roundness = control[v].roundness;
      }
    }
    return values;
  }

  void put_mean_normals(const std::vector<Value>& values, Control& control) const
  {
    Slot_values slot_values;
    for (const Crease_star& star : creases_.stars)
      if (star.number_of_wedges > 1)
        for (Index w = 0; w < star.number_of_wedges; ++w)
          slot_values.emplace_back(star.slot(w), values[star.slot(w)]);
    for_each_crease_vertex<Average>(
      slot_values, whole_control_->number_of_vertices(),
      [&](std::size_t, Index v, const Value& value) { control.put_estimate(v, value.normal); });
  }

  // \name Rounds

  // the sink gets no valid values for vertices on creases: the values of their slots are returned
  Slot_values evaluate_round(Level& level, Sink sink) const
  {
    Level_round& round = *level.round;
    round.read(level.values.data());
    Slot_values on_creases = round.crease_values(this->for_chunks_);
    evaluate_rows(round.round(), 0, round.number_of_vertices(), level.values.data(), {},
                  this->for_chunks_, sink);
    return on_creases;
  }

  // the sink gets what the changed slots reach beside creases, which is put into `changed`; returns what is
  // on creases
  Slot_values evaluate_round_from(Level& level, std::vector<Index>& changed, List_sink sink) const
  {
    Level_round& round = *level.round;
    round.read(level.values.data());
    changed = level.readers(round.round(), level.values.size(), changed);
    if (const auto& others = round.vertices_of_values(); !others.empty()) {
      std::vector<Index> rest;
      std::set_difference(changed.begin(), changed.end(), others.begin(), others.end(),
                          std::back_inserter(rest));
      changed = std::move(rest);
    }
    Slot_values on_creases = round.crease_values(this->for_chunks_);
    evaluate_rows(round.round(), changed.data(), static_cast<Index>(changed.size()),
                  level.values.data(), this->for_chunks_, sink);
    return on_creases;
  }

  // the values of a vertex, which begin at this position
  bool is_as_before(const Slot_values& on_creases, std::size_t first) const
  {
    const Index n = number_of_refined_vertices();
    std::size_t i = first;
    do {
      if (!is_same_value<FT>(on_creases[i].second, last_on_creases_[i].second)) return false;
      ++i;
    } while (i < on_creases.size() && on_creases[i].first >= n);
    return true;
  }

  const Scheme scheme_;      // the masks may refer to it
  Level_creases creases_;    // of the control level
  std::deque<Level> levels_; // keeps its elements where they are
  std::optional<Level_connectivity> whole_control_, whole_last_; // before they were cut open
  Slot_values last_on_creases_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_STORED_ROUNDS_H
