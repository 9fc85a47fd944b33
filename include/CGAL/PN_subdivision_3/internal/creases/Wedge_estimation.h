// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_WEDGE_ESTIMATION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_WEDGE_ESTIMATION_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Control_tangents.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>
#include <CGAL/PN_subdivision_3/internal/normals/face_normals.h>
#include <CGAL/PN_subdivision_3/internal/normals/roundness.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Where a plane joins a bend beside a crease the wedge has the area normal, as whole vertices have it
// in Coherent_estimation. Wedge normals and area normals are orthogonal to the tangents of the creases.
template <class FT>
class Wedge_joints
{
public:
  using Value = Point_normal<FT, 3>;
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;

  // values[slot] has the point and, when joints are made, the normal that arcs ask for
  Wedge_joints(const Level_connectivity& cut, const Wedges<FT>& wedges, std::vector<Value>& values)
    : cut_(cut)
    , wedges_(wedges)
    , values_(values)
  {}

  void operator()(const std::vector<bool>& is_given)
  {
    std::vector<std::pair<Index, Vector>> changed;
    for (Index slot = 0; slot < values_.size(); ++slot) {
      if (is_given[slot] || !wedges_.is_at_crease[slot] || cut_.is_isolated(slot)) continue;
      Vector n = wedges_.area_normals[slot];
      if (is_zero_not_unit(n)) continue;
      const double share = share_of_reciprocal(slot);
      if (share >= 1) continue;
      scale(n, FT(1 - share));
      add_multiple(n, FT(share), values_[slot].normal);
      changed.emplace_back(slot, unit_or_zero(n, FT(1)));
    }
    for (const auto& [slot, n] : changed) values_[slot].normal = n;
  }

private:
  double share_of_reciprocal(Index slot) const
  {
    const auto r = to_double_3<FT>(values_[slot].normal),
               a = to_double_3<FT>(wedges_.area_normals[slot]);
    if (is_zero(r)) return 0;
    Curvature_mismatch m;
    double unit = 0; // of length
    for (const Index h : fan_of_vertex(cut_, slot)) {
      const Value &p = values_[slot], &q = values_[cut_.source(h)];
      const auto e = to_double_3<FT>(difference(q.point, p.point));
      const double e_length = length(e);
      const auto other = to_double_3<FT>(q.normal);
      if (!(e_length > 0) || !std::isfinite(e_length) || is_zero(other)) continue;
      if (unit == 0) unit = e_length;
      const auto u = quotient(e, e_length);
      const auto of_other = dot(other, u);
      const double first = dot(r, u) + of_other;
      const double second = dot(a, u) + of_other;
      const double curvature = unit / e_length;
      m.add(first * first, second * second, curvature * curvature);
    }
    return m.share_of_first(vanishing_tolerance<FT>());
  }

  const Level_connectivity& cut_;
  const Wedges<FT>& wedges_;
  std::vector<Value>& values_;
};

// How round creases are, and their wedges at most: where arcs meet. The end of a crease takes its tangent from its neighbor,
// so that their arc proves nothing: beside a corner tangents turn from edges as in a round fan, too; beside a dart no vertex
// is round, between two corners a straight one is. A crease that turns more, or moves far for its faces, needs exact arcs.
template <class FT>
class Crease_roundness
{
public:
  using Value = Point_normal<FT, 3>;
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  Crease_roundness(const Level_connectivity& level, const Creases<FT>& creases,
                   const std::vector<Value>& values)
    : level_(level)
    , creases_(creases)
    , values_(values)
    , is_inside_(level.number_of_vertices(), false)
    , is_dart_(is_inside_)
  {}

  // the roundness of all slots
  std::vector<double> operator()()
  {
    std::vector<double> of_vertices(is_inside_.size(), 1), result(values_.size(), 1);
    for (const Crease_star& star : creases_.stars) {
      is_inside_[star.vertex] = creases_.rule(star) == Vertex_rule::crease;
      is_dart_[star.vertex] = creases_.rule(star) == Vertex_rule::dart;
    }
    for (const Crease_star& star : creases_.stars)
      if (is_inside_[star.vertex]) of_vertices[star.vertex] = of_vertex(star);
    for (const Crease_edge<FT>& e : creases_.edges)
      for (Index side : {0u, 1u}) {
        const Index v = level_.target(e.halfedge(side)), other = level_.source(e.halfedge(side));
        const double share = of_vertices[is_inside_[v] ? v : other];
        const auto put = [&](Index slot) { result[slot] = (std::min)(result[slot], share); };
        if (e.has_after(side)) put(e.after[side]);
        if (e.has_before(side)) put(e.before[side]);
      }
    return result;
  }

private:
  double of_vertex(const Crease_star& star) const
  {
    double least = 1, miss = 0, miss_of_normals = 0, reach = 0; // least: the cosine of a turn
    int ends = 0;
    for (const Crease_halfedge& end : creases_.ends_of(star)) {
      const Crease_edge<FT>& e = creases_.edge(end);
      const Index h = creases_.halfedge(end), w = level_.source(h);
      const Vector edge = between(level_.target(h), w);
      const double edge_length = length(edge);
      if (!(edge_length > 0) || !std::isfinite(edge_length)) continue;
      const Vector u = quotient(edge, edge_length);
      const Vector t = to_double_3<FT>(e.tangent_from[1 - end.side]);
      const auto cosine = dot(t, u);
      least = (std::min)(least, cosine);
      if (is_dart_[w]) return 0;
      for (const Index side : {h, level_.opposite(h)})
        reach = (std::max)(reach, edge_length / 4 * length(cross(t, u)) / width(side, u));
      for (const Index side : {0u, 1u})
        if (e.has_after(side)) miss_of_normals = (std::max)(miss_of_normals, miss_of(e, side, u));
      ends += is_inside_[w] ? 0 : 1;
      if (!is_inside_[w]) continue;
      Vector difference_of_arcs = to_double_3<FT>(e.tangent_from[end.side]);
      add_multiple(difference_of_arcs, 2 * cosine, u);
      add_multiple(difference_of_arcs, -1, t);
      miss = (std::max)(miss, length(difference_of_arcs));
    }
    if (ends > 1) // through any three points there is an arc
      return 1 - smooth_window(std::sqrt((std::max)(0., 2 - 2 * least)), 0.01, 0.1);
    // a triangle with sharp sides is no circle, unless it is the rim of a round surface
    const double turn = share_of_turn(least);
    return share_of_arcs(miss) *
           (ends > 0 ? turn : either(turn, share_of_exact_arcs(miss_of_normals))) *
           either(share_of_exact_arcs(miss), 1 - smooth_window(reach, 0.1, 0.3));
  }

  Vector between(Index v, Index w) const
  {
    return to_double_3<FT>(difference(values_[w].point, values_[v].point));
  }

  // how far the arc of the normals on one side of an edge misses; u is the direction of the edge
  double miss_of(const Crease_edge<FT>& e, Index side, const Vector& u) const
  {
    return std::abs(dot(to_double_3<FT>(values_[e.after[side]].normal), u) +
                    dot(to_double_3<FT>(values_[e.before[1 - side]].normal), u));
  }

  // the width of the face of a half-edge of the direction u: the least distance of its other corners from the edge
  double width(Index side, const Vector& u) const
  {
    double least = std::numeric_limits<double>::infinity();
    if (level_.is_border(side)) return least;
    for (Index h = level_.next(side); level_.target(h) != level_.source(side); h = level_.next(h))
      least = (std::min)(least, length(cross(between(level_.source(side), level_.target(h)), u)));
    return least;
  }

  const Level_connectivity& level_;
  const Creases<FT>& creases_;
  const std::vector<Value>& values_;
  std::vector<bool> is_inside_, is_dart_; // of vertices: a crease goes through, or ends
};

// The control data of a level with creases before the first round: tangents, and normals of the wedges without given ones.
template <class FT>
class Wedge_estimation
{
public:
  using Value = Point_normal<FT, 3>;
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;

  // values[slot] has the point; its normal if is_given[slot]
  Wedge_estimation(const Level_connectivity& level, Creases<FT>& creases,
                   std::vector<Value>& values, std::vector<bool> is_given,
                   Control_normal_estimate estimate)
    : level_(level)
    , creases_(creases)
    , values_(values)
    , is_given_(std::move(is_given))
    , estimate_(estimate)
  {}

  // tangents that are not zero stay
  void operator()()
  {
    const bool has_joints = estimate_ == Control_normal_estimate::coherent;
    make_control_tangents(level_, creases_, values_, is_given_, has_joints);
    if (std::find(is_given_.begin(), is_given_.end(), false) == is_given_.end()) return;
    const Cut_copy<FT> cut(level_, creases_);
    Wedges<FT> wedges{slots_at_creases(), {}};
    if (has_joints) {
      wedges.area_normals = area_normals(cut.connectivity());
      strip_all([&](Index slot) -> Vector& { return wedges.area_normals[slot]; });
    }
    estimate_normals(cut.connectivity(), estimate_, values_, &is_given_, &wedges);
    strip_all([&](Index slot) -> Vector& { return values_[slot].normal; });
    if (!has_joints) return;
    Wedge_joints<FT>(cut.connectivity(), wedges, values_)(is_given_);
    const std::vector<double> shares = Crease_roundness<FT>(level_, creases_, values_)();
    for (Index slot = 0; slot < values_.size(); ++slot)
      if (!is_given_[slot]) values_[slot].roundness *= FT(shares[slot]);
  }

private:
  // in the level cut open every wedge is a vertex
  std::vector<Vector> area_normals(const Level_connectivity& cut) const
  {
    std::vector<Area_sum> sums(values_.size());
    add_areas(cut, Scaled_differences<FT>(cut, values_),
              [&](Index slot) -> Area_sum& { return sums[slot]; });
    std::vector<Vector> normals;
    for (const Area_sum& sum : sums) {
      const auto n = sum.unit();
      normals.push_back({FT(n[0]), FT(n[1]), FT(n[2])});
    }
    return normals;
  }

  using Normal_of = Function_ref<Vector&(Index)>;

  void strip_all(Normal_of normal)
  {
    for (const Crease_star& star : creases_.stars)
      if (is_at_crease_or_corner(star))
        name_undecided<FT>(
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

  // makes estimated normals orthogonal to the tangents of the edges beside their wedges, if that turns the normals little
  void strip_normals(const Crease_star& star, Normal_of normal) const
  {
    std::vector<std::vector<Vector>> tangents(star.number_of_wedges); // those after, then before
    for (const Crease_halfedge& e : creases_.ends_of(star))
      if (creases_.edge(e).has_after(e.side))
        tangents[star.wedge(creases_.edge(e).after[e.side])].push_back(creases_.tangent_from(e));
    for (const Crease_halfedge& e : creases_.ends_of(star))
      if (creases_.edge(e).has_before(e.side))
        tangents[star.wedge(creases_.edge(e).before[e.side])].push_back(creases_.tangent_from(e));
    for (Index w = 0; w < star.number_of_wedges; ++w) {
      const Index slot = star.slot(w);
      const std::vector<Vector>& beside = tangents[w];
      if (is_given_[slot] || beside.empty()) continue;
      const Vector n = normal(slot);
      Vector& stripped = normal(slot);
      stripped = beside.size() == 2 ? strip<FT>(n, beside[0], beside[1]) : strip<FT>(n, beside[0]);
      const double cosine = length(to_double_3<FT>(stripped));
      stripped = unit_or_zero(stripped, FT(1));
      if (creases_.rule(star) == Vertex_rule::corner && cosine < cos_36)
        keep_part(slot, share_of_turn(cosine), n, stripped);
    }
  }

  // Where creases bend away from the surface at a corner, the normal orthogonal to both lies across the surface.
  void keep_part(Index slot, double share, const Vector& n, Vector& stripped) const
  {
    scale(stripped, FT(share));
    add_multiple(stripped, FT(1 - share), n);
    stripped = unit_or_zero(stripped, FT(1));
    if (estimate_ == Control_normal_estimate::coherent) values_[slot].roundness *= FT(share);
  }

  const Level_connectivity& level_;
  Creases<FT>& creases_;
  std::vector<Value>& values_;
  const std::vector<bool> is_given_;
  const Control_normal_estimate estimate_;
};

template <class FT>
void estimate_wedges(const Level_connectivity& level, Creases<FT>& creases,
                     std::vector<Point_normal<FT, 3>>& values, std::vector<bool> is_given,
                     Control_normal_estimate estimate)
{
  Wedge_estimation<FT>(level, creases, values, std::move(is_given), estimate)();
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_WEDGE_ESTIMATION_H
