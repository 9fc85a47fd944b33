// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_BUTTERFLY_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_BUTTERFLY_H

#include "Quadrisection.h"

namespace reference {

// The point beyond the side a -> b of a triangle; on the border its reflection.
inline Row butterfly_beyond(const Face_list& mesh, int a, int b)
{
  if (mesh.face(b, a) >= 0) return mesh.point(mesh.after(b, a));
  return mesh.point(a) + mesh.point(b) - mesh.point(mesh.after(a, b));
}

inline Row butterfly_half_of_wings(const Face_list& mesh, int a, int b)
{
  const int wing = mesh.after(a, b);
  return mesh.point(wing) / 8 -
         (butterfly_beyond(mesh, b, wing) + butterfly_beyond(mesh, wing, a)) / 16;
}

inline Row butterfly_irregular(const Face_list& mesh, int v, int other)
{
  std::vector<int> ring = mesh.ring(v);
  std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), other), ring.end());
  const int n = int(ring.size());
  Row row = Real(0.75) * mesh.point(v);
  for (int j = 0; j < n; ++j) {
    Real s = 0;
    if (n == 3)
      s = j == 0 ? Real(5) / 12 : -Real(1) / 12;
    else if (n == 4)
      s = j == 0 ? Real(3) / 8 : j == 2 ? -Real(1) / 8 : 0;
    else
      s = (Real(0.25) + cosine(Real(j) / n) + cosine(Real(2 * j) / n) / 2) / n;
    row[ring[std::size_t(j)]] += s;
  }
  return row;
}

inline Row butterfly_edge(const Face_list& mesh, int a, int b)
{
  if (mesh.is_border(a, b))
    return (9 * (mesh.point(a) + mesh.point(b)) - mesh.point(mesh.next_on_border(b, a)) -
            mesh.point(mesh.next_on_border(a, b))) /
           16;
  const bool at_a = mesh.is_interior_of_valence_other_than(6, a);
  const bool at_b = mesh.is_interior_of_valence_other_than(6, b);
  if (at_a && at_b) return (butterfly_irregular(mesh, a, b) + butterfly_irregular(mesh, b, a)) / 2;
  if (at_a) return butterfly_irregular(mesh, a, b);
  if (at_b) return butterfly_irregular(mesh, b, a);
  return mesh.mean({a, b}) + butterfly_half_of_wings(mesh, a, b) +
         butterfly_half_of_wings(mesh, b, a);
}

inline Refined butterfly(const Face_list& mesh)
{
  Refined result;
  const auto on_edge = add_vertices_and_edges(
    mesh, result, [&](int v) { return mesh.point(v); },
    [&](int a, int b) { return butterfly_edge(mesh, a, b); });
  add_four_triangles(mesh, on_edge, result);
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_BUTTERFLY_H
