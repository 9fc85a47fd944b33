// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_ORIENT_SOUP_H
#define PN_SUBDIVIDE_ORIENT_SOUP_H

#include "io/Mesh_data.h"

#include <cstddef>
#include <vector>

namespace pn_subdivide {

// Orients the faces consistently and gives vertices and edges that join too many faces a copy for each part, which stand behind
// the old vertices. Faces that are turned change their `is_reversed`. Returns the number of copies.
std::size_t orient_soup(Mesh_data& mesh, std::vector<bool>& is_reversed);

// What a copy has from its vertex, but for the point.
inline void add_values_of_copy(Mesh_data& mesh, Mesh_data::Index original)
{
  mesh.copied_from.push_back(original);
  if (mesh.has_normals()) mesh.normals.push_back(mesh.normals[original]);
  if (!mesh.roundness.empty()) mesh.roundness.push_back(mesh.roundness[original]);
  for (Column& column : mesh.attributes.of_vertices)
    column.values.push_back(column.values[original]);
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_ORIENT_SOUP_H
