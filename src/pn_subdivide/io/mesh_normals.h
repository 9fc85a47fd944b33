// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_MESH_NORMALS_H
#define PN_SUBDIVIDE_MESH_NORMALS_H

#include "io/Mesh_data.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pn_subdivide {

inline Triple normalized(const Triple& n)
{
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0)) return {0, 0, 0};
  return {n[0] / length, n[1] / length, n[2] / length};
}

// By more than 0.1 degrees, which is more than files are rounded?
inline bool directions_differ(const Triple& m, const Triple& n)
{
  const Triple a = normalized(m), b = normalized(n);
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > 0.0017;
}

// From the normals of its corners. At vertices where they are the same it is this normal, elsewhere
// the normalized sum of the different ones; vertices without faces keep theirs. Drops the normals of
// the corners if they are the same at every vertex.
void set_vertex_normals(Mesh_data& mesh);

// The same where only the corners of some vertices have normals of their own.
void set_several_normals(Mesh_data& mesh, std::vector<Corner_normal>&& normals);

// The roundness of the vertices is made the least of their corners, whose own goes if it is no other.
void set_vertex_roundness(Mesh_data& mesh);

// Vertices whose corners have normals in clearly different directions.
std::size_t vertices_with_several_normals(const Mesh_data& mesh);

// Normals or texture points of a mesh's corners, where equal ones at the same vertex count once.
struct Different_values
{
  Different_values(const Mesh_data& mesh, const std::vector<Triple>& of_corners);

  std::vector<Triple> values;           // in the order of the first corners that have them
  std::vector<Mesh_data::Index> vertex; // of each
  std::vector<std::size_t> of_corner;   // which of them each corner has
};

// The unit vector of the area vector; zero if there is no area.
Triple face_normal(const Mesh_data& mesh, std::size_t f);

inline Triple difference(const Triple& a, const Triple& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Triple cross_product(const Triple& a, const Triple& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double scalar_product(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

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

#endif // PN_SUBDIVIDE_MESH_NORMALS_H
