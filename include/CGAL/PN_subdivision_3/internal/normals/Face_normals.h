// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FACE_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FACE_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>

#include <cmath>
#include <unordered_map>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The unit area vectors of polygons, in double. Those of large ones are kept, since each of their
// corners may ask.
template <class FT, class Point_of>
class Face_normals
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  Face_normals(const Level_connectivity& level, const Point_of& point)
    : level_(level)
    , point_(point)
  {}

  // of the face of a half-edge; zero if it has no area or is a triangle, whose corners tell it
  Vector operator()(Index h)
  {
    if (level_.has_degree(h, 3)) return {0, 0, 0};
    constexpr Index few = 16;
    Index degree = 0, g = h;
    do {
      g = level_.next(g);
      ++degree;
    } while (g != h && degree <= few);
    if (degree <= few) return normal(h);
    const auto [place, is_new] = kept_.insert({level_.face(h), Vector{0, 0, 0}});
    if (is_new) place->second = normal(h);
    return place->second;
  }

private:
  using T = Wide_number<FT>;

  Vector normal(Index first) const
  {
    Vector area{0, 0, 0}, before{0, 0, 0};
    double scale = 0; // of the first edge that has a length
    const auto& origin = point_(level_.target(first));
    for (Index h = level_.next(first); h != first; h = level_.next(h)) {
      const auto& p = point_(level_.target(h));
      Vector corner =
        to_double_3<T>({T(p[0]) - T(origin[0]), T(p[1]) - T(origin[1]), T(p[2]) - T(origin[2])});
      if (scale == 0) scale = length(corner);
      if (scale > 0) corner = quotient(corner, scale);
      add_multiple<double, 3>(area, 1, cross(before, corner));
      before = corner;
    }
    const double area_length = length(area);
    if (!(area_length > 0) || !std::isfinite(area_length)) return {0, 0, 0};
    return quotient(area, area_length);
  }

  const Level_connectivity& level_;
  const Point_of& point_;
  std::unordered_map<Index, Vector> kept_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FACE_NORMALS_H
