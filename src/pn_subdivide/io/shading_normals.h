// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SHADING_NORMALS_H
#define PN_SUBDIVIDE_SHADING_NORMALS_H

#include "io/Mesh_data.h"
#include "io/mesh_normals.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pn_subdivide {

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
  Mesh_data::Index vertex(std::size_t slot) const
  {
    return is_of_corners() ? vertex_[slot] : Mesh_data::Index(slot);
  }
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
    for (const Mesh_data::Index v : mesh_.face(f)) {
      const std::size_t slot = is_of_corners() ? of_corner_[first + i] : v;
      if (!is_zero(normal(slot))) function(i, slot, normal(slot));
      ++i;
    }
  }

private:
  bool is_of_corners() const { return !of_corner_.empty(); }

  const Mesh_data& mesh_;
  std::vector<std::size_t> of_corner_;
  std::vector<Mesh_data::Index> vertex_;
  std::vector<Triple> normals_;
};

// Which of the sums that modelling programs write the normals of a mesh are: unit sums of the normals of the faces with
// weights 1, the area, the angle, the area times the angle, or |a x b| of the two edges of the corner. They are of this kind
// if at least 80 % of them agree with one and the same of these, within two units of their last digit, 2e-6 and what the
// rounding of the points makes of it, and less
// than 80 % with the sum of a x b / (|a|^2 |b|^2): true normals of many round shapes agree with all of them, by
// symmetry, but then with this one, too. Normals that are zero and corners without area do not count.
Shading find_shading(const Mesh_data& mesh);

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

#endif // PN_SUBDIVIDE_SHADING_NORMALS_H
