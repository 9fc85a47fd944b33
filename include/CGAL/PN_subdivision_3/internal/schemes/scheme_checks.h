// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_CHECKS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <stdexcept>
#include <string>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What a scheme refuses in a control mesh, by the name of the element.

template <class Element_names>
void check_face_degrees(const Level_connectivity& level, const Element_names& names,
                        Level_connectivity::Index degree, const char* advice)
{
  if (level.uniform_degree() == degree) return;
  for (Level_connectivity::Index f = 0; f < level.number_of_faces(); ++f) {
    const auto h = level.halfedge_of_face(f);
    if (!level.has_degree(h, degree))
      throw std::invalid_argument("PN_subdivision_3: " + names.face_name(f) + " has " +
                                  std::to_string(level.degree(h)) + " corners: the scheme takes " +
                                  advice);
  }
}

template <class Element_names>
void check_triangles(const Level_connectivity& level, const Element_names& names)
{
  check_face_degrees(level, names, 3, "triangles only; triangulate the mesh");
}

template <class Element_names>
void check_quadrilaterals(const Level_connectivity& level, const Element_names& names)
{
  check_face_degrees(level, names, 4,
                     "quadrilaterals only; apply one round of Catmull-Clark first");
}

// The interpolatory schemes have no rule for an interior vertex of valence 2, and Doo-Sabin would make a face
// with two corners of it, which is no face of a polygon mesh.
template <class Element_names>
void check_interior_valences(const Level_connectivity& level, const Element_names& names)
{
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v) {
    const auto h = level.halfedge_of_vertex(v);
    if (h == Level_connectivity::null || level.is_border(h)) continue;
    if (level.next_around_target(level.next_around_target(h)) == h)
      throw std::invalid_argument("PN_subdivision_3: " + names.vertex_name(v) +
                                  " has valence 2: the scheme has no rule for an interior vertex "
                                  "with two edges; join them");
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_CHECKS_H
