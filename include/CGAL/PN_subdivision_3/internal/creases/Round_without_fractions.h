// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_ROUND_WITHOUT_FRACTIONS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_ROUND_WITHOUT_FRACTIONS_H

#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_round.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/ended_creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The other half of a round with edges of which less than a round is left, 0 < s < 1: the round in which they are smooth.
//
// The result is phi times the result of the round in which these edges are sharp, and 1 - phi times the result of this round,
// normals then unit. The new point of such an edge has phi = s, a vertex on such edges the mean of their s, and any other new
// vertex the least s of such edges at the faces that its row touches: 1 almost everywhere.
template <class Scheme, class Average>
class Round_without_fractions
{
public:
  using Level_round = Crease_round<Scheme, Average, Creases<typename Average::FT>>;
  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  using Slot_value = typename Level_round::Slot_value;

  // `level` is whole; it is copied
  Round_without_fractions(const Scheme& scheme, const Level_connectivity& level,
                          const Creases<FT>& creases, unsigned number)
    : creases_(level, creases)
    , level_(level, size_when_cut(level.size(), creases_.creases))
  {
    level_.set_size(level.size());
    round_.emplace(scheme, level_, creases_.creases, nullptr, number);
    find_shares_on_creases();
    find_shares_of_rows(level);
    find_shares_of_ended(creases);
    for (auto it = share_.begin(); it != share_.end();)
      it = it->second < 1 ? ++it : share_.erase(it);
    const std::vector<Index> all = vertices(), of_values = round_->vertices_of_values();
    std::set_difference(all.begin(), all.end(), of_values.begin(), of_values.end(),
                        std::back_inserter(rows_));
  }

  // the new vertices that are blended, in increasing order
  std::vector<Index> vertices() const
  {
    std::vector<Index> result;
    for (const auto& share : share_) result.push_back(share.first);
    return result;
  }

  // `values` and the tangents of `refined` come from the round in which the edges are sharp
  void blend(const Creases<FT>& creases, const Value* old, Refined_creases<FT>& refined,
             std::vector<Slot_value>& values, const For_chunks& for_chunks)
  {
    const std::vector<Slot_value> smooth = smooth_values(creases, old, for_chunks);
    auto share = share_.end();
    for (Slot_value& value : values) {
      if (value.first < round_->number_of_vertices()) share = share_.find(value.first);
      if (share == share_.end()) continue;
      const auto other = std::lower_bound(smooth.begin(), smooth.end(), value.first,
                                          [](const Slot_value& v, Index s) { return v.first < s; });
      name_undecided(share->first, [&] { mix(value.second, other->second, FT(share->second)); });
    }
    for (const Crease_star& star : refined.creases.stars)
      if ((share = share_.find(star.vertex)) != share_.end())
        name_undecided(star.vertex,
                       [&] { mix_tangents(star, FT(share->second), refined.creases); });
  }

private:
  // \name Shares of the sharp round
  // by the numbers of the new vertices

  void find_shares_on_creases()
  {
    const Creases<FT>& creases = creases_.creases;
    const auto grow = [&](double& share, Index slot) {
      share = (std::min)(share, creases_.reach[slot]);
    };
    const auto grow_by_edge = [&](double& share, const Crease_edge<FT>& e) {
      for (const Index side : {0u, 1u}) {
        if (e.has_after(side)) grow(share, e.after[side]);
        if (e.has_before(side)) grow(share, e.before[side]);
      }
    };
    for (const Crease_star& star : creases.stars) {
      double& share = share_.emplace(star.vertex, 1).first->second;
      const Vertex_rule rule = creases.rule(star);
      for (Index w = 0; w < star.number_of_wedges; ++w) grow(share, star.slot(w));
      if (rule == Vertex_rule::crease)
        for (Index i = 0; i < 2; ++i) grow_by_edge(share, creases.edge(creases.end(star, i)));
      else if (rule == Vertex_rule::dart)
        round_->for_each_smooth_entry(star, [&](Index slot) { grow(share, slot); });
    }
    for (const Crease_edge<FT>& e : creases.edges)
      grow_by_edge(share_.emplace(round_->round().host().vertex_of_edge(e.edge), 1).first->second,
                   e);
  }

  void find_shares_of_rows(const Level_connectivity& level)
  {
    std::vector<bool> is_near(level.number_of_vertices(), false);
    const std::vector<Index> extra =
      vertices_of_extra_slots(creases_.creases, level.number_of_vertices());
    for (std::size_t s = 0; s < creases_.reach.size(); ++s)
      if (creases_.reach[s] < 1) is_near[s < is_near.size() ? s : extra[s - is_near.size()]] = true;
    constexpr int rings = 2; // a row reads no vertex farther off
    for (int i = 0; i < rings; ++i) grow_by_ring(level, is_near);
    Stencil_block<FT> buffer;
    const auto add = [&](Index v) {
      if (share_.count(v) != 0) return;
      double share = 1;
      round_->round().for_each_entry(
        v, buffer, [&](Index slot) { share = (std::min)(share, creases_.reach[slot]); });
      if (share < 1) share_.emplace(v, share);
    };
    const auto& host = round_->round().host();
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      if (is_near[v]) add(v);
    for (Index e = 0; e < level.number_of_edges(); ++e)
      if (is_near[level.target(2 * e)] || is_near[level.source(2 * e)]) add(host.vertex_of_edge(e));
    if constexpr (Scheme::Host::refined_degree == 4)
      for (Index f = 0; f < level.number_of_faces(); ++f)
        if (is_near[level.target(level.halfedge_of_face(f))]) add(host.vertex_of_face(f));
  }

  static void grow_by_ring(const Level_connectivity& level, std::vector<bool>& is_near)
  {
    const std::vector<bool> old = is_near;
    for (Index f = 0; f < level.number_of_faces(); ++f) {
      bool is_any = false;
      const auto halfedges = halfedges_around_face(level, level.halfedge_of_face(f));
      for (const Index h : halfedges) is_any = is_any || old[level.target(h)];
      if (is_any)
        for (const Index h : halfedges) is_near[level.target(h)] = true;
    }
  }

  void find_shares_of_ended(const Creases<FT>& creases)
  {
    for (const Crease_star& star : creases.stars) {
      const double share = mean_sharpness(creases, star, is_fraction);
      if (share < 1) share_[star.vertex] = share;
    }
    for (const Crease_edge<FT>& e : creases.edges)
      if (is_fraction(e.sharpness))
        share_[round_->round().host().vertex_of_edge(e.edge)] = e.sharpness;
  }

  // \name Values
  // by their slots
  std::vector<Slot_value> smooth_values(const Creases<FT>& creases, const Value* old,
                                        const For_chunks& for_chunks)
  {
    std::vector<Value> values;
    if (const auto& without = creases.without_fractions) {
      values.assign(without->values.begin(), without->values.end());
      for (std::size_t i = 0; i < creases_.creases.edges.size(); ++i)
        creases_.creases.edges[i].tangent_from = without->creases.edges[i].tangent_from;
    } else {
      creases_.take_tangents(creases);
      name_undecided(Level_connectivity::null, [&] {
        values = creases_.template merged<Value>(creases, [&](Index slot) { return old[slot]; });
      });
    }
    round_->read(values.data());
    std::vector<Slot_value> result = round_->crease_values(for_chunks);
    const std::vector<Value> of_rows =
      values_of_rows(round_->round(), rows_, values.data(), for_chunks);
    for (std::size_t i = 0; i < rows_.size(); ++i) result.emplace_back(rows_[i], of_rows[i]);
    std::sort(result.begin(), result.end(),
              [](const Slot_value& a, const Slot_value& b) { return a.first < b.first; });
    return result;
  }

  static void mix(Value& value, const Value& other, const FT& share)
  {
    value.point = mixed<FT>(value.point, other.point, share);
    value.normal = unit_or_zero(mixed<FT>(value.normal, other.normal, share), FT(1));
    value.roundness = share * value.roundness + (FT(1) - share) * other.roundness;
  }

  void mix_tangents(const Crease_star& star, const FT& share, Creases<FT>& refined) const
  {
    const Creases<FT>& smooth = round_->refined().creases;
    for (const Crease_halfedge& e : refined.ends_of(star)) {
      Coordinates<FT, 3>& t = refined.tangent_from(e);
      t = unit_or_zero(mixed<FT>(t, smooth.tangent_from(e), share), FT(1));
    }
  }

  template <class Function>
  static void name_undecided(Index vertex, const Function& f)
  {
    internal::name_undecided<FT>(f, [&] {
      return vertex == Level_connectivity::null
               ? std::string("whether the normals of wedges that are joined cancel")
               : "the normal of vertex " + std::to_string(vertex) + " where a crease ends";
    });
  }

  Creases_without_fractions<FT> creases_;
  Level_connectivity level_; // cut open
  std::optional<Level_round> round_;
  std::map<Index, double> share_;
  std::vector<Index> rows_; // blended vertices whose values in round_ come from their rows
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_ROUND_WITHOUT_FRACTIONS_H
