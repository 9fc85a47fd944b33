// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_MODIFIED_CATMULLCLARK_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_MODIFIED_CATMULLCLARK_H

#include "CatmullClark.h"
#include "Tuned_ring.h"

namespace reference {

// n quads about the vertex 0; neighbors 1, ..., n, then the vertices between them.
inline Face_list quads_about_a_vertex(int n)
{
  std::vector<Face> faces;
  for (int i = 0; i < n; ++i) faces.push_back({0, 1 + i, 1 + n + i, 1 + (i + 1) % n});
  return Face_list(2 * n + 1, faces);
}

inline Matrix catmull_clark_ring(int n)
{
  const Face_list star = quads_about_a_vertex(n);
  const Refined refined = catmull_clark(star);
  Matrix ring(2 * n + 1, 2 * n + 1);
  ring.row(0) = refined.points[0];
  for (int i = 0; i < n; ++i) {
    ring.row(1 + i) = refined.points[edge_point(star, 0, 1 + i)];
    ring.row(1 + n + i) = refined.points[face_point(star, i)];
  }
  return ring;
}

inline const Matrix& modified_catmull_clark_ring(int n, Real cap)
{
  static std::map<std::pair<int, Real>, Matrix> rings;
  Matrix& ring = rings[{n, cap}];
  if (ring.size() == 0)
    ring = tuned_ring(catmull_clark_ring(n), n, 2, cap, n == 3 ? Real(0.5) : Real(0));
  return ring;
}

inline Refined modified_catmull_clark(const Face_list& mesh, Real cap)
{
  Refined result = catmull_clark(mesh);
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    if (!is_separated(mesh, v, 4, 4)) continue;
    const std::vector<int> neighbors = mesh.ring(v);
    const int n = int(neighbors.size());
    std::vector<int> ring{v};
    ring.insert(ring.end(), neighbors.begin(), neighbors.end());
    for (int u : neighbors) ring.push_back(mesh.after(v, u));
    const Matrix& s = modified_catmull_clark_ring(n, cap);
    result.points[std::size_t(v)] = spread(mesh, ring, s.row(0));
    for (int i = 0; i < n; ++i) {
      const int u = neighbors[std::size_t(i)];
      result.points[edge_point(mesh, v, u)] = spread(mesh, ring, s.row(1 + i));
      result.points[face_point(mesh, mesh.face(v, u))] = spread(mesh, ring, s.row(1 + n + i));
    }
  }
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_MODIFIED_CATMULLCLARK_H
