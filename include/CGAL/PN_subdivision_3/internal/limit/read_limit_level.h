// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_READ_LIMIT_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_READ_LIMIT_LEVEL_H

#include <CGAL/Bbox_3.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>

#include <algorithm>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The level of a mesh with points and, for PN schemes, control normals: the user's, or estimated ones
// if there is no map of them.
template <class Scheme, class FT, class Access, class Point_map, class Normal_map>
auto read_limit_level(const Access& access, const Scheme& scheme, Point_map points,
                      Normal_map normals)
{
  static_assert(check_no_grid_rows<Scheme>());
  using Average = Average_of_scheme<Scheme, FT>;
  Valued_level<typename Average::Value> result;
  result.level = checked_level(access);
  check_scheme(scheme, result.level, access);
  refuse_crease_borders(scheme, access, result.level, "there are no limit points");
  result.values =
    read_values<Average>(access, result.level, points, normals, normal_estimate(scheme));
  put_given_roundness(scheme, result.level.number_of_vertices(), result.values);
  return result;
}

// the largest side of a box
inline double size_of(const Bbox_3& box)
{
  return (std::max)(
    {0., box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
}

// that of the box of the points
template <class Value>
double box_size(const Valued_level<Value>& level)
{
  Bbox_3 box;
  for (const Value& value : level.values) {
    const auto p = to_double_3(point_of(value));
    box += Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
  }
  return size_of(box);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_READ_LIMIT_LEVEL_H
