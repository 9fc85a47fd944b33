// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_NORMALS_OF_FILE_H
#define PN_SUBDIVIDE_NORMALS_OF_FILE_H

#include "io/Mesh_data.h"

#include <algorithm>
#include <cstddef>

namespace pn_subdivide {

// What the normals are that a file gives to vertices or corners.

// Zero everywhere: "no control normal here". Also if there are none.
bool are_all_zero(const Mesh_data& mesh);

// How many different normals there are on how many faces, if each is that of its face within 0.1
// degrees; corners without a normal and faces without area do not count.
Flat_shading find_flat_shading(const Mesh_data& mesh);

// Normals that point against the faces whose corners have them.
struct Opposing_normals
{
  std::size_t number = 0, of = 0;
  std::size_t of_all_faces = 0;      // that point against each one of these
  Mesh_data::Index first_vertex = 0; // by its number in the file

  void add(Mesh_data::Index vertex)
  {
    first_vertex = number == 0 ? vertex : (std::min)(first_vertex, vertex);
    ++number;
  }
};
Opposing_normals find_opposing_normals(const Mesh_data& mesh);

// Turns those over that point against each one of their faces.
Opposing_normals turn_opposing_normals(Mesh_data& mesh);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_NORMALS_OF_FILE_H
