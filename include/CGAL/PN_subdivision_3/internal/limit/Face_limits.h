// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_FACE_LIMITS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_FACE_LIMITS_H

#include <CGAL/PN_subdivision_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_tower.h>
#include <CGAL/PN_subdivision_3/internal/limit/Ring_class.h>
#include <CGAL/PN_subdivision_3/internal/limit/orient_normals.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The limits at the faces of a level of a dual scheme, whose corners in a face of the next round
// depend on those of the face alone: the ring of a face is its corners.
template <class Scheme, class FT>
class Face_limits
{
public:
  using Index = Level_connectivity::Index;
  using Tower = Limit_tower<Scheme, FT>;
  using Result = typename Tower::Result;
  using Level = Valued_level<typename Tower::Value>;

  Face_limits(const Scheme& scheme, const Limit_demand& demand, const For_chunks& for_chunks)
    : scheme_(scheme)
    , demand_(demand)
    , for_chunks_(for_chunks)
  {}

  std::vector<Result> operator()(const Level& level)
  {
    const Index n = level.level.number_of_faces();
    for (Index f = 0; f < n; ++f) {
      auto& ring_class = classes_[level.level.degree(level.level.halfedge_of_face(f))];
      if (!ring_class) ring_class = make(level.level.degree(level.level.halfedge_of_face(f)));
    }
    std::vector<Result> results(n);
    const Caller_precision<FT> precision;
    for_chunks_(n, [&](Index begin, Index end) {
      const typename Caller_precision<FT>::In_this_thread same(precision);
      std::map<Index, std::unique_ptr<Tower>> towers;
      std::vector<Index> ring;
      for (Index f = begin; f < end; ++f) {
        ring.clear();
        const Index first = level.level.halfedge_of_face(f);
        Index h = first;
        do {
          ring.push_back(level.level.target(h));
          h = level.level.next(h);
        } while (h != first);
        auto& tower = towers[static_cast<Index>(ring.size())];
        if (!tower)
          tower =
            std::make_unique<Tower>(*classes_.at(static_cast<Index>(ring.size())), demand_, false);
        tower->add(
          [&](std::size_t p) -> const auto& { return level.values[ring[p]]; }, results[f]);
        if (tower->is_full()) tower->evaluate();
      }
      for (auto& entry : towers) entry.second->evaluate();
    });
    if (demand_.surface_normals) orient_normals(level, results);
    return results;
  }

private:
  using Class = Ring_class<Scheme, FT>;

  // The frame of a surface normal is that of the control normal, which may be on the wrong side.
  static void orient_normals(const Level& level, std::vector<Result>& results)
  {
    const auto point = [&](Index v) { return to_double_3(point_of(level.values[v])); };
    for (Index f = 0; f < static_cast<Index>(results.size()); ++f) {
      Result& result = results[f];
      const Index h = level.level.halfedge_of_face(f);
      if (result.has_surface_normal &&
          is_against_face(level.level, h, point, result.surface_normal))
        result.surface_normal = opposite_vector<double, 3>(result.surface_normal);
    }
  }

  // from a level of one face: its new vertices are the corners in their order
  std::unique_ptr<Class> make(Index degree) const
  {
    Level_size size;
    size.vertices = size.edges = size.corners = degree;
    size.faces = 1;
    size.border_valences = 2 * std::uint64_t(degree);
    Level_connectivity level(size);
    for (Index i = 0; i < degree; ++i) {
      const Index h = 2 * i, next = 2 * ((i + 1) % degree);
      level.set_target(h, i);
      level.set_face(h, 0);
      level.set_next(h, next);
      level.set_target(h + 1, (i + degree - 1) % degree);
      level.set_border(h + 1);
      level.set_next(next + 1, h + 1);
      level.set_halfedge_of_vertex(i, next + 1);
    }
    level.set_halfedge_of_face(0, 0);
    Ring_pair rings;
    rings.ring.resize(degree);
    std::iota(rings.ring.begin(), rings.ring.end(), Index(0));
    rings.next_ring = rings.ring;
    Ring_layout layout;
    layout.first = 0;
    layout.number = degree;
    layout.clockwise = false;
    return std::make_unique<Class>(scheme_, std::vector<Ring_round>{{level, 1, rings}}, layout);
  }

  const Scheme& scheme_;
  const Limit_demand& demand_;
  For_chunks for_chunks_;
  std::map<Index, std::unique_ptr<Class>> classes_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_FACE_LIMITS_H
