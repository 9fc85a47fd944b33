// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SOUP_REPAIR_H
#define PN_SUBDIVIDE_SOUP_REPAIR_H

#include "io/Mesh_data.h"

#include <string>

namespace pn_subdivide {

struct Soup_repair
{
  std::size_t reversed_faces = 0;
  std::size_t added_vertices = 0; // copies, behind the old vertices

  bool changed_anything() const { return reversed_faces + added_vertices > 0; }
  std::string description() const; // one line
};

// Orients the faces consistently and gives vertices and edges that join too many faces a copy for
// each part, with CGAL's orient_polygon_soup(). Copies take the normal of their original; normals
// are not reversed along with faces, because they say by themselves which way they point.
Soup_repair repair_soup(Mesh_data& mesh);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SOUP_REPAIR_H
