// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_CHECKS_H

#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class Coordinates>
bool has_finite_coordinates(const Coordinates& c)
{
  return CGAL::is_finite(c.x()) && CGAL::is_finite(c.y()) && CGAL::is_finite(c.z());
}

// Once, before CGAL's hosts begin, since they do not check and leak when a mask throws.
template <class PolygonMesh, class PointNormalMap>
void check_mask_input(const PolygonMesh& mesh, const PointNormalMap& point_normals)
{
  std::size_t index = 0;
  const auto require = [&index](bool holds, const char* otherwise) {
    if (!holds)
      throw std::invalid_argument("PN_mask_3: vertex " + std::to_string(index) +
                                  " (counting from 0 in vertices(mesh)) " + otherwise);
  };
  for (auto v : vertices(mesh)) {
    require(halfedge(v, mesh) != boost::graph_traits<PolygonMesh>::null_halfedge(),
            "has no edge, which CGAL's hosts cannot treat; remove it");
    const auto point_normal = get(point_normals, v);
    require(has_finite_coordinates(point_normal.first),
            "has a point with an infinite or NaN coordinate; mend or remove it");
    require(has_finite_coordinates(point_normal.second),
            "has a normal with an infinite or NaN coordinate; give a unit or a zero normal");
    ++index;
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_CHECKS_H
