// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_CHECKED_COORDINATES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_CHECKED_COORDINATES_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/numbers/is_interval.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// also where -ffast-math tells the compiler that nothing else occurs: by the exponent's bits
template <class FT>
bool is_finite_number(const FT& x)
{
  if constexpr (std::is_same_v<FT, float> || std::is_same_v<FT, double>) {
    using Bits = std::conditional_t<std::is_same_v<FT, float>, std::uint32_t, std::uint64_t>;
    static_assert(sizeof(Bits) == sizeof(FT) && std::numeric_limits<FT>::is_iec559);
    constexpr int fraction_bits = std::numeric_limits<FT>::digits - 1;
    constexpr Bits all_ones = (Bits(-1) << fraction_bits) & (Bits(-1) >> 1);
    Bits bits;
    std::memcpy(&bits, &x, sizeof bits);
    return (bits & all_ones) != all_ones;
  } else if constexpr (std::is_floating_point_v<FT>)
    return std::isfinite(x);
  else {
    // types whose traits know neither NaN nor infinity, but which have them
    using Limits = std::numeric_limits<FT>;
    if constexpr (Limits::is_specialized && (Limits::has_infinity || Limits::has_quiet_NaN) &&
                  !is_exact_v<FT> && !is_interval_v<FT>)
      if (!(FT(x - x) == FT(0))) return false;
    return CGAL::is_valid(x) && CGAL::is_finite(x);
  }
}

template <class FT, class Point_or_vector>
Coordinates<FT, 3> coordinates_3(const Point_or_vector& p)
{
  return {FT(p.x()), FT(p.y()), FT(p.z())};
}

template <class FT, int dimension, class Name>
void check_finite(const Coordinates<FT, dimension>& x, const char* what, const Name& name)
{
  for (const FT& c : x)
    if (!is_finite_number(c))
      throw std::invalid_argument("PN_subdivision_3: the " + std::string(what) + " of " + name() +
                                  " is not finite: give it finite coordinates");
}

// Coordinates near the end of the range of a floating point type may overflow in between. Below the
// root of the largest number new points are not looked at: they grow by small factors only.
template <class FT, std::size_t dimension>
bool is_near_overflow([[maybe_unused]] const std::array<FT, dimension>& p)
{
  if constexpr (std::is_floating_point_v<FT>) {
    static const FT root_of_largest = std::ldexp(FT(1), std::numeric_limits<FT>::max_exponent / 2);
    for (const FT& x : p)
      if (std::abs(x) >= root_of_largest) return true;
  }
  return false;
}

template <class FT, std::size_t dimension, class Name>
void check_in_range([[maybe_unused]] const std::array<FT, dimension>& p,
                    [[maybe_unused]] const Name& name)
{
  if constexpr (std::is_floating_point_v<FT>)
    for (const FT& x : p)
      if (!is_finite_number(x))
        throw std::overflow_error("PN_subdivision_3: " + name() +
                                  " is out of the range of the number type: scale the input down");
}

// So that its square neither overflows nor underflows; whether it is not zero.
template <class FT, int dimension>
bool scale_to_about_one(Coordinates<FT, dimension>& n)
{
  if constexpr (is_interval_v<FT>) {
    scale_harmlessly(n);
    return FT(0) < dot<FT, dimension>(n, n);
  } else {
    FT largest(0);
    for (const FT& x : n) largest = (CGAL::max)(largest, FT(CGAL::abs(x)));
    if (largest == FT(0)) return false;
    for (FT& x : n) x /= largest;
    return true;
  }
}

// Normals of any length become unit vectors once; unit vectors and zero are taken as they are.
// Intervals that may be unit vectors or not are normalized: the result contains both.
template <class FT, int dimension>
void normalize_control_normal(Coordinates<FT, dimension>& n)
{
  using Traits = Unit_normal_traits<FT>;
  const FT squared_length = dot<FT, dimension>(n, n);
  const FT tolerance = Traits::unit_tolerance();
  if (CGAL::certainly(is_at_most(FT(FT(1) - tolerance), squared_length)) &&
      CGAL::certainly(is_at_most(squared_length, FT(FT(1) + tolerance))))
    return;
  if (!scale_to_about_one<FT, dimension>(n)) return;
  const FT inverse = Traits::inverse_length(dot<FT, dimension>(n, n));
  for (FT& x : n) x *= inverse;
}

// names the element whose normal may be zero or not
template <class FT, int dimension, class Name>
void normalize_control_normal(Coordinates<FT, dimension>& n, const Name& name)
{
  try {
    normalize_control_normal<FT, dimension>(n);
  } catch (const Uncertain_conversion_exception&) {
    throw std::domain_error("PN_subdivision_3: the precision of the number type does not decide "
                            "whether the normal of " +
                            name() + " is zero: give it a narrower interval");
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_CHECKED_COORDINATES_H
