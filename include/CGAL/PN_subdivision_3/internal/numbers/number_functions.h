// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_NUMBER_FUNCTIONS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_NUMBER_FUNCTIONS_H

#include <CGAL/PN_subdivision_3/internal/numbers/is_interval.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Functions of numbers that round, of the processor's and of others.

template <class FT>
FT square_root_of(const FT& x)
{
  if constexpr (std::is_floating_point_v<FT>)
    return std::sqrt(x);
  else
    return FT(CGAL::sqrt(x));
}

template <class FT>
FT absolute_value(const FT& x)
{
  if constexpr (std::is_floating_point_v<FT>)
    return std::abs(x);
  else
    return FT(CGAL::abs(x));
}

// 1 or -1
template <class FT>
FT sign_of(const FT& x)
{
  if constexpr (std::is_floating_point_v<FT>)
    return std::copysign(FT(1), x);
  else
    return FT(x < FT(0) ? -1 : 1);
}

// The number type of what is computed with roots: long double, and other types that round and have them; double
// for all others.
template <class FT>
using Rooted_number = std::conditional_t<std::is_same_v<FT, long double> ||
                                           (!std::is_floating_point_v<FT> && !is_exact_v<FT> &&
                                            !is_interval_v<FT> && has_sqrt_v<FT>),
                                         FT, double>;

template <class FT>
FT times_power_of_two(const FT& x, int exponent)
{
  const int half = exponent / 2; // 2^1074 is no double
  return x * FT(std::ldexp(1., half)) * FT(std::ldexp(1., exponent - half));
}

// Multiplies by the power of two that makes the squares of components harmless, and returns its exponent. Of intervals
// it is not asked which component is the largest, which they need not decide.
template <class FT, std::size_t dimension>
int scale_harmlessly(std::array<FT, dimension>& v)
{
  double largest = 0;
  for (const FT& x : v)
    largest = (std::max)(largest, std::abs(static_cast<double>(CGAL::to_double(x))));
  if (!(largest > 0) || !std::isfinite(largest)) return 0;
  const int exponent = -std::ilogb(largest);
  for (FT& x : v) x = times_power_of_two(x, exponent);
  return exponent;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_NUMBER_FUNCTIONS_H
