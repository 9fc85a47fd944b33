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
#include <CGAL/PN_limit_surface_3/internal/limit/made_levels.h>
#include <CGAL/PN_subdivision_3/creases/Crease_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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
    set_rules(mask_of, valence, round, points_);
    if (!facts_of(scheme).has_normal_mask) return;
    if constexpr (Has_normal_mask<Scheme>::value) {
      has_own_normals_ = true;
      const auto normal_mask_of = [&](auto number, const Level_connectivity& level) {
        return scheme.template normal_mask<decltype(number)>(level, round);
      };
      set_rules(normal_mask_of, valence, round, normals_);
    }
  }
  // the rules of a vertex on a border that is a crease on one side, by the ring class of a plain border vertex
  Dart_rules(const Ring_rules<Scheme, FT>& border, Index crease_place)
    : crease_places_{crease_place}
    , points_{border.matrix(), border.limit_row()}
    , normals_{border.normal_matrix(), border.normal_limit_row()}
    , has_own_normals_(border.has_own_normals())
  {}

  bool has_own_normals() const { return has_own_normals_; }

  const std::vector<Index>& crease_places() const { return crease_places_; }
  const Weights& points() const { return points_; }
  const Weights& normals() const { return normals_; }

private:
  using Host = typename Scheme::Host;

  template <class Mask_of>
  static void set_rules(const Mask_of& mask_of, Index valence, unsigned round, Weights& result)
  {
    using Real = Ring_eigenvectors::Real;
    const Wheel wheel(valence, round);
    const auto matrix = dart_matrix<FT>(mask_of, wheel, valence);
    const auto real_matrix = dart_matrix<Real>(mask_of, wheel, valence);
    const Ring_eigenvectors masks(real_matrix, Ring_layout());
    if (masks.limit().empty()) throw std::invalid_argument(no_mask(valence));
    result = {matrix, limit_weights<FT>(masks.limit(), matrix)};
  }
  static std::string no_mask(Index valence)
  {
    return "PN_subdivision_3: the scheme has no limit mask about a vertex of valence " +
           std::to_string(valence) + " where a crease ends";
  }

  // What matrices of all number types have in common: the wheel, cut open for a round, and then whole with counted valences.
  struct Wheel
  {
    Wheel(Index valence, unsigned round)
      : whole(wheel(valence, Host::refined_degree))
      , creases(Make_creases<FT>(whole, Border::surface)(
          [](Index e) { return e == 0 ? infinite_sharpness : 0; }, [](Index) { return 0.; }))
      , cut(whole, creases)
      , host(cut.connectivity(), round)
    {
      Vertex_ring::append(cut.connectivity(), 0, 1, rings.ring);
      Vertex_ring::append_next(cut.connectivity(), host, 0, rings.next_ring);
      count_valences(whole, creases);
    }

    Level_connectivity whole;
    const Creases<FT> creases;
    const Cut_copy<FT> cut;
    const Host host;
    Ring_pair rings;
  };

  // the matrix of the points, which are the same on both sides of the crease
  template <class Number, class Mask_of>
  static Ring_matrix<Number> dart_matrix(const Mask_of& mask_of, const Wheel& wheel, Index valence)
  {
    const Ring_pair& rings = wheel.rings;
    auto matrix =
      ring_matrix<Number>(wheel.host, mask_of(Number(), wheel.cut.connectivity()), rings);
    if (!matrix) throw std::invalid_argument(no_mask(valence));

    const auto mask = mask_of(Number(), wheel.whole);
    const Corner_slots<FT> slot_of(wheel.whole, wheel.creases);
    Entry_row<Number> row;
    Slot_shares<Number, std::decay_t<decltype(mask)>, FT>(wheel.whole, slot_of, mask)
      .vertex(0, row);
    matrix->front().clear();
    for (const auto* e = row.begin(); e != row.end(); ++e) {
      const auto place = std::find(rings.ring.begin(), rings.ring.end(), e->vertex);
      if (place == rings.ring.end()) throw std::invalid_argument(no_mask(valence));
      matrix->front().push_back(
        {static_cast<std::uint32_t>(place - rings.ring.begin()), e->weight});
    }
    return *matrix;
  }

  std::vector<Index> crease_places_; // of the slots of the neighbor on the crease
  Weights points_, normals_;
  bool has_own_normals_ = false; // otherwise they are refined by the rules of the points
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
        average(dart.points().limit, dart.has_own_normals() ? &dart.normals().limit : nullptr);
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
      next.push_back(
        average(dart.points().rows[p], dart.has_own_normals() ? &dart.normals().rows[p] : nullptr));
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
