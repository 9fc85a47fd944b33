// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_CREASE_VERTEX_LIMIT_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_CREASE_VERTEX_LIMIT_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_weights.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_eigenvectors.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules_cache.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/creases/Crease_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The weights of the curve that a scheme makes of a border or crease: of a vertex and its neighbors in a
// round, and in the limit. In a round edges are halved, so that the limit mask (x, y, x) satisfies
// x = w y + x/2 with the weight w of a neighbor: it is (1, 4, 1)/6 for the cubic spline.
template <class FT>
struct Crease_curve_weights
{
  FT vertex, limit;

  // the weights of a vertex on the border of a level that is cut open
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

  // entry j belongs to place[j]
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

// What darts of one valence share: the rows of their ring, which is cut open along the crease, and the limit
// mask. Places are those of Vertex_ring.
template <class Scheme, class FT>
class Dart_rules
{
public:
  using Index = Level_connectivity::Index;

  struct Weights
  {
    Ring_matrix<FT> rows;
    Ring_row<FT> limit;
  };

  // the rules of an interior vertex in a round with the rules of all later rounds
  Dart_rules(const Scheme& scheme, Index valence, unsigned round)
    : crease_places_{1, valence + 1}
  {
    const auto mask_of = [&](auto number, const Level_connectivity& level) {
      return scheme.template mask<decltype(number)>(level, round);
    };
    points_ = weights(mask_of, valence, round);
    if constexpr (Has_normal_mask<Scheme>::value) {
      const auto normal_mask_of = [&](auto number, const Level_connectivity& level) {
        return scheme.template normal_mask<decltype(number)>(level, round);
      };
      if (facts_of(scheme).has_normal_mask) normals_ = weights(normal_mask_of, valence, round);
    }
  }
  // the rules of a vertex on a border that is a crease on one side, by the ring class of a plain border vertex
  Dart_rules(const Ring_rules<Scheme, FT>& border, Index crease_place)
    : crease_places_{crease_place}
    , points_{border.matrix(), border.limit_row()}
  {
    if (border.has_own_normals())
      normals_ = Weights{border.normal_matrix(), border.normal_limit_row()};
  }

  const std::vector<Index>& crease_places() const { return crease_places_; }
  const Weights& points() const { return points_; }
  // null: they are refined by the rules of the points
  const Weights* normals() const { return normals_ ? &*normals_ : nullptr; }

private:
  template <class Mask_of>
  static Weights weights(const Mask_of& mask_of, Index valence, unsigned round)
  {
    using Real = Ring_eigenvectors::Real;
    const auto matrix = dart_matrix<FT>(mask_of, valence, round);
    const auto real_matrix = dart_matrix<Real>(mask_of, valence, round);
    const Ring_eigenvectors masks(real_matrix, Ring_layout());
    if (masks.limit().empty()) throw std::invalid_argument(no_mask(valence));
    return {matrix, limit_weights<FT>(masks.limit(), matrix)};
  }
  static std::string no_mask(Index valence)
  {
    return "PN_subdivision_3: the scheme has no limit mask about a vertex of valence " +
           std::to_string(valence) + " where a crease ends";
  }

  // The matrix of the points, which are the same on both sides of the crease: of a wheel that is cut open for a round, but the vertex
  // itself has the smooth rule, in which each side has half of the neighbor on the crease.
  template <class Number, class Mask_of>
  static Ring_matrix<Number> dart_matrix(const Mask_of& mask_of, Index valence, unsigned round)
  {
    using Host = typename Scheme::Host;
    Level_connectivity whole = wheel(valence, Host::refined_degree),
                       open = wheel(valence, Host::refined_degree, true);
    for (Level_connectivity* level : {&whole, &open}) level->set_counted_valences({{0, valence}});
    const Host host(open, round);
    Ring_pair rings;
    Vertex_ring::append(open, 0, 1, rings.ring);
    Vertex_ring::append_next(open, host, 0, rings.next_ring);
    auto matrix = ring_matrix<Number>(host, mask_of(Number(), open), rings);
    if (!matrix) throw std::invalid_argument(no_mask(valence));

    Stencil_block<Number> row;
    mask_of(Number(), whole).vertex(0, row.row());
    row.close_row();
    matrix->front().clear();
    const auto add = [&](Index vertex, const Number& weight) {
      const auto place = std::find(rings.ring.begin(), rings.ring.end(), vertex);
      if (place == rings.ring.end()) throw std::invalid_argument(no_mask(valence));
      matrix->front().push_back({static_cast<std::uint32_t>(place - rings.ring.begin()), weight});
    };
    const Index on_crease[] = {1, open.number_of_vertices() - 1};
    for (const auto* e = row.begin(0); e != row.end(0); ++e)
      if (e->vertex != on_crease[0])
        add(e->vertex, e->weight);
      else
        for (const Index v : on_crease) add(v, Number(e->weight / Number(2)));
    return *matrix;
  }

  std::vector<Index> crease_places_; // of the slots of the neighbor on the crease
  Weights points_;
  std::optional<Weights> normals_;
};

// The limit at a vertex where a crease ends. Its ring is refined by itself: on the crease by the crease
// average, elsewhere by the rows of the class.
template <class Scheme, class FT>
class Dart_limit
{
public:
  using Rules_of_dart = Dart_rules<Scheme, FT>;
  using Average = Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Vector = Coordinates<FT, 3>;

  explicit Dart_limit(const Average& average)
    : average_(average)
  {}

  std::vector<Value> ring;
  Vector tangent;     // from the vertex along the crease
  Vector far_tangent; // from its neighbor

  // returns the limit of the value; the tangent becomes its limit
  Value evaluate(const Rules_of_dart& dart, Convergence<FT>& steps)
  {
    const Vector center = point_of(ring.front());
    if constexpr (std::is_floating_point_v<FT>)
      for (Value& v : ring) add_multiple<FT, 3>(point_of(v), FT(-1), center);
    for (;;) {
      Value limit =
        average(dart.points().limit, dart.normals() != nullptr ? &dart.normals()->limit : nullptr);
      if (steps.is_last(point_of(limit))) {
        turn_tangent(limit);
        if constexpr (std::is_floating_point_v<FT>)
          add_multiple<FT, 3>(point_of(limit), FT(1), center);
        return limit;
      }
      refine(dart);
    }
  }

private:
  static constexpr bool is_pn = is_pn_v<Scheme>;
  using Rule = Crease_average<FT, 3>;
  using Entry = typename Rule::Entry;
  using Row = Ring_row<FT>;

  // without a row of their own the normals are averaged as the points
  Value average(const Row& row, [[maybe_unused]] const Row* normal_row) const
  {
    const auto* const begin = row.data();
    if constexpr (Has_normal_mask<Scheme>::value)
      if (normal_row != nullptr)
        return average_(begin, begin + row.size(), normal_row->data(),
                        normal_row->data() + normal_row->size(), ring.data());
    return average_(begin, begin + row.size(), ring.data());
  }

  void refine(const Rules_of_dart& dart)
  {
    std::vector<Value> next;
    for (std::size_t p = 0; p < ring.size(); ++p)
      next.push_back(average(dart.points().rows[p],
                             dart.normals() != nullptr ? &dart.normals()->rows[p] : nullptr));
    const FT half = FT(1) / FT(2);
    const Vector onwards = opposite_vector(far_tangent);
    const std::array<Entry, 2> entries{
      {{half, point_of(ring.front()), tangent},
       {half, point_of(ring[dart.crease_places().front()]), onwards}}};
    const auto along = [&](std::size_t p) -> FT { // whose rows refine it as well
      return averaged_roundness(entries,
                                [&](std::size_t j) { return roundness_of(j == 0 ? 0 : p); });
    };
    const FT roundness =
      (CGAL::max)(along(dart.crease_places().front()), along(dart.crease_places().back()));
    const Rule rule(entries.data(), entries.data() + 2, roundness);
    for (const auto p : dart.crease_places()) {
      point_of(next[p]) = rule.point();
      if constexpr (is_pn)
        next[p].normal =
          rule.normal([&](std::size_t j) -> const Vector& { return ring[j == 0 ? 0 : p].normal; });
    }
    far_tangent = opposite_vector(rule.tangent());
    turn_tangent(next.front());
    ring.swap(next);
  }

  FT roundness_of([[maybe_unused]] std::size_t place) const
  {
    if constexpr (is_pn)
      return ring[place].roundness;
    else
      return FT(1);
  }

  // makes the tangent orthogonal to the normal
  void turn_tangent([[maybe_unused]] const Value& value)
  {
    if constexpr (is_pn) {
      const FT length = root_of_square<FT>(dot(tangent, tangent));
      add_multiple<FT, 3>(tangent, FT(-dot(tangent, value.normal)), value.normal);
      tangent = unit_or_zero<FT, 3>(tangent, length);
    }
  }

  Average average_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_CREASE_VERTEX_LIMIT_H
