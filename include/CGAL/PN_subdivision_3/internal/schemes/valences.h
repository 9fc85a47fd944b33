// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_VALENCES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_VALENCES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The valences of the interior vertices that have another one than the regular one, 0 for all others.
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
  return irregular;
}

// Refuses an interior vertex of valence 2, for which the interpolatory schemes have no rule.
template <class Element_names>
void check_interior_valences(const Level_connectivity& level, const Element_names& names)
{
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v)
    if (!level.is_isolated(v) && !level.is_border_vertex(v) && level.valence(v) == 2)
      throw std::invalid_argument("PN_subdivision_3: " + names.vertex_name(v) +
                                  " has valence 2: the scheme has no rule for an interior vertex "
                                  "with two edges; join them");
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_VALENCES_H
