// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_ORIENT_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_ORIENT_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/normals/angle_weighted_normals.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The height of the area vectors of triangles over a plane, but for a positive factor.
class Area_height
{
public:
  using Vector = Coordinates<double, 3>;

  // size: the largest coordinate of what is added
  Area_height(const Vector& normal, double size)
    : normal_(normal)
    , exponent_(size > 0 && std::isfinite(size) ? std::ilogb(size) : 0)
  {}
  void add(Vector a, Vector b)
  {
    for (double& x : a) x = std::ldexp(x, -exponent_);
    for (double& x : b) x = std::ldexp(x, -exponent_);
    height_ += dot<double, 3>(cross<double>(a, b), normal_);
  }
  double operator()() const { return height_; }

private:
  const Vector& normal_;
  int exponent_;
  double height_ = 0;
};

inline double largest_coordinate(const Coordinates<double, 3>& v)
{
  return (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

inline Coordinates<double, 3> offset(const Coordinates<double, 3>& p,
                                     const Coordinates<double, 3>& o)
{
  return {p[0] - o[0], p[1] - o[1], p[2] - o[2]};
}

// Whether a normal at a vertex is on the other side than those of the faces around, which have the corners point(v).
template <class Point_of>
bool is_against_faces(const Level_connectivity& level, Level_connectivity::Index v,
                      const Point_of& point, const Coordinates<double, 3>& normal)
{
  using Index = Level_connectivity::Index;
  const Coordinates<double, 3> center = point(v);
  const auto away = [&](Index w) { return offset(point(w), center); };
  const Index first = level.halfedge_of_vertex(v);
  double size = 0;
  level.for_each_neighbor(first,
                          [&](Index w) { size = (std::max)(size, largest_coordinate(away(w))); });
  Area_height height(normal, size);
  Index h = first;
  do {
    if (!level.is_border(h)) height.add(away(level.target(level.next(h))), away(level.source(h)));
    h = level.next_around_target(h);
  } while (h != first);
  return height() < 0;
}

// The same of a normal at a face.
template <class Point_of>
bool is_against_face(const Level_connectivity& level, Level_connectivity::Index first,
                     const Point_of& point, const Coordinates<double, 3>& normal)
{
  using Index = Level_connectivity::Index;
  const Coordinates<double, 3> corner = point(level.target(first));
  const auto away = [&](Index h) { return offset(point(level.target(h)), corner); };
  double size = 0;
  for (Index h = level.next(first); h != first; h = level.next(h))
    size = (std::max)(size, largest_coordinate(away(h)));
  Area_height height(normal, size);
  for (Index h = level.next(first); level.next(h) != first; h = level.next(h))
    height.add(away(h), away(level.next(h)));
  return height() < 0;
}

// The frame of a surface normal is that of the control normal, which may be on the wrong side.
template <class Results>
void orient_normals(const Level_connectivity& level, Results& results, const For_chunks& for_chunks)
{
  using Index = Level_connectivity::Index;
  const auto point = [&](Index v) { return to_double_3(point_of(results[v].value)); };
  for_chunks(static_cast<Index>(results.size()), [&](Index begin, Index end) {
    for (Index v = begin; v < end; ++v) {
      auto& result = results[v];
      if (result.has_surface_normal && !level.is_isolated(v) &&
          is_against_faces(level, v, point, result.surface_normal))
        result.surface_normal = opposite_vector<double, 3>(result.surface_normal);
    }
  });
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_ORIENT_NORMALS_H
