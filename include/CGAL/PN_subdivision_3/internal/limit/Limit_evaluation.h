// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_EVALUATION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_EVALUATION_H

#include <CGAL/PN_subdivision_3/internal/limit/Limit_classes.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_neighborhood.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_tower.h>
#include <CGAL/PN_subdivision_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Caller_precision.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Round.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A level with its values.
template <class Value>
struct Valued_level
{
  Level_connectivity level;
  std::vector<Value> values;
};

// The limits at vertices of a level of a scheme that keeps its vertices. Where the neighborhood of a
// vertex is not settled yet, the faces around all such vertices are cut out and refined until it is.
template <class Scheme, class FT>
class Limit_evaluation
{
public:
  using Index = Level_connectivity::Index;
  using Tower = Limit_tower<Scheme, FT>;
  using Value = typename Tower::Value;
  using Stored_value = typename Tower::Stored_value;
  using Result = typename Tower::Result;
  using Level = Valued_level<Value>;

  Limit_evaluation(const Scheme& scheme, const Limit_demand& demand, const For_chunks& for_chunks)
    : scheme_(scheme)
    , demand_(demand)
    , for_chunks_(for_chunks)
    , classes_(scheme)
  {}

  // of all vertices, in the round that is next
  std::vector<Result> operator()(const Level& level, unsigned next_round)
  {
    std::vector<Index> vertices(level.level.number_of_vertices());
    std::iota(vertices.begin(), vertices.end(), Index(0));
    std::vector<Result> results(vertices.size());
    evaluate(level, vertices, next_round, 0, results.data());
    return results;
  }

private:
  using Average = typename Tower::Average;
  using One_round = Round<Scheme, Average>;
  using Kind = typename Limit_classes<Scheme, FT>::Kind;
  using Neighborhood = Limit_neighborhood<Scheme>;

  // after so many rounds only a scheme of other rules than the built-in ones is not settled
  static constexpr unsigned most_rounds = 6;

  // result i is that of vertices[i]
  void evaluate(const Level& level, const std::vector<Index>& vertices, unsigned next_round,
                unsigned depth, Result* results)
  {
    const auto n = static_cast<Index>(vertices.size());
    const unsigned first_final_round = First_tuned_round<Scheme>::of(scheme_);
    const Settled_neighborhood<Scheme> is_settled(level.level, next_round >= first_final_round);
    std::vector<const Kind*> kind(n, nullptr);
    std::vector<char> state(n);
    for_chunks_(n, [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i)
        state[i] = level.level.is_isolated(vertices[i]) ? 'i' : is_settled(vertices[i]) ? 's' : 'u';
    });
    std::vector<Index> unsettled; // positions
    for (Index i = 0; i < n; ++i) {
      results[i].depth = depth;
      if (state[i] == 's')
        kind[i] = &classes_.at(level.level, vertices[i]);
      else if (state[i] == 'i')
        results[i].value = level.values[vertices[i]];
      else
        unsettled.push_back(i);
    }
    const Caller_precision<FT> precision;
    for_chunks_(n, [&](Index begin, Index end) {
      const typename Caller_precision<FT>::In_this_thread same(precision);
      run_towers(level, vertices, kind, begin, end, results);
    });
    if (unsettled.empty()) return;
    if (depth == most_rounds && next_round < first_final_round)
      throw std::invalid_argument(
        "PN_subdivision_3: the first round of the rules of the scheme is " +
        std::to_string(first_final_round) + ", but no limit is sought beyond round " +
        std::to_string(next_round - 1) + ", which is " + std::to_string(most_rounds) +
        " rounds after the mesh: subdivide it first, or take an earlier first round");
    if (depth == most_rounds)
      throw std::invalid_argument("PN_subdivision_3: the scheme does not settle about its vertices "
                                  "within " +
                                  std::to_string(most_rounds) + " rounds: it has no limit masks");
    refine(level, vertices, unsettled, next_round, depth, results);
  }

  void run_towers(const Level& level, const std::vector<Index>& vertices,
                  const std::vector<const Kind*>& kind, Index begin, Index end,
                  Result* results) const
  {
    std::map<std::pair<const Kind*, bool>, std::unique_ptr<Tower>> towers;
    std::vector<Index> ring;
    const Kind* last_kind = nullptr;
    bool last_is_spline = false;
    Tower* tower = nullptr;
    for (Index i = begin; i < end; ++i) {
      if (kind[i] == nullptr) continue;
      const Index v = vertices[i];
      const bool is_spline = is_regular_spline(level.level, v);
      if (tower == nullptr || kind[i] != last_kind || is_spline != last_is_spline) {
        auto& slot = towers[{kind[i], is_spline}];
        if (!slot) slot = std::make_unique<Tower>(*kind[i]->ring_class, demand_, is_spline);
        tower = slot.get();
        last_kind = kind[i];
        last_is_spline = is_spline;
      }
      ring.clear();
      Limit_classes<Scheme, FT>::append_ring(level.level, v, *kind[i], ring);
      tower->add([&](std::size_t p) -> const Value& { return level.values[ring[p]]; }, results[i]);
      if (tower->is_full()) evaluate_tower(*tower, v);
    }
    for (auto& entry : towers) entry.second->evaluate();
  }

  // number types that may not decide a comparison have one vertex in a tower
  static void evaluate_tower(Tower& tower, [[maybe_unused]] Index v)
  {
    if constexpr (std::is_floating_point_v<FT>)
      tower.evaluate();
    else
      try {
        tower.evaluate();
      } catch (const Uncertain_conversion_exception&) {
        throw std::domain_error(
          "PN_subdivision_3: the precision of the number type does not decide whether a normal "
          "next to vertex number " +
          std::to_string(v) + " vanishes or is opposite to a neighbor's: use a higher precision");
      }
  }

  // curvature is asked of the jet of a spline where all around is regular
  bool is_regular_spline(const Level_connectivity& level, Index v) const
  {
    if (!demand_.curvatures || !Neighborhood::is_spline || level.is_border_vertex(v)) return false;
    return level.valence(v) == Settled_neighborhood<Scheme>::regular_valence;
  }

  void refine(const Level& level, const std::vector<Index>& vertices,
              const std::vector<Index>& positions, unsigned next_round, unsigned depth,
              Result* results)
  {
    std::vector<Index> centers;
    for (const Index i : positions) centers.push_back(vertices[i]);
    const Level refined = refined_about(level, centers, next_round);
    std::vector<Result> fine(centers.size());
    evaluate(refined, centers, next_round + 1, depth + 1, fine.data());
    for (std::size_t k = 0; k < positions.size(); ++k) results[positions[k]] = fine[k];
  }

  // the next level; `vertices` are given, and come back, as their numbers there
  Level refined_about(const Level& level, std::vector<Index>& vertices, unsigned round) const
  {
    if constexpr (Neighborhood::cut_rings == (std::numeric_limits<unsigned>::max)())
      return refined(level.level, stored(level.values), round);
    else {
      Sub_level cut(level.level, vertices, Neighborhood::cut_rings);
      std::vector<Stored_value> values;
      values.reserve(cut.origin().size());
      for (const Index v : cut.origin()) values.emplace_back(level.values[v]);
      vertices = cut.centers();
      return refined(cut.level(), values, round);
    }
  }

  template <class Values>
  static std::vector<Stored_value> stored(const Values& values)
  {
    return std::vector<Stored_value>(values.begin(), values.end());
  }

  Level refined(const Level_connectivity& level, const std::vector<Stored_value>& values,
                unsigned number) const
  {
    const One_round round(scheme_, level, number);
    Level result;
    result.level = Level_connectivity(round.refined_size());
    result.level.set_uniform_degree(Scheme::Host::refined_degree);
    round.host().connect(result.level, for_chunks_);
    result.values.resize(round.refined_size().vertices);
    const auto transfers = round.transfers(values.data(), for_chunks_);
    const Caller_precision<FT> precision;
    for_chunks_(result.level.number_of_vertices(), [&](Index begin, Index end) {
      const typename Caller_precision<FT>::In_this_thread same(precision);
      round.evaluate(
        begin, end, values.data(), transfers, [&](Index v, const Value* refined, Index n) {
          std::copy(refined, refined + n, result.values.begin() + static_cast<std::ptrdiff_t>(v));
        });
    });
    return result;
  }

  const Scheme& scheme_;
  const Limit_demand& demand_;
  For_chunks for_chunks_;
  Limit_classes<Scheme, FT> classes_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_EVALUATION_H
