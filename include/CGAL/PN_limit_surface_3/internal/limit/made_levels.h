// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_MADE_LEVELS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_MADE_LEVELS_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// A face by its half-edges in turn, each with its target.
using Made_face = std::vector<std::pair<Level_connectivity::Index, Level_connectivity::Index>>;

// The level of faces of one degree whose half-edges and vertices have numbers already. All other half-edges are on the border,
// which passes every vertex once at most; a vertex inside has one of its half-edges.
inline Level_connectivity level_of_faces(Level_connectivity::Index vertices,
                                         Level_connectivity::Index edges,
                                         const std::vector<Made_face>& faces)
{
  using Index = Level_connectivity::Index;
  Level_size size;
  size.vertices = vertices;
  size.edges = edges;
  size.faces = faces.size();
  size.corners = faces.size() * faces.front().size();
  Level_connectivity level(size);
  level.set_uniform_degree(static_cast<Index>(faces.front().size()));
  for (Index h = 0; h < level.number_of_halfedges(); ++h) level.set_border(h);
  for (Index f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; i < faces[f].size(); ++i) {
      const auto [h, target] = faces[f][i];
      const Index next = faces[f][(i + 1) % faces[f].size()].first;
      level.set_target(h, target);
      level.set_target(Level_connectivity::opposite(next), target);
      level.set_next(h, next);
      level.set_face(h, f);
      level.set_halfedge_of_vertex(target, h);
    }
    level.set_halfedge_of_face(f, faces[f].front().first);
  }
  std::vector<Index> border_from(vertices);
  for (Index h = 0; h < level.number_of_halfedges(); ++h)
    if (level.is_border(h)) border_from[level.source(h)] = h;
  for (Index h = 0; h < level.number_of_halfedges(); ++h)
    if (level.is_border(h)) {
      level.set_next(h, border_from[level.target(h)]);
      level.set_halfedge_of_vertex(level.target(h), h);
    }
  return level;
}

// Faces all around vertex 0: edge i leads to it from its neighbor 1 + i, and behind the neighbors come the
// diagonal vertices of quads. An open wheel is cut open along edge 0: its neighbor is there twice, the second time as the last
// vertex.
inline Level_connectivity wheel(Level_connectivity::Index valence, Level_connectivity::Index degree,
                                bool is_open = false)
{
  using Index = Level_connectivity::Index;
  const Index n = valence, outer = (degree - 2) * n, spokes = n + (is_open ? 1 : 0);
  // the k-th vertex of the rim
  const auto rim = [&](Index k) {
    if (is_open && k == outer) return 1 + outer;
    k %= outer;
    return degree == 3 ? 1 + k : (k % 2 == 0 ? 1 + k / 2 : 1 + n + k / 2);
  };
  std::vector<Made_face> faces(n);
  for (Index i = 0; i < n; ++i) {
    faces[i] = {{2 * i + 1, 1 + i}};
    for (Index k = (degree - 2) * i; k < (degree - 2) * (i + 1); ++k)
      faces[i].emplace_back(2 * (spokes + k), rim(k + 1));
    faces[i].emplace_back(2 * ((i + 1) % spokes), 0);
  }
  Level_connectivity level = level_of_faces(1 + outer + (is_open ? 1 : 0), spokes + outer, faces);
  if (!is_open) level.set_halfedge_of_vertex(0, 0);
  return level;
}

// Triangles about vertex 0, which is on the border. Edge i leads to it from neighbor i, which is
// vertex 1 + i, and then come the edges opposite to vertex 0.
inline Level_connectivity fan_of_triangles(Level_connectivity::Index triangles)
{
  using Index = Level_connectivity::Index;
  const Index spokes = triangles + 1;
  std::vector<Made_face> faces;
  for (Index i = 0; i < triangles; ++i)
    faces.push_back({{2 * i, 0}, {2 * i + 3, 2 + i}, {2 * (spokes + i), 1 + i}});
  return level_of_faces(1 + spokes, spokes + triangles, faces);
}

// One face, whose corners are the vertices in their order.
inline Level_connectivity single_face(Level_connectivity::Index degree)
{
  Made_face face;
  for (Level_connectivity::Index i = 0; i < degree; ++i) face.emplace_back(2 * i, i);
  Level_connectivity level = level_of_faces(degree, degree, {face});
  Level_size size = level.size();
  size.border_valences = 2 * std::uint64_t(degree);
  level.set_size(size);
  return level;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_MADE_LEVELS_H
