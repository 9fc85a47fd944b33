// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_WEIGHT_NUMBER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_WEIGHT_NUMBER_H

#include <CGAL/FPU.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#ifdef CGAL_USE_MPFR
#  include <mpfr.h>
#endif

#include <boost/type_traits/is_detected.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

// The unevaluated sum of two doubles, about 104 bits: irrational weights are computed in it, which have then the
// same bits on all processors and with all mathematical libraries. (long double has 53, 64, 106 or 113 bits, and its
// cosine is rounded as the library likes.) Dekker, A floating-point technique for extending the available precision,
// Numer. Math. 18 (1971). For numbers of moderate size: neither overflow nor underflow is looked at.
class Double_double
{
public:
  Double_double() = default;
  explicit Double_double(int x)
    : high_(x)
  {}
  explicit Double_double(double x)
    : high_(x)
  {}

  // to nearest
  template <class T, class = std::enable_if_t<std::is_floating_point_v<T>>>
  explicit operator T() const
  {
    return static_cast<T>(high_);
  }

  Double_double operator-() const { return {-high_, -low_}; }

  friend Double_double operator+(const Double_double& a, const Double_double& b)
  {
    const Double_double high = exact_sum(a.high_, b.high_), low = exact_sum(a.low_, b.low_);
    const Double_double sum = exact_sum_of_ordered(high.high_, high.low_ + low.high_);
    return exact_sum_of_ordered(sum.high_, sum.low_ + low.low_);
  }
  friend Double_double operator-(const Double_double& a, const Double_double& b) { return a + -b; }
  friend Double_double operator*(const Double_double& a, const Double_double& b)
  {
    const Double_double p = exact_product(a.high_, b.high_);
    const double across = a.high_ * b.low_ + a.low_ * b.high_;
    return exact_sum_of_ordered(p.high_, p.low_ + across);
  }
  friend Double_double operator/(const Double_double& a, const Double_double& b)
  {
    const double first = a.high_ / b.high_;
    Double_double rest = a - b * Double_double(first);
    const double second = rest.high_ / b.high_;
    rest = rest - b * Double_double(second);
    return exact_sum_of_ordered(first, second) + Double_double(rest.high_ / b.high_);
  }
  Double_double& operator+=(const Double_double& x) { return *this = *this + x; }

  friend bool operator<(const Double_double& a, const Double_double& b)
  {
    return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
  }

  // Newton's correction of the root in double. \pre x >= 0
  friend Double_double sqrt(const Double_double& x)
  {
    if (!(x.high_ > 0)) return Double_double(0);
    const double root = std::sqrt(x.high_);
    const Double_double rest = x - exact_product(root, root);
    return exact_sum_of_ordered(root, rest.high_ / (2 * root));
  }

  static Double_double pi() { return {3.141592653589793116, 1.224646799147353207e-16}; }

private:
  Double_double(double high, double low)
    : high_(high)
    , low_(low)
  {}

  // \pre |a| >= |b|, or a is 0
  static Double_double exact_sum_of_ordered(double a, double b)
  {
    const double sum = a + b;
    return {sum, b - (sum - a)};
  }
  static Double_double exact_sum(double a, double b)
  {
    const double sum = a + b, of_b = sum - a, of_a = sum - of_b;
    return {sum, (a - of_a) + (b - of_b)};
  }
  // the leading 26 bits; no fused product changes what the parts of a product are
  static Double_double halves(double x)
  {
    const double scaled = 134217729 * x; // 2^27 + 1
    const double high = scaled - (scaled - x);
    return {high, x - high};
  }
  static Double_double exact_product(double a, double b)
  {
    const double product = a * b;
    const Double_double x = halves(a), y = halves(b);
    const double rest =
      ((x.high_ * y.high_ - product) + x.high_ * y.low_ + x.low_ * y.high_) + x.low_ * y.low_;
    return {product, rest};
  }

  double high_ = 0, low_ = 0;
};

// The sum of (-1)^i x^(2i) / (2i+s)!: with s = 0 the cosine, with s = 1 the sine divided by x.
// \pre |x| <= pi/4
inline Double_double Taylor_sum(const Double_double& square, std::size_t s)
{
  constexpr std::size_t terms = 15, terms_of_low_part = 9; // double does for those behind
  static const auto coefficients = [] {
    std::array<Double_double, 2 * terms> c; // (-1)^(j/2) / j!
    c[0] = c[1] = Double_double(1);
    for (std::size_t j = 2; j < c.size(); ++j)
      c[j] = -c[j - 2] / Double_double(static_cast<int>(j * (j - 1)));
    return c;
  }();
  const auto x = static_cast<double>(square);
  double last = 0;
  std::size_t i = terms;
  while (i > terms_of_low_part) last = last * x + static_cast<double>(coefficients[2 * --i + s]);
  Double_double sum(last);
  while (i > 0) sum = sum * square + coefficients[2 * --i + s];
  return sum;
}

// cos(2 pi k / n), whatever the rounding of the caller is: what is found is kept for others. \pre 0 <= 2k <= n
inline Double_double cosine_of_turn(std::int64_t k, std::int64_t n)
{
  const Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  std::int64_t m = 2 * k; // of half turns
  const bool is_negative = 2 * m > n;
  if (is_negative) m = n - m;
  const bool is_sine = 4 * m > n;
  const Double_double eighths =
    is_sine
      ? Double_double(static_cast<double>(n - 2 * m)) / Double_double(static_cast<double>(2 * n))
      : Double_double(static_cast<double>(m)) / Double_double(static_cast<double>(n));
  const Double_double x = eighths * Double_double::pi(), square = x * x;
  const Double_double cosine = is_sine ? x * Taylor_sum(square, 1) : Taylor_sum(square, 0);
  return is_negative ? -cosine : cosine;
}

namespace square_root_lookup {

using std::sqrt; // besides what argument-dependent lookup finds

template <class Number>
auto square_root(const Number& x) -> decltype(Number(sqrt(x)))
{
  return Number(sqrt(x));
}

} // namespace square_root_lookup
using square_root_lookup::square_root;

template <class FT>
using Square_root_of = decltype(square_root(std::declval<const FT&>()));
template <class FT>
using Has_square_root = boost::is_detected<Square_root_of, FT>;

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

// cos(2 pi k / n) with the precision that a number type has, where 2k <= n and k, n are coprime. They are
// found without a header of the number type.

template <class FT>
using Cosine_and_inverse_of = decltype(FT(cos(std::declval<FT>())), FT(acos(std::declval<FT>())));
template <class FT>
using Has_own_cosine = boost::is_detected<Cosine_and_inverse_of, FT>;

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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_WEIGHT_NUMBER_H
