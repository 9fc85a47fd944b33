// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SEVERAL_WEDGES_H
#define PN_SUBDIVIDE_SEVERAL_WEDGES_H

#include "surface/Surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pn_subdivide {

// The wedges of vertices that have several, which are few where a mesh is large: runs of faces round the vertex between
// sharp edges and border edges.
class Several_wedges
{
public:
  using Vertex = Surface::Vertex_index;
  using Halfedge = Surface::Halfedge_index;

  // `is_sharp(edge)`
  template <class Is_sharp>
  Several_wedges(const Surface& surface, const Is_sharp& is_sharp)
    : has_several_(surface.number_of_vertices(), false)
  {
    for (const Surface::Edge_index e : surface.edges())
      if (is_sharp(e))
        for (const Halfedge h : {surface.halfedge(e), surface.opposite(surface.halfedge(e))})
          has_several_[surface.target(h)] = true;
    for (const Vertex v : surface.vertices())
      if (has_several_[v]) has_several_[v] = add(surface, is_sharp, v);
  }

  std::size_t size() const { return vertex_.size(); }
  Vertex vertex(std::size_t wedge) const { return vertex_[wedge]; }
  bool at(Vertex v) const { return has_several_[v]; }
  // That of the half-edge's face at its target, which has several.
  std::size_t of(Halfedge h) const { return of_corner_.at(static_cast<std::uint32_t>(h)); }

private:
  // Returns whether there are several.
  template <class Is_sharp>
  bool add(const Surface& surface, const Is_sharp& is_sharp, Vertex v)
  {
    using Run = std::vector<Halfedge>;
    std::vector<Run> runs;
    const auto is_begin = [&](Halfedge h) {
      return !surface.is_border(h) &&
             (is_sharp(surface.edge(h)) || surface.is_border(surface.opposite(h)));
    };
    Halfedge first = surface.halfedge(v);
    const Halfedge start = first;
    while (!is_begin(first)) {
      first = surface.opposite(surface.next(first));
      if (first == start) return false;
    }
    Halfedge h = first;
    do {
      if (is_begin(h)) runs.emplace_back();
      if (!surface.is_border(h)) runs.back().push_back(h);
      h = surface.opposite(surface.next(h));
    } while (h != first);
    if (runs.size() < 2) return false;
    // whatever half-edge the vertex has
    std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
      return *std::min_element(a.begin(), a.end()) < *std::min_element(b.begin(), b.end());
    });
    for (const Run& run : runs) {
      for (const Halfedge corner : run)
        of_corner_.emplace(static_cast<std::uint32_t>(corner), vertex_.size());
      vertex_.push_back(v);
    }
    return true;
  }

  std::vector<bool> has_several_;
  std::vector<Vertex> vertex_; // of each wedge
  std::unordered_map<std::uint32_t, std::size_t> of_corner_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SEVERAL_WEDGES_H
