// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_MESH_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_MESH_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Leaf_triangles.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Split_edges.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The triangles of all leaves as a level of their own. They are joined along the half-edges that they have from the
// edges of the levels, not by their vertices: two of these may have several edges.
template <class FT>
class Tessellation_mesh
{
public:
  using Index = Level_connectivity::Index;
  using Vector = flatness::Vector;

  Tessellation_mesh(const Split_edges<FT>& all, const Leaf_triangles<FT>& triangles)
    : all_(all)
    , triangles_(triangles.triangles())
  {
    Level_size size;
    size.vertices = all.number_of_vertices();
    size.edges = triangles.number_of_edges();
    size.faces = triangles_.size();
    size.corners = 3 * size.faces;
    level_ = Level_connectivity(size);
    level_.set_uniform_degree(3);
    connect(triangles.number_of_edges());
    find_isolated(size);
  }

  const Level_connectivity& level() const { return level_; }
  // calls f(half-edge, normal) for all corners
  template <class Function>
  void for_each_corner(const Function& f) const
  {
    for (const Tessellation_triangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i)
        f(t.halfedges[i == 0 ? 2 : i - 1], all_.slot(t.slot_ids[i]).normal);
  }
  // of the vertices, where there are several wedges the mean of these
  std::vector<Vector> normals() const
  {
    std::vector<Vector> sums(all_.number_of_vertices(), Vector{});
    std::vector<unsigned> wedges(sums.size(), 0);
    for (Index s = 0; s < all_.number_of_slots(); ++s) {
      const auto& slot = all_.slot(s);
      if (slot.vertex == null) continue;
      add_multiple<double, 3>(sums[slot.vertex], 1, slot.normal);
      ++wedges[slot.vertex];
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
      if (wedges[v] > 1) sums[v] = unit_or_zero<double, 3>(sums[v], wedges[v]);
    return sums;
  }

private:
  static constexpr Index null = Level_connectivity::null;
  static Index opposite(Index h) { return Level_connectivity::opposite(h); }

  void connect(Index number_of_edges)
  {
    std::vector<Index> before(2 * std::size_t(number_of_edges), null);
    for (Index v = 0; v < level_.number_of_vertices(); ++v) level_.set_isolated(v);
    for (Index t = 0; t < triangles_.size(); ++t) {
      const auto& triangle = triangles_[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const Index h = triangle.halfedges[i], next = triangle.halfedges[(i + 1) % 3];
        const Index target = all_.slot(triangle.slot_ids[(i + 1) % 3]).vertex;
        level_.set_next(h, next);
        before[next] = h;
        level_.set_face(h, t);
        level_.set_target(h, target);
        level_.set_halfedge_of_vertex(target, h);
      }
      level_.set_halfedge_of_face(t, triangle.halfedges[0]);
    }
    for (Index h = 0; h < before.size(); ++h)
      if (before[h] == null) connect_border(h, before);
  }

  // the border goes on where the fan of triangles at its target ends
  void connect_border(Index h, const std::vector<Index>& before)
  {
    Index last = before[opposite(h)];
    const Index target = level_.target(last);
    while (before[opposite(last)] != null) last = before[opposite(last)];
    level_.set_border(h);
    level_.set_target(h, target);
    level_.set_next(h, opposite(last));
    level_.set_halfedge_of_vertex(target, h);
  }

  void find_isolated(Level_size size)
  {
    for (Index v = 0; v < level_.number_of_vertices(); ++v)
      if (level_.is_isolated(v)) ++size.isolated_vertices;
    level_.set_size(size);
  }

  const Split_edges<FT>& all_;
  const std::vector<Tessellation_triangle>& triangles_;
  Level_connectivity level_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_MESH_H
