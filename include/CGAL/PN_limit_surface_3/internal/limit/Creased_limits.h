// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_CREASED_LIMITS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_CREASED_LIMITS_H

#include <CGAL/PN_limit_surface_3/internal/limit/Crease_vertex_limit.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The limits at all slots of a level with creases.
//
// Without a crease nearby, the level cut open has the same limits: the next ring of a vertex depends on
// the ring alone, and in it on slots. Vertices on creases are evaluated with their neighbors along the
// crease, darts with their ring, and corners stay. The level is refined about rings that are not settled; if an edge is
// sharp, but not forever, all of it is.
template <class Scheme, class FT, Limit_kinds kinds = Limit_kinds::all>
class Creased_limits
{
public:
  using Index = Level_connectivity::Index;
  using Evaluation = Limit_evaluation<Scheme, FT, kinds>;
  using Value = typename Evaluation::Value;
  using Result = typename Evaluation::Result;
  using Level = typename Evaluation::Level;
  using Numbers = std::vector<Index>;

  Creased_limits(const Scheme& scheme, const Limit_demand& demand, const For_chunks& for_chunks,
                 std::shared_ptr<typename Evaluation::Rules_cache> rules_cache = nullptr)
    : scheme_(scheme)
    , demand_(demand)
    , for_chunks_(for_chunks)
    , evaluation_(scheme, demand, for_chunks, std::move(rules_cache))
    , any_round_((std::max)(101u, facts_of(scheme).first_round))
  {}

  // `level` has the values of the slots; it is cut open meanwhile. The creases get the tangents of the limit. If
  // only some vertices are asked for, which are sorted, the other slots have no results.
  std::vector<Result> operator()(Level& level, Creases<FT>& creases, unsigned next_round,
                                 const Numbers* some = nullptr);

private:
  static constexpr bool is_pn = is_pn_v<Scheme>;
  using Average = Average_of_scheme<Scheme, FT>;
  using Refiner = Level_refiner<Scheme, Average, Creases<FT>>;
  using Vector = Coordinates<FT, 3>;
  using Crease_limit = Crease_vertex_limit<FT, is_pn>;
  using Dart = Dart_rules<Scheme, FT>;

  // open while it lives
  struct Cut
  {
    Cut(Level_connectivity& level, const Creases<FT>& creases)
      : cut(level, creases)
    {}
    ~Cut() { cut.close(); }
    Cut_in_place<FT> cut;
  };

  // \name Where something is sharp, but not forever
  // The slots of the corners about a vertex, from its half-edge on, which its descendants have, too.
  static Numbers slots_about(const Level_connectivity& level, const Corner_slots<FT>& slot_of,
                             Index v)
  {
    Numbers slot_ids;
    for_each_halfedge_to(level, v,
                         [&](Index h) { slot_ids.push_back(level.is_border(h) ? v : slot_of(h)); });
    return slot_ids;
  }

  // refines the whole level until nothing ends any more
  std::vector<Result> after_the_end(const Level& level, const Creases<FT>& creases,
                                    unsigned next_round, const Numbers* some)
  {
    Refiner refiner(scheme_, Level_connectivity(level.level), Creases<FT>(creases),
                    {level.values.begin(), level.values.end()}, for_chunks_, next_round - 1);
    for (; is_anything_ending(refiner.creases()); ++next_round) refiner.refine();
    const Numbers vertices = // old ones keep their numbers
      some != nullptr ? *some : first_indices(level.level.number_of_vertices());
    Level refined{refiner.level(), {refiner.values().begin(), refiner.values().end()}};
    Creases<FT> now = refiner.creases();
    std::vector<std::pair<Index, Index>> spread; // from a slot to a slot that it comes from
    {
      const Corner_slots<FT> old_slots(level.level, creases), new_slots(refined.level, now);
      for (const Index v : vertices) {
        if (level.level.is_isolated(v)) {
          spread.emplace_back(v, v);
          continue;
        }
        const Numbers from = slots_about(refined.level, new_slots, v),
                      to = slots_about(level.level, old_slots, v);
        for (std::size_t i = 0; i < to.size(); ++i) spread.emplace_back(from[i], to[i]);
      }
    }
    const std::vector<Result> limits = (*this)(refined, now, next_round, &vertices);
    std::vector<Result> results(creases.number_of_slots);
    for (const auto& [from, to] : spread) results[to] = limits[from];
    return results;
  }

  // \name Vertices whose limit depends on their ring
  // all that are asked for but crease vertices and corners
  Numbers vertices_of_rings(const Level_connectivity& level, const Creases<FT>& creases) const
  {
    Numbers vertices;
    auto star = creases.stars.begin(); // in the order of the vertices
    for (const Index v : some_ != nullptr ? *some_ : first_indices(level.number_of_vertices())) {
      while (star != creases.stars.end() && star->vertex < v) ++star;
      const bool is_star = star != creases.stars.end() && star->vertex == v;
      if (!is_star || creases.rule(*star) == Vertex_rule::dart) vertices.push_back(v);
    }
    return vertices;
  }
  bool is_asked_for(const Crease_star& star) const
  {
    return some_ == nullptr || std::binary_search(some_->begin(), some_->end(), star.vertex);
  }

  // the limits of the level cut open; returns the positions of the vertices that have to be refined first
  Numbers evaluate_rest(const Level& level, const Creases<FT>& creases, Creases<FT>& limits,
                        const Numbers& vertices, const Numbers& places, unsigned next_round,
                        unsigned depth, std::vector<Result>& results)
  {
    std::vector<char> is_dart(level.level.number_of_vertices(), 0);
    for (const Crease_star& star : creases.stars)
      is_dart[star.vertex] = creases.rule(star) == Vertex_rule::dart;
    Numbers smooth, smooth_positions, rest;
    const bool is_final = next_round >= facts_of(scheme_).first_round;
    const Has_final_rules<Scheme> has_final_rules(scheme_, level.level, is_final);
    for (Index i = 0; i < vertices.size(); ++i) {
      const Index v = vertices[i];
      if (is_dart[v] == 0) {
        smooth.push_back(v);
        smooth_positions.push_back(i);
        continue;
      }
      if (has_final_rules(v))
        evaluate_dart(level, creases, v, limits, places[i], depth, results[places[i]]);
      else {
        evaluation_.require_depth(depth, next_round);
        rest.push_back(i);
      }
    }
    const Numbers unsettled =
      evaluation_.evaluate_settled(level, smooth, next_round, depth, [&](Index i) -> Result& {
        return results[places[smooth_positions[i]]];
      });
    for (const Index i : unsettled) rest.push_back(smooth_positions[i]);
    return rest;
  }

  // \name Vertices on creases
  void evaluate_creases(const Level& level, const Creases<FT>& creases, Creases<FT>& limits,
                        std::vector<Result>& results)
  {
    Crease_curve_weights<FT> weights{FT(0), FT(0)};
    const auto first =
      std::find_if(creases.stars.begin(), creases.stars.end(), [&](const Crease_star& star) {
        return creases.rule(star) == Vertex_rule::crease;
      });
    if (first != creases.stars.end())
      weights = Crease_curve_weights<FT>::of(scheme_, level.level, first->vertex, any_round_);
    const Caller_precision<FT> precision;
    for_chunks_(static_cast<Index>(creases.stars.size()), [&](Index begin, Index end) {
      const typename Caller_precision<FT>::In_this_thread same(precision);
      for (Index i = begin; i < end; ++i) {
        const Crease_star& star = creases.stars[i];
        if (!is_asked_for(star)) continue;
        const Vertex_rule rule = creases.rule(star);
        if (rule == Vertex_rule::crease)
          name_undecided(star,
                         [&] { evaluate_crease(level, creases, star, weights, limits, results); });
        else if (rule == Vertex_rule::corner)
          for (Index w = 0; w < star.number_of_wedges; ++w)
            results[star.slot(w)].value = level.values[star.slot(w)];
      }
    });
  }

  template <class Function>
  static void name_undecided(const Crease_star& star, const Function& f)
  {
    internal::name_undecided<FT>(
      f, [&] { return "the limit at vertex " + std::to_string(star.vertex) + " on a crease"; });
  }

  void evaluate_crease(const Level& level, const Creases<FT>& creases, const Crease_star& star,
                       const Crease_curve_weights<FT>& weights, Creases<FT>& limits,
                       std::vector<Result>& results) const
  {
    const Crease_halfedge &from = creases.end(star, 0), &to = creases.end(star, 1);
    const auto neighbor = [&](const Crease_halfedge& e) {
      return point_of(level.values[level.level.source(creases.halfedge(e))]);
    };
    Crease_limit limit;
    limit.points = {point_of(level.values[star.vertex]), neighbor(from), neighbor(to)};
    limit.tangents = {creases.tangent_from(to), creases.tangent_towards(from),
                      opposite_vector(creases.tangent_towards(to))};
    limit.arrival_tangent = opposite_vector(creases.tangent_from(from));
    Numbers slot_ids;
    if constexpr (is_pn) {
      add_wedge(level, creases, from, to, false, limit, slot_ids);
      add_wedge(level, creases, to, from, true, limit, slot_ids);
    }
    Convergence<FT> steps(demand_, !is_pn, 1. / 16);
    limit.evaluate(weights, steps);
    for (Index w = 0; w < star.number_of_wedges; ++w) {
      Result& result = results[star.slot(w)];
      point_of(result.value) = limit.points[0];
      result.error = steps.error();
      result.depth = steps.depth();
    }
    if constexpr (is_pn)
      for (std::size_t w = 0; w < slot_ids.size(); ++w)
        results[slot_ids[w]].value.normal = limit.normals[w][0];
    limits.tangent_from(from) = opposite_vector(limit.tangents[0]);
    limits.tangent_from(to) = limit.tangents[0];
  }

  // the normals of a linear scheme, which has the rules of a border in a wedge
  void evaluate_normals(const Level& level, const Creases<FT>& creases, unsigned next_round,
                        std::vector<Result>& results)
  {
    Numbers slot_ids;
    for (const Crease_star& star : creases.stars)
      if (is_asked_for(star) && creases.rule(star) == Vertex_rule::crease)
        for (Index w = 0; w < star.number_of_wedges; ++w) slot_ids.push_back(star.slot(w));
    std::vector<Result> of_slots(slot_ids.size());
    evaluation_.evaluate_settled(level, slot_ids, next_round, 0,
                                 [&](Index i) -> Result& { return of_slots[i]; });
    for (std::size_t i = 0; i < slot_ids.size(); ++i) {
      results[slot_ids[i]].surface_normal = of_slots[i].surface_normal;
      results[slot_ids[i]].has_surface_normal = of_slots[i].has_surface_normal;
    }
  }

  // the normals of the wedge that lies behind one end and before the other one, if there is one
  static void add_wedge(const Level& level, const Creases<FT>& creases,
                        const Crease_halfedge& behind, const Crease_halfedge& before,
                        bool is_reversed, [[maybe_unused]] Crease_limit& limit, Numbers& slot_ids)
  {
    const Crease_edge<FT>& first = creases.edge(behind);
    if (!first.has_after(behind.side)) return;
    slot_ids.push_back(first.after[behind.side]);
    std::array<Index, 3> three{slot_ids.back(), creases.far_after(behind),
                               creases.far_before(before)};
    if (is_reversed) std::swap(three[1], three[2]);
    if constexpr (is_pn) {
      typename Crease_limit::Three normals;
      for (std::size_t i = 0; i < 3; ++i) normals[i] = level.values[three[i]].normal;
      limit.normals.push_back(normals);
      const auto roundness = [&](std::size_t i) { return level.values[three[i]].roundness; };
      limit.roundness.push_back({roundness(0), roundness(1), roundness(2)});
    }
  }

  // \name Darts
  void evaluate_dart(const Level& level, const Creases<FT>& creases, Index v, Creases<FT>& limits,
                     Index place, unsigned depth, Result& result)
  {
    const Crease_star &star = *creases.star_at(v), &star_of_limits = *limits.star_at(place);
    const Crease_halfedge& e = creases.end(star, 0);
    Numbers places;
    Vertex_ring::append(level.level, v, 1, places);
    const bool is_first = star.is_border && places[1] == level.level.source(creases.halfedge(e));
    Dart_limit<Scheme, FT> limit(average_of<Average>(scheme_));
    limit.ring = values_of_part(level.values, places);
    limit.tangent = creases.tangent_from(e);
    limit.far_tangent = creases.tangent_towards(e);
    // the differences fall by 1/4 at least, as the square of the ring
    Convergence<FT> steps(demand_, !is_pn, 1. / 4);
    const Dart& dart = rules_of_dart(level, star, is_first);
    name_undecided(star, [&] { result.value = limit.evaluate(dart, steps); });
    result.error = steps.error();
    result.depth = depth + steps.depth();
    limits.tangent_from(limits.end(star_of_limits, 0)) = limit.tangent;
  }

  // is_first: of a border, whether the crease is on its first edge
  const Dart& rules_of_dart(const Level& level, const Crease_star& star, bool is_first)
  {
    const Index valence = level.level.valence(star.vertex);
    auto& dart = darts_[{star.is_border, is_first, valence}];
    if (!dart && star.is_border)
      dart.emplace(evaluation_.rules_of_border(level.level, star.vertex),
                   is_first ? Index(1) : valence);
    else if (!dart) // cut open it has one more
      dart.emplace(scheme_, valence - 1, any_round_);
    return *dart;
  }

  const Scheme& scheme_;
  const Limit_demand& demand_;
  For_chunks for_chunks_;
  Evaluation evaluation_;
  const unsigned any_round_;      // with the rules of all later ones
  const Numbers* some_ = nullptr; // the vertices that are asked for
  // of the border, whether the crease is on its first edge, valence
  std::map<std::tuple<bool, bool, Index>, std::optional<Dart>> darts_;
};

template <class Scheme, class FT, Limit_kinds kinds>
auto Creased_limits<Scheme, FT, kinds>::operator()(Level& level, Creases<FT>& creases,
                                                   unsigned next_round, const Numbers* some)
  -> std::vector<Result>
{
  if constexpr (creases_may_end_v<Scheme>)
    if (is_anything_ending(creases)) return after_the_end(level, creases, next_round, some);
  std::vector<Result> results(creases.number_of_slots);
  Creases<FT> limits = creases;
  some_ = some;
  Numbers rest = vertices_of_rings(level.level, creases);
  {
    const Cut cut(level.level, creases);
    evaluate_creases(level, creases, limits, results);
    if constexpr (!is_pn && has_normals(kinds))
      if (demand_.surface_normals) evaluate_normals(level, creases, next_round, results);
    rest = values_of_part(
      rest, evaluate_rest(level, creases, limits, rest, rest, next_round, 0, results));
  }
  if (!rest.empty())
    evaluation_.refine_about(
      level, creases, rest, rest, next_round,
      [&](Level& refined, const Creases<FT>& refined_creases, const Numbers& here,
          const Numbers& places, unsigned round, unsigned depth) {
        const Cut refined_cut(refined.level, refined_creases);
        return evaluate_rest(refined, refined_creases, limits, here, places, round, depth, results);
      });
  if constexpr (has_normals(kinds))
    if (demand_.surface_normals) {
      const Cut cut(level.level, creases);
      orient_normals(level, results, for_chunks_, some == nullptr || demand_.has_neighbors);
    }
  creases = std::move(limits);
  return results;
}

// What finds the limits at the slots of a level.
template <class Scheme, class FT, class Level_creases, Limit_kinds kinds = Limit_kinds::all>
using Limits_of_level =
  std::conditional_t<are_creases_v<Level_creases>, Creased_limits<Scheme, FT, kinds>,
                     Limit_evaluation<Scheme, FT, kinds>>;

// What the library CGAL::PN_subdivision_3_limits has, see compiled_levels.h: MACRO(EXTERN, scheme, creases) for all schemes of
// faces with four corners, or with three, without creases and with them.
#define CGAL_PN_SUBDIVISION_3_OF_QUADS(MACRO, EXTERN)                                              \
  MACRO(EXTERN, Any_of_quads, No_creases)                                                          \
  MACRO(EXTERN, Any_of_quads, Creases<double>)                                                     \
  MACRO(EXTERN, Linear_of_quads, No_creases)                                                       \
  MACRO(EXTERN, Linear_of_quads, Creases<double>)
#define CGAL_PN_SUBDIVISION_3_OF_TRIANGLES(MACRO, EXTERN)                                          \
  MACRO(EXTERN, Any_of_triangles, No_creases)                                                      \
  MACRO(EXTERN, Any_of_triangles, Creases<double>)                                                 \
  MACRO(EXTERN, Linear_of_triangles, No_creases)                                                   \
  MACRO(EXTERN, Linear_of_triangles, Creases<double>)

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_CREASED_LIMITS_H
