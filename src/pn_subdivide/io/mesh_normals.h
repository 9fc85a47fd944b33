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
#include <utility>
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

// Whether a zero normal of a corner is one of those of its vertex, or says nothing of it.
enum class Zero_normals { count, are_left_out };

// From the normals of its corners. At vertices where they are the same it is this normal, elsewhere
// the normalized sum of the different ones; vertices without faces keep theirs. Drops the normals of
// the corners if they are the same at every vertex.
void set_vertex_normals(Mesh_data& mesh, Zero_normals zero = Zero_normals::count);

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

  std::vector<Triple> values;         // in the order of the first corners that have them
  std::vector<Index> vertex;          // of each
  std::vector<std::size_t> of_corner; // which of them each corner has
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
  std::size_t of_all_faces = 0; // that point against each one of these
  Index first_vertex = 0;       // by its number in the file

  void add(Index vertex)
  {
    first_vertex = number == 0 ? vertex : (std::min)(first_vertex, vertex);
    ++number;
  }
};
Opposing_normals find_opposing_normals(const Mesh_data& mesh);

// Turns those over that point against each one of their faces.
Opposing_normals turn_opposing_normals(Mesh_data& mesh);

inline bool is_zero(const Triple& n)
{
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

// The normals of a mesh that has some, of corners if these have them: equal ones of a vertex count once and stand for
// all faces that have them, so where files tell normals of wedges these are the wedges.
class Normal_slots
{
public:
  explicit Normal_slots(const Mesh_data& mesh)
    : mesh_(mesh)
  {
    if (mesh.corner_normals.empty()) return;
    Different_values different(mesh, mesh.corner_normals);
    of_corner_ = std::move(different.of_corner);
    vertex_ = std::move(different.vertex);
    normals_ = std::move(different.values);
  }

  std::size_t size() const { return is_of_corners() ? vertex_.size() : mesh_.points.size(); }
  Index vertex(std::size_t slot) const { return is_of_corners() ? vertex_[slot] : Index(slot); }
  const Triple& normal(std::size_t slot) const
  {
    return is_of_corners() ? normals_[slot] : mesh_.normals[slot];
  }

  // `function(i, slot, normal)` for each corner of a face, the i-th, that has a normal
  template <class Function>
  void for_each(std::size_t f, const Function& function) const
  {
    const std::size_t first = mesh_.first_corner(f);
    std::size_t i = 0;
    for (const Index v : mesh_.face(f)) {
      const std::size_t slot = is_of_corners() ? of_corner_[first + i] : v;
      if (!is_zero(normal(slot))) function(i, slot, normal(slot));
      ++i;
    }
  }

private:
  bool is_of_corners() const { return !of_corner_.empty(); }

  const Mesh_data& mesh_;
  std::vector<std::size_t> of_corner_;
  std::vector<Index> vertex_;
  std::vector<Triple> normals_;
};

// Which of the sums that modelling programs write the normals of a mesh are: unit sums of the normals of the faces with
// weights 1, the area, the angle, the area times the angle, or |a x b| of the two edges of the corner. They are of this kind
// if at least 80 % of them agree with one and the same of these, within two units of their last digit, 2e-6 and what the
// rounding of the points makes of it, and less
// than 80 % with the sum of a x b / (|a|^2 |b|^2): true normals of many round shapes agree with all of them, by
// symmetry, but then with this one, too. Normals that are zero and corners without area do not count.
Shading find_shading(const Mesh_data& mesh);
double rounding_of(const std::vector<Triple>& points); // of a file

// The components of the mesh whose normals say nothing of its shape: in the median more than 10 degrees from the normals by arcs, by
// areas and by angles, each of them.
struct Stray_normals
{
  std::vector<bool> is_stray; // the component of a vertex
  std::size_t components = 0, of = 0;
  double degrees = 0; // by which they are off, at the most
};
Stray_normals find_stray_normals(const Mesh_data& mesh);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_MESH_NORMALS_H
