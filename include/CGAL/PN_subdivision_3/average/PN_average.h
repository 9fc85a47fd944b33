// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_AVERAGE_PN_AVERAGE_H
#define CGAL_PN_SUBDIVISION_3_AVERAGE_PN_AVERAGE_H

#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <boost/type_traits/type_identity.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Average
/// the coordinates of a point or vector.
template <class FT, int dimension>
using Coordinates = std::array<FT, dimension>;

/// \ingroup PkgPNSubdivision3Average
/// a point with its control normal, which is a unit vector or zero ("no normal"), and with a roundness.
template <class FT, int dimension>
struct Point_normal
{
  /// the point.
  Coordinates<FT, dimension> point;
  /// the unit normal, zero if there is none.
  Coordinates<FT, dimension> normal;
  /// the roundness: 1 is the point-normal rule, 0 the linear one.
  FT roundness = FT(1);
};

namespace internal {

// whether a value is more than a point
template <class Value>
constexpr bool has_normal_v = false;
template <class FT, int dimension>
inline constexpr bool has_normal_v<Point_normal<FT, dimension>> = true;

template <class FT, std::size_t dimension>
FT dot(const std::array<FT, dimension>& a, const std::array<FT, dimension>& b)
{
  FT sum = a[0] * b[0];
  for (std::size_t c = 1; c < dimension; ++c) sum += a[c] * b[c];
  return sum;
}

template <class FT, std::size_t dimension>
void add_multiple(std::array<FT, dimension>& sum, const boost::type_identity_t<FT>& factor,
                  const std::array<FT, dimension>& v)
{
  for (std::size_t c = 0; c < dimension; ++c) sum[c] += factor * v[c];
}

// The fraction h_j = numerator / denominator: the height over q, along the line with unit direction
// n, of the end of the circular or helical arc from (p_j, n_j) to that line. The denominator is
// d_j.
template <class FT>
struct PN_height
{
  FT numerator;
  FT denominator;
};

template <class FT, int dimension, class Value>
PN_height<FT> pn_height(const Value& pj, const Coordinates<FT, dimension>& q,
                        const Coordinates<FT, dimension>& n)
{
  FT s = pj.normal[0] + n[0];
  PN_height<FT> h{s * (pj.point[0] - q[0]), s * n[0]};
  for (int c = 1; c < dimension; ++c) {
    s = pj.normal[c] + n[c];
    h.numerator += s * (pj.point[c] - q[c]);
    h.denominator += s * n[c];
  }
  return h;
}

// The window of d_j in which an entry fades: 135 to 155 degrees between its normal and the new one.
template <class FT>
FT fade_begin()
{
  return FT(75) / FT(256);
}
template <class FT>
FT fade_end()
{
  return FT(3) / FT(32);
}

// chi_j: 1 outside of the window, 0 behind it, smooth between. \pre d < fade_begin()
template <class FT>
FT fade(const FT& d)
{
  if (d <= fade_end<FT>()) return FT(0);
  const FT t = (d - fade_end<FT>()) / (fade_begin<FT>() - fade_end<FT>());
  return t * t * (FT(3) - FT(2) * t);
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Average

The linear rule: the point sum a<sub>j</sub> p<sub>j</sub>.
*/
template <class FT_, int dimension>
struct Linear_average
{
  /// the number type.
  using FT = FT_;
  /// what is averaged: a point.
  using Value = Coordinates<FT, dimension>;

  /// averages the old values of the entries of a row.
  template <class Entry>
  Value operator()(const Entry* begin, const Entry* end, const Value* old) const
  {
    if (end - begin == 1) return old[begin->vertex];
    Value q;
    q.fill(FT(0));
    for (const Entry* e = begin; e != end; ++e)
      internal::add_multiple(q, e->weight, old[e->vertex]);
    return q;
  }
};

/*!
\ingroup PkgPNSubdivision3Average

The point-normal rule of Yang, <em>Point-Normal Subdivision Curves and Surfaces</em>,
Section 3.1: for point weights a<sub>j</sub> and normal weights b<sub>j</sub>, normally the same,

 - q = &sum; a<sub>j</sub> p<sub>j</sub>, N = &sum; b<sub>j</sub> n<sub>j</sub>, n = N/|N|,
 - d<sub>j</sub> = (n<sub>j</sub> + n)&middot;n, h<sub>j</sub> = (n<sub>j</sub> +
n)&middot;(p<sub>j</sub> - q) / d<sub>j</sub>,
 - p = q + (&sum; a<sub>j</sub> h<sub>j</sub>) n.

If N vanishes, see `Unit_normal_traits::vanishing_tolerance()`, the result is q with a zero normal.

<em>Roundness.</em> With the roundness w<sub>j</sub> of the values it is

 - w = &sum; a<sub>j</sub> w<sub>j</sub>, p = q + w (&sum; a<sub>j</sub> h<sub>j</sub>) n:

the fraction w of the way from the linear point to that of the rule without. Since the weights sum to 1 exactly,
this is the rule itself, bit for bit, where all w<sub>j</sub> are 1, and the linear one where all are 0. If all
values have the same roundness, `roundness` saves the sum and its rounding.

<em>Fade of opposite normals.</em> If n<sub>j</sub> is opposite to n, no arc from p<sub>j</sub> is defined. If it is
nearly opposite, as one reversed normal among others is, the arc is many times longer than the chord. Such an entry
fades out: &chi;<sub>j</sub> falls smoothly from 1 at d<sub>j</sub> = 75/256, 135 degrees between n<sub>j</sub> and n,
to 0 at d<sub>j</sub> = 3/32, 155 degrees. With W = &sum; a<sub>j</sub>&chi;<sub>j</sub> the sum of heights becomes
(&sum; a<sub>j</sub>&chi;<sub>j</sub>h<sub>j</sub>)/W, or 0 if W < 1/64.

A row with a single entry is a copy.

This is the rule itself, for any number type and any row. The package has it in other forms, which are tested against
this one. `internal/rows/PN_average_block.h` has it for hardware floating point in three passes over a block of rows,
which hides the latency of roots and divisions and adds the heights in another order. It leaves rows that fade or
whose normal may vanish to this form. `internal/rows/Vectorized_PN_average.h` has the same, to the same bits, with four rows
side by side for AVX2. `PN_mask_3` has it through masks that only average points, which never see a row.

The old values are a pointer to them, or anything whose `operator[]` makes a `Value` of an index.
*/
template <class FT_, int dimension>
struct PN_average
{
  /// the number type.
  using FT = FT_;
  /// a vector.
  using Vector = Coordinates<FT, dimension>;
  /// what is averaged.
  using Value = Point_normal<FT, dimension>;

  /// that of all values, if it is one: then it is not read from them.
  std::optional<FT> roundness;

  /// one mask for points and normals.
  template <class Entry, class Values>
  Value operator()(const Entry* begin, const Entry* end, const Values& old) const
  {
    if (end - begin == 1) return old[begin->vertex];
    return (*this)(begin, end, begin, end, old);
  }

  /// `[begin, end)` for the points, `[normal_begin, normal_end)` for the normals.
  template <class Entry, class Values>
  Value operator()(const Entry* begin, const Entry* end, const Entry* normal_begin,
                   const Entry* normal_end, const Values& old) const
  {
    Value result;
    result.point.fill(FT(0));
    for (const Entry* e = begin; e != end; ++e)
      internal::add_multiple(result.point, e->weight, old[e->vertex].point);
    result.normal = unit_normal(normal_begin, normal_end, old);
    result.roundness = roundness ? *roundness : averaged_roundness(begin, end, old);
    if (!is_zero(result.normal)) {
      FT h = height(begin, end, old, result);
      if (!CGAL::certainly(result.roundness == FT(1))) // some numbers become longer
        h *= result.roundness;
      internal::add_multiple(result.point, h, result.normal);
    }
    return result;
  }

  /// whether `n`, a unit vector or zero, is zero.
  static bool is_zero(const Vector& n) { return internal::dot(n, n) < FT(1) / FT(2); }

private:
  using Traits = Unit_normal_traits<FT>;

  template <class Entry, class Values>
  static Vector unit_normal(const Entry* begin, const Entry* end, const Values& old)
  {
    if (end - begin == 1) return old[begin->vertex].normal;
    Vector sum;
    sum.fill(FT(0));
    for (const Entry* e = begin; e != end; ++e)
      internal::add_multiple(sum, e->weight, old[e->vertex].normal);
    const FT squared_length = internal::dot(sum, sum);
    if (squared_length <= squared_vanishing_length(begin, end, old))
      sum.fill(FT(0));
    else if constexpr (std::is_floating_point_v<FT>) {
      const FT length = std::sqrt(squared_length);
      for (FT& x : sum) x /= length;
    } else {
      if constexpr (internal::Rounds_exact_numbers<FT>::value)
        if (const int bits = internal::bits_of_refined_normals(); bits != 0)
          return internal::rational_unit_vector<FT, dimension>(sum, bits);
      const FT inverse = Traits::inverse_length(squared_length);
      for (FT& x : sum) x *= inverse;
    }
    return sum;
  }

  template <class Entry, class Values>
  static FT squared_vanishing_length(const Entry* begin, const Entry* end, const Values& old)
  {
    if constexpr (internal::is_exact_v<FT>) return FT(0);
    FT sum(0);
    for (const Entry* e = begin; e != end; ++e)
      if (!is_zero(old[e->vertex].normal)) sum += CGAL::abs(e->weight);
    sum *= Traits::vanishing_tolerance();
    return sum * sum;
  }

  template <class Entry, class Values>
  static FT averaged_roundness(const Entry* begin, const Entry* end, const Values& old)
  {
    FT sum(0);
    [[maybe_unused]] bool are_equal =
      !std::is_floating_point_v<FT>; // in intervals weights hardly sum to 1
    for (const Entry* e = begin; e != end; ++e) {
      const Value& value = old[e->vertex];
      sum += e->weight * value.roundness;
      if constexpr (!std::is_floating_point_v<FT>)
        are_equal = are_equal && CGAL::certainly(value.roundness == old[begin->vertex].roundness);
    }
    return are_equal && begin != end ? old[begin->vertex].roundness : sum;
  }

  // the sum of the heights over q = result.point
  template <class Entry, class Values>
  static FT height(const Entry* begin, const Entry* end, const Values& old, const Value& result)
  {
    FT sum(0), weight(0);
    bool faded = false;
    for (const Entry* e = begin; e != end; ++e) {
      if (CGAL::certainly(e->weight == FT(0))) continue;
      const auto h =
        internal::pn_height<FT, dimension>(old[e->vertex], result.point, result.normal);
      if (h.denominator < internal::fade_begin<FT>()) {
        faded = true;
        const FT chi = internal::fade(h.denominator);
        if (chi == FT(0)) continue;
        weight += e->weight * chi;
        sum += e->weight * chi * (h.numerator / h.denominator);
      } else {
        weight += e->weight;
        sum += e->weight * (h.numerator / h.denominator);
      }
    }
    if (!faded) return sum;
    return weight < FT(1) / FT(64) ? FT(0) : FT(sum / weight);
  }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_AVERAGE_PN_AVERAGE_H
