// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CGAL_MASKS_3_INTERNAL_MASK_PROBE_H
#define CGAL_PN_CGAL_MASKS_3_INTERNAL_MASK_PROBE_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/number_type_basic.h>

#include <boost/property_map/property_map.hpp>

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

// What a mask is told when it asks for the point of a vertex: the point, the normal read as a
// point, or the vertex's share (chi h, chi, 0) in the height over q along n.
template <class PointNormalMap>
class Mask_probe
{
public:
  using Vertex = typename boost::property_traits<PointNormalMap>::key_type;
  using Point_normal = typename boost::property_traits<PointNormalMap>::value_type;
  using Point = typename Point_normal::first_type;
  using Vector = typename Point_normal::second_type;
  using FT = typename Kernel_traits<Point>::Kernel::FT;

  explicit Mask_probe(const PointNormalMap& point_normals)
    : point_normals_(point_normals)
  {}

  void answer_points() { answer_ = Answer::points; }
  void answer_normals() { answer_ = Answer::normals; }
  void answer_heights(const Point& q, const Vector& n)
  {
    answer_ = Answer::heights;
    q_ = q;
    n_ = n;
    fading_ = false;
  }

  Point operator()(const Vertex& v) const
  {
    const Point_normal pn = get(point_normals_, v);
    if (answer_ == Answer::points) return pn.first;
    const Vector n = normalization_.control(pn.second);
    return answer_ == Answer::normals ? ORIGIN + n : height(pn.first, n);
  }

  // The new normal for the mask's sum of the normals, zero if it vanishes.
  Vector normal(const Vector& sum) const
  {
    if (normalization_.vanishes(sum)) return Vector(FT(0), FT(0), FT(0));
    return normalization_.unit(sum);
  }

  // The new height for the mask's sum of the heights.
  FT height(const Point& sum) const
  {
    if (!fading_) return sum.x();
    if (sum.y() < FT(1) / FT(64)) return FT(0);
    return sum.x() / sum.y();
  }

private:
  enum class Answer { points, normals, heights };

  // The fade is decided before the division by d, which may be zero.
  Point height(const Point& p, const Vector& n_p) const
  {
    const Vector s = n_p + n_;
    const FT d = s * n_;
    const FT chi = fade(d);
    if (chi != FT(1)) fading_ = true;
    if (chi == FT(0)) return Point(FT(0), FT(0), FT(0));
    return Point(chi * ((s * (p - q_)) / d), chi, FT(0));
  }

  static FT fade(const FT& d) { return d < fade_begin<FT>() ? internal::fade(d) : FT(1); }

  PointNormalMap point_normals_;
  Mask_normalization<Vector, FT> normalization_;
  Answer answer_ = Answer::points;
  Point q_ = ORIGIN;
  Vector n_ = NULL_VECTOR;
  mutable bool fading_ = false;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CGAL_MASKS_3_INTERNAL_MASK_PROBE_H
