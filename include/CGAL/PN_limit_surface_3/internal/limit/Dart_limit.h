// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_DART_LIMIT_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_DART_LIMIT_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_weights.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_eigenvectors.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_geometry.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_limits_by_kind.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules.h>
#include <CGAL/PN_subdivision_3/creases/Crease_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Faces all around vertex 0: edge i leads to it from its neighbor 1 + i, and behind the neighbors come the
// diagonal vertices of quads.
inline Level_connectivity wheel(Level_connectivity::Index valence, Level_connectivity::Index degree)
{
  using Index = Level_connectivity::Index;
  const Index n = valence, outer = (degree - 2) * n;
  Level_size size;
  size.vertices = 1 + outer;
  size.edges = n + outer;
  size.faces = n;
  size.corners = std::size_t(degree) * n;
  Level_connectivity level(size);
  level.set_uniform_degree(degree);
  // the k-th vertex of the rim
  const auto rim = [&](Index k) {
    k %= outer;
    return degree == 3 ? 1 + k : (k % 2 == 0 ? 1 + k / 2 : 1 + n + k / 2);
  };
  level.set_halfedge_of_vertex(0, 0);
  for (Index i = 0; i < n; ++i) {
    level.set_target(2 * i, 0);
    level.set_target(2 * i + 1, 1 + i);
    const Index first = (degree - 2) * i;
    level.set_halfedge_of_face(i, 2 * i + 1);
    level.set_next(2 * i + 1, 2 * (n + first));
    for (Index k = first; k < first + degree - 2; ++k) {
      const Index h = 2 * (n + k);
      level.set_target(h, rim(k + 1));
      level.set_target(h + 1, rim(k));
      level.set_halfedge_of_vertex(rim(k), h + 1);
      level.set_border(h + 1);
      level.set_next(h + 1, 2 * (n + (k + outer - 1) % outer) + 1);
      level.set_face(h, i);
      level.set_next(h, k + 1 < first + degree - 2 ? h + 2 : 2 * ((i + 1) % n));
    }
    level.set_next(2 * ((i + 1) % n), 2 * i + 1);
    level.set_face(2 * i + 1, i);
    level.set_face(2 * ((i + 1) % n), i);
  }
  return level;
}

// What darts of one valence share: the rows of their ring, which is cut open along the crease, and the limit
// mask. Places are those of Vertex_ring.
template <class Scheme, class FT>
class Dart_rules
{
public:
  using Index = Level_connectivity::Index;
  using Entry = typename Entry_row<FT>::Entry;
  using Row = std::vector<Entry>;

  struct Weights
  {
    std::vector<Row> rows;
    Row limit;
  };

  // of an interior vertex in a round with the rules of all later ones
  Dart_rules(const Scheme& scheme, Index valence, unsigned round)
    : crease_places_{1, valence + 1}
  {
    const auto mask_of = [&](auto number, const Level_connectivity& level) {
      return scheme.template mask<decltype(number)>(level, round);
    };
    set_rules(mask_of, valence, round, points_);
    if (!has_normal_mask(scheme)) return;
    if constexpr (Has_normal_mask<Scheme>::value) {
      has_own_normals_ = true;
      const auto normal_mask_of = [&](auto number, const Level_connectivity& level) {
        return scheme.template normal_mask<decltype(number)>(level, round);
      };
      set_rules(normal_mask_of, valence, round, normals_);
    }
  }
  // of a vertex on a border that is a crease on one side, by the ring class of a plain one
  Dart_rules(const Ring_rules<Scheme, FT>& border, Index crease_place)
    : crease_places_{crease_place}
    , points_(rules(border.matrix(), border.limit_row()))
    , normals_(rules(border.normal_matrix(), border.normal_limit_row()))
    , has_own_normals_(border.has_own_normals())
  {}

  bool has_own_normals() const { return has_own_normals_; }

  const std::vector<Index>& crease_places() const { return crease_places_; }
  const Weights& points() const { return points_; }
  const Weights& normals() const { return normals_; }

private:
  using Host = typename Scheme::Host;

  static Row entries(const Ring_row<FT>& row)
  {
    Row result;
    for (const auto& [place, weight] : row) result.push_back({place, weight});
    return result;
  }
  static Weights rules(const Ring_matrix<FT>& matrix, const Ring_row<FT>& limit)
  {
    Weights result;
    for (const auto& row : matrix) result.rows.push_back(entries(row));
    result.limit = entries(limit);
    return result;
  }

  template <class Mask_of>
  static void set_rules(const Mask_of& mask_of, Index valence, unsigned round, Weights& result)
  {
    using Real = Ring_eigenvectors::Real;
    const Wheel wheel(valence, round);
    const auto matrix = dart_matrix<FT>(mask_of, wheel, valence);
    const auto real_matrix = dart_matrix<Real>(mask_of, wheel, valence);
    const Ring_eigenvectors masks(real_matrix, Ring_layout());
    if (masks.limit().empty()) throw std::invalid_argument(no_mask(valence));
    result = rules(matrix, limit_weights(masks.limit(), matrix));
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

  // that of the points, which are the same on both sides of the crease
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
      matrix->front().emplace_back(static_cast<std::uint32_t>(place - rings.ring.begin()),
                                   e->weight);
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
  using Row = typename Rules_of_dart::Row;

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

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_DART_LIMIT_H
