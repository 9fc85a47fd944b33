// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_BUILD_MESH_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_BUILD_MESH_H

#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/property_map/property_map.hpp>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Makes an empty mesh one with the connectivity of a level, with points and normals, and with what put_others() puts.
template <class Access, class Point_map, class Point, class Normal_map, class Vector,
          class Function>
void build_mesh(Access& access, const Level_connectivity& level, Point_map point_map,
                const std::vector<Point>& points, [[maybe_unused]] Normal_map normal_map,
                [[maybe_unused]] const std::vector<Vector>& normals, const Function& put_others)
{
  using Index = Level_connectivity::Index;
  const Level_size size = level.size(), old_size = access.size();
  if (old_size.vertices != 0 || old_size.edges != 0 || old_size.faces != 0)
    throw std::invalid_argument("PN_subdivision_3: the mesh to be built has vertices already: it "
                                "must be empty");
  if (size.halfedges() >= Access::index_limit() || size.vertices >= Access::index_limit())
    throw std::length_error("PN_subdivision_3: the refined mesh has " +
                            std::to_string(size.halfedges()) +
                            " half-edges, more than the index type of the mesh can number");
  Growth<Access> growth(access);
  access.grow(size);
  for (Index v = 0; v < points.size(); ++v) {
    put(point_map, access.vertex(v), points[v]);
    if constexpr (!std::is_same_v<Normal_map, No_normal_map>)
      if (v < normals.size()) put(normal_map, access.vertex(v), normals[v]);
  }
  put_others();
  access.write(level, For_chunks());
  growth.keep();
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_BUILD_MESH_H
