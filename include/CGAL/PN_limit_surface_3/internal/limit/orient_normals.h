// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_ORIENT_NORMALS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_ORIENT_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cmath>

namespace CGAL::PN_subdivision_3::internal {

// Whether the sum of the area vectors of triangles is on the other side than a normal. for_each(f) calls f(a, b)
// with two sides of each.
template <class For_each_triangle>
bool is_against_area(const Coordinates<double, 3>& normal, const For_each_triangle& for_each)
{
  using Vector = Coordinates<double, 3>;
  constexpr double greatest = 0x1p300; // whose products are in range, as those of its reciprocal
  double height = 0, size = 0;
  for_each([&](const Vector& a, const Vector& b) {
    size = (std::max)({size, largest_coordinate(a), largest_coordinate(b)});
    height += dot(cross(a, b), normal);
  });
  if (size > greatest || size < 1 / greatest) {
    const int exponent = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
    height = 0;
    for_each([&](Vector a, Vector b) {
      for (double& x : a) x = std::ldexp(x, -exponent);
      for (double& x : b) x = std::ldexp(x, -exponent);
      height += dot(cross(a, b), normal);
    });
  }
  return height < 0;
}

// Whether a normal at a vertex is on the other side than those of the faces around, which have the corners point(v).
template <class Point_of>
bool is_against_faces(const Level_connectivity& level, Level_connectivity::Index v,
                      const Point_of& point, const Coordinates<double, 3>& normal)
{
  using Index = Level_connectivity::Index;
  const Coordinates<double, 3> center = point(v);
  const auto away = [&](Index w) { return difference(point(w), center); };
  return is_against_area(normal, [&](const auto& add) {
    for_each_halfedge_to(level, v, [&](Index h) {
      if (!level.is_border(h)) add(away(level.target(level.next(h))), away(level.source(h)));
    });
  });
}

// The same of a normal at a face.
template <class Point_of>
bool is_against_face(const Level_connectivity& level, Level_connectivity::Index first,
                     const Point_of& point, const Coordinates<double, 3>& normal)
{
  using Index = Level_connectivity::Index;
  const Coordinates<double, 3> corner = point(level.target(first));
  const auto away = [&](Index h) { return difference(point(level.target(h)), corner); };
  return is_against_area(normal, [&](const auto& add) {
    for (Index h = level.next(first); level.next(h) != first; h = level.next(h))
      add(away(h), away(level.next(h)));
  });
}

// The frame of a surface normal is that of the control normal, which may be on the wrong side: is_against(i, normal).
template <class Results, class Is_against>
void orient_normals(Results& results, const For_chunks& for_chunks, const Is_against& is_against)
{
  using Index = Level_connectivity::Index;
  for_chunks(static_cast<Index>(results.size()), [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      auto& result = results[i];
      if (result.has_surface_normal && is_against(i, result.surface_normal))
        result.surface_normal = opposite_vector(result.surface_normal);
    }
  });
}
// of the faces at vertices, whose corners are point(v); result i is that of vertex(i)
template <class Results, class Point_of, class Vertex_of>
void orient_normals(const Level_connectivity& level, Results& results, const For_chunks& for_chunks,
                    const Point_of& point, const Vertex_of& vertex)
{
  using Index = Level_connectivity::Index;
  orient_normals(results, for_chunks, [&](Index i, const auto& normal) {
    const Index v = vertex(i);
    return !level.is_isolated(v) && is_against_faces(level, v, point, normal);
  });
}
// of all limits, or of some, whose neighbors have none: these go by the points of the level
template <class Level, class Results>
void orient_normals(const Level& level, Results& results, const For_chunks& for_chunks,
                    bool are_all)
{
  using Index = Level_connectivity::Index;
  const auto orient = [&](const auto& of) {
    orient_normals(
      level.level, results, for_chunks, [&](Index v) { return to_double_3(point_of(of(v))); },
      [](Index v) { return v; });
  };
  if (are_all)
    orient([&](Index v) -> const auto& { return results[v].value; });
  else
    orient([&](Index v) -> const auto& { return level.values[v]; });
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_ORIENT_NORMALS_H
