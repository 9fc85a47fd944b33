// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ANGLES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ANGLES_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/is_interval.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/angle_weighted_normals.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The area vector of a face, in the number type up to the end, scaled to a length of about 1.
template <class FT>
Coordinates<double, 3> direction_of_face(const Level_connectivity& level,
                                         const std::vector<Coordinates<FT, 3>>& points,
                                         Level_connectivity::Index f)
{
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;
  const Index first = level.halfedge_of_face(f);
  const Vector& origin = points[level.target(first)];
  // relative to the longest diagonal, or about so with intervals, so that nothing overflows
  FT size(0);
  for (Index h = level.next(first); h != first; h = level.next(h)) {
    const FT length = length_of<FT, 3>(difference<FT, 3>(points[level.target(h)], origin));
    if (CGAL::possibly(is_greater(length, size)) &&
        !(CGAL::to_double(length) < CGAL::to_double(size)))
      size = length;
  }
  if (!CGAL::certainly(is_greater(size, FT(0)))) return {0, 0, 0};
  Vector area = zero_vector<FT, 3>(), before = area;
  for (Index h = level.next(first); h != first; h = level.next(h)) {
    Vector v = difference<FT, 3>(points[level.target(h)], origin);
    for (FT& x : v) x /= size;
    add_multiple<FT, 3>(area, FT(1), cross(before, v));
    before = v;
  }
  return to_double_3(area);
}

// Edges are sharp from this on above the angle that is asked for: meshes have many edges at exactly 30 or 45
// degrees, and only rounding would tell on which side they are.
constexpr double margin_of_crease_angles = 0.1;

// inner edges whose faces' area vectors are more than an angle and the margin apart
template <class FT>
std::vector<bool> edges_of_greater_angle(const Level_connectivity& level,
                                         const std::vector<Coordinates<FT, 3>>& points,
                                         double degrees)
{
  using Index = Level_connectivity::Index;
  const double greatest = (degrees + margin_of_crease_angles) * std::acos(-1.) / 180;
  std::vector<Coordinates<double, 3>> direction;
  for (Index f = 0; f < level.number_of_faces(); ++f)
    direction.push_back(direction_of_face<FT>(level, points, f));
  std::vector<bool> result(level.number_of_edges(), false);
  for (Index e = 0; e < level.number_of_edges(); ++e) {
    if (level.is_border_edge(e)) continue;
    const auto &m = direction[level.face(2 * e)], &n = direction[level.face(2 * e + 1)];
    const double sine = length(cross(m, n)), cosine = dot<double, 3>(m, n);
    result[e] = (sine != 0 || cosine != 0) && std::atan2(sine, cosine) > greatest;
  }
  return result;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ANGLES_H
