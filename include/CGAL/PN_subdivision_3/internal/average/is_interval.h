// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_IS_INTERVAL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_IS_INTERVAL_H

#include <CGAL/Uncertain.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Comparisons of intervals may be undecided.
template <class FT>
constexpr bool is_interval_v =
  std::is_same_v<decltype(std::declval<const FT&>() < std::declval<const FT&>()), Uncertain<bool>>;

// Some interval types have a < that may be undecided, while their other comparisons are made of it and throw.
template <class FT>
auto is_greater(const FT& a, const FT& b)
{
  if constexpr (is_interval_v<FT>)
    return b < a;
  else
    return a > b;
}
template <class FT>
auto is_at_most(const FT& a, const FT& b)
{
  if constexpr (is_interval_v<FT>)
    return !(b < a);
  else
    return a <= b;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_IS_INTERVAL_H
