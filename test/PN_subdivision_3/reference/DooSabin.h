// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_DOOSABIN_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_DOOSABIN_H

#include "Face_list.h"

#include <map>

namespace reference {

inline Row doo_sabin_corner(const Face_list& mesh, const Face& face, std::size_t corner)
{
  const std::size_t n = face.size();
  Row row = mesh.zero();
  for (std::size_t k = 0; k < n; ++k) {
    const Real weight = k == 0 ? Real(n + 5) : 3 + 2 * cosine(Real(k) / Real(n));
    row[face[(corner + k) % n]] += weight / (4 * Real(n));
  }
  return row;
}

inline Refined doo_sabin(const Face_list& mesh)
{
  Refined result;
  std::map<std::pair<int, int>, int> at; // (face, vertex)
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    const Face& face = mesh.faces()[std::size_t(f)];
    result.faces.emplace_back();
    for (std::size_t i = 0; i < face.size(); ++i) {
      at[{f, face[i]}] = result.add(doo_sabin_corner(mesh, face, i));
      result.faces.back().push_back(at[{f, face[i]}]);
    }
  }
  for (const auto& [a, b] : mesh.edges()) {
    const int left = mesh.face(a, b), right = mesh.face(b, a);
    if (left >= 0 && right >= 0)
      result.faces.push_back({at[{left, b}], at[{left, a}], at[{right, a}], at[{right, b}]});
  }
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    const std::vector<int> ring = mesh.ring(v);
    if (ring.empty() || mesh.is_border(v)) continue;
    result.faces.emplace_back();
    for (int u : ring) result.faces.back().push_back(at[{mesh.face(v, u), v}]);
  }
  return result;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_DOOSABIN_H
