// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_CURVATURE_DATA_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_CURVATURE_DATA_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/curvature/Cell_order.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What is known of the vertices of a mesh, which are numbered anew, so that near ones have near numbers. A normal
// is a unit vector or zero; it takes part in the fit if `fits_normals`, and otherwise only tells the sides of the
// surface apart.
struct Curvature_data
{
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  struct Vertex
  {
    Vector point, normal;
  };

  // without normals
  Curvature_data(Level_connectivity&& a_level, const std::vector<Vector>& points)
    : level(std::move(a_level))
    , unit(unit_of(points))
    , old_number(Cell_order(points)())
  {
    vertices.reserve(points.size());
    for (const Index v : old_number) vertices.push_back({points[v], {0, 0, 0}});
    const Index n = level.number_of_vertices();
    std::vector<Index> number(n);
    for (Index v = 0; v < n; ++v) number[old_number[v]] = v;
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      level.set_target(h, number[level.target(h)]);
    for (Index v = 0; v < n; ++v) number[v] = level.halfedge_of_vertex(old_number[v]);
    for (Index v = 0; v < n; ++v) level.set_halfedge_of_vertex(v, number[v]);
  }

  // from one vertex to another, in the unit
  Vector offset(Index from, Index to) const
  {
    const Vector &a = vertices[from].point, &b = vertices[to].point;
    return {unit * (b[0] - a[0]), unit * (b[1] - a[1]), unit * (b[2] - a[2])};
  }

  // The order in which things are added up about a vertex must not depend on the new numbers.
  bool is_before(Index v, Index w) const { return old_number[v] < old_number[w]; }

  Level_connectivity level;
  // A power of two that makes the size of the mesh about 1.
  double unit;
  std::vector<Index> old_number;
  std::vector<Vertex> vertices;
  // Where a vertex has no normal of its own, the normal of its faces gives the plane of the fit. Only if
  // normals are fitted.
  std::vector<Vector> face_normals;
  bool fits_normals = false;

private:
  static double unit_of(const std::vector<Vector>& points)
  {
    const auto span = Cell_order::span(points).second;
    const double size = (std::max)({span[0], span[1], span[2]});
    constexpr int largest = 1000;
    if (!(size > 0) || !std::isfinite(size)) return 1;
    return std::ldexp(1., (std::min)((std::max)(-std::ilogb(size), -largest), largest));
  }
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_CURVATURE_DATA_H
