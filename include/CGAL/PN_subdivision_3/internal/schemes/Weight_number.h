// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_WEIGHT_NUMBER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_WEIGHT_NUMBER_H

#include <CGAL/PN_subdivision_3/internal/schemes/Double_double.h>

#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

namespace square_root_lookup {

using std::sqrt; // besides what argument-dependent lookup finds

template <class Number>
auto square_root(const Number& x) -> decltype(Number(sqrt(x)))
{
  return Number(sqrt(x));
}

} // namespace square_root_lookup
using square_root_lookup::square_root;

template <class FT, class = void>
struct Has_square_root : std::false_type
{};

template <class FT>
struct Has_square_root<FT, std::void_t<decltype(square_root(std::declval<const FT&>()))>>
  : std::true_type
{};

// In which number type irrational weights are computed before they are rounded to FT: its own if it
// has the functions that they need, as told by traits such as Has_trigonometry<FT>. Exact types would
// only carry on the rounding of square roots and cosines, at great cost.
template <class FT, class... Has_functions>
using Weight_number =
  std::conditional_t<std::is_same_v<FT, long double> ||
                       (!std::is_floating_point_v<FT> && (Has_functions::value && ...)),
                     FT, Double_double>;

template <class FT, class Number>
FT rounded_weight(const Number& x)
{
  if constexpr (std::is_same_v<FT, Number>)
    return x;
  else if constexpr (std::is_floating_point_v<FT>)
    return static_cast<FT>(x);
  else
    return FT(static_cast<double>(x));
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_WEIGHT_NUMBER_H
