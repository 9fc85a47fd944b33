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

// Estimates normals and roundness of the vertices of a level from the points in their values, 1 where the estimate has no other
// roundness. Vertices with is_given, whose normals are unit vectors or zero, stay; `wedges` are those of a level cut open.
template <class FT>
void estimate_normals(const Level_connectivity& level, Control_normal_estimate estimate,
                      Point_normals<FT>& values, const std::vector<bool>* is_given = nullptr,
                      const Wedges<FT>* wedges = nullptr)
{
  using Index = Level_connectivity::Index;
  using Coherent = Coherent_estimation<FT>;
  const auto is_estimated = [&](Index v) { return is_given == nullptr || !(*is_given)[v]; };
  const auto estimate_all = [&] {
    if (estimate == Control_normal_estimate::coherent)
      return Coherent(level, values, is_given, wedges)();
    if (estimate == Control_normal_estimate::reciprocal)
      typename Coherent::Reciprocal(level, values, is_given)();
    else {
      Angle_weighted_normals<FT> normals(level, values);
      for (Index f = 0; f < level.number_of_faces(); ++f) normals.add_face(f);
      for (Index v = 0; v < level.number_of_vertices(); ++v)
        if (is_estimated(v)) values[v].normal = normals.normal(v);
    }
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      if (is_estimated(v)) values[v].roundness = FT(1);
  };
  name_undecided<FT>(estimate_all, [] { return "whether an estimated control normal vanishes"; });
}

// the same of vertices, which libraries have
template <class FT>
void estimate_normals_of(const Level_connectivity& level, Control_normal_estimate estimate,
                         Point_normals<FT>& values, const std::vector<bool>* is_given = nullptr)
{
  estimate_normals(level, estimate, values, is_given);
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ESTIMATE_NORMALS_H
