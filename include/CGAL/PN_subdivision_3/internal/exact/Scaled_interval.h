// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_EXACT_SCALED_INTERVAL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_EXACT_SCALED_INTERVAL_H

#include <CGAL/Interval_nt.h>
#include <CGAL/PN_subdivision_3/internal/exact/measure_number.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A positive number within an interval of doubles times a power of two, so that it may be squared, divided
// and have roots as tightly beyond the range of double as in it.
class Scaled_interval
{
public:
  using Interval = Interval_nt<>;

  // of |x|
  template <class Number>
  static Scaled_interval of(Number x)
  {
    Interval i = interval_around(x);
    long exponent = 0;
    if constexpr (is_exact_v<Number>)
      if (!is_well_inside(i) && x != Number(0)) {
        constexpr int step = 900;
        const bool is_small = is_smaller_than_one(x);
        const Number factor(std::ldexp(1., is_small ? step : -step));
        while (!is_well_inside(i) && is_smaller_than_one(x) == is_small) {
          x = x * factor;
          exponent += is_small ? -step : step;
          i = interval_around(x);
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

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_EXACT_SCALED_INTERVAL_H
