// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_MAKE_CREASES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_MAKE_CREASES_H

#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// What is sharp on a control level, beside seams; empty if nothing is.
struct Control_sharpness
{
  std::vector<double> edges, vertices;
  Border border = Border::surface;
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

  // the sharpness of an edge or of a vertex, at least 0
  using Sharpness = Function_ref<double(Index)>;
  Creases<FT> operator()(Sharpness edge_sharpness, Sharpness vertex_sharpness);

private:
  struct Sorted_end
  {
    Index halfedge;
    Crease_halfedge end;
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

  // sorts the ends by their vertices, and those at a vertex by their half-edges
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

  // Walks round the vertex, from the border on or from the vertex' own half-edge: the refined
  // creases have this order, so that a refined mesh that is read again has it, too.
  void add_star(Index v, double sharpness, std::size_t first, std::size_t end)
  {
    const auto first_end = static_cast<Index>(creases_.ends.size());
    const bool is_border = level_.is_border_vertex(v);
    if (end != first) {
      const Index own = level_.halfedge_of_vertex(v);
      const Index start = is_border ? level_.next_around_target(own) : own;
      for (const Index h : halfedges_around_target(level_, start)) {
        const auto it = std::lower_bound(
          sorted_.begin() + std::ptrdiff_t(first), sorted_.begin() + std::ptrdiff_t(end), h,
          [](const Sorted_end& a, Index halfedge) { return a.halfedge < halfedge; });
        if (it != sorted_.begin() + std::ptrdiff_t(end) && it->halfedge == h)
          creases_.ends.push_back(it->end);
      }
    }
    creases_.add_star({v, sharpness, is_border}, first_end);
  }

  const Level_connectivity& level_;
  const Border border_;
  Creases<FT> creases_;
  std::vector<Sorted_end> sorted_;
};

template <class FT>
Creases<FT> Make_creases<FT>::operator()(Sharpness edge_sharpness, Sharpness vertex_sharpness)
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

// The creases of a level among others: edge_of(e) and star_of(v) point to what is sharp there, or are null. The rim of a part, but not
// the border of the whole, has the rules of a smooth border.
template <class FT>
Creases<FT> creases_among(const Creases<FT>& others, const Level_connectivity& level,
                          Function_ref<const Crease_edge<FT>*(Level_connectivity::Index)> edge_of,
                          Function_ref<const Crease_star*(Level_connectivity::Index)> star_of)
{
  using Index = Level_connectivity::Index;
  const auto sharpness = [](const auto* s) { return s == nullptr ? 0 : s->sharpness; };
  Creases<FT> result = Make_creases<FT>(level, Border::surface)(
    [&](Index e) { return sharpness(edge_of(e)); }, [&](Index v) { return sharpness(star_of(v)); });
  result.has_fixed_border = others.has_fixed_border;
  for (Crease_edge<FT>& e : result.edges) {
    const Crease_edge<FT>& other = *edge_of(e.edge);
    e.control_edge = other.control_edge;
    e.tangent_from = other.tangent_from;
  }
  return result;
}

// The creases of the refined level, without their tangents, and where the creases of the old level are among them.
template <class FT>
struct Refined_creases
{
  using Index = Level_connectivity::Index;
  static constexpr Index null = Level_connectivity::null;

  Creases<FT> creases;
  std::vector<Index> rank;   // of an old crease edge among the edges that remain, or null
  std::vector<Index> star;   // the new star of an old star, or null where nothing is sharp any more
  Index number_of_edges = 0; // old crease edges that remain
  Index first_edge_star = 0; // from here on the stars of new vertices on edges, by the edges' rank

  Refined_creases(const Creases<FT>& old, const Level_connectivity& level, Index refined_vertices)
    : creases(refined_vertices)
  {
    const Edge_split split(level);
    creases.has_fixed_border = old.has_fixed_border;
    for (const Crease_edge<FT>& e : old.edges)
      rank.push_back(refined_sharpness(e.sharpness) > 0 ? number_of_edges++ : null);
    creases.edges.resize(2 * std::size_t(number_of_edges));
    for (std::size_t i = 0; i < rank.size(); ++i)
      if (rank[i] != null) set_halves(old.edges[i], rank[i], split);
    for (const Crease_star& s : old.stars) refine_star(old, s);
    first_edge_star = static_cast<Index>(creases.stars.size());
    for (std::size_t i = 0; i < rank.size(); ++i)
      if (rank[i] != null) add_edge_star(old.edges[i], rank[i], split);
  }

  // the halves of the edge of rank r: at the source of its half-edge of this side, and at the target
  Index first_half(Index r, Index side) const { return side == 0 ? r : number_of_edges + r; }
  Index second_half(Index r, Index side) const { return first_half(r, 1 - side); }

private:
  void set_halves(const Crease_edge<FT>& old, Index r, const Edge_split& split)
  {
    Crease_edge<FT> half = old;
    half.sharpness = refined_sharpness(old.sharpness);
    for (const Index h : {split.first_half(2 * old.edge), split.second_half(2 * old.edge)}) {
      half.edge = Level_connectivity::edge(h);
      creases.edges[half.edge == old.edge ? r : number_of_edges + r] = half;
    }
  }

  void refine_star(const Creases<FT>& old, const Crease_star& s)
  {
    const auto first_end = static_cast<Index>(creases.ends.size());
    const double sharpness = refined_sharpness(s.sharpness);
    for (const Crease_halfedge& e : old.ends_of(s))
      if (rank[e.crease] != null)
        creases.ends.push_back({second_half(rank[e.crease], e.side), e.side});
    const bool is_sharp = creases.ends.size() != first_end || sharpness > 0;
    star.push_back(is_sharp ? static_cast<Index>(creases.stars.size()) : null);
    if (is_sharp) creases.add_star({s.vertex, sharpness, s.is_border}, first_end);
  }

  void add_edge_star(const Crease_edge<FT>& e, Index r, const Edge_split& split)
  {
    const auto first_end = static_cast<Index>(creases.ends.size());
    const bool is_border = e.is_border();
    // the end that has no face before it comes first
    const Index first_side = is_border ? 1 - e.border_side : 0;
    for (const Index side : {first_side, 1 - first_side})
      creases.ends.push_back({first_half(r, side), side});
    const bool is_corner = is_border && creases.has_fixed_border;
    creases.add_star({split.edge_vertex(2 * e.edge), is_corner ? infinite_sharpness : 0, is_border},
                     first_end);
  }
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_MAKE_CREASES_H
