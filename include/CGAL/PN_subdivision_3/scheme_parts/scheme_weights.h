// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEME_PARTS_SCHEME_WEIGHTS_H
#define CGAL_PN_SUBDIVISION_3_SCHEME_PARTS_SCHEME_WEIGHTS_H

#include <CGAL/PN_subdivision_3/internal/numbers/Weight_number.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <stdexcept>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

A number that a scheme takes, such as the tension of `Kobbelt_scheme`: a `double` or a fraction. In exact number types fractions are what
they are, `Scheme_parameter(1, 20)` is 1/20, while 0.05 is the `double` next to it.
*/
class Scheme_parameter
{
public:
  /// a number that is a `double`.
  Scheme_parameter(double value)
    : value_(value)
  {}
  /// a fraction. \throws std::invalid_argument if the denominator is not positive
  Scheme_parameter(int numerator, int denominator)
    : value_(static_cast<double>(numerator) / denominator)
    , numerator_(numerator)
    , denominator_(denominator)
  {
    if (denominator <= 0)
      throw std::invalid_argument(
        "PN_subdivision_3: the denominator of a parameter of a scheme must be positive");
  }

  /// returns the number rounded to `double`.
  double to_double() const { return value_; }
  /// returns the number in the number type `FT`.
  template <class FT>
  FT value() const
  {
    return denominator_ == 0 ? FT(value_) : FT(FT(numerator_) / FT(denominator_));
  }

private:
  double value_;
  int numerator_ = 0, denominator_ = 0; // 0: none is given
};

/// \ingroup PkgPNSubdivision3Schemes
/// at which extraordinary vertices a modified scheme has rules of its own.
enum class Tuned_valences {
  /// at all.
  all,
  /// where the curvature of the linear scheme diverges: not at valence 3 of Catmull-Clark and valences
  /// 4 and 5 of Loop subdivision, where it is bounded.
  diverging
};

/*!
\ingroup PkgPNSubdivision3Schemes

returns cos(2&pi;k/n).

The rational values (those of the multiples of 60 and 90 degrees) are exact. The others are rounded: to the nearest
`float` or `double`, on every processor the same, since no mathematical library is asked; up to an ulp in
`long double`; to the default precision of `Gmpfr`. Other number types round by their own `cos()` and `acos()` if
argument-dependent lookup finds these, and else to `double`, as exact types do. Intervals contain the cosine. A mask
emits rows that sum to 1 whatever the rounding, see `Stencil::add_rest()`.

\pre `n > 0`
*/
template <class FT>
FT cosine_weight(std::int64_t k, std::int64_t n)
{
  k %= n;
  if (k < 0) k += n;
  if (2 * k > n) k = n - k;
  const std::int64_t divisor = std::gcd(k, n);
  k /= divisor;
  n /= divisor;
  switch (n) {
  case 1:
    return FT(1);
  case 2:
    return FT(-1);
  case 3:
    return FT(-1) / FT(2);
  case 4:
    return FT(0);
  case 6:
    return FT(1) / FT(2);
  default:
    return internal::irrational_cosine<FT>(k, n);
  }
}

/*!
\ingroup PkgPNSubdivision3Schemes
A weight that depends on the valence only, computed once for the valences below 32.
*/
template <class FT>
class Weight_per_valence
{
public:
  /// returns the weight of a valence.
  using Function = FT (*)(std::uint32_t);

  /// keeps the weights that `f` returns.
  explicit Weight_per_valence(Function f)
    : function_(f)
  {
    for (std::uint32_t n = 1; n < table_.size(); ++n) table_[n] = f(n);
  }

  /// the weight of the valence `n`.
  FT operator()(std::uint32_t n) const { return n < table_.size() ? table_[n] : function_(n); }

private:
  Function function_;
  std::array<FT, 32> table_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEME_PARTS_SCHEME_WEIGHTS_H
