// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_LOOP_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_LOOP_H

#include "Quadrisection.h"

namespace reference {

inline Row loop_vertex(const Face_list& mesh, int v)
{
  const std::vector<int> ring = mesh.ring(v);
  if (mesh.is_border(v))
    return (mesh.point(ring.front()) + 6 * mesh.point(v) + mesh.point(ring.back())) / 8;
  const Real root = 3 + 2 * cosine(1 / Real(ring.size()));
  const Real alpha = (40 - root * root) / 64;
  return (1 - alpha) * mesh.point(v) + alpha * mesh.mean(ring);
}

inline Row loop_edge(const Face_list& mesh, int a, int b)
{
  if (mesh.is_border(a, b)) return mesh.mean({a, b});
  return (6 * mesh.mean({a, b}) + 2 * mesh.mean({mesh.after(a, b), mesh.after(b, a)})) / 8;
}

inline Refined loop(const Face_list& mesh)
{
  Refined result;
  const auto on_edge = add_vertices_and_edges(
    mesh, result, [&](int v) { return loop_vertex(mesh, v); },
    [&](int a, int b) { return loop_edge(mesh, a, b); });
  add_four_triangles(mesh, on_edge, result);
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_LOOP_H
