// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_IRREGULAR_VALENCES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_IRREGULAR_VALENCES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// what the valence of v counts as, null if that is the valence itself
inline const Level_connectivity::Counted_valence* counted_valence(const Level_connectivity& level,
                                                                  Level_connectivity::Index v)
{
  const auto& counted = level.counted_valences(); // in the order of the vertices
  const auto it = std::lower_bound(counted.begin(), counted.end(), v,
                                   [](const auto& c, auto vertex) { return c.vertex < vertex; });
  return it != counted.end() && it->vertex == v ? &*it : nullptr;
}

// The valence of each interior vertex that is not regular; 0 for all other vertices. Counted valences go
// first.
inline std::vector<Level_connectivity::Index> irregular_valences(const Level_connectivity& level,
                                                                 Level_connectivity::Index regular)
{
  // counted, not walked round: of the vertices nearly all are regular
  std::vector<Level_connectivity::Index> irregular(level.number_of_vertices(), 0);
  for (Level_connectivity::Index h = 0; h < level.number_of_halfedges(); ++h)
    ++irregular[level.target(h)];
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v)
    if (irregular[v] == regular || (irregular[v] != 0 && level.is_border_vertex(v)))
      irregular[v] = 0;
  for (const auto& counted : level.counted_valences())
    irregular[counted.vertex] = counted.valence == regular ? 0 : counted.valence;
  return irregular;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_IRREGULAR_VALENCES_H
