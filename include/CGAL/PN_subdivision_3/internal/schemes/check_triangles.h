// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_CHECK_TRIANGLES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_CHECK_TRIANGLES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <stdexcept>
#include <string>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// refuses, by its name, a face that is not a triangle
template <class Element_names>
void check_triangles(const Level_connectivity& level, const Element_names& names)
{
  if (level.uniform_degree() == 3) return;
  for (Level_connectivity::Index f = 0; f < level.number_of_faces(); ++f) {
    const auto h = level.halfedge_of_face(f);
    if (!level.has_degree(h, 3))
      throw std::invalid_argument(
        "PN_subdivision_3: " + names.face_name(f) + " has " + std::to_string(level.degree(h)) +
        " corners: the scheme takes triangles only; triangulate the mesh");
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_CHECK_TRIANGLES_H
