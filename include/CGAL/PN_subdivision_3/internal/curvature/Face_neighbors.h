// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_FACE_NEIGHBORS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_FACE_NEIGHBORS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/curvature/Curvature_data.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The vertices that share faces with each vertex of the interior, clockwise; none at the border. They begin with
// the neighbor of the least number, whatever half-edge the vertex stores.
class Face_neighbors
{
public:
  using Index = Level_connectivity::Index;

  explicit Face_neighbors(const Curvature_data& data)
    : data_(data)
    , begin_(std::size_t(data.level.number_of_vertices()) + 1, 0)
  {
    count(data.level);
    vertices_.resize(begin_.back());
  }

  // to be called once for every vertex
  void set(Index v)
  {
    if (begin(v) != end(v)) fill(data_.level, v);
  }

  const Index* begin(Index v) const { return vertices_.data() + begin_[v]; }
  const Index* end(Index v) const { return vertices_.data() + begin_[std::size_t(v) + 1]; }

private:
  void count(const Level_connectivity& level)
  {
    const Index uniform = level.uniform_degree();
    for (Index f = 0; f < level.number_of_faces(); ++f) {
      const Index first = level.halfedge_of_face(f);
      const Index degree = uniform != 0 ? uniform : level.degree(first);
      Index h = first;
      do {
        begin_[std::size_t(level.target(h)) + 1] += degree - 2;
        h = level.next(h);
      } while (h != first);
    }
    if (level.has_border())
      for (Index v = 0; v < level.number_of_vertices(); ++v)
        if (!level.is_isolated(v) && level.is_border_vertex(v)) begin_[std::size_t(v) + 1] = 0;
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
  }

  void fill(const Level_connectivity& level, Index v)
  {
    Index* to = vertices_.data() + begin_[v];
    const Index first = first_halfedge(level, v);
    Index h = first;
    do {
      *to++ = level.source(h);
      const Index next = level.next(h);
      for (Index g = level.next(next); level.next(g) != h; g = level.next(g))
        *to++ = level.target(g);
      h = Level_connectivity::opposite(next);
    } while (h != first);
  }

  Index first_halfedge(const Level_connectivity& level, Index v) const
  {
    const Index first = level.halfedge_of_vertex(v);
    Index best = first;
    for (Index h = level.next_around_target(first); h != first; h = level.next_around_target(h))
      if (data_.is_before(level.source(h), level.source(best))) best = h;
    return best;
  }

  const Curvature_data& data_;
  std::vector<std::size_t> begin_; // in vertices_
  std::vector<Index> vertices_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_FACE_NEIGHBORS_H
