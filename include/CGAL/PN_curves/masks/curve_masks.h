// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_MASKS_CURVE_MASKS_H
#define CGAL_PN_CURVES_MASKS_CURVE_MASKS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Curves
/// What happens at the ends of a control polygon.
enum class Curve_end {
  closed,  ///< the polygon is closed; its first point is not repeated
  reflect, ///< open; points beyond an end are reflected in it: p_{-i} = 2 p_0 - p_i
  none     ///< open; only points whose whole stencil exists are kept
};

/*!
\ingroup PkgPNSubdivision3Curves

The mask of uniform B-spline curves of a degree m &ge; 1 (Lane and Riesenfeld).

a<sub>i</sub> = C(m+1, i) / 2<sup>m</sup>. Odd degrees are primal: a new point for every old one and one for every
edge; even degrees are dual. Degree 2 is Chaikin's scheme.

\cgalModels{PNSubdivisionCurveMask}
*/
class B_spline_mask
{
public:
  /// the greatest degree; the least one is 1.
  static constexpr int greatest_degree = 30;

  /// the name of the masks, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "bspline:DEGREE"; }

  /// \throws std::invalid_argument if the degree is not in [1, 30]
  explicit B_spline_mask(int degree)
    : degree_(degree)
  {
    if (degree < 1 || degree > greatest_degree)
      throw std::invalid_argument("PN_subdivision_3: a B-spline mask has a degree from 1 to " +
                                  std::to_string(greatest_degree) + ", not " +
                                  std::to_string(degree));
  }

  /// the index of the first coefficient.
  int first_index() const { return degree_ % 2 != 0 ? -(degree_ + 1) / 2 : -degree_ / 2; }

  /// the coefficients, in the order of their indices.
  template <class FT>
  std::vector<FT> coefficients() const
  {
    std::vector<FT> a;
    long long binomial = 1;
    for (int i = 0; i <= degree_ + 1; ++i) {
      // below 2^31, as is the power of two: both are exact as int
      a.push_back(FT(static_cast<int>(binomial)) / FT(1 << degree_));
      binomial = binomial * (degree_ + 1 - i) / (i + 1);
    }
    return a;
  }

private:
  int degree_;
};

/*!
\ingroup PkgPNSubdivision3Curves

The interpolatory mask of Dubuc and Deslauriers on 2n points. Old points are kept. The new point of an edge is the
value in its middle of the polynomial through the n points on either side. Four points are the four-point scheme with
w = 1/16.

\cgalModels{PNSubdivisionCurveMask}
*/
class Dubuc_Deslauriers_mask
{
public:
  /// the greatest number of points; the least one is 2.
  static constexpr int greatest_number_of_points = 20;

  /// the name of the masks, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "POINTS-point"; }

  /// \throws std::invalid_argument if the number of points is not even or not in [2, 20]
  explicit Dubuc_Deslauriers_mask(int points)
    : half_(points / 2)
  {
    if (points < 2 || points > greatest_number_of_points || points % 2 != 0)
      throw std::invalid_argument("PN_subdivision_3: a Dubuc-Deslauriers mask has an even number "
                                  "of points from 2 to " +
                                  std::to_string(greatest_number_of_points) + ", not " +
                                  std::to_string(points));
  }

  /// the index of the first coefficient.
  int first_index() const { return 1 - 2 * half_; }

  /// the coefficients, in the order of their indices.
  template <class FT>
  std::vector<FT> coefficients() const
  {
    std::vector<FT> a(static_cast<std::size_t>(4 * half_ - 1), FT(0));
    a[static_cast<std::size_t>(2 * half_ - 1)] = FT(1);
    for (int j = 1 - half_; j <= half_; ++j)
      a[static_cast<std::size_t>(2 * half_ - 2 * j)] = lagrange<FT>(j);
    return a;
  }

private:
  // The Lagrange polynomial of node j at 1/2, of the nodes 1 - n, ..., n: a fraction over a power
  // of two, which stays within 64 bits when it is reduced after each factor.
  template <class FT>
  FT lagrange(int j) const
  {
    std::int64_t numerator = 1, denominator = 1;
    for (int k = 1 - half_; k <= half_; ++k) {
      if (k == j) continue;
      numerator *= 1 - 2 * k;
      denominator *= std::int64_t(2) * (j - k);
      const std::int64_t divisor = std::gcd(numerator, denominator);
      numerator /= divisor;
      denominator /= divisor;
    }
    return integer<FT>(numerator) / integer<FT>(denominator);
  }

  // a field is made from int only
  template <class FT>
  static FT integer(std::int64_t i)
  {
    const std::int64_t base = 1 << 30;
    if (i >= -base && i <= base) return FT(static_cast<int>(i));
    return integer<FT>(i / base) * FT(static_cast<int>(base)) + FT(static_cast<int>(i % base));
  }

  int half_;
};

/*!
\ingroup PkgPNSubdivision3Curves

A mask given by its coefficients a<sub>first</sub>, a<sub>first + 1</sub>, ...: the new point i is
&sum;<sub>j</sub> a<sub>i - 2j</sub> p<sub>j</sub>. The coefficients of even and those of odd index
each sum to 1. An odd number of coefficients makes a primal mask, an even number a dual one.

\tparam Coefficient a number type that the number type of the curve can be constructed from
\cgalModels{PNSubdivisionCurveMask}
*/
template <class Coefficient>
class Univariate_mask
{
public:
  /// makes the mask of the coefficients, of which the first has the index `first_index`.
  Univariate_mask(int first_index, std::vector<Coefficient> coefficients)
    : first_index_(first_index)
    , coefficients_(std::move(coefficients))
  {}

  /// the index of the first coefficient.
  int first_index() const { return first_index_; }

  /// the coefficients, in the order of their indices.
  template <class FT>
  std::vector<FT> coefficients() const
  {
    return std::vector<FT>(coefficients_.begin(), coefficients_.end());
  }

private:
  int first_index_;
  std::vector<Coefficient> coefficients_;
};

/// \ingroup PkgPNSubdivision3Curves
/// The linear twin of a mask, made by `linear()`: normals take no part and come out as zero.
template <class Mask>
struct Linear_mask
{
  /// the index of the first coefficient.
  int first_index() const { return mask.first_index(); }

  /// the coefficients, in the order of their indices.
  template <class FT>
  std::vector<FT> coefficients() const
  {
    return mask.template coefficients<FT>();
  }

  /// the mask whose normals are left out.
  Mask mask;
};

/// \ingroup PkgPNSubdivision3Curves
/// returns the linear twin of a mask of curves.
template <class Mask, class = decltype(std::declval<const Mask&>().first_index()), class = void>
Linear_mask<Mask> linear(const Mask& mask)
{
  return {mask};
}

/// \ingroup PkgPNSubdivision3Curves
/// A mask whose normals are refined by another one, made by `with_normal_mask()`.
template <class Mask, class Normal_mask>
struct Mask_with_normals
{
  /// the index of the first coefficient.
  int first_index() const { return mask.first_index(); }

  /// the coefficients, in the order of their indices.
  template <class FT>
  std::vector<FT> coefficients() const
  {
    return mask.template coefficients<FT>();
  }

  /// the mask of the points.
  Mask mask;
  /// the mask of the normals.
  Normal_mask normal_mask;
};

/*!
\ingroup PkgPNSubdivision3Curves
returns the mask that refines points as `mask` and normals as `normal_mask` does (Yang,
Section 4.1). Both are primal or both are dual. Circles are in general not reproduced.
*/
template <class Mask, class Normal_mask>
Mask_with_normals<Mask, Normal_mask> with_normal_mask(const Mask& mask,
                                                      const Normal_mask& normal_mask)
{
  return {mask, normal_mask};
}

/*!
\ingroup PkgPNSubdivision3Curves
A mask that differs from round to round, made by `level_dependent_mask()`.
*/
template <class Function>
struct Level_dependent_mask
{
  /// the mask of the k-th round, counted from 1.
  auto in_round(unsigned k) const { return function(k); }

  /// returns the mask of a round.
  Function function;
};

/*!
\ingroup PkgPNSubdivision3Curves
returns the mask that is `function(k)` in the k-th round, counted from 1 in each call of `subdivide_curve()`, so
that two calls begin twice with the first mask. Such masks make, for instance, trigonometric splines.
\tparam Function a function object that returns a model of `PNSubdivisionCurveMask`, or what `linear()` or
  `with_normal_mask()` makes of one, always of the same type
*/
template <class Function>
Level_dependent_mask<Function> level_dependent_mask(const Function& function)
{
  return {function};
}

namespace internal {

template <class Mask>
struct Listed_masks
{
  const Mask& operator()(unsigned k) const
  {
    return masks[(std::min)(std::size_t(k), masks.size()) - 1];
  }
  std::vector<Mask> masks;
};

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Curves
returns the mask that is `masks[k - 1]` in the k-th round, and the last one of them in all further rounds. Since the rounds are
the same from there on, `curve_limit_points()` knows its limits.
\tparam Mask a model of `PNSubdivisionCurveMask`, or what `linear()` or `with_normal_mask()` makes of one
\throws std::invalid_argument if there is no mask
*/
template <class Mask>
Level_dependent_mask<internal::Listed_masks<Mask>>
level_dependent_mask(const std::vector<Mask>& masks)
{
  if (masks.empty())
    throw std::invalid_argument(
      "PN_subdivision_3: a mask that differs from round to round is made of one mask at least");
  return {{masks}};
}

/// \ingroup PkgPNSubdivision3Curves
/// returns the linear twin of a mask that differs from round to round.
template <class Function>
auto linear(const Level_dependent_mask<Function>& mask)
{
  return level_dependent_mask([mask](unsigned k) { return linear(mask.in_round(k)); });
}
template <class Mask>
auto linear(const Level_dependent_mask<internal::Listed_masks<Mask>>& mask)
{
  std::vector<Linear_mask<Mask>> masks;
  for (const Mask& m : mask.function.masks) masks.push_back(linear(m));
  return level_dependent_mask(masks);
}

namespace internal {

// the mask of a round, if masks differ or not
template <class Mask>
const Mask& mask_in_round(const Mask& mask, unsigned /*k*/)
{
  return mask;
}
template <class Function>
auto mask_in_round(const Level_dependent_mask<Function>& mask, unsigned k)
{
  return mask.in_round(k);
}

template <class Mask>
using Mask_in_round = std::decay_t<decltype(mask_in_round(std::declval<const Mask&>(), 1u))>;

template <class Mask>
constexpr bool is_level_dependent_v = false;
template <class Function>
inline constexpr bool is_level_dependent_v<Level_dependent_mask<Function>> = true;

template <class Mask>
constexpr bool is_listed_v = false;
template <class Mask>
inline constexpr bool is_listed_v<Level_dependent_mask<Listed_masks<Mask>>> = true;

} // namespace internal
} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CURVES_MASKS_CURVE_MASKS_H
