// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CONTROL_CREASES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CONTROL_CREASES_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/is_interval.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Control_tangents.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/Wedge_joints.h>
#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The control data of a level with creases, once before the first round: the wedges' normals where
// none are given, and the tangents.
template <class FT, class Value = Point_normal<FT, 3>>
class Control_creases
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;

  // values[slot] has the point; its normal if is_given[slot]
  Control_creases(const Level_connectivity& level, Creases<FT>& creases, std::vector<Value>& values,
                  std::vector<bool> is_given,
                  Control_normal_estimate estimate = Control_normal_estimate::coherent)
    : level_(level)
    , creases_(creases)
    , values_(values)
    , is_given_(std::move(is_given))
    , estimate_(estimate)
  {}

  // tangents that are not zero stay
  void operator()()
  {
    const auto point = [&](Index v) -> const Vector& { return values_[v].point; };
    const auto given = [&](Index slot) {
      return is_given_[slot] ? values_[slot].normal : zero_vector<FT, 3>();
    };
    const bool has_joints = estimate_ == Control_normal_estimate::coherent;
    const auto has_joint = [&](Index slot) { return has_joints && !is_given_[slot]; };
    using Tangents = Control_tangents<FT, decltype(point), decltype(given), decltype(has_joint)>;
    Tangents(level_, creases_, point, given, has_joint)();
    if (std::find(is_given_.begin(), is_given_.end(), false) == is_given_.end()) return;
    const Cut_level<FT> cut(level_, creases_);
    const Wedge_sectors sectors(cut.connectivity(), slots_at_creases());
    estimate_normals(cut.connectivity(), sectors);
    if (!has_joints) {
      strip_all([&](Index slot) -> Vector& { return values_[slot].normal; });
      return;
    }
    Wedge_joints<FT, Value> joints(cut.connectivity(), sectors, values_);
    strip_all([&](Index slot) -> Vector& { return values_[slot].normal; });
    strip_all([&](Index slot) -> Vector& { return joints.area_normal(slot); });
    joints(is_given_);
  }

private:
  // sector by sector: cut open, every wedge is the whole of its vertex
  void estimate_normals(const Level_connectivity& cut, const Wedge_sectors& sectors)
  {
    internal::estimate_normals<FT>(
      cut, estimate_, sectors, [&](Index slot) -> const Vector& { return values_[slot].point; },
      [&](Index slot) -> const Vector* {
        return is_given_[slot] ? &values_[slot].normal : nullptr;
      },
      [&](Index slot, const Vector& n) { values_[slot].normal = n; },
      Set_roundness_of_value<Value>{values_.data()});
  }

  template <class Normal_of>
  void strip_all(const Normal_of& normal)
  {
    for (const Crease_star& star : creases_.stars)
      if (is_at_crease_or_corner(star))
        decided<FT>(
          [&] { strip_normals(star, normal); },
          [&] { return "the normals at the creases of vertex " + std::to_string(star.vertex); });
  }

  std::vector<bool> slots_at_creases() const
  {
    std::vector<bool> is_at_crease(values_.size(), false);
    for (const Crease_star& star : creases_.stars)
      if (is_at_crease_or_corner(star))
        for (Index w = 0; w < star.number_of_wedges; ++w) is_at_crease[star.slot(w)] = true;
    return is_at_crease;
  }

  bool is_at_crease_or_corner(const Crease_star& star) const
  {
    const Vertex_rule rule = creases_.rule(star);
    return rule == Vertex_rule::crease || rule == Vertex_rule::corner;
  }

  // makes the estimated normals orthogonal to the tangents of the edges beside their wedges
  template <class Normal_of>
  void strip_normals(const Crease_star& star, const Normal_of& normal) const
  {
    const Vector none = zero_vector<FT, 3>();
    std::vector<Vector> after(star.number_of_wedges, none), before = after;
    std::vector<bool> has_after(star.number_of_wedges, false), has_before = has_after;
    for (Index i = 0; i < star.number_of_ends; ++i) {
      const Crease_end& e = creases_.end(star, i);
      const Crease_edge<FT>& crease = creases_.edge(e);
      const Vector& t = crease.tangent_from[1 - e.side];
      if (crease.has_after(e.side)) {
        after[star.wedge(crease.after[e.side])] = t;
        has_after[star.wedge(crease.after[e.side])] = true;
      }
      if (crease.has_before(e.side)) {
        before[star.wedge(crease.before[e.side])] = t;
        has_before[star.wedge(crease.before[e.side])] = true;
      }
    }
    for (Index w = 0; w < star.number_of_wedges; ++w) {
      if (is_given_[star.slot(w)] || (!has_after[w] && !has_before[w])) continue;
      Vector& n = normal(star.slot(w));
      if (has_after[w] && has_before[w])
        n = strip<FT>(n, after[w], before[w]);
      else
        n = strip<FT>(n, has_after[w] ? after[w] : before[w]);
      n = unit_or_zero<FT, 3>(n, FT(1));
    }
  }

  const Level_connectivity& level_;
  Creases<FT>& creases_;
  std::vector<Value>& values_;
  const std::vector<bool> is_given_;
  const Control_normal_estimate estimate_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CONTROL_CREASES_H
