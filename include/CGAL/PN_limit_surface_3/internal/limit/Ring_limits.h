// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_LIMITS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_LIMITS_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_geometry.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_planes.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules_cache.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Curvature_transfer.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The limit at one vertex or face.
template <class Average>
struct Limit_result
{
  typename Average::Value value; // point and control normal
  Coordinates<double, 3> surface_normal{};
  double error = 0, normal_error = 0;
  double gaussian = 0, mean = 0;
  unsigned depth = 0; // rounds
  bool has_surface_normal = false, has_curvature = false;
};

// The ring of a vertex or face is refined round by round on its own; the averages of the limit mask
// over it converge, and their differences tell how far they have come. Rings of one class are refined
// side by side, which changes nothing of their results.
template <class Scheme, class FT, Limit_kinds kinds = Limit_kinds::all>
class Ring_limits
{
public:
  using Rules = Ring_rules<Scheme, FT>;
  using Average = typename Rules::Average;
  using Value = typename Rules::Value;
  using Result = Limit_result<Average>;

  // is_spline: whether the surface is a regular piece of a spline about the vertices
  Ring_limits(const Rules& ring_rules, const Limit_demand& demand, bool is_spline)
    : rules_(ring_rules)
    , demand_(demand)
    , is_spline_(is_spline)
    , copies_(ring_rules.copies())
    , rings_(ring_rules.largest_size() * copies_)
    , next_(rings_.size())
    , limits_(copies_)
    , states_(copies_)
    , planes_(ring_rules)
  {
    if (is_pn_v<Scheme> && !rules_.is_interpolating()) refuse_intervals<FT>();
    if constexpr (has_transfers)
      if (rules_.transfer_valence() != 0)
        transfer_.emplace(Scheme::Host::refined_degree, rules_.transfer_valence());
  }

  bool is_full() const { return count_ == copies_; }

  // adds a ring, given by value(place), whose result is to be stored in `result`
  template <class Value_of>
  void add(const Value_of& value, Result& result)
  {
    State& state = states_[count_];
    state = State();
    state.result = &result;
    state.center = point_of(value(0));
    for (std::size_t p = 0; p < rules_.size(); ++p)
      rings_[p * copies_ + count_] = relative(value(p), state.center, FT(-1));
    ++count_;
  }

  // the results of the rings that have been added
  void evaluate()
  {
    if (count_ == 0) return;
    // unused copies have to be finite, no more
    for (std::size_t c = count_; c < copies_; ++c)
      for (std::size_t p = 0; p < rules_.size(); ++p) rings_[p * copies_ + c] = rings_[p * copies_];
    std::size_t left = count_;
    for (unsigned depth = 0; left != 0; ++depth) {
      if (depth != 0) {
        rules_.refine(rings_.data(), next_.data());
        if constexpr (has_transfers) transfer_curvature();
        std::copy(next_.begin(), next_.end(), rings_.begin());
      }
      rules_.limit(rings_.data(), limits_.data());
      if constexpr (has_normals(kinds))
        if (demand_.surface_normals && rules_.has_tangents())
          planes_.find(rings_.data(), limits_.data(), count_,
                       [&](std::size_t c) { return states_[c].is_done; });
      for (std::size_t c = 0; c < count_; ++c)
        if (!states_[c].is_done && advance(c, depth)) --left;
    }
    count_ = 0;
  }

private:
  using Vector = Coordinates<double, 3>;
  static constexpr bool has_transfers = Has_curvature_transfer<Scheme>::value;

  // the error of a curvature at an extraordinary vertex falls by lambda^2 a round, from some percent
  static constexpr unsigned curvature_depth = 8;
  // in the small rings after more rounds than these, second differences are rounding
  static constexpr unsigned most_curvature_depth = 12;

  struct State
  {
    Result* result = nullptr;
    Coordinates<FT, 3> center;
    Coordinates<FT, 3> last_limit;
    Vector last_normal{};
    double last_step = 0, last_turn = 0;
    bool is_done = false, had_normal = false;
  };

  // The place in a ring of what the transfer calls number j. A diagonal vertex is here in front of the
  // neighbor with its number, and there behind it.
  std::size_t place(std::size_t j) const
  {
    const std::size_t n = rules_.transfer_valence();
    return j <= n ? j : 1 + n + (j - n) % n;
  }

  // transfers curvature in the refined rings
  void transfer_curvature()
  {
    if (!transfer_) return;
    std::vector<Point_normal<FT, 3>> ring(transfer_->size());
    for (std::size_t c = 0; c < count_; ++c) {
      const auto at = [&](std::size_t j) -> Value& { return next_[place(j) * copies_ + c]; };
      for (std::size_t j = 0; j < ring.size(); ++j) ring[j] = at(j);
      if (const auto part = (*transfer_)(ring, origin(c)))
        transfer_->add_half(
          *part, [&](std::size_t j) -> auto& { return at(j).normal; });
    }
  }

  // the origin of the coordinates of ring c, see relative()
  Coordinates<FT, 3> origin(std::size_t c) const
  {
    if constexpr (std::is_floating_point_v<FT>)
      return states_[c].center;
    else
      return {FT(0), FT(0), FT(0)};
  }

  // notes the limit of ring c at this depth; whether it is the last one
  bool advance(std::size_t c, unsigned depth)
  {
    State& state = states_[c];
    Result& result = *state.result;
    const Coordinates<FT, 3>& point = point_of(limits_[c]);
    const bool is_exact = rules_.is_interpolating() || !is_pn_v<Scheme>;
    if (depth != 0 && !is_exact)
      result.error = limit_error(rules_.error_factor(), rules_.error_ratio(),
                                 quick_length(to_double_3(difference(point, state.last_limit))),
                                 state.last_step);
    bool is_last = (is_exact || depth != 0) && result.error <= demand_.tolerance;
    if constexpr (has_normals(kinds)) {
      if (demand_.surface_normals && rules_.has_tangents()) {
        const bool is_normal_found = note_normal(c, depth);
        // stand-ins for normals are as exact as points
        const bool has_to_be_close = demand_.points || !planes_[c].exists;
        is_last = is_normal_found && (is_last || !has_to_be_close);
      }
    }
    if constexpr (kinds == Limit_kinds::all)
      if (demand_.curvatures && settles() && !is_spline_ && depth < curvature_depth)
        is_last = false;
    is_last = is_last || depth * rules_.rounds() >= demand_.max_depth;
    if constexpr (kinds == Limit_kinds::all)
      if (demand_.curvatures &&
          (is_last ? depth <= most_curvature_depth : depth == most_curvature_depth))
        note_curvature(c);
    if (!is_last) {
      state.last_limit = point;
      return false;
    }
    if (!demand_.points && result.has_surface_normal)
      result.error = std::numeric_limits<double>::infinity();
    result.value = relative(limits_[c], state.center, FT(1));
    result.depth += depth * rules_.rounds();
    state.is_done = true;
    return true;
  }

  // the surface normal; whether it meets the tolerance, or no further round will make it better
  bool note_normal(std::size_t c, unsigned depth)
  {
    State& state = states_[c];
    Result& result = *state.result;
    const auto& plane = planes_[c];
    const bool had_normal = std::exchange(state.had_normal, plane.exists);
    if (!plane.exists) return true; // nor will it, but for rounding
    const Vector n = plane.normal;
    const Vector last = std::exchange(state.last_normal, n);
    const bool is_found_at_once = depth == 0 && !demand_.points && !demand_.curvatures &&
                                  plane.error <= demand_.normal_tolerance;
    double error = is_found_at_once ? (std::max)(plane.error, plane.rounding) : plane.rounding;
    if (is_pn_v<Scheme> && depth != 0 && had_normal) {
      // a turn may be small by chance, two in a row hardly are
      const double ratio = rules_.normal_ratio();
      const double turn = quick_length(difference(n, last));
      error =
        (std::max)(error, 1.5 * ratio / (1 - ratio) * (std::max)(turn, ratio * state.last_turn));
      state.last_turn = turn;
      // further rounds have more rounding still
      if (depth > 1 && (plane.rounding >= result.normal_error ||
                        (result.normal_error < 1e-6 && error > result.normal_error)))
        return true;
    }
    result.has_surface_normal = true;
    const bool is_turned = !demand_.points && plane.is_against_faces;
    result.surface_normal = is_turned ? opposite_vector(n) : n;
    result.normal_error = error;
    return !is_pn_v<Scheme> || is_found_at_once ||
           (depth != 0 && had_normal && error <= demand_.normal_tolerance);
  }

  // whether the ring matrix has no part of second order that would last
  bool settles() const
  {
    const double lambda2 = rules_.lambda() * rules_.lambda();
    return is_pn_v<Scheme> && rules_.has_tangents() && !rules_.is_at_border() &&
           (transfer_ || rules_.largest_other() < 0.9 * lambda2);
  }

  // where curvature settles, or at regular vertices of splines
  void note_curvature(std::size_t c)
  {
    if (!is_spline_ && !settles()) return;
    const Ring_geometry g = planes_.geometry(rings_.data(), limits_.data(), c);
    if (!g.is_regular()) return;
    Coordinates<FT, 3> center = point_of(limits_[c]);
    add_multiple<FT, 3>(center, FT(1), origin(c));
    const auto part = remaining_part(planes_.divided(to_double_3(center)));
    Curvatures<double> k =
      is_spline_ ? curvatures(spline_jet(Scheme::Host::refined_degree == 4, planes_.ring(),
                                         rules_.roundness_at(limits_[c])))
                 : g.extraordinary_curvatures(transfer_.has_value(), part ? &*part : nullptr);
    k.gaussian = std::ldexp(k.gaussian, -2 * planes_.exponent());
    k.mean = std::ldexp(k.mean, -planes_.exponent());
    if (!std::isfinite(k.gaussian) || !std::isfinite(k.mean)) return;
    Result& result = *states_[c].result;
    result.gaussian = k.gaussian;
    result.mean = k.mean;
    result.has_curvature = true;
  }

  // the part that will still be transferred in the ring of `planes_`
  std::optional<Quadratic_part<double>>
  remaining_part([[maybe_unused]] const Vector& origin_of_ring) const
  {
    if constexpr (has_transfers)
      if (transfer_ && !is_spline_) {
        std::vector<Point_normal<double, 3>> ring(planes_.ring().size());
        for (std::size_t j = 0; j < ring.size(); ++j) ring[j] = planes_.ring()[place(j)];
        const auto degree = static_cast<Level_connectivity::Index>(Scheme::Host::refined_degree);
        return Normal_transfer<double>(degree, rules_.transfer_valence())(ring, origin_of_ring);
      }
    return std::nullopt;
  }

  const Rules& rules_;
  const Limit_demand& demand_;
  const bool is_spline_;
  const std::size_t copies_;
  std::vector<Value> rings_, next_, limits_;
  std::vector<State> states_;
  Ring_planes<Scheme, FT> planes_;
  std::optional<Normal_transfer<FT>> transfer_;
  std::size_t count_ = 0;
};

// The limits of vertices of several kinds: rings are gathered until there are as many of a kind as are refined at once.
template <class Scheme, class FT, Limit_kinds kinds = Limit_kinds::all>
class Ring_limits_by_kind
{
public:
  using Index = Level_connectivity::Index;
  using Limits = Ring_limits<Scheme, FT, kinds>;
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

  // adds a vertex whose ring is given by value(place)
  template <class Value_of>
  void add(const Vertex& vertex, bool is_spline, const Value_of& value)
  {
    const auto is_of_kind = [&](const Kind_limits& k) {
      return k.kind == vertex.kind && k.is_spline == is_spline;
    };
    if (limits_.empty() || !is_of_kind(limits_[last_])) {
      const auto found = std::find_if(limits_.begin(), limits_.end(), is_of_kind);
      last_ = static_cast<std::size_t>(found - limits_.begin());
      if (last_ == limits_.size())
        limits_.push_back({vertex.kind, is_spline,
                           std::make_unique<Limits>(*vertex.kind->ring_rules, demand_, is_spline)});
    }
    Limits& limits = *limits_[last_].limits;
    limits.add(value, *vertex.result);
    if (!limits.is_full()) return;
    // with number types that may not decide a comparison one ring is refined at once
    name_undecided<FT>([&] { limits.evaluate(); },
                       [&] {
                         return "whether a normal next to vertex number " +
                                std::to_string(vertex.v) +
                                " vanishes or is opposite to a neighbor's";
                       });
  }

  // the rest
  void finish()
  {
    for (Kind_limits& k : limits_) k.limits->evaluate();
  }

private:
  struct Kind_limits
  {
    const Kind* kind;
    bool is_spline;
    std::unique_ptr<Limits> limits;
  };

  const Limit_demand& demand_;
  std::vector<Kind_limits> limits_; // few
  std::size_t last_ = 0;            // where the last ring went
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_LIMITS_H
