// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_MODIFIED_LOOP_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_MODIFIED_LOOP_H

#include "Loop.h"
#include "Tuned_ring.h"

namespace reference {

// n triangles about the vertex 0; neighbors 1, ..., n.
inline Face_list triangles_about_a_vertex(int n)
{
  std::vector<Face> faces;
  for (int i = 0; i < n; ++i) faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  return Face_list(n + 1, faces);
}

inline Matrix loop_ring(int n)
{
  const Face_list star = triangles_about_a_vertex(n);
  const Refined refined = loop(star);
  Matrix ring(n + 1, n + 1);
  ring.row(0) = refined.points[0];
  for (int i = 0; i < n; ++i) ring.row(1 + i) = refined.points[edge_point(star, 0, 1 + i)];
  return ring;
}

inline const Matrix& modified_loop_ring(int n, Real cap)
{
  static std::map<std::pair<int, Real>, Matrix> rings;
  Matrix& ring = rings[{n, cap}];
  if (ring.size() == 0) ring = tuned_ring(loop_ring(n), n, 1, cap, n <= 4 ? Real(0.5) : Real(0));
  return ring;
}

inline Refined modified_loop(const Face_list& mesh, Real cap)
{
  Refined result = loop(mesh);
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    if (!is_separated(mesh, v, 6, 3)) continue;
    std::vector<int> ring = mesh.ring(v);
    const int n = int(ring.size());
    ring.insert(ring.begin(), v);
    const Matrix& s = modified_loop_ring(n, cap);
    result.points[std::size_t(v)] = spread(mesh, ring, s.row(0));
    for (int i = 0; i < n; ++i)
      result.points[edge_point(mesh, v, ring[std::size_t(1 + i)])] =
        spread(mesh, ring, s.row(1 + i));
  }
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_MODIFIED_LOOP_H
