// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_HARMLESS_SCALE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_HARMLESS_SCALE_H

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

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

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_HARMLESS_SCALE_H
