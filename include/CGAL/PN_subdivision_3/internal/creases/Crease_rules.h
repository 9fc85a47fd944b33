// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_RULES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_RULES_H

#include <CGAL/PN_subdivision_3/average/Crease_average.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/join_wedges.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Round.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A new point at a vertex or edge, its normal in each wedge, and the tangents from it: along the ends
// of a star, or in the direction of travel along an edge.
template <class FT>
struct Crease_value
{
  using Vectors = std::vector<Coordinates<FT, 3>>;

  Coordinates<FT, 3> point;
  Vectors normals, tangents;
  FT roundness = FT(1); // of all wedges
};

// What the rules of a round read: the level cut open, its creases, the values of the slots and, of
// slots that are read softened, the normals themselves.
template <class Scheme, class Average>
struct Crease_round_data
{
  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using One_round = Round<Scheme, Average>;
  using Slot_normal = std::pair<Index, Coordinates<FT, 3>>;

  const Scheme& scheme;
  const Level_connectivity& cut;
  const Creases<FT>& creases;
  const One_round& round; // its mask is that of the cut level
  const Smooth_rows<FT>* smooth_rows;
  const Smooth_rows<FT>* smooth_normal_rows; // of a normal mask
  const typename One_round::Stored_value* old;
  const std::vector<Slot_normal>& stored_normals; // by their slots
};

// The rules of creases, corners and darts. Objects of this class are cheap and not shared by threads.
template <class Scheme, class Average>
class Crease_rules
{
public:
  static constexpr bool is_pn = !Is_linear<Scheme>::value;

  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;
  using Data = Crease_round_data<Scheme, Average>;
  using Value = Crease_value<FT>;

  explicit Crease_rules(const Data& data)
    : data_(data)
  {}

  // the edge point; the normal on the side of the half-edge of side 0 first
  Value edge(const Crease_edge<FT>& e)
  {
    const Index a = data_.cut.target(e.halfedge(1)), b = data_.cut.target(e.halfedge(0));
    row_.clear();
    data_.round.mask().edge(e.edge, row_);
    std::array<FT, 2> weight{FT(0), FT(0)};
    for (const auto* entry = row_.begin(); entry != row_.end(); ++entry)
      weight[entry->vertex == b ? 1 : 0] += entry->weight;
    const std::array<Entry, 2> entries{
      {{weight[0], point(a), e.tangent_from[0]},
       {weight[1], point(b), opposite_vector<FT, 3>(e.tangent_from[1])}}};
    const FT roundness = averaged_roundness(entries, {a, b});
    const Rule average(entries.data(), entries.data() + 2, roundness);
    Value result{average.point(), {}, {average.tangent()}, roundness};
    if constexpr (is_pn) {
      const Vector none = zero_vector<FT, 3>();
      result.normals = {none, none};
      if (e.has_after(0))
        result.normals[0] = normal(average, {normal(e.before[1]), normal(e.after[0])});
      if (e.has_after(1))
        result.normals[1] = normal(average, {normal(e.after[1]), normal(e.before[0])});
    }
    return result;
  }

  // the scheme's own rule of an inner edge
  Value smooth_edge(const Crease_edge<FT>& e)
  {
    const auto i = std::size_t(&e - data_.creases.edges.data());
    return smooth([i](const Smooth_rows<FT>& rows) { return rows.of_edge(i); }, 2);
  }

  // the vertex by a rule, as if only the ends of `join` existed
  Value vertex(const Crease_star& star, Vertex_rule rule, const Wedge_join& join)
  {
    if (rule == Vertex_rule::corner) return corner(star, join);
    if (rule == Vertex_rule::crease) return crease(star, join);
    const auto star_index = std::size_t(&star - data_.creases.stars.data());
    Value result =
      smooth([star_index](const Smooth_rows<FT>& rows) { return rows.of_star(star_index); },
             join.number_of_wedges);
    for (const Index i : join.ends) {
      Vector t = tangent_from(data_.creases.end(star, i));
      if constexpr (is_pn) {
        const FT length = root_of_square<FT>(dot<FT, 3>(t, t));
        add_multiple<FT, 3>(t, FT(-dot<FT, 3>(t, result.normals[0])), result.normals[0]);
        t = unit_or_zero<FT, 3>(t, length);
      }
      result.tangents.push_back(t);
    }
    return result;
  }

private:
  using Rule = Crease_average<FT, 3>;
  using Entry = typename Rule::Entry;
  using Row = Entry_row<FT>;

  Vector point(Index slot) const
  {
    const typename Average::Value value = data_.old[slot];
    if constexpr (is_pn)
      return value.point;
    else
      return value;
  }
  Vector normal(Index slot) const
  {
    const typename Average::Value value = data_.old[slot];
    return value.normal;
  }
  FT roundness(Index slot) const
  {
    if constexpr (has_roundness_v<typename Average::Value>) {
      const typename Average::Value value = data_.old[slot];
      return value.roundness;
    } else
      return FT(1);
  }
  // Equal ones are not summed: here the weights come in another order than that in which they sum to 1.
  template <std::size_t n>
  FT averaged_roundness(const std::array<Entry, n>& entries,
                        const std::array<Index, n>& slots) const
  {
    FT sum(0);
    bool are_equal = true;
    for (std::size_t j = 0; j < n; ++j) {
      sum += entries[j].weight * roundness(slots[j]);
      are_equal = are_equal && CGAL::certainly(roundness(slots[j]) == roundness(slots[0]));
    }
    return are_equal ? roundness(slots[0]) : sum;
  }
  // not softened
  Vector stored_normal(Index slot) const
  {
    const auto& stored = data_.stored_normals;
    const auto it = std::lower_bound(stored.begin(), stored.end(), slot,
                                     [](const auto& s, Index i) { return s.first < i; });
    return it != stored.end() && it->first == slot ? it->second : normal(slot);
  }
  template <std::size_t n>
  static Vector normal(const Rule& average, const std::array<Vector, n>& normals)
  {
    return average.normal([&](std::size_t j) -> const Vector& { return normals[j]; });
  }
  static Vector normal(const Rule& average, const std::array<Vector, 2>& normals)
  {
    return normal<2>(average, normals);
  }

  const Vector& tangent_from(const Crease_end& e) const
  {
    return data_.creases.edge(e).tangent_from[1 - e.side];
  }
  const Vector& tangent_towards(const Crease_end& e) const
  {
    return data_.creases.edge(e).tangent_from[e.side];
  }
  // the slot of the other end of the edge, behind it and before it
  Index far_after(const Crease_end& e) const { return data_.creases.edge(e).before[1 - e.side]; }
  Index far_before(const Crease_end& e) const { return data_.creases.edge(e).after[1 - e.side]; }

  Value corner(const Crease_star& star, const Wedge_join& join) const
  {
    Value result{point(star.vertex), {}, {}, roundness(star.vertex)};
    if constexpr (is_pn)
      result.normals = joined(star, join, [&](Index slot) { return stored_normal(slot); });
    for (const Index i : join.ends)
      result.tangents.push_back(tangent_from(data_.creases.end(star, i)));
    return result;
  }

  // the normals of the joined wedges
  template <class Normal_of>
  typename Value::Vectors joined(const Crease_star& star, const Wedge_join& join,
                                 const Normal_of& normal_of) const
  {
    typename Value::Vectors normals;
    for (Index w = 0; w < star.number_of_wedges; ++w) normals.push_back(normal_of(star.slot(w)));
    return join_normals<FT>(normals, join);
  }

  Value crease(const Crease_star& star, const Wedge_join& join)
  {
    const Crease_end& to_a = data_.creases.end(star, join.ends[0]);
    const Crease_end& to_b = data_.creases.end(star, join.ends[1]);
    const std::array<FT, 3> weights = crease_weights(star.vertex);
    const Vector to_last = opposite_vector<FT, 3>(tangent_towards(to_b));
    const Index a = data_.cut.source(data_.creases.halfedge(to_a));
    const Index b = data_.cut.source(data_.creases.halfedge(to_b));
    const std::array<Entry, 3> entries{
      {{weights[0], point(a), tangent_towards(to_a)},
       {weights[1], point(b), to_last},
       {weights[2], point(star.vertex), tangent_at(star, to_a, to_b)}}};
    const FT roundness = averaged_roundness(entries, {a, b, star.vertex});
    const Rule average(entries.data(), entries.data() + 3, roundness);
    Value result{average.point(), {}, {}, roundness};
    result.tangents = {opposite_vector<FT, 3>(average.tangent()), average.tangent()};
    if constexpr (is_pn) {
      const auto at_vertex = joined(star, join, [&](Index slot) { return normal(slot); });
      result.normals.resize(join.number_of_wedges, zero_vector<FT, 3>());
      add_wedge(star, join, average, at_vertex, {to_a, to_b}, false, result);
      add_wedge(star, join, average, at_vertex, {to_b, to_a}, true, result);
    }
    return result;
  }

  // the wedge that lies between the ends clockwise, if there is one
  void add_wedge(const Crease_star& star, const Wedge_join& join, const Rule& average,
                 const typename Value::Vectors& at_vertex, const std::array<Crease_end, 2>& ends,
                 bool is_reversed, Value& result) const
  {
    const Crease_edge<FT>& first = data_.creases.edge(ends[0]);
    if (!first.has_after(ends[0].side)) return;
    const Index w = join.wedge[star.wedge(first.after[ends[0].side])];
    std::array<Vector, 3> normals{normal(far_after(ends[0])), normal(far_before(ends[1])),
                                  at_vertex[w]};
    if (is_reversed) std::swap(normals[0], normals[1]);
    result.normals[w] = normal<3>(average, normals);
  }

  // in the direction of travel
  Vector tangent_at(const Crease_star& star, const Crease_end& to_a, const Crease_end& to_b) const
  {
    Vector t = tangent_from(to_b);
    if (data_.creases.rule(star) == Vertex_rule::crease) return t;
    t = difference<FT, 3>(t, tangent_from(to_a));
    return unit_or_zero<FT, 3>(t, FT(2));
  }

  // of the neighbors along the crease and of the vertex itself
  std::array<FT, 3> crease_weights(Index v)
  {
    row_.clear();
    data_.round.mask().vertex(v, row_);
    std::array<FT, 3> weights{FT(0), FT(0), FT(0)};
    std::size_t next = 0;
    for (const auto* e = row_.begin(); e != row_.end(); ++e)
      weights[e->vertex == v ? 2 : (std::min)(next++, std::size_t(1))] += e->weight;
    return weights;
  }

  // row_of(rows) is the row of the rule
  template <class Row_of>
  Value smooth(const Row_of& row_of, Index number_of_wedges) const
  {
    const auto row = row_of(*data_.smooth_rows);
    const Average average{};
    if constexpr (!is_pn)
      return {average(row.first, row.second, data_.old), {}, {}, FT(1)};
    else {
      const Old_values old{data_.old};
      typename Average::Value value;
      if constexpr (Has_normal_mask<Scheme>::value) {
        const auto normal_row = row_of(*data_.smooth_normal_rows);
        value = average(row.first, row.second, normal_row.first, normal_row.second, old);
      } else
        value = average(row.first, row.second, old);
      Value result{value.point, {}, {}, FT(1)};
      if constexpr (has_roundness_v<typename Average::Value>) result.roundness = value.roundness;
      result.normals.resize(number_of_wedges, value.normal);
      return result;
    }
  }

  struct Old_values
  {
    typename Average::Value operator[](std::size_t slot) const { return stored[slot]; }
    const typename Round<Scheme, Average>::Stored_value* stored;
  };

  const Data& data_;
  Row row_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_RULES_H
