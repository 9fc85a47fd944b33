// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_SQRT3_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_SQRT3_H

#include "Face_list.h"

#include <map>

namespace reference {

inline Row sqrt3_vertex(const Face_list& mesh, int v, bool refines_border)
{
  const std::vector<int> ring = mesh.ring(v);
  if (ring.empty()) return mesh.point(v);
  if (mesh.is_border(v)) {
    if (!refines_border) return mesh.point(v);
    return (4 * mesh.point(ring.front()) + 19 * mesh.point(v) + 4 * mesh.point(ring.back())) / 27;
  }
  const Real alpha = (4 - 2 * cosine(1 / Real(ring.size()))) / 9;
  return (1 - alpha) * mesh.point(v) + alpha * mesh.mean(ring);
}

// Every side a -> b of a triangle has a new point beside it. Where two triangles meet, the edge
// between these points replaces theirs.
inline Refined sqrt3(const Face_list& mesh, unsigned round)
{
  const bool refines_border = round % 2 == 0;
  Refined result;
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    result.add(sqrt3_vertex(mesh, v, refines_border));
  std::map<Edge, int> beside;
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    Face t = mesh.faces()[std::size_t(f)];
    for (int turn = 0; turn < 3 && mesh.face(t[1], t[0]) >= 0; ++turn)
      std::rotate(t.begin(), t.begin() + 1, t.end()); // the border edge, if any, is t[0] -> t[1]
    const int s = t[0], e = t[1], w = t[2];
    if (!refines_border || mesh.face(e, s) >= 0) {
      beside[{s, e}] = beside[{e, w}] = beside[{w, s}] = result.add(mesh.centroid(f));
      continue;
    }
    const int before = mesh.next_on_border(e, s), after = mesh.next_on_border(s, e);
    beside[{w, s}] =
      result.add((mesh.point(before) + 16 * mesh.point(s) + 10 * mesh.point(e)) / 27);
    beside[{e, w}] = result.add((10 * mesh.point(s) + 16 * mesh.point(e) + mesh.point(after)) / 27);
    result.faces.push_back({beside[{w, s}], beside[{e, w}], w});
  }
  for (const auto& [side, point] : beside) {
    const auto& [a, b] = side;
    if (mesh.face(b, a) >= 0)
      result.faces.push_back({a, beside.at({b, a}), point});
    else
      result.faces.push_back({a, b, point});
  }
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_SQRT3_H
