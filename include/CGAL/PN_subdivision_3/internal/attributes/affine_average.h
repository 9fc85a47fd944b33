// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_AFFINE_AVERAGE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_AFFINE_AVERAGE_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// origin + sum, where sum = sum w_j (v_j - origin). Where that leaves the range of the numbers (infinite or huge
// values, and what is not a number) plain_sum() counts.
template <class FT, class Plain_sum>
FT average_from(const FT& origin, const FT& sum, [[maybe_unused]] const Plain_sum& plain_sum)
{
  if constexpr (std::is_floating_point_v<FT>) {
    if (sum == FT(0)) return origin; // a zero of either sign, too
    const FT result = origin + sum;
    return std::isfinite(result) ? result : plain_sum();
  } else
    return origin + sum;
}

// The average of a row for n components; component(v, c) is component c of value v.
template <class FT, class Entry, class Component, class Result>
void component_average(const Entry* begin, const Entry* end, std::size_t n,
                       const Component& component, const Result& result)
{
  for (std::size_t c = 0; c < n; ++c) {
    const FT& origin = component(begin->vertex, c);
    FT sum(0);
    for (const Entry* e = begin + 1; e != end; ++e)
      sum += e->weight * FT(component(e->vertex, c) - origin);
    result(c, average_from<FT>(origin, sum, [&] {
             FT plain(0);
             bool are_equal = true;
             for (const Entry* e = begin; e != end; ++e) {
               const FT& x = component(e->vertex, c);
               are_equal = are_equal && x == origin;
               if (e->weight != FT(0)) plain += e->weight * x;
             }
             return are_equal ? origin : plain;
           }));
  }
}

// The average of a row. A single entry is a copy.
template <class FT, class Traits, class Entry>
typename Traits::Sum affine_average(const Entry* begin, const Entry* end,
                                    const typename Traits::Sum* old)
{
  using Sum = typename Traits::Sum;
  const Sum& origin = old[begin->vertex];
  if (end - begin == 1) return origin;
  if constexpr (Traits::has_components) {
    Sum result;
    component_average<FT>(
      begin, end, result.size(),
      [&](Level_connectivity::Index v, std::size_t c) -> const FT& { return old[v][c]; },
      [&](std::size_t c, const FT& x) { result[c] = x; });
    return result;
  } else {
    Sum sum = Traits::difference(begin[1].weight, old[begin[1].vertex], origin);
    for (const Entry* e = begin + 2; e != end; ++e)
      sum = Sum(sum + Traits::difference(e->weight, old[e->vertex], origin));
    return Sum(origin + sum);
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_AFFINE_AVERAGE_H
