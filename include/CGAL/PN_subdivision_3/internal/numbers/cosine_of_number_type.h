// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_COSINE_OF_NUMBER_TYPE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_COSINE_OF_NUMBER_TYPE_H

#include <CGAL/PN_subdivision_3/internal/numbers/Weight_number.h>
#include <CGAL/PN_subdivision_3/internal/numbers/is_interval.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#ifdef CGAL_USE_MPFR
#  include <mpfr.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// cos(2 pi k / n) with the precision that a number type has, where 2k <= n and k, n are coprime. They are
// found without a header of the number type.

template <class FT, class = void>
struct Has_own_cosine : std::false_type
{};
template <class FT>
struct Has_own_cosine<
  FT, std::void_t<decltype(FT(cos(std::declval<FT>()))), decltype(FT(acos(std::declval<FT>())))>>
  : std::true_type
{};

// CGAL::Gmpfr
template <class FT, class = void>
struct Is_mpfr_number : std::false_type
{};
#ifdef CGAL_USE_MPFR
template <class FT>
struct Is_mpfr_number<FT, std::void_t<decltype(FT(0, typename FT::Precision_type()).fr())>>
  : std::is_same<decltype(std::declval<FT&>().fr()), mpfr_ptr>
{};

template <class Gmpfr>
Gmpfr mpfr_cosine(std::int64_t k, std::int64_t n, typename Gmpfr::Precision_type bits)
{
  Gmpfr x(0, bits);
  mpfr_const_pi(x.fr(), MPFR_RNDN);
  mpfr_mul_si(x.fr(), x.fr(), static_cast<long>(2 * k), MPFR_RNDN);
  mpfr_div_si(x.fr(), x.fr(), static_cast<long>(n), MPFR_RNDN);
  mpfr_cos(x.fr(), x.fr(), MPFR_RNDN);
  return x;
}
#else
template <class Number, class Precision>
Number mpfr_cosine(std::int64_t, std::int64_t,
                   Precision); // of no number type, but it has to be a name
#endif

// the angle of a vector in the plane
template <class FT>
FT own_angle(const FT& y, const FT& x)
{
#ifdef CGAL_USE_MPFR
  if constexpr (Is_mpfr_number<FT>::value) {
    FT result(0, FT::get_default_precision());
    mpfr_atan2(result.fr(), y.fr(), x.fr(), MPFR_RNDN);
    return result;
  } else
#endif
    return FT(atan2(y, x));
}
template <class FT, class = void>
struct Has_own_angle : Is_mpfr_number<FT>
{};
template <class FT>
struct Has_own_angle<
  FT, std::void_t<decltype(FT(atan2(std::declval<const FT&>(), std::declval<const FT&>())))>>
  : std::true_type
{};

// whether its weights are computed in the number type
template <class FT>
struct Has_trigonometry
  : std::bool_constant<Has_own_cosine<FT>::value || Is_mpfr_number<FT>::value || is_interval_v<FT>>
{};

// cos(2 pi k / n) to nearest. \pre 0 <= 2k <= n
inline double nearest_cosine(std::int64_t k, std::int64_t n)
{
  static const auto first = [] { // masks are made in every round: k = 1 is what they ask for then
    std::array<double, 32> cosines{};
    for (std::size_t i = 2; i < cosines.size(); ++i)
      cosines[i] = static_cast<double>(cosine_of_turn(1, static_cast<std::int64_t>(i)));
    return cosines;
  }();
  return k == 1 && n < 32 ? first[static_cast<std::size_t>(n)]
                          : static_cast<double>(cosine_of_turn(k, n));
}

template <class FT>
FT own_cosine(std::int64_t k, std::int64_t n)
{
  return FT(
    cos(FT(2) * FT(acos(FT(-1))) * FT(static_cast<double>(k)) / FT(static_cast<double>(n))));
}

// contains the cosine
template <class FT>
FT interval_cosine(std::int64_t k, std::int64_t n)
{
  if constexpr (Is_mpfr_number<typename Interval_bounds<FT>::Bound>::value) {
    const auto bits = FT::get_default_precision();
    constexpr int more = 32, safe = 8;
    using Bound = typename Interval_bounds<FT>::Bound;
    return FT(mpfr_cosine<Bound>(k, n, bits + more)) +
           symmetric_interval<FT>(1) *
             negative_power_of_two<FT>(static_cast<int>(bits) + more - safe);
  } else if constexpr (Has_own_cosine<FT>::value)
    return own_cosine<FT>(k, n);
  else {
    const double c = nearest_cosine(k, n);
    return FT(std::make_pair(std::nextafter(c, -2.), std::nextafter(c, 2.)));
  }
}

template <class FT>
FT irrational_cosine(std::int64_t k, std::int64_t n)
{
  if constexpr (std::is_same_v<FT, Double_double>)
    return cosine_of_turn(k, n);
  else if constexpr (std::is_same_v<FT, long double>) {
    const long double pi = 3.141592653589793238462643383279502884L;
    return std::cos(2 * pi * (static_cast<long double>(k) / static_cast<long double>(n)));
  } else if constexpr (std::is_floating_point_v<FT>)
    return FT(nearest_cosine(k, n));
  else if constexpr (is_interval_v<FT>)
    return interval_cosine<FT>(k, n);
  else if constexpr (Is_mpfr_number<FT>::value) {
    const auto bits = FT::get_default_precision();
    return FT(mpfr_cosine<FT>(k, n, bits + 32), std::round_to_nearest, bits);
  } else if constexpr (Has_own_cosine<FT>::value)
    return own_cosine<FT>(k, n);
  else
    return FT(nearest_cosine(k, n));
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_COSINE_OF_NUMBER_TYPE_H
