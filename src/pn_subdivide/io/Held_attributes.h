// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_HELD_ATTRIBUTES_H
#define PN_SUBDIVIDE_HELD_ATTRIBUTES_H

#include "io/Mesh_data.h"

#include <set>
#include <string>
#include <vector>

namespace pn_subdivide {

// What of a mesh's attributes a file format takes, so that the rest can be named.
class Held_attributes
{
public:
  explicit Held_attributes(const Mesh_data& mesh)
    : attributes_(mesh.attributes)
  {}

  // Returns its argument.
  Column_group take(Column_group columns)
  {
    taken_.insert(columns.begin(), columns.end());
    return columns;
  }
  void take_texture() { texture_ = true; }
  void take_texture_files() { texture_files_ = true; }
  void take_material_files() { material_files_ = true; }

  // For people, as in "groups" or "'quality' of vertices".
  std::vector<std::string> rest() const;

private:
  const Attributes& attributes_;
  std::set<const Column*> taken_;
  bool texture_ = false, texture_files_ = false, material_files_ = false;
};

Column_group all_of(const Columns& columns);

// Texture coordinates of the vertices: their own, or those of the corners if these are the same all
// round each vertex and every corner has some. Empty if there are none; vertices without faces have 0.
std::vector<Texture_point> texture_of_vertices(const Mesh_data& mesh);

// Vertices whose corners have different texture coordinates get a copy for each, behind the others, as formats with
// texture coordinates of vertices need it. Corners without any get 0 0; returns how many.
std::size_t split_at_seams(Mesh_data& mesh);

// Texture coordinates of corners become the columns of vertices that other programs read from .ply files; the mesh
// must be split at its seams.
void move_texture_to_vertices(Mesh_data& mesh);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_HELD_ATTRIBUTES_H
