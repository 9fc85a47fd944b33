// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_FOR_EACH_CREASE_VERTEX_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_FOR_EACH_CREASE_VERTEX_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/decided.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Calls f(position, vertex, value) for the vertices among slots with values, of which those of a vertex
// follow one another. With several of them it has their mean normal.
template <class Average, class Function>
void for_each_crease_vertex(
  const std::vector<std::pair<Level_connectivity::Index, typename Average::Value>>& slots,
  Level_connectivity::Index number_of_vertices, const Function& f)
{
  using FT = typename Average::FT;
  using Value = typename Average::Value;
  constexpr bool has_normals = std::is_same_v<Value, Point_normal<FT, 3>>;
  for (std::size_t i = 0; i < slots.size();) {
    const std::size_t first = i;
    const auto v = slots[i].first;
    Value value = slots[i].second;
    int wedges = 1;
    for (++i; i < slots.size() && slots[i].first >= number_of_vertices; ++i, ++wedges)
      if constexpr (has_normals) add_multiple<FT, 3>(value.normal, FT(1), slots[i].second.normal);
    if constexpr (has_normals)
      if (wedges > 1)
        decided<FT>([&] { value.normal = unit_or_zero<FT, 3>(value.normal, FT(wedges)); },
                    [&] { return "the mean normal of vertex " + std::to_string(v); });
    f(first, v, value);
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_FOR_EACH_CREASE_VERTEX_H
