// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CATMULLCLARK_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CATMULLCLARK_H

#include "Quadrisection.h"

namespace reference {

inline Row catmull_clark_vertex(const Face_list& mesh, int v)
{
  const std::vector<int> ring = mesh.ring(v);
  if (mesh.is_border(v))
    return (mesh.point(ring.front()) + 6 * mesh.point(v) + mesh.point(ring.back())) / 8;
  const Real n = Real(ring.size());
  Row faces = mesh.zero(), edges = mesh.zero();
  for (int u : ring) {
    faces += mesh.centroid(mesh.face(v, u)) / n;
    edges += mesh.mean({v, u}) / n;
  }
  return (faces + 2 * edges + (n - 3) * mesh.point(v)) / n;
}

inline Row catmull_clark_edge(const Face_list& mesh, int a, int b)
{
  if (mesh.is_border(a, b)) return mesh.mean({a, b});
  return (mesh.point(a) + mesh.point(b) + mesh.centroid(mesh.face(a, b)) +
          mesh.centroid(mesh.face(b, a))) /
         4;
}

inline Refined catmull_clark(const Face_list& mesh)
{
  Refined result;
  const auto on_edge = add_vertices_and_edges(
    mesh, result, [&](int v) { return catmull_clark_vertex(mesh, v); },
    [&](int a, int b) { return catmull_clark_edge(mesh, a, b); });
  std::vector<int> on_face;
  for (int f = 0; f < mesh.number_of_faces(); ++f) on_face.push_back(result.add(mesh.centroid(f)));
  add_corner_quads(mesh, on_edge, on_face, result);
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CATMULLCLARK_H
