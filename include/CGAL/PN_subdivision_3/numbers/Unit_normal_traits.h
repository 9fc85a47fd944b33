// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_NUMBERS_UNIT_NORMAL_TRAITS_H
#define CGAL_PN_SUBDIVISION_3_NUMBERS_UNIT_NORMAL_TRAITS_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/number_type_basic.h>

#include <boost/type_traits/detected_or.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3 {
namespace internal {

template <class FT>
constexpr bool is_exact_v = CGAL::Algebraic_structure_traits<FT>::Is_exact::value;

template <class FT>
constexpr bool has_sqrt_v =
  std::is_convertible_v<typename CGAL::Algebraic_structure_traits<FT>::Algebraic_category*,
                        CGAL::Field_with_sqrt_tag*>;

template <class FT>
using Default_precision_of = decltype(FT::get_default_precision());
template <class FT>
using Has_default_precision = boost::is_detected<Default_precision_of, FT>;

template <class FT>
using Exact_of = decltype(std::declval<const FT&>().exact());
template <class FT>
using Is_lazy = boost::is_detected<Exact_of, FT>;

// 2^-k, also below the range of double
template <class FT>
FT negative_power_of_two(int k)
{
  FT p(1);
  for (; k > 1000; k -= 1000) p *= FT(std::ldexp(1.0, -1000));
  return p * FT(std::ldexp(1.0, -k));
}

// The unit of relative precision: 0 for exact types; that of double where a type tells nothing.
template <class FT>
FT machine_epsilon()
{
  if constexpr (is_exact_v<FT>)
    return FT(0);
  else if constexpr (Has_default_precision<FT>::value) // Gmpfr, Gmpfi: no numeric_limits
    return negative_power_of_two<FT>(static_cast<int>(FT::get_default_precision()) - 1);
  else if constexpr (std::numeric_limits<FT>::is_specialized &&
                     !std::numeric_limits<FT>::is_integer && std::numeric_limits<FT>::digits > 0)
    return FT(std::numeric_limits<FT>::epsilon());
  else
    return FT(std::numeric_limits<double>::epsilon());
}

template <class FT>
std::pair<double, double> close_interval(const FT& x)
{
  std::pair<double, double> i = CGAL::to_interval(x);
  // to_double() of a lazy number may be far less precise than a double; its exact value is not
  if constexpr (Is_lazy<FT>::value) {
    const double largest = (std::max)(std::abs(i.first), std::abs(i.second));
    if (!std::isfinite(largest) || !(i.second - i.first <= largest * std::ldexp(1.0, -50))) {
      x.exact();
      i = CGAL::to_interval(x);
    }
  }
  return i;
}

// nearly the nearest double, also of lazy numbers
template <class FT>
double close_double(const FT& x)
{
  if constexpr (Is_lazy<FT>::value) close_interval(x);
  return static_cast<double>(CGAL::to_double(x));
}

// 1/sqrt(x) from a double; its relative error is below 2^-48. \pre x > 0
template <class FT>
FT approximate_inverse_sqrt(const FT& x)
{
  const std::pair<double, double> i = close_interval(x);
  if constexpr (is_exact_v<FT>) {
    using Limits = std::numeric_limits<double>;
    if (i.first < (Limits::min)()) // x is below the range of double
      return FT(std::ldexp(1.0, 500)) * approximate_inverse_sqrt(FT(x * FT(std::ldexp(1.0, 1000))));
    if (!(i.second <= (Limits::max)())) // above it
      return FT(std::ldexp(1.0, -500)) *
             approximate_inverse_sqrt(FT(x * FT(std::ldexp(1.0, -1000))));
  }
  return FT(1.0 / std::sqrt(i.first / 2 + i.second / 2));
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Kernels

How unit normals are made in the number type `FT`. Specialize it for a number type whose square root
this template does not find.

In a field with square root the length of a normal is rounded as `FT` rounds. In an exact field without square root
(the number type of EPECK for instance) 1/|N| is a `double` with a relative error below 2<sup>-48</sup>. Normals keep
their exact direction and have unit length up to this error, unless they are rounded to unit vectors, see
`Rounded_exact_normals`. All other operations of the package remain exact.

\tparam FT a field
*/
template <class FT>
struct Unit_normal_traits
{
  /// whether lengths are rounded although `FT` is exact. A point may then have left a shape for that alone, and `is_on()` refutes
  /// nothing. A specialization without this constant does not round.
  static constexpr bool rounds_exact_numbers =
    internal::is_exact_v<FT> && !internal::has_sqrt_v<FT>;

  /// returns 1/sqrt(`squared_length`). \pre `squared_length > 0`
  static FT inverse_length(const FT& squared_length)
  {
    if constexpr (internal::has_sqrt_v<FT>)
      return FT(1) / FT(CGAL::sqrt(squared_length));
    else
      return internal::approximate_inverse_sqrt(squared_length);
  }

  /// a sum N of normals vanishes if |N| is at most this times the sum of the lengths:
  /// 2<sup>12</sup> times the machine epsilon, 0 for exact types. The machine epsilon is that of
  /// `std::numeric_limits`, or of the default precision where it can be set (`Gmpfr`), or of
  /// `double` for types that tell neither.
  static FT vanishing_tolerance() { return FT(4096) * internal::machine_epsilon<FT>(); }

  /// a normal counts as a unit vector if its squared length differs from 1 by at most this: 4 times
  /// the machine epsilon; in exact types 0, or 2<sup>-46</sup> where normalization is approximate.
  static FT unit_tolerance()
  {
    if constexpr (rounds_exact_numbers)
      return FT(std::ldexp(1.0, -46));
    else
      return FT(4) * internal::machine_epsilon<FT>();
  }
};

namespace internal {

template <class FT>
using Rounding_of = std::bool_constant<Unit_normal_traits<FT>::rounds_exact_numbers>;
template <class FT>
using Rounds_exact_numbers = boost::detected_or_t<std::false_type, Rounding_of, FT>;

} // namespace internal

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_NUMBERS_UNIT_NORMAL_TRAITS_H
