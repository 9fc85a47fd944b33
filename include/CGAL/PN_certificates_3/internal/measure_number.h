// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_INTERNAL_MEASURE_NUMBER_H
#define CGAL_PN_CERTIFICATES_3_INTERNAL_MEASURE_NUMBER_H

#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace CGAL::PN_subdivision_3::internal {

// Numbers that are sums of doubles times powers of two: float, double, long double, Gmpfr, and all whose
// std::numeric_limits say that they round and have the radix 2.
template <class FT>
constexpr bool is_rounded_v =
  !is_exact_v<FT> && !is_interval_v<FT> &&
  (std::is_floating_point_v<FT> || Has_default_precision<FT>::value ||
   (std::numeric_limits<FT>::is_specialized && !std::numeric_limits<FT>::is_integer &&
    std::numeric_limits<FT>::radix == 2));

// The number type that measures of coordinates in FT are computed in: FT itself, but for rounded
// numbers, whose measures would drown in their own rounding.
template <class FT>
struct Measure_number_of
{
  static_assert(
    is_exact_v<FT> || is_interval_v<FT> || is_rounded_v<FT>,
    "PN_subdivision_3: deviations of numbers that round are measured in exact ones, which "
    "these cannot be converted to: specialize std::numeric_limits with radix 2, if they are "
    "sums of powers of 2");
  using type = std::conditional_t<is_rounded_v<FT>, CGAL::Exact_rational, FT>;
};
template <class FT>
using Measure_number = typename Measure_number_of<FT>::type;

// x 2^(1000 k)
template <class Number>
Number times_thousands(Number x, int k)
{
  const Number factor(std::ldexp(1., k < 0 ? -1000 : 1000));
  for (int i = 0; i < std::abs(k); ++i) x = x * factor;
  return x;
}

// a number of radix 2 as it is, or an interval around it
template <class Number, class FT>
Number number_of_binary(const FT& x)
{
  constexpr int most = 100; // steps of 2^1000 beyond the range of double
  Number sum(0);
  int k = 0; // what is left is rest 2^(-1000 k)
  for (FT rest = x; rest != FT(0);) {
    const auto head = static_cast<double>(CGAL::to_double(rest));
    if (std::isfinite(head) && std::abs(head) >= (std::numeric_limits<double>::min)()) {
      sum = sum + times_thousands(Number(head), -k);
      rest = rest - FT(head);
      continue;
    }
    const int step = std::abs(head) < 1 ? 1 : -1;
    if (std::isnan(head) || std::abs(k += step) > most)
      throw std::invalid_argument("PN_subdivision_3: a number is not finite or not between "
                                  "2^-100000 and 2^100000: scale the data");
    rest = times_thousands(rest, step);
  }
  return sum;
}

// an interval around an exact number: by the doubles that it begins with, and what they leave
template <class Number, class FT>
Number interval_of_exact(const FT& x)
{
  constexpr int most = 40;
  Number sum(0);
  FT rest(x);
  for (int i = 0; i < most; ++i) {
    const double head = close_double(rest);
    if (head == 0 || !std::isfinite(head)) break;
    sum = sum + Number(head);
    rest = rest - FT(head);
  }
  return sum + Number(CGAL::to_interval(rest));
}

// x as it is, or an interval around it
template <class Number, class FT>
Number measure_number(const FT& x)
{
  if constexpr (std::is_same_v<Number, FT>)
    return x;
  else if constexpr (std::is_same_v<FT, float>)
    return number_of_binary<Number>(static_cast<double>(x));
  else if constexpr (is_rounded_v<FT>)
    return number_of_binary<Number>(x);
  else if constexpr (is_interval_v<Number> && is_exact_v<FT>)
    return interval_of_exact<Number>(x);
  else if constexpr (is_interval_v<Number>)
    return Number(CGAL::to_interval(x));
  else if constexpr (std::is_constructible_v<Number, const FT&> && !is_interval_v<FT> &&
                     is_exact_v<FT>)
    return Number(x);
  else if constexpr (Is_lazy<FT>::value)
    return measure_number<Number>(x.exact());
  else {
    static_assert(
      std::is_same_v<typename Fraction_traits<FT>::Is_fraction, Tag_true>,
      "PN_subdivision_3: the numbers of the shape are not exact, or cannot be converted "
      "to those of the points: take doubles, fractions or the kernel of the points");
    std::ostringstream text;
    text << x;
    return Number(text.str().c_str());
  }
}

// Whether a point is on a shape, of which a number vanishes there. That it is not is no proof where the averages that may have
// made it are rounded.
template <class FT, class Number>
Uncertain<bool> is_proved_zero(const Number& x)
{
  const Uncertain<bool> is_zero = make_uncertain(x == Number(0));
  if constexpr (Rounds_exact_numbers<FT>::value)
    return certainly(is_zero) ? is_zero : Uncertain<bool>::indeterminate();
  else
    return is_zero;
}

// the advice where the sign of a number is not known
template <class FT>
constexpr const char* advice_for_proofs()
{
  if constexpr (Rounds_exact_numbers<FT>::value)
    return "PN_subdivision_3: lengths of normals are rounded in this number type, so that points "
           "may have left the "
           "shape: take Sqrt_extension, include CGAL/PN_subdivision_3/sqrt_extension_normals.h, "
           "and make control "
           "normals by rational_unit_normal()";
  else
    return "PN_subdivision_3: the intervals do not tell: call is_on() with a tolerance";
}

// A positive number within an interval of doubles times a power of two, so that it may be squared, divided
// and have roots as tightly beyond the range of double as in it.
class Scaled_interval
{
public:
  using Interval = Interval_nt<>;

  // an interval around |x|; tight unless x is an interval itself
  template <class Number>
  static Scaled_interval of(Number x)
  {
    Interval i(close_interval(x));
    long exponent = 0;
    if constexpr (is_exact_v<Number>)
      if (!is_well_inside(i) && x != Number(0)) {
        constexpr int step = 900;
        const bool is_small = is_smaller_than_one(x);
        const Number factor(std::ldexp(1., is_small ? step : -step));
        while (!is_well_inside(i) && is_smaller_than_one(x) == is_small) {
          x = x * factor;
          exponent += is_small ? -step : step;
          i = Interval(close_interval(x));
        }
      }
    return {CGAL::abs(i), exponent};
  }

  friend Scaled_interval sqrt(Scaled_interval x)
  {
    if (x.exponent_ % 2 != 0) {
      x.mantissa_ = x.mantissa_ * Interval(2);
      --x.exponent_;
    }
    return {CGAL::sqrt(x.mantissa_), x.exponent_ / 2};
  }
  friend Scaled_interval square(const Scaled_interval& x)
  {
    return {CGAL::square(x.mantissa_), 2 * x.exponent_};
  }
  friend Scaled_interval operator*(const Scaled_interval& x, const Scaled_interval& y)
  {
    return {x.mantissa_ * y.mantissa_, x.exponent_ + y.exponent_};
  }
  friend Scaled_interval operator/(const Scaled_interval& x, const Scaled_interval& y)
  {
    return {x.mantissa_ / y.mantissa_, x.exponent_ - y.exponent_};
  }
  friend Scaled_interval operator+(const Scaled_interval& x, const Scaled_interval& y)
  {
    const long larger = (std::max)(x.exponent_, y.exponent_);
    return {x.times_power(x.exponent_ - larger) + y.times_power(y.exponent_ - larger), larger};
  }

  Interval interval() const { return times_power(exponent_); }

private:
  Scaled_interval(const Interval& mantissa, long exponent)
    : mantissa_(mantissa)
    , exponent_(exponent)
  {}

  // so that a product of two is in the range, too
  static bool is_well_inside(const Interval& i)
  {
    const double largest = (std::max)(std::abs(i.inf()), std::abs(i.sup()));
    return largest > 0x1p-450 && largest < 0x1p450;
  }
  template <class Number>
  static bool is_smaller_than_one(const Number& x)
  {
    return CGAL::abs(x) < Number(1);
  }

  Interval times_power(long exponent) const
  {
    constexpr long step = 900, most = 5; // more is beyond the ends of double anyway
    Interval result = mantissa_;
    const Interval factor(
      std::ldexp(1., exponent < 0 ? -static_cast<int>(step) : static_cast<int>(step)));
    long rest = std::abs(exponent);
    for (long i = 0; i < most && rest >= step; ++i, rest -= step) result = result * factor;
    const auto last = static_cast<int>((std::min)(rest, step));
    return result * Interval(std::ldexp(1., exponent < 0 ? -last : last));
  }

  Interval mantissa_;
  long exponent_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_CERTIFICATES_3_INTERNAL_MEASURE_NUMBER_H
