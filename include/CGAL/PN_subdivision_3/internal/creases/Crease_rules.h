// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_RULES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_RULES_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/creases/Crease_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/ended_creases.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The weights in the row of a vertex on a crease: of both neighbors on the crease, in their order, and of the vertex.
template <class FT>
std::array<FT, 3> crease_weights(const Entry_row<FT>& row, Level_connectivity::Index v)
{
  std::array<FT, 3> weights{FT(0), FT(0), FT(0)};
  std::size_t next = 0;
  for (const auto* e = row.begin(); e != row.end(); ++e)
    weights[e->vertex == v ? 2 : (std::min)(next++, std::size_t(1))] += e->weight;
  return weights;
}

// The rules of creases, corners and darts. Objects of this class are cheap and not shared by threads.
template <class Mask, class Average>
class Crease_rules
{
public:
  static constexpr bool is_pn = has_normal_v<typename Average::Value>;

  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;

  // What the rules of a round read: the level cut open, its creases and the values of the slots.
  struct Data
  {
    const Level_connectivity& cut;
    const Creases<FT>& creases;
    const Mask& mask; // of the cut level
    const Average& average;
    unsigned round;
    Index first_edge_vertex; // the new vertices of edges follow one another
    const Smooth_rows<FT>* smooth_rows;
    const Smooth_rows<FT>* smooth_normal_rows; // of a normal mask, if there is one
    const typename Average::Value* old;
  };
  // A new point at a vertex or edge, its normal in each wedge, and the tangents from it: along the ends
  // of a star, or in the direction of travel along an edge.
  struct Value
  {
    Vector point;
    std::vector<Vector> normals, tangents;
    std::vector<FT> roundness; // of the wedges, if there are normals
  };

  explicit Crease_rules(const Data& data)
    : data_(data)
  {}

  // the edge point; the normal on the side of the half-edge of side 0 first
  Value edge(const Crease_edge<FT>& e)
  {
    const Index a = data_.cut.target(e.halfedge(1)), b = data_.cut.target(e.halfedge(0));
    row_.clear();
    data_.mask.edge(e.edge, row_);
    std::array<FT, 2> weight{FT(0), FT(0)};
    for (const auto* entry = row_.begin(); entry != row_.end(); ++entry)
      weight[entry->vertex == b ? 1 : 0] += entry->weight;
    const std::array<Entry, 2> entries{{{weight[0], point(a), e.tangent_from[0]},
                                        {weight[1], point(b), opposite_vector(e.tangent_from[1])}}};
    std::vector<FT> roundness;
    for (Index side = 0; is_pn && side < 2; ++side)
      if (e.has_after(side))
        roundness.push_back(averaged_roundness(
          entries, {side == 0 ? e.before[1] : e.after[1], side == 0 ? e.after[0] : e.before[0]}));
    const Rule average(entries.data(), entries.data() + 2, largest(roundness));
    Value result{average.point(), {}, {average.tangent()}, roundness};
    if (!is_pn) return result;
    const Vector none = zero_vector<FT, 3>();
    result.normals = {none, none};
    if (e.has_after(0))
      result.normals[0] = normal<2>(average, {normal(e.before[1]), normal(e.after[0])});
    if (e.has_after(1))
      result.normals[1] = normal<2>(average, {normal(e.after[1]), normal(e.before[0])});
    return result;
  }

  // the scheme's own rule of an inner edge, without normals
  Value smooth_edge(const Crease_edge<FT>& e)
  {
    const auto i = std::size_t(&e - data_.creases.edges.data());
    return smooth([i](const Smooth_rows<FT>& rows) { return rows.of_edge(i); });
  }

  // the new point of a vertex by a rule; without normals as if only the ends of `merge` existed
  Value vertex(const Crease_star& star, Vertex_rule rule, const Wedge_merge& merge)
  {
    if (rule == Vertex_rule::corner) return corner(star);
    if (rule == Vertex_rule::crease) return crease(star, merge);
    const auto star_index = std::size_t(&star - data_.creases.stars.data());
    Value result =
      smooth([star_index](const Smooth_rows<FT>& rows) { return rows.of_star(star_index); });
    for (const Index i : merge.ends) {
      Vector t = data_.creases.tangent_from(data_.creases.end(star, i));
      if (is_pn) {
        const FT length = root_of_square<FT>(dot(t, t));
        add_multiple(t, FT(-dot(t, result.normals[0])), result.normals[0]);
        t = unit_or_zero(t, length);
      }
      result.tangents.push_back(t);
    }
    return result;
  }

private:
  using Rule = Crease_average<FT, 3>;
  using Entry = typename Rule::Entry;
  using Row = Entry_row<FT>;

  Vector point(Index slot) const { return point_of(data_.old[slot]); }
  // of points alone the normal is zero, and the roundness 1, for which no caller asks
  Point_normal<FT, 3> whole(Index slot) const
  {
    if constexpr (is_pn)
      return data_.old[slot];
    else
      return {data_.old[slot], Vector{}};
  }
  Vector normal(Index slot) const { return whole(slot).normal; }
  FT roundness(Index slot) const { return whole(slot).roundness; }
  template <std::size_t n>
  FT averaged_roundness(const std::array<Entry, n>& entries,
                        const std::array<Index, n>& slot_ids) const
  {
    return internal::averaged_roundness(entries,
                                        [&](std::size_t j) { return roundness(slot_ids[j]); });
  }
  // the roundness of the crease: a circle between a plane and a wedge that is not round is round
  FT largest(const std::vector<FT>& of_wedges) const
  {
    if (of_wedges.empty()) return FT(1);
    return (CGAL::max)(of_wedges.front(), of_wedges.back()); // two at most
  }
  template <std::size_t n>
  static Vector normal(const Rule& average, const std::array<Vector, n>& normals)
  {
    return average.normal([&](std::size_t j) -> const Vector& { return normals[j]; });
  }

  Value corner(const Crease_star& star) const
  {
    Value result{point(star.vertex), {}, {}, {}};
    if (is_pn)
      for (Index w = 0; w < star.number_of_wedges; ++w) {
        result.normals.push_back(normal(star.slot(w)));
        result.roundness.push_back(roundness(star.slot(w)));
      }
    for (const Crease_halfedge& e : data_.creases.ends_of(star))
      result.tangents.push_back(data_.creases.tangent_from(e));
    return result;
  }

  Value crease(const Crease_star& star, const Wedge_merge& merge)
  {
    const Crease_halfedge& to_a = data_.creases.end(star, merge.ends[0]);
    const Crease_halfedge& to_b = data_.creases.end(star, merge.ends[1]);
    row_.clear();
    data_.mask.vertex(star.vertex, row_);
    const std::array<FT, 3> weights = crease_weights(row_, star.vertex);
    const Vector to_last = opposite_vector(data_.creases.tangent_towards(to_b));
    const Index a = data_.cut.source(data_.creases.halfedge(to_a));
    const Index b = data_.cut.source(data_.creases.halfedge(to_b));
    const std::array<Entry, 3> entries{
      {{weights[0], point(a), data_.creases.tangent_towards(to_a)},
       {weights[1], point(b), to_last},
       {weights[2], point(star.vertex), data_.creases.tangent_from(to_b)}}};
    std::vector<FT> roundness;
    if (is_pn) {
      roundness.resize(star.number_of_wedges, FT(1));
      for_each_wedge(star, to_a, to_b, [&](Index w, const std::array<Index, 3>& slot_ids) {
        roundness[w] = averaged_roundness(entries, slot_ids);
      });
    }
    const Rule average(entries.data(), entries.data() + 3, largest(roundness));
    Value result{average.point(), {}, {}, roundness};
    result.tangents = {opposite_vector(average.tangent()), average.tangent()};
    if (is_pn) {
      result.normals.resize(star.number_of_wedges, zero_vector<FT, 3>());
      for_each_wedge(star, to_a, to_b, [&](Index w, const std::array<Index, 3>& slot_ids) {
        result.normals[w] =
          normal<3>(average, {normal(slot_ids[0]), normal(slot_ids[1]), normal(slot_ids[2])});
      });
    }
    return result;
  }

  // calls f(wedge, its slots at a, b and the vertex)
  template <class Function>
  void for_each_wedge(const Crease_star& star, const Crease_halfedge& to_a,
                      const Crease_halfedge& to_b, const Function& f) const
  {
    for (const bool is_reversed : {false, true}) {
      const Crease_halfedge &first = is_reversed ? to_b : to_a, &last = is_reversed ? to_a : to_b;
      const Crease_edge<FT>& crease = data_.creases.edge(first);
      if (!crease.has_after(first.side)) continue;
      const Index slot = crease.after[first.side];
      std::array<Index, 3> slot_ids{data_.creases.far_after(first), data_.creases.far_before(last),
                                    slot};
      if (is_reversed) std::swap(slot_ids[0], slot_ids[1]);
      f(star.wedge(slot), slot_ids);
    }
  }

  // row_of(rows) is the row of the rule
  template <class Row_of>
  Value smooth(const Row_of& row_of) const
  {
    const auto row = row_of(*data_.smooth_rows);
    const Average& average = data_.average;
    if constexpr (!is_pn)
      return {average(row.first, row.second, data_.old), {}, {}, {}};
    else {
      const auto* const old = data_.old;
      const auto average_of_rows = [&] {
        if (data_.smooth_normal_rows != nullptr) {
          const auto normal_row = row_of(*data_.smooth_normal_rows);
          return average(row.first, row.second, normal_row.first, normal_row.second, old);
        }
        return average(row.first, row.second, old);
      };
      const typename Average::Value value = average_of_rows();
      return {value.point, {value.normal}, {}, {value.roundness}};
    }
  }

  const Data& data_;
  Row row_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_RULES_H
