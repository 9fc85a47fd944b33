// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_NUMBER_FUNCTIONS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_NUMBER_FUNCTIONS_H

#include <CGAL/Interval_traits.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/utils.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

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

// Ends of intervals, which are numbers that any two can be compared of; doubles around the interval for types without
// CGAL::Interval_traits.
template <class FT, class = void>
struct Interval_bounds
{
  using Bound = double;
  static Bound lower(const FT& x) { return CGAL::to_interval(x).first; }
  static Bound upper(const FT& x) { return CGAL::to_interval(x).second; }
};
template <class FT>
struct Interval_bounds<
  FT, std::enable_if_t<std::is_same_v<typename CGAL::Interval_traits<FT>::Is_interval, Tag_true>>>
{
  using Traits = CGAL::Interval_traits<FT>;
  using Bound = typename Traits::Bound;
  static Bound lower(const FT& x) { return typename Traits::Lower()(x); }
  static Bound upper(const FT& x) { return typename Traits::Upper()(x); }
};

// an interval without width near the middle of x
template <class FT>
FT middle(const FT& x)
{
  using Bounds = Interval_bounds<FT>;
  return FT(typename Bounds::Bound((Bounds::lower(x) + Bounds::upper(x)) / 2));
}

// the least one that contains both
template <class FT>
FT interval_around_both(const FT& a, const FT& b)
{
  using Bounds = Interval_bounds<FT>;
  const auto al = Bounds::lower(a), bl = Bounds::lower(b);
  const auto au = Bounds::upper(a), bu = Bounds::upper(b);
  return FT(std::make_pair(al < bl ? al : bl, au < bu ? bu : au));
}

// [-radius, radius], of doubles
template <class FT>
FT symmetric_interval(double radius)
{
  return FT(std::make_pair(-radius, radius));
}

// calls f(); if the precision of the number type does not decide a comparison there, throws a message with what() is undecided
template <class FT, class Function, class What>
void name_undecided(const Function& f, [[maybe_unused]] const What& what)
{
  if constexpr (std::is_floating_point_v<FT>)
    f();
  else
    try {
      f();
    } catch (const Uncertain_conversion_exception&) {
      throw std::domain_error(
        "PN_subdivision_3: the precision of the number type does not decide " +
        std::string(what()) + ": use a higher precision");
    }
}

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

// divides by the largest absolute value, and returns it; zero stays zero
template <class FT, std::size_t dimension>
FT divide_by_largest(std::array<FT, dimension>& v)
{
  FT largest(0);
  for (const FT& x : v) largest = (CGAL::max)(largest, FT(CGAL::abs(x)));
  if (!(largest == FT(0)))
    for (FT& x : v) x /= largest;
  return largest;
}

// Multiplies by the power of two that makes the squares of components harmless, and returns its exponent. Intervals
// are not asked which component is the largest, which they need not decide.
template <class FT, std::size_t dimension>
int scale_to_one(std::array<FT, dimension>& v)
{
  double largest = 0;
  for (const FT& x : v)
    largest = (std::max)(largest, std::abs(static_cast<double>(CGAL::to_double(x))));
  if (!(largest > 0) || !std::isfinite(largest)) return 0;
  const int exponent = -std::ilogb(largest);
  for (FT& x : v) x = times_power_of_two(x, exponent);
  return exponent;
}

// x 2^k, of any k
template <class FT>
FT times_power(FT x, int k)
{
  constexpr int step = 1000;
  for (; k > step; k -= step) x = times_power_of_two(x, step);
  for (; k < -step; k += step) x = times_power_of_two(x, -step);
  return times_power_of_two(x, k);
}

// The multiple of 2^-bits that is nearest to an exact number below 2^100, or nearly so, by doubles that are integers.
template <class FT>
FT rounded_to_bits(const FT& x, int bits)
{
  constexpr int most = 900; // in the range of double
  if (bits > most) {
    const FT head = rounded_to_bits(x, most);
    const FT tail = rounded_to_bits(times_power(FT(x - head), most), bits - most);
    return head + times_power(tail, -most);
  }
  FT rest = times_power(x, bits), sum(0);
  for (;;) {
    const double head = std::nearbyint(close_double(rest));
    if (head == 0 || !std::isfinite(head)) break;
    sum = sum + FT(head);
    rest = rest - FT(head);
  }
  return times_power(sum, -bits);
}

// the root of a number from 1 to some thousands: Newton's iteration, each step of which is rounded
template <class FT>
FT rounded_root(const FT& square, int bits)
{
  FT root(std::sqrt(close_double(square)));
  for (int exact = 45; exact < bits; exact *= 2)
    root = rounded_to_bits(FT((root + square / root) / FT(2)), bits);
  return root;
}

// The vector of length 1, exactly, whose direction is that of v, but for an angle below 1.5 2^-bits: the
// stereographic projection, from the pole opposite to the axis that v is next to, with the coordinates rounded to
// bits. v may be zero, and is then returned.
template <class FT, std::size_t dimension>
std::array<FT, dimension> rational_unit_vector(const std::array<FT, dimension>& v, int bits)
{
  std::size_t axis = 0;
  for (std::size_t c = 1; c < dimension; ++c)
    if (CGAL::abs(v[axis]) < CGAL::abs(v[c])) axis = c;
  const FT largest = CGAL::abs(v[axis]);
  if (largest == FT(0)) return v;
  FT square(0);
  for (const FT& x : v) square = square + CGAL::square(FT(x / largest));
  const FT distance = FT(1) + rounded_root(square, bits + 8);
  std::array<FT, dimension> n;
  FT sum(0);
  for (std::size_t c = 0; c < dimension; ++c) {
    if (c == axis) continue;
    n[c] = rounded_to_bits(FT(v[c] / largest / distance), bits);
    sum = sum + CGAL::square(n[c]);
  }
  const FT factor = FT(2) / (FT(1) + sum);
  for (std::size_t c = 0; c < dimension; ++c)
    if (c != axis) n[c] = n[c] * factor;
  n[axis] = v[axis] < FT(0) ? FT(FT(1) - factor) : FT(factor - FT(1));
  return n;
}

// the number of bits to which refined normals of exact types without square root are rounded; 0: they are not
inline std::atomic<int>& bits_of_refined_normals()
{
  static std::atomic<int> bits{0};
  return bits;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_NUMBER_FUNCTIONS_H
