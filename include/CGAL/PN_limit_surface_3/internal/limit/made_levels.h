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

// Closes the rim of a part of triangles by fans, so that it is not taken for a border: sqrt(3) cuts border
// edges into three parts, and no triangle with two of them. Where the rim joins the border the fan gets three
// triangles on the border besides; they have one border edge each.
class Rim_closure
{
public:
  using Index = Level_connectivity::Index;

  // is_rim(b) tells it of the border half-edges
  template <class Is_rim>
  Rim_closure(Level_connectivity& level, const Is_rim& is_rim)
    : level_(level)
  {
    const Index old = level.number_of_halfedges();
    std::vector<char> is_seen(old, 0);
    for (Index b = 0; b < old; ++b)
      if (level.is_border(b) && is_seen[b] == 0) collect(b, is_rim, is_seen);
    if (runs_.empty()) return;
    grow();
    for (Run& run : runs_) close(run);
  }

  // a vertex of the part for each vertex that was added, in their order
  const std::vector<Index>& neighbors_of_new_vertices() const { return neighbors_; }

private:
  // half-edges of the rim, one after the other; between two on the border, or all of a loop
  struct Run
  {
    std::vector<Index> halfedges;
    Index before = Level_connectivity::null; // null: a loop
  };

  static Index opposite(Index h) { return Level_connectivity::opposite(h); }

  template <class Is_rim>
  void collect(Index first, const Is_rim& is_rim, std::vector<char>& is_seen)
  {
    std::vector<Index> loop;
    for (const Index b : halfedges_around_face(level_, first)) {
      is_seen[b] = 1;
      loop.push_back(b);
    }
    std::size_t begin = 0; // behind a half-edge on the border, if there is one
    while (begin < loop.size() && is_rim(loop[begin])) ++begin;
    if (begin == loop.size()) return runs_.push_back({loop, Level_connectivity::null});
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index h = loop[(begin + i) % loop.size()];
      if (!is_rim(h)) continue;
      const Index before = loop[(begin + i + loop.size() - 1) % loop.size()];
      if (!is_rim(before)) runs_.push_back({{}, before});
      runs_.back().halfedges.push_back(h);
    }
  }

  void grow()
  {
    Level_size size = level_.size();
    vertices_ = static_cast<Index>(size.vertices);
    edges_ = static_cast<Index>(size.edges);
    faces_ = static_cast<Index>(size.faces);
    for (const Run& run : runs_) {
      const bool is_loop = run.before == Level_connectivity::null;
      const std::size_t triangles = run.halfedges.size() + (is_loop ? 0 : 3);
      size.vertices += is_loop ? 1 : 3;
      size.edges += triangles + (is_loop ? 0 : 3);
      size.faces += triangles;
      size.corners += 3 * triangles;
    }
    level_.resize(size);
  }

  Index new_vertex(Index neighbor)
  {
    neighbors_.push_back(neighbor);
    return vertices_++;
  }

  void close(Run& run)
  {
    const Index source = level_.target(opposite(run.halfedges.front()));
    if (run.before != Level_connectivity::null) join_ends(run, source);
    const Index center = new_vertex(source);
    const std::size_t n = run.halfedges.size();
    const Index first_spoke = 2 * edges_; // to the center
    for (std::size_t i = 0; i < n; ++i) {
      const Index h = run.halfedges[i];
      const Index in = first_spoke + 2 * Index(i);
      const Index out = opposite(first_spoke + 2 * Index(i == 0 ? n - 1 : i - 1));
      const Index f = faces_++;
      level_.set_next(h, in);
      level_.set_next(in, out);
      level_.set_next(out, h);
      for (const Index g : {h, in, out}) level_.set_face(g, f);
      level_.set_target(in, center);
      level_.set_target(out, level_.target(opposite(h)));
      level_.set_halfedge_of_face(f, h);
      level_.set_halfedge_of_vertex(level_.target(h), h);
    }
    for (const Index b : new_border_) level_.set_halfedge_of_vertex(level_.target(b), b);
    new_border_.clear();
    if (run.before != Level_connectivity::null) level_.set_halfedge_of_vertex(source, run.before);
    level_.set_halfedge_of_vertex(center, first_spoke);
    edges_ += Index(n);
  }

  // three edges from the end of a run back to its start
  void join_ends(Run& run, Index source)
  {
    const Index last = run.halfedges.back(), end = level_.target(last), behind = level_.next(last);
    const Index corners[] = {end, new_vertex(end), new_vertex(source), source};
    Index next_border = behind;
    for (int i = 0; i < 3; ++i) {
      const Index h = 2 * edges_++, b = opposite(h);
      level_.set_target(h, corners[i + 1]);
      level_.set_target(b, corners[i]);
      level_.set_border(b);
      level_.set_next(b, next_border);
      next_border = b;
      run.halfedges.push_back(h);
      new_border_.push_back(b);
    }
    level_.set_next(run.before, next_border);
  }

  Level_connectivity& level_;
  std::vector<Run> runs_;
  std::vector<Index> neighbors_, new_border_;
  Index vertices_ = 0, edges_ = 0, faces_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_MADE_LEVELS_H
