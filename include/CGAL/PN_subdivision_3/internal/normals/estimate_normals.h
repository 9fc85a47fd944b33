// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ESTIMATE_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ESTIMATE_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/normals/Coherent_estimation.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/normals/Reciprocal_estimation.h>
#include <CGAL/PN_subdivision_3/internal/normals/face_normals.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Calls set_normal(s, n) and set_roundness(s, w) for every sector that is not given, where point(v)
// returns Coordinates<FT, 3>; given(s) points to the given normal of a sector, a unit vector or zero,
// or is null. The roundness is in double, 1 if the estimate has no other.
template <class FT, class Sectors, class Point_of, class Given, class Set_normal,
          class Set_roundness>
void estimate_normals(const Level_connectivity& level, Control_normal_estimate estimate,
                      const Sectors& sectors, const Point_of& point, const Given& given,
                      const Set_normal& set_normal, const Set_roundness& set_roundness)
{
  using Index = Level_connectivity::Index;
  using Coherent = Coherent_estimation<FT, Sectors, Point_of>;
  const auto estimate_all = [&] {
    if (estimate == Control_normal_estimate::coherent)
      return Coherent(level, sectors, point)(given, set_normal, set_roundness);
    if (estimate == Control_normal_estimate::reciprocal)
      typename Coherent::Reciprocal(level, sectors, point)(given, set_normal);
    else {
      Angle_weighted_normals<FT, Sectors> normals(level, sectors);
      for (Index f = 0; f < level.number_of_faces(); ++f) normals.add_face(f, point);
      for (Index s = 0; s < sectors.number_of_sectors(); ++s)
        if (given(s) == nullptr) set_normal(s, normals.normal(s));
    }
    for (Index s = 0; s < sectors.number_of_sectors(); ++s)
      if (given(s) == nullptr) set_roundness(s, 1.);
  };
  name_undecided<FT>(estimate_all, [] { return "whether an estimated control normal vanishes"; });
}

// Estimates normals and roundness of the vertices of a level from the points in their values; the normals of vertices
// with is_given stay.
template <class FT>
void estimate_normals_of(const Level_connectivity& level, Control_normal_estimate estimate,
                         std::vector<Point_normal<FT, 3>>& values,
                         const std::vector<bool>* is_given = nullptr)
{
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<FT, 3>;
  estimate_normals<FT>(
    level, estimate, Vertex_sectors(level),
    [&](Index v) -> const Vector& { return values[v].point; },
    [&](Index v) { return is_given && (*is_given)[v] ? &values[v].normal : nullptr; },
    [&](Index v, const Vector& n) { values[v].normal = n; },
    [&](Index v, double w) { values[v].roundness = w; });
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ESTIMATE_NORMALS_H
