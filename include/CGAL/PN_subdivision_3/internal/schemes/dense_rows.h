// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_DENSE_ROWS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_DENSE_ROWS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The sum of the squares of the irregular valences.
inline double squared_irregular_valences(const Level_connectivity& level,
                                         Level_connectivity::Index regular)
{
  double sum = 0;
  for (const Level_connectivity::Index n : irregular_valences(level, regular))
    sum += double(n) * double(n);
  return sum;
}

// The sum of the squares of the degrees of the faces that are not quadrilaterals.
inline double squared_irregular_degrees(const Level_connectivity& level)
{
  double sum = 0;
  if (level.uniform_degree() == 4) return sum;
  for (Level_connectivity::Index f = 0; f < level.number_of_faces(); ++f) {
    const Level_connectivity::Index h = level.halfedge_of_face(f);
    if (level.has_degree(h, 4)) continue;
    const double m = level.degree(h);
    sum += m * m;
  }
  return sum;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_DENSE_ROWS_H
