// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_TOWERS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_TOWERS_H

#include <CGAL/PN_subdivision_3/average/Unit_normal_traits.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_classes.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_tower.h>
#include <CGAL/PN_subdivision_3/internal/limit/Settled_neighborhood.h>
#include <CGAL/PN_subdivision_3/internal/limit/refuse_intervals.h>

#include <CGAL/Uncertain.h>

#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The towers of vertices of several kinds: rings are gathered until the tower of their kind is full.
template <class Scheme, class FT>
class Limit_towers
{
public:
  using Index = Level_connectivity::Index;
  using Tower = Limit_tower<Scheme, FT>;
  using Kind = typename Limit_classes<Scheme, FT>::Kind;

  // what its limit is stored in, and of which kind its ring is
  struct Vertex
  {
    Index v;
    typename Tower::Result* result;
    const Kind* kind;
  };

  explicit Limit_towers(const Limit_demand& demand)
    : demand_(demand)
  {}

  // of a vertex whose ring is given by value(place)
  template <class Value_of>
  void add(const Vertex& vertex, bool is_spline, const Value_of& value)
  {
    if (last_ == nullptr || vertex.kind != last_kind_ || is_spline != last_is_spline_) {
      auto& slot = towers_[{vertex.kind, is_spline}];
      if (!slot) slot = std::make_unique<Tower>(*vertex.kind->ring_class, demand_, is_spline);
      last_ = slot.get();
      last_kind_ = vertex.kind;
      last_is_spline_ = is_spline;
    }
    last_->add(value, *vertex.result);
    if (last_->is_full()) evaluate(*last_, vertex.v);
  }

  // the rest
  void finish()
  {
    for (auto& entry : towers_) entry.second->evaluate();
  }

private:
  // number types that may not decide a comparison have one vertex in a tower
  static void evaluate(Tower& tower, [[maybe_unused]] Index v)
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

  const Limit_demand& demand_;
  std::map<std::pair<const Kind*, bool>, std::unique_ptr<Tower>> towers_;
  Tower* last_ = nullptr;
  const Kind* last_kind_ = nullptr;
  bool last_is_spline_ = false;
};

// Decides when the averages of a limit mask over values that are refined by themselves have come close
// enough to the limit, as a Limit_tower does.
template <class FT>
class Limit_steps
{
public:
  // ratio: that of the differences in a row; is_exact: whether the first average is the limit
  Limit_steps(const Limit_demand& demand, bool is_exact, double ratio)
    : demand_(demand)
    , is_exact_(is_exact)
    , ratio_(ratio)
  {
    if (!is_exact) refuse_intervals<FT>();
  }

  // takes the averages one after the other
  bool is_last(const Coordinates<FT, 3>& limit)
  {
    if (is_exact_) return true;
    if (is_first_)
      is_first_ = false;
    else {
      ++depth_;
      const double step =
        std::hypot(close_double(FT(limit[0] - last_[0])), close_double(FT(limit[1] - last_[1])),
                   close_double(FT(limit[2] - last_[2])));
      error_ = limit_error(limit_error_factor(ratio_), ratio_, step, last_step_);
      if (error_ <= demand_.tolerance || depth_ >= demand_.max_depth) return true;
    }
    last_ = limit;
    return false;
  }

  // estimated
  double error() const { return error_; }
  // rounds done
  unsigned depth() const { return depth_; }

private:
  const Limit_demand& demand_;
  const bool is_exact_;
  const double ratio_;
  bool is_first_ = true;
  Coordinates<FT, 3> last_{};
  double last_step_ = 0, error_ = 0;
  unsigned depth_ = 0;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_TOWERS_H
