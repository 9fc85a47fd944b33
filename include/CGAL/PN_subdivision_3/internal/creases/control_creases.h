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
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/control_tangents.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/normals/Normal_estimation.h>
#include <CGAL/PN_subdivision_3/schemes/normal_estimate.h>
#include <CGAL/PN_subdivision_3/schemes/with_border.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The vertices of the slots behind all vertices.
template <class FT>
std::vector<Level_connectivity::Index> vertices_of_extra_slots(const Creases<FT>& creases,
                                                               Level_connectivity::Index vertices)
{
  using Index = Level_connectivity::Index;
  std::vector<Index> result(creases.number_of_slots - vertices);
  for (const Crease_star& star : creases.stars)
    for (Index w = 1; w < star.number_of_wedges; ++w) result[star.slot(w) - vertices] = star.vertex;
  return result;
}

inline std::vector<Level_connectivity::Index> vertices_of_extra_slots(No_creases,
                                                                      Level_connectivity::Index)
{
  return {};
}

// The control data of a level with creases, once before the first round: the wedges' normals where
// none are given, and the tangents.
template <class FT>
class Control_creases
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;

  // values[slot] has the point; its normal if is_given[slot]
  Control_creases(const Level_connectivity& level, Creases<FT>& creases,
                  std::vector<Point_normal<FT, 3>>& values, std::vector<bool> is_given,
                  Control_normal_estimate estimate = Control_normal_estimate::reciprocal)
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
    using Tangents = Control_tangents<FT, decltype(point), decltype(given)>;
    Tangents(level_, creases_, point, given)();
    if (std::find(is_given_.begin(), is_given_.end(), false) == is_given_.end()) return;
    estimate_normals();
    for (const Crease_star& star : creases_.stars) {
      const Vertex_rule rule = creases_.rule(star);
      if (rule != Vertex_rule::crease && rule != Vertex_rule::corner) continue;
      decided<FT>(
        [&] { strip_normals(star); },
        [&] { return "the normals at the creases of vertex " + std::to_string(star.vertex); });
    }
  }

private:
  // sector by sector: cut open, every wedge is the whole of its vertex
  void estimate_normals()
  {
    const Cut_level<FT> cut(level_, creases_);
    internal::estimate_normals<FT>(
      cut.connectivity(), estimate_, Vertex_sectors(cut.connectivity()),
      [&](Index slot) -> const Vector& { return values_[slot].point; },
      [&](Index slot) -> const Vector* {
        return is_given_[slot] ? &values_[slot].normal : nullptr;
      },
      [&](Index slot, const Vector& n) { values_[slot].normal = n; });
  }

  // makes the estimated normals orthogonal to the tangents of the edges beside their wedges
  void strip_normals(const Crease_star& star)
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
      Vector& n = values_[star.slot(w)].normal;
      if (has_after[w] && has_before[w])
        n = strip<FT>(n, after[w], before[w]);
      else
        n = strip<FT>(n, has_after[w] ? after[w] : before[w]);
      n = unit_or_zero<FT, 3>(n, FT(1));
    }
  }

  const Level_connectivity& level_;
  Creases<FT>& creases_;
  std::vector<Point_normal<FT, 3>>& values_;
  const std::vector<bool> is_given_;
  const Control_normal_estimate estimate_;
};

// Makes the creases of a control level from the sharpness of its edges and vertices.
template <class FT>
class Make_creases
{
public:
  using Index = Level_connectivity::Index;

  Make_creases(const Level_connectivity& level, Border border)
    : level_(level)
    , border_(border)
    , creases_(level.number_of_vertices())
  {
    creases_.has_fixed_border = border == Border::fixed;
  }

  // edge_sharpness(e), vertex_sharpness(v) are numbers >= 0
  template <class Edge_sharpness, class Vertex_sharpness>
  Creases<FT> operator()(const Edge_sharpness& edge_sharpness,
                         const Vertex_sharpness& vertex_sharpness)
  {
    for (Index e = 0; e < level_.number_of_edges(); ++e) add_edge(e, edge_sharpness(e));
    collect_ends();
    std::size_t first = 0;
    for (Index v = 0; v < level_.number_of_vertices(); ++v) {
      std::size_t end = first;
      while (end < sorted_.size() && level_.target(sorted_[end].halfedge) == v) ++end;
      const double sharpness = sharpness_of_vertex(v, vertex_sharpness(v));
      if (end != first || sharpness > 0) add_star(v, sharpness, first, end);
      first = end;
    }
    return std::move(creases_);
  }

private:
  struct Sorted_end
  {
    Index halfedge;
    Crease_end end;
  };

  void add_edge(Index e, double sharpness)
  {
    Crease_edge<FT> crease;
    crease.edge = crease.control_edge = e;
    crease.tangent_from.fill(zero_vector<FT, 3>());
    for (Index side = 0; side < 2; ++side)
      if (level_.is_border(2 * e + side)) crease.border_side = side;
    const bool is_tagged = sharpness > 0;
    if (crease.is_border() ? !is_tagged && border_ == Border::surface : !is_tagged) return;
    crease.sharpness = crease.is_border() ? infinite_sharpness : sharpness;
    creases_.edges.push_back(crease);
  }

  double sharpness_of_vertex(Index v, double sharpness) const
  {
    if (level_.is_isolated(v)) return 0;
    if (!level_.is_border_vertex(v)) return sharpness;
    const bool is_kept =
      border_ == Border::fixed || (border_ == Border::corners && level_.valence(v) == 2);
    return is_kept ? infinite_sharpness : sharpness;
  }

  // by their vertices, and there by the half-edges
  void collect_ends()
  {
    for (std::size_t i = 0; i < creases_.edges.size(); ++i)
      for (Index side = 0; side < 2; ++side)
        sorted_.push_back({creases_.edges[i].halfedge(side), {static_cast<Index>(i), side}});
    std::sort(sorted_.begin(), sorted_.end(), [&](const Sorted_end& a, const Sorted_end& b) {
      return std::make_pair(level_.target(a.halfedge), a.halfedge) <
             std::make_pair(level_.target(b.halfedge), b.halfedge);
    });
  }

  // Walks round the vertex, from the border on or from the vertex' own half-edge: this order is that of
  // the refined creases, so that a refined mesh that is read again has the same one.
  void add_star(Index v, double sharpness, std::size_t first, std::size_t end)
  {
    const auto first_end = static_cast<Index>(creases_.ends.size());
    const bool is_border = level_.is_border_vertex(v);
    if (end != first) {
      const Index own = level_.halfedge_of_vertex(v);
      const Index start = is_border ? level_.next_around_target(own) : own;
      Index h = start;
      do {
        const auto it = std::lower_bound(
          sorted_.begin() + std::ptrdiff_t(first), sorted_.begin() + std::ptrdiff_t(end), h,
          [](const Sorted_end& a, Index halfedge) { return a.halfedge < halfedge; });
        if (it != sorted_.begin() + std::ptrdiff_t(end) && it->halfedge == h)
          creases_.ends.push_back(it->end);
        h = level_.next_around_target(h);
      } while (h != start);
    }
    creases_.add_star({v, sharpness, is_border}, first_end);
  }

  const Level_connectivity& level_;
  const Border border_;
  Creases<FT> creases_;
  std::vector<Sorted_end> sorted_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CONTROL_CREASES_H
