// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_NORMALIZATION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_NORMALIZATION_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/PN_subdivision_3/internal/average/is_interval.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Unit vectors in any field, and the two tolerances of the PN rule.
// Where the field has no square root, the inverse length is a double, good to 2^-50.
template <class Vector, class FT>
class Mask_normalization
{
  using Algebra = Algebraic_structure_traits<FT>;
  static constexpr bool is_exact = Algebra::Is_exact::value;
  static constexpr bool has_sqrt = !std::is_same<typename Algebra::Sqrt, Null_functor>::value;

public:
  Mask_normalization()
    : vanishing_(is_exact ? FT(0) : FT(4096) * epsilon())
    , unit_tolerance_(is_exact && has_sqrt ? FT(0) : FT(4) * epsilon())
  {}

  bool vanishes(const Vector& sum) const
  {
    return is_zero(sum) || sum.squared_length() <= vanishing_ * vanishing_;
  }

  // A control normal: zero and unit vectors as they are, others normalized.
  Vector control(const Vector& v) const
  {
    if (is_zero(v)) return v;
    const FT excess = v.squared_length() - FT(1);
    return CGAL::abs(excess) <= unit_tolerance_ ? v : unit(v);
  }

  Vector unit(const Vector& v) const
  {
    const FT squared_length = v.squared_length();
    if (squared_length < far_too_small() || !(squared_length <= FT(1) / far_too_small()))
      return divided_by_length(v / largest_coordinate(v));
    return divided_by_length(v);
  }

  static bool is_zero(const Vector& v)
  {
    return v.x() == FT(0) && v.y() == FT(0) && v.z() == FT(0);
  }

private:
  static FT far_too_small() { return FT(std::ldexp(1., -100)); }

  static FT largest_coordinate(const Vector& v)
  {
    return (std::max)({CGAL::abs(v.x()), CGAL::abs(v.y()), CGAL::abs(v.z())});
  }

  static Vector divided_by_length(const Vector& v)
  {
    if constexpr (has_sqrt)
      return v / CGAL::sqrt(v.squared_length());
    else
      return v * FT(inverse_root(v.squared_length()));
  }

  // to_double() of a lazy number may be wrong in the fifth digit; the exact residual mends that.
  static double inverse_root(const FT& squared_length)
  {
    double r = 1 / std::sqrt(CGAL::to_double(squared_length));
    for (int step = 0; step < 4; ++step) {
      const double residual = CGAL::to_double(FT(r) * FT(r) * squared_length - FT(1));
      if (std::abs(residual) <= std::ldexp(1., -51)) break;
      r -= r * residual / 2;
    }
    return r;
  }

  // Also for types without numeric_limits, at their current precision (intervals: that of a bound).
  static FT epsilon()
  {
    if constexpr (is_exact)
      return FT(std::numeric_limits<double>::epsilon());
    else if constexpr (std::numeric_limits<FT>::is_specialized)
      return std::numeric_limits<FT>::epsilon();
    else {
      FT e(1);
      while (CGAL::certainly(is_greater(FT(FT(1) + e / FT(2)), FT(1)))) e = e / FT(2);
      return e;
    }
  }

  FT vanishing_;
  FT unit_tolerance_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_NORMALIZATION_H
