// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_CREASED_SUB_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_CREASED_SUB_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Corner_slots.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/schemes/with_border.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The part of a level about some vertices, with its creases, their tangents and the values of its slots. At its rim,
// but not at the border of the level, the rules are those of a smooth border.
template <class FT, class Value>
class Creased_sub_level
{
public:
  using Index = Level_connectivity::Index;

  // `level` is not cut open, `values` are those of its slots
  Creased_sub_level(const Level_connectivity& level, const Creases<FT>& creases,
                    const std::vector<Value>& values, const std::vector<Index>& centers,
                    unsigned rings)
    : sub_(level, centers, rings, true)
    , creases_(Make_creases<FT>(sub_.level(), Border::surface)(
        [&](Index e) {
          const Crease_edge<FT>* crease = crease_at(creases, sub_.edge_origin()[e]);
          return crease == nullptr ? 0 : crease->sharpness;
        },
        [&](Index v) { return sharpness_at(creases, sub_.origin()[v]); }))
  {
    creases_.has_fixed_border = creases.has_fixed_border;
    for (Crease_edge<FT>& e : creases_.edges)
      e.tangent_from = crease_at(creases, sub_.edge_origin()[e.edge])->tangent_from;
    take_values(Corner_slots<FT>(level, creases), values);
  }

  const Level_connectivity& level() const { return sub_.level(); }
  const Creases<FT>& creases() const { return creases_; }
  const std::vector<Value>& values() const { return values_; }
  // the centers' numbers in this level, in their order
  const std::vector<Index>& centers() const { return sub_.centers(); }

private:
  static const Crease_edge<FT>* crease_at(const Creases<FT>& creases, Index edge)
  {
    const auto it = std::lower_bound(creases.edges.begin(), creases.edges.end(), edge,
                                     [](const Crease_edge<FT>& c, Index e) { return c.edge < e; });
    return it != creases.edges.end() && it->edge == edge ? &*it : nullptr;
  }
  static double sharpness_at(const Creases<FT>& creases, Index vertex)
  {
    const auto it = std::lower_bound(creases.stars.begin(), creases.stars.end(), vertex,
                                     [](const Crease_star& s, Index v) { return s.vertex < v; });
    return it != creases.stars.end() && it->vertex == vertex ? it->sharpness : 0;
  }

  // wedges that begin at a crease are told from the others by this
  void take_values(const Corner_slots<FT>& slots, const std::vector<Value>& values)
  {
    const Level_connectivity& level = sub_.level();
    values_.resize(creases_.number_of_slots);
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      const Index own = level.halfedge_of_vertex(v);
      const Index h = level.is_border(own) ? level.next_around_target(own) : own;
      values_[v] = values[slots(sub_.halfedge_origin(h))];
    }
    for (const Crease_star& star : creases_.stars)
      for (Index i = 0; i < star.number_of_ends; ++i) {
        const Crease_end& e = creases_.end(star, i);
        if (creases_.edge(e).has_after(e.side))
          values_[creases_.edge(e).after[e.side]] =
            values[slots(sub_.halfedge_origin(creases_.halfedge(e)))];
      }
  }

  Sub_level sub_;
  Creases<FT> creases_;
  std::vector<Value> values_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_CREASED_SUB_LEVEL_H
