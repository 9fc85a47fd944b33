// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_VERTEX_RING_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_VERTEX_RING_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A vertex and the vertices of some rings of faces around it, in an order that depends on the
// connectivity alone: the vertex; its neighbors, clockwise, on the border from one border neighbor
// to the other; the other vertices of its faces in the same sense; then ring by ring.
class Vertex_ring
{
public:
  using Index = Level_connectivity::Index;

  // Appends the rings behind what is there. Vertices of the first ring that coincide, as they may on the coarsest
  // meshes, occur as often as they are met.
  static void append(const Level_connectivity& level, Index v, unsigned rings,
                     std::vector<Index>& ring)
  {
    const Index h = level.halfedge_of_vertex(v);
    const auto begin = static_cast<std::ptrdiff_t>(ring.size());
    ring.push_back(v);
    level.for_each_neighbor(h, [&](Index w) { ring.push_back(w); });
    Index g = h;
    do {
      if (!level.is_border(g))
        for (Index c = level.next(level.next(g)); level.next(c) != g; c = level.next(c))
          ring.push_back(level.target(c));
      g = level.next_around_target(g);
    } while (g != h);
    if (rings > 1) append_outer_rings(level, h, rings, {ring.begin() + begin, ring.end()}, ring);
  }

  // The first ring that the vertex will have in the next round of a host that splits edges, in the
  // same order.
  template <class Host>
  static void append_next(const Level_connectivity& level, const Host& host, Index v,
                          std::vector<Index>& ring)
  {
    const Index first = level.halfedge_of_vertex(v);
    ring.push_back(v);
    Index h = first;
    do {
      h = level.next(h);
      ring.push_back(host.vertex_of_edge(Level_connectivity::edge(h)));
      h = Level_connectivity::opposite(h);
    } while (h != first);
    if constexpr (Host::refined_degree == 4) do {
        if (!level.is_border(h)) ring.push_back(host.vertex_of_face(level.face(h)));
        h = level.next_around_target(h);
      } while (h != first);
  }

private:
  static void append_outer_rings(const Level_connectivity& level, Index h, unsigned rings,
                                 std::unordered_set<Index>&& known, std::vector<Index>& ring)
  {
    std::vector<Index> in; // a half-edge into each vertex of the last ring, found from the center
    Index g = h;
    do {
      in.push_back(level.next(g));
      if (!level.is_border(g))
        for (Index c = level.next(level.next(g)); level.next(c) != g; c = level.next(c))
          in.push_back(c);
      g = level.next_around_target(g);
    } while (g != h);
    std::vector<Index> next_in;
    for (unsigned r = 1; r < rings; ++r) {
      next_in.clear();
      for (const Index first : in) {
        g = first;
        do {
          if (!level.is_border(g))
            for (Index c = level.next(g); c != g; c = level.next(c))
              if (known.insert(level.target(c)).second) {
                ring.push_back(level.target(c));
                next_in.push_back(c);
              }
          g = level.next_around_target(g);
        } while (g != first);
      }
      in.swap(next_in);
    }
  }
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_VERTEX_RING_H
