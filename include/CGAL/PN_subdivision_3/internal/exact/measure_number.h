// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_EXACT_MEASURE_NUMBER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_EXACT_MEASURE_NUMBER_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_subdivision_3/average/Unit_normal_traits.h>
#include <CGAL/PN_subdivision_3/internal/average/is_interval.h>
#include <CGAL/number_type_basic.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Numbers that are a sum of few doubles: float, double, long double, Gmpfr.
template <class FT>
constexpr bool is_rounded_v = std::is_floating_point_v<FT> ||
                              (Has_default_precision<FT>::value && !is_exact_v<FT> &&
                               !is_interval_v<FT>);

// The number type that measures of coordinates in FT are computed in: FT itself, but for rounded
// numbers, whose measures would drown in their own rounding.
template <class FT>
using Measure_number = std::conditional_t<is_rounded_v<FT>, CGAL::Exact_rational, FT>;

template <class FT>
void check_range(const FT& rest, double head)
{
  if (!std::isfinite(head) || (head == 0 && rest != FT(0)))
    throw std::invalid_argument(
      "PN_subdivision_3: a number is not finite or out of the range of double, in which "
      "deviations are measured: scale the data");
}

// x as it is, or an interval around it
template <class Number, class FT>
Number measure_number(const FT& x)
{
  if constexpr (std::is_same_v<Number, FT>)
    return x;
  else if constexpr (std::is_same_v<FT, float> || std::is_same_v<FT, double>) {
    check_range(x, static_cast<double>(x));
    return Number(static_cast<double>(x));
  } else if constexpr (is_rounded_v<FT>) {
    Number sum(0);
    for (FT rest = x; rest != FT(0);) {
      const auto head = static_cast<double>(CGAL::to_double(rest));
      check_range(rest, head);
      sum += Number(head);
      rest = rest - FT(head);
    }
    return sum;
  } else if constexpr (is_interval_v<Number>)
    return Number(CGAL::to_interval(x));
  else
    return Number(x);
}

template <class Number>
Uncertain<bool> is_zero_number(const Number& x)
{
  return make_uncertain(x == Number(0));
}

// an interval around x, tight unless x is an interval itself
template <class Number>
Interval_nt<> interval_around(const Number& x)
{
  return Interval_nt<>(close_interval(x));
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_EXACT_MEASURE_NUMBER_H
