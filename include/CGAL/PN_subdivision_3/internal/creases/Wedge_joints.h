// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_WEDGE_JOINTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_WEDGE_JOINTS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/normals/area_normals.h>
#include <CGAL/PN_subdivision_3/internal/normals/roundness.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Whole vertices of a level that is cut open. Who says what is sharp says what is smooth: slots at
// creases and corners are round.
class Wedge_sectors : public Vertex_sectors
{
public:
  Wedge_sectors(const Level_connectivity& level, std::vector<bool> is_at_crease)
    : Vertex_sectors(level)
    , is_at_crease_(std::move(is_at_crease))
  {}

  bool is_at_crease(Index slot) const { return is_at_crease_[slot]; }

private:
  const std::vector<bool> is_at_crease_;
};

// Where a plane joins a bend beside a crease the wedge has the area normal, as whole vertices have it
// in Coherent_estimation; both normals orthogonal to the tangents of the creases.
template <class FT, class Value>
class Wedge_joints
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;

  // values[slot] has the point and, when joints are made, the normal that arcs ask for
  Wedge_joints(const Level_connectivity& cut, const Wedge_sectors& sectors,
               std::vector<Value>& values)
    : cut_(cut)
    , sectors_(sectors)
    , values_(values)
    , area_(values.size())
  {
    const Point_of point{values.data()};
    const Scaled_differences<FT, Point_of> difference(cut, point);
    std::vector<Area_sum> sums(area_.size());
    add_areas(cut, sectors, difference, [&](Index slot) -> Area_sum& { return sums[slot]; });
    for (Index slot = 0; slot < area_.size(); ++slot) {
      const auto n = sums[slot].unit();
      area_[slot] = {FT(n[0]), FT(n[1]), FT(n[2])};
    }
  }

  Vector& area_normal(Index slot) { return area_[slot]; }

  void operator()(const std::vector<bool>& is_given)
  {
    std::vector<std::pair<Index, Vector>> changed;
    for (Index slot = 0; slot < area_.size(); ++slot) {
      if (is_given[slot] || !sectors_.is_at_crease(slot) || sectors_.is_empty(slot)) continue;
      if (is_zero_not_unit<FT, 3>(area_[slot])) continue;
      const double share = share_of_reciprocal(slot);
      if (share >= 1) continue;
      Vector n = area_[slot];
      scale<FT, 3>(n, FT(1 - share));
      add_multiple<FT, 3>(n, FT(share), values_[slot].normal);
      changed.emplace_back(slot, unit_or_zero<FT, 3>(n, FT(1)));
    }
    for (const auto& [slot, n] : changed) values_[slot].normal = n;
  }

private:
  struct Point_of
  {
    const Vector& operator()(Index slot) const { return values[slot].point; }
    const Value* values;
  };

  double share_of_reciprocal(Index slot) const
  {
    const auto r = to_double_3<FT>(values_[slot].normal), a = to_double_3<FT>(area_[slot]);
    if (is_zero(r)) return 0;
    Curvature_mismatch m;
    double unit = 0; // of length
    for_each_halfedge(cut_, fan_of_vertex(cut_, slot), [&](Index h) {
      const Value &p = values_[slot], &q = values_[cut_.source(h)];
      const auto e = to_double_3<FT>(difference<FT, 3>(q.point, p.point));
      const double e_length = length(e);
      const auto other = to_double_3<FT>(q.normal);
      if (!(e_length > 0) || !std::isfinite(e_length) || is_zero(other)) return;
      if (unit == 0) unit = e_length;
      const auto u = quotient(e, e_length);
      const auto of_other = dot<double, 3>(other, u);
      const double first = dot<double, 3>(r, u) + of_other;
      const double second = dot<double, 3>(a, u) + of_other;
      const double curvature = unit / e_length;
      m.add(first * first, second * second, curvature * curvature);
    });
    return m.share_of_first(vanishing_tolerance<FT>());
  }

  const Level_connectivity& cut_;
  const Wedge_sectors& sectors_;
  std::vector<Value>& values_;
  std::vector<Vector> area_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_WEDGE_JOINTS_H
