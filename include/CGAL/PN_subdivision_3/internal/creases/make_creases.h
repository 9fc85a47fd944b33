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
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
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

  // of edges and of vertices, numbers >= 0
  using Sharpness = Function_ref<double(Index)>;
  Creases<FT> operator()(Sharpness edge_sharpness, Sharpness vertex_sharpness);

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

// The creases of some faces of a level as a level of their own, with their tangents. Its rim, but not the border
// of the whole, has the rules of a smooth border. The origins are the numbers in the whole; edges keep their
// orientation.
template <class FT, class Edge_origin, class Vertex_origin>
Creases<FT> creases_of_part(const Creases<FT>& whole, const Level_connectivity& part,
                            const Edge_origin& edge_origin, const Vertex_origin& vertex_origin)
{
  using Index = Level_connectivity::Index;
  const auto crease_at = [&](Index e) -> const Crease_edge<FT>* {
    const Index origin = edge_origin(e);
    const auto it = std::lower_bound(whole.edges.begin(), whole.edges.end(), origin,
                                     [](const Crease_edge<FT>& c, Index i) { return c.edge < i; });
    return it != whole.edges.end() && it->edge == origin ? &*it : nullptr;
  };
  const auto edge_sharpness = [&](Index e) {
    const Crease_edge<FT>* crease = crease_at(e);
    return crease == nullptr ? 0 : crease->sharpness;
  };
  const auto vertex_sharpness = [&](Index v) {
    const Index origin = vertex_origin(v);
    const auto it = std::lower_bound(whole.stars.begin(), whole.stars.end(), origin,
                                     [](const Crease_star& s, Index i) { return s.vertex < i; });
    return it != whole.stars.end() && it->vertex == origin ? it->sharpness : 0;
  };
  Creases<FT> creases = Make_creases<FT>(part, Border::surface)(edge_sharpness, vertex_sharpness);
  creases.has_fixed_border = whole.has_fixed_border;
  for (Crease_edge<FT>& e : creases.edges) {
    const Crease_edge<FT>& of_whole = *crease_at(e.edge);
    e.control_edge = of_whole.control_edge;
    e.tangent_from = of_whole.tangent_from;
  }
  return creases;
}

// Puts the values of the slots of a part; isolated vertices are not looked at. Wedges that begin at
// a crease are told from the others by this; `slots` are the slots of the whole.
template <class FT, class Halfedge_origin, class Whole_values, class Values>
void take_slot_values(const Level_connectivity& part, const Creases<FT>& creases,
                      const Halfedge_origin& halfedge_origin, const Corner_slots<FT>& slot_of,
                      const Whole_values& whole_values, Values& values)
{
  using Index = Level_connectivity::Index;
  for (Index v = 0; v < part.number_of_vertices(); ++v) {
    if (part.is_isolated(v)) continue;
    const Index own = part.halfedge_of_vertex(v);
    const Index h = part.is_border(own) ? part.next_around_target(own) : own;
    values[v] = whole_values[slot_of(halfedge_origin(h))];
  }
  for (const Crease_star& star : creases.stars)
    for (const Crease_end& e : creases.ends_of(star))
      if (creases.edge(e).has_after(e.side))
        values[creases.edge(e).after[e.side]] =
          whole_values[slot_of(halfedge_origin(creases.halfedge(e)))];
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_MAKE_CREASES_H
