// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_COSINE_WEIGHTS_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_COSINE_WEIGHTS_H

#include <CGAL/PN_subdivision_3/internal/schemes/Double_double.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class FT, class = void>
struct Has_trigonometry : std::false_type
{};

template <class FT>
struct Has_trigonometry<
  FT, std::void_t<decltype(FT(cos(std::declval<FT>()))), decltype(FT(acos(std::declval<FT>())))>>
  : std::true_type
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

// \pre 0 <= 2k <= n
template <class FT>
FT irrational_cosine(std::int64_t k, std::int64_t n)
{
  if constexpr (std::is_same_v<FT, Double_double>)
    return cosine_of_turn(k, n);
  else if constexpr (std::is_same_v<FT, long double>) {
    const long double pi = 3.141592653589793238462643383279502884L;
    return std::cos(2 * pi * (static_cast<long double>(k) / static_cast<long double>(n)));
  } else if constexpr (!std::is_floating_point_v<FT> && Has_trigonometry<FT>::value)
    return FT(
      cos(FT(2) * FT(acos(FT(-1))) * FT(static_cast<double>(k)) / FT(static_cast<double>(n))));
  else
    return FT(nearest_cosine(k, n));
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Schemes

returns cos(2&pi;k/n).

The rational values (those of the multiples of 60 and 90 degrees) are exact. The others are rounded: to the nearest
`float` or `double`, on every processor the same, since no mathematical library is asked; up to an ulp in
`long double`; by the number type's own `cos()` and `acos()` where argument-dependent lookup finds them; and to
`double` in all other number types, in particular in exact ones. A mask emits rows that sum to 1 whatever the rounding, see `Stencil::add_rest()`.

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

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_COSINE_WEIGHTS_H
