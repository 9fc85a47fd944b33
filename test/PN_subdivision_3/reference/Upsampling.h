// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_UPSAMPLING_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_UPSAMPLING_H

#include "Quadrisection.h"

namespace reference {

inline std::map<Edge, int> keep_and_halve(const Face_list& mesh, Refined& result)
{
  return add_vertices_and_edges(
    mesh, result, [&](int v) { return mesh.point(v); },
    [&](int a, int b) {
      return mesh.mean({a, b});
    });
}

inline Refined midpoint(const Face_list& mesh)
{
  Refined result;
  const auto on_edge = keep_and_halve(mesh, result);
  add_four_triangles(mesh, on_edge, result);
  return result;
}

inline Refined bilinear(const Face_list& mesh)
{
  Refined result;
  const auto on_edge = keep_and_halve(mesh, result);
  std::vector<int> on_face;
  for (int f = 0; f < mesh.number_of_faces(); ++f) on_face.push_back(result.add(mesh.centroid(f)));
  add_corner_quads(mesh, on_edge, on_face, result);
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_UPSAMPLING_H
