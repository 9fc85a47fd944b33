// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_EVALUATION_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_EVALUATION_H

#include <CGAL/PN_limit_surface_3/internal/limit/Ring_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_planes.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules_cache.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// A level with its values.
template <class Value>
struct Valued_level
{
  Level_connectivity level;
  std::vector<Value> values;
};

// the level that a round makes
template <class Plain_round, class Value>
Valued_level<Value> level_of_round(const Plain_round& round, const std::vector<Value>& old,
                                   const For_chunks& for_chunks)
{
  using Index = Level_connectivity::Index;
  Valued_level<Value> result{child_level(round, for_chunks),
                             std::vector<Value>(round.refined_size().vertices)};
  evaluate_rows(round, 0, result.level.number_of_vertices(), old.data(),
                round.transfers(old.data(), for_chunks), for_chunks,
                [&](Index first, const Value* values, Index n) {
                  std::copy(values, values + n,
                            result.values.begin() + static_cast<std::ptrdiff_t>(first));
                });
  return result;
}

// The limits at vertices of a level of a scheme that keeps its vertices. What is defined behind the class may be compiled once,
// see limits_at_slots.h. Where the neighborhood of a
// vertex is not settled yet but will be after one round, the round makes its ring and nothing else;
// the faces around all other such vertices are cut out and refined until it is.
template <class Scheme, class FT, Limit_kinds kinds = Limit_kinds::all>
class Limit_evaluation
{
public:
  using Index = Level_connectivity::Index;
  using Limits_of_rings = Ring_limits<Scheme, FT, kinds>;
  using Value = typename Limits_of_rings::Value;
  using Result = typename Limits_of_rings::Result;
  using Level = Valued_level<Value>;
  using Rules_cache = Ring_rules_cache<Scheme, FT>;
  using Result_of = Function_ref<Result&(Index)>;
  using Numbers = std::vector<Index>;

  // `rules_cache` may be shared with other evaluations of the scheme
  Limit_evaluation(const Scheme& scheme, const Limit_demand& demand, const For_chunks& for_chunks,
                   std::shared_ptr<Rules_cache> rules_cache = nullptr)
    : scheme_(scheme)
    , neighborhood_(facts_of(scheme).limit_neighborhood)
    , demand_(demand)
    , for_chunks_(for_chunks)
    , rules_cache_(rules_cache ? std::move(rules_cache) : std::make_shared<Rules_cache>(scheme))
  {}

  // the limits of all vertices, by the rules of the next round, or of some vertices, which keep their places among all
  std::vector<Result> operator()(const Level& level, const No_creases& none, unsigned next_round,
                                 const Numbers* some = nullptr) const;

  // Sets result_of(i), of vertices[i], where the neighborhood is settled, or will be after one round; returns the
  // positions of the other vertices. A level that is cut open along creases may be given, without vertices on creases.
  Numbers evaluate_settled(const Level& level, const Numbers& vertices, unsigned next_round,
                           unsigned depth, Result_of result_of) const;

  // called after `depth` rounds about vertices that are not settled
  void require_depth(unsigned depth, unsigned next_round) const;

  // Refines the level about some vertices only, and then about those that are still left, whose positions
  // evaluate(level, creases, vertices, places, next round, depth) returns; `places` are those of the vertices' results.
  template <class Level_creases, class Evaluate>
  void refine_about(const Level& level, const Level_creases& creases, const Numbers& vertices,
                    Numbers places, unsigned next_round, const Evaluate& evaluate) const
  {
    Part<Level_creases> part = part_about(level, creases, vertices);
    for (unsigned depth = 1;; ++depth) {
      Level_refiner<Scheme, Average, Level_creases> refiner(
        scheme_, std::move(part.level), std::move(part.creases),
        {part.values.begin(), part.values.end()}, for_chunks_, next_round - 1);
      refiner.refine(); // old vertices keep their numbers
      ++next_round;
      Level refined{refiner.take_level(), {refiner.values().begin(), refiner.values().end()}};
      const Numbers here = std::move(part.centers);
      const Numbers rest = evaluate(refined, refiner.creases(), here, places, next_round, depth);
      if (rest.empty()) return;
      places = values_of_part(places, rest);
      part = part_about(refined, refiner.creases(), values_of_part(here, rest));
    }
  }

  // what the rings of a border vertex have in common, in a round with the rules of all later rounds
  const typename Rules_cache::Rules& rules_of_border(const Level_connectivity& level, Index v) const
  {
    return *rules_cache_->at(level, v, (std::max)(101u, facts_of(scheme_).first_round)).ring_rules;
  }

private:
  using Average = typename Limits_of_rings::Average;
  using Plain_round = Round<Scheme, Average>;

  using Limits = Ring_limits_by_kind<Scheme, FT, kinds>;
  using Rings = Gathered_rings<Value, typename Limits::Vertex>;
  using Vertices = std::vector<typename Limits::Vertex>;

  enum class Vertex_state : char {
    evaluated,
    settled_then,
    unsettled
  }; // then: after the next round

  // after so many rounds only a scheme of other rules than the built-in ones is not settled
  static constexpr unsigned most_rounds = 6;
  // rings of the next round that are made at once
  static constexpr Index batch = 128;

  // calls f() for ranges [begin, end) of [0, n), each with gathered rings of its own
  template <class Function>
  void with_limits(std::size_t n, const Function& f) const
  {
    const Caller_precision<FT> precision;
    for_chunks_(static_cast<Index>(n), [&](Index begin, Index end) {
      const typename Caller_precision<FT>::In_this_thread same(precision);
      Limits limits(demand_);
      f(limits, begin, end);
      limits.finish();
    });
  }

  void put_rings(const Level_connectivity& level, Rings& rings, Limits& limits) const
  {
    rings.take([&](const typename Limits::Vertex& vertex, const auto& value) {
      limits.add(vertex, is_regular_spline(level, vertex.v), value);
    });
  }

  void evaluate_in_next_ring(const Level& level, const Vertices& vertices, unsigned number) const
  {
    if constexpr (Has_final_rules<Scheme>::may_have_next_ring) {
      const Plain_round round(scheme_, level.level, number);
      with_limits(vertices.size(), [&](Limits& limits, Index begin, Index end) {
        std::vector<Index> rings;
        std::vector<Value> values;
        for (Index first = begin; first < end; first += batch) {
          const Index last = (std::min)(end, first + batch);
          rings.clear();
          for (Index i = first; i < last; ++i)
            Vertex_ring::append_next(level.level, round.host(), vertices[i].v, rings);
          values.resize(rings.size());
          round.evaluate(rings.data(), rings.data() + rings.size(), level.values.data(),
                         [&](const Index* at, const Value* refined, Index n) {
                           std::copy(refined, refined + n, values.begin() + (at - rings.data()));
                         });
          const Value* ring = values.data();
          for (Index i = first; i < last; ++i) {
            ++vertices[i].result->depth;
            limits.add(vertices[i], is_regular_spline(level.level, vertices[i].v),
                       [&](std::size_t p) -> const Value& { return ring[p]; });
            ring += vertices[i].kind->ring_rules->size();
          }
        }
      });
    }
  }

  // curvature is asked of the jet of a spline where all around is regular
  bool is_regular_spline(const Level_connectivity& level, Index v) const
  {
    if (!demand_.curvatures || !neighborhood_.is_spline || level.is_border_vertex(v)) return false;
    return level.valence(v) == Has_final_rules<Scheme>::regular_valence;
  }

  template <class Level_creases>
  struct Part
  {
    Level_connectivity level;
    Level_creases creases;
    std::vector<Value> values;
    Numbers centers;
  };
  // A part of a level that is not cut open. The rim has the rules of a smooth border, and sqrt(3) may refine it as one: what is
  // read ends before the new vertices beside it. A vertex has the same rows whichever vertices are asked for.
  template <class Level_creases>
  Part<Level_creases> part_about(const Level& level, const Level_creases& creases,
                                 const Numbers& vertices) const
  {
    Sub_level cut(level.level, vertices, cut_rings(scheme_, creases), Sub_level::Keeps::walks);
    auto [of_part, origins] = cut.creases_and_slots(level.level, creases);
    return {std::move(cut.level), std::move(of_part), values_of_part(level.values, origins),
            std::move(cut.centers)};
  }

  const Scheme& scheme_;
  const Limit_neighborhood neighborhood_;
  const Limit_demand& demand_;
  For_chunks for_chunks_;
  std::shared_ptr<Rules_cache> rules_cache_;
};

template <class Scheme, class FT, Limit_kinds kinds>
auto Limit_evaluation<Scheme, FT, kinds>::operator()(const Level& level, const No_creases& none,
                                                     unsigned next_round, const Numbers* some) const
  -> std::vector<Result>
{
  std::vector<Result> results(level.level.number_of_vertices());
  Numbers all;
  if (some == nullptr) {
    all = first_indices(results.size());
    some = &all;
  }
  const auto evaluate = [&](const Level& part, const No_creases&, const Numbers& vertices,
                            const Numbers& places, unsigned round, unsigned depth) {
    return evaluate_settled(part, vertices, round, depth,
                            [&](Index i) -> Result& { return results[places[i]]; });
  };
  const Numbers rest = values_of_part(*some, evaluate(level, none, *some, *some, next_round, 0));
  if (!rest.empty()) refine_about(level, none, rest, rest, next_round, evaluate);
  // where points are not asked for, rings have oriented them
  if constexpr (has_normals(kinds))
    if (demand_.surface_normals && demand_.points)
      orient_normals(level, results, for_chunks_, some == &all || demand_.has_neighbors);
  return results;
}

template <class Scheme, class FT, Limit_kinds kinds>
auto Limit_evaluation<Scheme, FT, kinds>::evaluate_settled(const Level& level,
                                                           const std::vector<Index>& vertices,
                                                           unsigned next_round, unsigned depth,
                                                           Result_of result_of) const -> Numbers
{
  const unsigned first_final_round = facts_of(scheme_).first_round;
  const Has_final_rules<Scheme> has_final_rules(scheme_, level.level,
                                                next_round >= first_final_round);
  const bool keeps_points =
    neighborhood_.keeps_points &&
    !(neighborhood_.has_tangent_planes && (demand_.surface_normals || demand_.curvatures));
  const bool is_final_then = next_round + 1 >= first_final_round;
  std::vector<Vertex_state> states(vertices.size());
  // all about a vertex in one go: what is read of the level is at hand then
  with_limits(vertices.size(), [&](Limits& limits, Index begin, Index end) {
    typename Rules_cache::Recent kind_of(*rules_cache_, level.level, next_round);
    Rings rings(level.values);
    std::array<Index, most_at_once> valences;
    for (Index i = begin; i < end; ++i) {
      const std::size_t in_part = (i - begin) % most_at_once;
      if (in_part == 0)
        find_valences(level.level, &vertices[i], (std::min<std::size_t>)(end - i, most_at_once),
                      valences.data());
      const Index v = vertices[i];
      Result& result = result_of(i);
      result.depth = depth;
      if (valences[in_part] == 0 || keeps_points)
        result.value = level.values[v];
      else if (has_final_rules(v)) {
        const auto* kind = &kind_of(v, valences[in_part]);
        rings.add({v, &result, kind}, [&](std::vector<Index>& ring) {
          Vertex_ring::append(level.level, v, kind->rings, ring);
        });
        if (rings.is_full()) put_rings(level.level, rings, limits);
      } else
        states[i] = is_final_then && has_final_rules.in_next_ring(v) ? Vertex_state::settled_then
                                                                     : Vertex_state::unsettled;
    }
    put_rings(level.level, rings, limits);
  });
  Vertices in_next_ring;
  std::vector<Index> unsettled;
  typename Rules_cache::Recent kind_of(*rules_cache_, level.level, next_round + 1);
  for (Index i = 0; i < vertices.size(); ++i)
    if (states[i] == Vertex_state::settled_then)
      in_next_ring.push_back(
        {vertices[i], &result_of(i), &kind_of(vertices[i], level.level.valence(vertices[i]))});
    else if (states[i] == Vertex_state::unsettled)
      unsettled.push_back(i);
  if (!in_next_ring.empty()) evaluate_in_next_ring(level, in_next_ring, next_round);
  if (!unsettled.empty()) require_depth(depth, next_round);
  return unsettled;
}

template <class Scheme, class FT, Limit_kinds kinds>
auto Limit_evaluation<Scheme, FT, kinds>::require_depth(unsigned depth, unsigned next_round) const
  -> void
{
  const unsigned first_final_round = facts_of(scheme_).first_round;
  if (depth < most_rounds) return;
  if (next_round < first_final_round)
    throw std::invalid_argument(
      "PN_subdivision_3: the first round of the rules of the scheme is " +
      std::to_string(first_final_round) + ", but no limit is sought beyond round " +
      std::to_string(next_round - 1) + ", which is " + std::to_string(most_rounds) +
      " rounds after the mesh: subdivide it first, or take an earlier first round");
  throw std::invalid_argument("PN_subdivision_3: the scheme does not settle about its vertices "
                              "within " +
                              std::to_string(most_rounds) + " rounds: it has no limit masks");
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMIT_EVALUATION_H
