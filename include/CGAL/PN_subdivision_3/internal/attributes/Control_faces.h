// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CONTROL_FACES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CONTROL_FACES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Level_origins.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The first control face at an origin, that is the one with the least number at an edge or a vertex. Where
// faces come from faces only, nothing is stored.
class Control_faces
{
public:
  using Index = Level_connectivity::Index;

  Control_faces() = default;
  explicit Control_faces(const Level_connectivity& level)
    : of_edge_(level.number_of_edges(), Level_connectivity::null)
    , of_vertex_(level.number_of_vertices(), Level_connectivity::null)
  {
    for (Index h = 0; h < level.number_of_halfedges(); ++h) {
      if (level.is_border(h)) continue;
      const Index f = level.face(h);
      for (Index* first : {&of_edge_[Level_connectivity::edge(h)], &of_vertex_[level.target(h)]})
        *first = (std::min)(*first, f); // null is the largest
    }
  }

  Index operator()(const Origin& origin) const
  {
    if (origin.kind == Origin::Kind::face) return origin.index;
    const std::vector<Index>& faces = origin.kind == Origin::Kind::edge ? of_edge_ : of_vertex_;
    return faces.empty() ? Level_connectivity::null : faces[origin.index];
  }

private:
  std::vector<Index> of_edge_, of_vertex_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CONTROL_FACES_H
