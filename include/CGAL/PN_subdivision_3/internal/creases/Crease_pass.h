// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_PASS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_PASS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_rules.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/ended_creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// f a + (1 - f) b
template <class FT>
Coordinates<FT, 3> mixed(Coordinates<FT, 3> a, const Coordinates<FT, 3>& b, const FT& f)
{
  scale(a, f);
  add_multiple(a, FT(FT(1) - f), b);
  return a;
}

// The new values on the creases of a round, for all slots of a new vertex together, and the refined creases' tangents.
template <class Mask, class Average>
class Crease_pass
{
public:
  using Rules = Crease_rules<Mask, Average>;
  using Data = typename Rules::Data;
  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  using Slot_value = std::pair<Index, Value>;

  Crease_pass(const Data& data, Refined_creases<FT>& refined)
    : data_(data)
    , refined_(refined)
  {}

  // every new value belongs to one star or edge
  std::vector<Slot_value> operator()(const For_chunks& for_chunks)
  {
    const auto stars = static_cast<Index>(data_.creases.stars.size());
    const auto edges = static_cast<Index>(data_.creases.edges.size());
    place_results(stars, edges);
    for_chunks.in_precision<FT>(stars, [&](Index begin, Index end) {
      Rules rules(data_);
      for (Index i = begin; i < end; ++i)
        name_undecided(data_.creases.stars[i].vertex, [&] { star(rules, i); });
    });
    for_chunks.in_precision<FT>(edges, [&](Index begin, Index end) {
      Rules rules(data_);
      for (Index i = begin; i < end; ++i) name_undecided(new_vertex(i), [&] { edge(rules, i); });
    });
    return std::move(results_);
  }

private:
  static constexpr bool is_pn = Rules::is_pn;
  static constexpr Index null = Level_connectivity::null;
  using Rule_value = typename Rules::Value;

  Index new_vertex(Index crease) const
  {
    return data_.first_edge_vertex + data_.creases.edges[crease].edge;
  }

  void place_results(Index stars, Index edges)
  {
    std::size_t n = 0;
    const auto place = [&](Index refined_star) {
      first_result_.push_back(n);
      n += refined_star == null ? 1 : refined_.creases.stars[refined_star].number_of_wedges;
    };
    for (Index i = 0; i < stars; ++i) place(refined_.star[i]);
    for (Index i = 0; i < edges; ++i) place(star_of_edge(i));
    results_.resize(n);
  }
  Index star_of_edge(Index crease) const
  {
    const Index rank = refined_.rank[crease];
    return rank == null ? null : refined_.first_edge_star + rank;
  }

  template <class Function>
  void name_undecided(Index vertex, const Function& f) const
  {
    internal::name_undecided<FT>(f, [&] {
      return "the rule of vertex " + std::to_string(vertex) + " on a crease in round " +
             std::to_string(data_.round);
    });
  }

  // \name Vertices
  void star(Rules& rules, Index i)
  {
    const Creases<FT>& creases = data_.creases;
    const Crease_star& star = creases.stars[i];
    const Wedge_merge all =
      merge_wedges<FT>(creases, star, [](const Crease_halfedge&) { return true; });
    const Wedge_merge merge = merge_wedges<FT>(
      creases, star, [&](const Crease_halfedge& e) { return refined_.rank[e.crease] != null; });
    const Vertex_rule parent = creases.rule(star);
    const Vertex_rule child = vertex_rule(refined_sharpness(star.sharpness), merge.ends.size(),
                                          star.is_border && merge.has_inner_end);
    Rule_value value = rules.vertex(star, parent, all);
    if (is_pn) {
      // a corner that becomes a crease vertex passes on one direction of travel
      if (parent == Vertex_rule::corner && child == Vertex_rule::crease)
        make_opposite_vectors<FT>(value.tangents[merge.ends[0]], value.tangents[merge.ends[1]]);
      value.normals = merge_normals<FT>(value.normals, merge);
      merge_roundness(merge, value.roundness);
    } else if (!is_same_rule(parent, child)) {
      const FT f(weight_of_parent_rule(creases, star));
      if (f < FT(1))
        value.point = mixed<FT>(value.point, rules.vertex(star, child, merge).point, f);
    }
    put(i, refined_.star[i], star.vertex, value, [](Index w) { return w; });
    for (std::size_t j = 0; j < merge.ends.size(); ++j) {
      const Crease_halfedge& e = creases.end(star, merge.ends[j]);
      const Index half = refined_.second_half(refined_.rank[e.crease], e.side);
      refined_.creases.edges[half].tangent_from[1 - e.side] = value.tangents[merge.ends[j]];
    }
  }

  // a merged wedge gets the roundness 0 later, so that the roundness of any of its old wedges will do here
  static void merge_roundness(const Wedge_merge& merge, std::vector<FT>& roundness)
  {
    if (roundness.size() == merge.number_of_wedges) return;
    std::vector<FT> merged(merge.number_of_wedges, FT(0));
    for (std::size_t w = 0; w < roundness.size(); ++w) merged[merge.wedge[w]] = roundness[w];
    roundness = merged;
  }

  // \name Edges
  void edge(Rules& rules, Index i)
  {
    const Crease_edge<FT>& e = data_.creases.edges[i];
    Rule_value value = rules.edge(e);
    if (!is_pn && e.sharpness < 1)
      value.point = mixed<FT>(value.point, rules.smooth_edge(e).point, FT(e.sharpness));
    const Index rank = refined_.rank[i];
    if (is_pn && rank == null) {
      Wedge_merge merge;
      merge.wedge = {0, 0};
      value.normals = merge_normals<FT>(value.normals, merge);
    }
    const Index first_side = e.has_after(0) ? 0 : 1;
    put(static_cast<Index>(data_.creases.stars.size()) + i, star_of_edge(i), new_vertex(i), value,
        [&](Index w) { return first_side + w; });
    if (rank == null) return;
    auto& edges = refined_.creases.edges;
    edges[refined_.first_half(rank, 0)].tangent_from[1] = opposite_vector(value.tangents[0]);
    edges[refined_.first_half(rank, 1)].tangent_from[0] = value.tangents[0];
  }

  // \name Both
  // place_of_normal(w) is the position in `value` of the normal of wedge w of the refined star
  template <class Normal_of>
  void put(Index owner, Index refined_star, Index vertex, const Rule_value& value,
           [[maybe_unused]] const Normal_of& place_of_normal)
  {
    Slot_value* result = results_.data() + first_result_[owner];
    const Index wedges =
      refined_star == null ? 1 : refined_.creases.stars[refined_star].number_of_wedges;
    for (Index w = 0; w < wedges; ++w, ++result) {
      result->first = refined_star == null ? vertex : refined_.creases.stars[refined_star].slot(w);
      if constexpr (is_pn)
        result->second = {value.point, value.normals[place_of_normal(w)], value.roundness[w]};
      else
        result->second = value.point;
    }
  }

  const Data& data_;
  Refined_creases<FT>& refined_;
  std::vector<Slot_value> results_;
  std::vector<std::size_t> first_result_; // of the stars, then of the edges
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_PASS_H
