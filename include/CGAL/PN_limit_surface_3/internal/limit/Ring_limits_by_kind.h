// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_LIMITS_BY_KIND_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_LIMITS_BY_KIND_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules_cache.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/creases/Crease_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

// The limits of vertices of several kinds: rings are gathered until there are as many of a kind as are refined at once.
template <class Scheme, class FT, bool points_alone = false>
class Ring_limits_by_kind
{
public:
  using Index = Level_connectivity::Index;
  using Limits = Ring_limits<Scheme, FT, points_alone>;
  using Kind = typename Ring_rules_cache<Scheme, FT>::Kind;

  // what its limit is stored in, and of which kind its ring is
  struct Vertex
  {
    Index v;
    typename Limits::Result* result;
    const Kind* kind;
  };

  explicit Ring_limits_by_kind(const Limit_demand& demand)
    : demand_(demand)
  {}

  // of a vertex whose ring is given by value(place)
  template <class Value_of>
  void add(const Vertex& vertex, bool is_spline, const Value_of& value)
  {
    if (last_ == nullptr || vertex.kind != last_kind_ || is_spline != last_is_spline_) {
      auto& limits = limits_[{vertex.kind, is_spline}];
      if (!limits) limits = std::make_unique<Limits>(*vertex.kind->ring_rules, demand_, is_spline);
      last_ = limits.get();
      last_kind_ = vertex.kind;
      last_is_spline_ = is_spline;
    }
    last_->add(value, *vertex.result);
    if (last_->is_full()) evaluate(*last_, vertex.v);
  }

  // the rest
  void finish()
  {
    for (auto& entry : limits_) entry.second->evaluate();
  }

private:
  // of number types that may not decide a comparison one ring is refined at once
  static void evaluate(Limits& limits, [[maybe_unused]] Index v)
  {
    if constexpr (std::is_floating_point_v<FT>)
      limits.evaluate();
    else
      try {
        limits.evaluate();
      } catch (const Uncertain_conversion_exception&) {
        throw std::domain_error(
          "PN_subdivision_3: the precision of the number type does not decide whether a normal "
          "next to vertex number " +
          std::to_string(v) + " vanishes or is opposite to a neighbor's: use a higher precision");
      }
  }

  const Limit_demand& demand_;
  std::map<std::pair<const Kind*, bool>, std::unique_ptr<Limits>> limits_;
  Limits* last_ = nullptr;
  const Kind* last_kind_ = nullptr;
  bool last_is_spline_ = false;
};

// The weights of the curve that a scheme makes of a border or crease: of a vertex and its neighbors in a
// round, and in the limit. In a round edges are halved, so that the limit mask (x, y, x) satisfies
// x = w y + x/2 with the weight w of a neighbor: it is (1, 4, 1)/6 for the cubic spline.
template <class FT>
struct Crease_curve_weights
{
  FT vertex, limit;

  // on a level that is cut open, of a vertex on its border
  template <class Scheme>
  static Crease_curve_weights of(const Scheme& scheme, const Level_connectivity& level,
                                 Level_connectivity::Index v, unsigned round)
  {
    const Sub_level around(level, {v}, 1);
    const Level_connectivity::Index center = around.centers.front();
    Entry_row<FT> row;
    scheme.template mask<FT>(around.level, round).vertex(center, row);
    Crease_curve_weights result{FT(0), FT(0)};
    for (const auto* e = row.begin(); e != row.end(); ++e)
      if (e->vertex == center) result.vertex += e->weight;
    result.limit = FT(1) / (FT(3) - FT(2) * result.vertex);
    return result;
  }
};

// The limit at a vertex on a crease. The vertex and its neighbors along the crease, with the tangents and the
// normals of the wedges, are refined by themselves.
template <class FT, bool is_pn>
class Crease_vertex_limit
{
public:
  using Vector = Coordinates<FT, 3>;
  // of the vertex, of the neighbor that the crease comes from, and of the one that it goes to
  using Three = std::array<Vector, 3>;

  Three points;
  Three tangents;         // in the direction of travel
  Vector arrival_tangent; // the tangent of the vertex, for the edge that the crease comes on
  boost::container::small_vector<Three, 2> normals;               // of each wedge
  boost::container::small_vector<std::array<FT, 3>, 2> roundness; // of each wedge with a normal

  // becomes the limit at the vertex, which is the first one of each three
  void evaluate(const Crease_curve_weights<FT>& weights, Convergence<FT>& steps)
  {
    const Vector center = points[0];
    if constexpr (std::is_floating_point_v<FT>)
      for (Vector& p : points) add_multiple<FT, 3>(p, FT(-1), center);
    for (;;) {
      const Crease_vertex_limit limit = averages(weights.limit, false);
      if (steps.is_last(limit.points[0])) {
        *this = limit;
        break;
      }
      *this = averages(weights.vertex, true);
    }
    if constexpr (std::is_floating_point_v<FT>) add_multiple<FT, 3>(points[0], FT(1), center);
  }

private:
  using Rule = Crease_average<FT, 3>;
  using Entry = typename Rule::Entry;

  // the values after a round: of the vertex by its weight, of the neighbors if they are asked for
  Crease_vertex_limit averages(const FT& vertex_weight, bool with_neighbors) const
  {
    Crease_vertex_limit next = *this;
    const FT side = (FT(1) - vertex_weight) / FT(2), half = FT(1) / FT(2);
    const std::array<Entry, 3> all{{{side, points[1], tangents[1]},
                                    {side, points[2], tangents[2]},
                                    {vertex_weight, points[0], tangents[0]}}};
    put(all, 0, {1, 2, 0}, next);
    next.arrival_tangent = next.tangents[0];
    if (!with_neighbors) return next;
    const std::array<Entry, 2> arrival{
      {{half, points[1], tangents[1]}, {half, points[0], arrival_tangent}}};
    put(arrival, 1, {1, 0, 0}, next);
    const std::array<Entry, 2> departure{
      {{half, points[0], tangents[0]}, {half, points[2], tangents[2]}}};
    put(departure, 2, {0, 2, 0}, next);
    return next;
  }

  // entry j is that of place[j]
  template <std::size_t n>
  void put(const std::array<Entry, n>& entries, std::size_t at,
           const std::array<std::size_t, 3>& place, Crease_vertex_limit& next) const
  {
    FT largest(roundness.empty() ? 1 : 0);
    for (std::size_t w = 0; w < roundness.size(); ++w) {
      FT& of_wedge = next.roundness[w][at];
      of_wedge = averaged_roundness(entries, [&](std::size_t j) { return roundness[w][place[j]]; });
      largest = w == 0 ? of_wedge : FT((CGAL::max)(largest, of_wedge));
    }
    const Rule rule(entries.data(), entries.data() + n, largest);
    next.points[at] = rule.point();
    next.tangents[at] = rule.tangent();
    if constexpr (is_pn)
      for (std::size_t w = 0; w < normals.size(); ++w)
        next.normals[w][at] =
          rule.normal([&](std::size_t j) -> const Vector& { return normals[w][place[j]]; });
  }
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_LIMITS_BY_KIND_H
