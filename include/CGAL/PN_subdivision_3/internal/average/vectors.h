// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_VECTORS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_VECTORS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/utils.h>

#include <boost/type_traits/type_identity.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL::PN_subdivision_3::internal {

template <class FT, int dimension>
Coordinates<FT, dimension> zero_vector()
{
  Coordinates<FT, dimension> zero;
  zero.fill(FT(0));
  return zero;
}

// the point of a value, with normal or without
template <class Value>
auto& point_of(Value&& value)
{
  if constexpr (has_normal_v<std::decay_t<Value>>)
    return value.point;
  else
    return value;
}

template <class FT, std::size_t dimension>
inline std::array<FT, dimension> difference(std::array<FT, dimension> a,
                                            const std::array<FT, dimension>& b)
{
  for (std::size_t c = 0; c < dimension; ++c) a[c] -= b[c];
  return a;
}

// whether two vectors, also of intervals, are the same numbers
template <class FT, std::size_t dimension>
bool are_certainly_equal(const std::array<FT, dimension>& a, const std::array<FT, dimension>& b)
{
  for (std::size_t c = 0; c < dimension; ++c)
    if (!CGAL::certainly(a[c] == b[c])) return false;
  return true;
}

template <class FT, std::size_t dimension>
std::array<FT, dimension> opposite_vector(std::array<FT, dimension> a)
{
  for (FT& x : a) x = -x;
  return a;
}

template <class FT, std::size_t dimension>
void scale(std::array<FT, dimension>& v, const boost::type_identity_t<FT>& factor)
{
  for (FT& x : v) x *= factor;
}

// \pre squared_length > 0
template <class FT, std::size_t dimension>
void divide_by_length(std::array<FT, dimension>& v,
                      const boost::type_identity_t<FT>& squared_length)
{
  if constexpr (std::is_floating_point_v<FT>) {
    const FT length = std::sqrt(squared_length);
    for (FT& x : v) x /= length;
  } else
    scale(v, Unit_normal_traits<FT>::inverse_length(squared_length));
}

template <class FT>
FT root_of_square(const FT& square)
{
  if constexpr (std::is_floating_point_v<FT>)
    return std::sqrt(square);
  else
    return square == FT(0) ? FT(0) : FT(square * Unit_normal_traits<FT>::inverse_length(square));
}

// The length; its square neither overflows nor underflows.
template <class FT, std::size_t dimension>
FT length_of(std::array<FT, dimension> v)
{
  if constexpr (is_interval_v<FT>) {
    const int exponent = scale_to_one(v);
    return times_power_of_two(root_of_square<FT>(dot(v, v)), -exponent);
  } else {
    const FT largest = divide_by_largest(v);
    return largest == FT(0) ? largest : FT(largest * root_of_square<FT>(dot(v, v)));
  }
}

// The unit vector of v, zero if the length of v is at most the tolerance times `scale`.
template <class FT, std::size_t dimension>
std::array<FT, dimension> unit_or_zero(std::array<FT, dimension> v,
                                       const boost::type_identity_t<FT>& scale)
{
  const FT least = Unit_normal_traits<FT>::vanishing_tolerance() * scale;
  const FT squared_length = dot(v, v);
  if (squared_length <= least * least) return zero_vector<FT, dimension>();
  divide_by_length(v, squared_length);
  return v;
}

// whether v, which is a unit vector or zero, is zero
template <class FT, std::size_t dimension>
bool is_zero_not_unit(const std::array<FT, dimension>& v)
{
  return PN_average<FT, dimension>::is_zero(v);
}

// 0 below 0, 1 above 1, with zero slopes there
template <class FT>
FT smoothstep(const FT& x)
{
  if (x <= FT(0)) return FT(0);
  if (x >= FT(1)) return FT(1);
  return x * x * (FT(3) - FT(2) * x);
}

// the number type in which normals are estimated: float is widened
template <class FT>
using At_least_double = std::conditional_t<std::is_same_v<FT, float>, double, FT>;

// a sum of vectors that are as exact as double or FT, whichever is less, vanishes if it is shorter
// than this times the sum of their lengths
template <class FT>
double vanishing_tolerance()
{
  return 4096 * (std::max)(static_cast<double>(CGAL::to_double(machine_epsilon<FT>())),
                           std::numeric_limits<double>::epsilon());
}

template <class T>
inline Coordinates<T, 3> cross(const Coordinates<T, 3>& a, const Coordinates<T, 3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T>
Coordinates<double, 3> to_double_3(const Coordinates<T, 3>& a)
{
  return {close_double(a[0]), close_double(a[1]), close_double(a[2])};
}

inline double largest_coordinate(const Coordinates<double, 3>& a)
{
  return (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
}

inline double length(const Coordinates<double, 3>& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

// The same but for a rounding, in a fraction of the time where squares are in range; of vectors times a power of two it
// is the length times this power to the bit.
inline double quick_length(const Coordinates<double, 3>& a)
{
  const auto square_of = [](double x, double y, double z) { return x * x + y * y + z * z; };
  const double square = square_of(a[0], a[1], a[2]);
  if (square > 0x1p-900 && square < 0x1p900) return std::sqrt(square);
  const double largest = largest_coordinate(a);
  if (!(largest > 0) || !std::isfinite(largest)) return largest;
  const int e = std::ilogb(largest);
  return std::ldexp(
    std::sqrt(square_of(std::ldexp(a[0], -e), std::ldexp(a[1], -e), std::ldexp(a[2], -e))), e);
}

inline bool is_zero(const Coordinates<double, 3>& a)
{
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

inline Coordinates<double, 3> quotient(const Coordinates<double, 3>& a, double divisor)
{
  return {a[0] / divisor, a[1] / divisor, a[2] / divisor};
}

inline Coordinates<double, 3> multiple(double factor, const Coordinates<double, 3>& a)
{
  return {factor * a[0], factor * a[1], factor * a[2]};
}

// Tangents of creases are no shorter than 1e-6, or zero: shorter ones in a map are values that nobody has set.
template <class FT, std::size_t dimension>
bool is_shorter_than_tangents(const std::array<FT, dimension>& t)
{
  const FT length = FT(1) / FT(1000000);
  return CGAL::certainly(dot(t, t) < length * length);
}
template <class FT, std::size_t dimension>
void drop_short_tangent(std::array<FT, dimension>& t)
{
  if (is_shorter_than_tangents(t)) t.fill(FT(0));
}

template <class FT>
using Pair = std::array<FT, 2>;

// divides a vector by its length; zero stays zero
template <class FT>
void normalize(Coordinates<FT, 3>& v)
{
  const FT length = square_root_of<FT>(dot(v, v));
  if (length > FT(0))
    for (FT& x : v) x /= length;
}

// A point with a unit normal and two unit vectors perpendicular to it, right-handed. In the frame a
// point is (u, z), and a normal (-g, 1) but for its length.
template <class FT>
class Local_frame
{
public:
  using Vector = Coordinates<FT, 3>;

  Local_frame(const Vector& origin, const Vector& normal)
    : origin_(origin)
    , normal_(normal)
  {
    const auto smaller = [](const FT& a, const FT& b) {
      return absolute_value(a) < absolute_value(b);
    };
    const auto smallest = std::min_element(normal.begin(), normal.end(), smaller);
    Vector axis{};
    axis[static_cast<std::size_t>(smallest - normal.begin())] = FT(1);
    e1_ = cross(axis, normal);
    normalize(e1_);
    e2_ = cross(normal, e1_);
  }

  const Vector& origin() const { return origin_; }
  const Vector& normal() const { return normal_; }
  const Vector& e1() const { return e1_; }
  const Vector& e2() const { return e2_; }

  Pair<FT> u(const Vector& p) const
  {
    const Vector d = difference(p, origin_);
    return {dot(d, e1_), dot(d, e2_)};
  }
  FT z(const Vector& p) const { return dot(difference(p, origin_), normal_); }

  // The slope of the plane perpendicular to n, bounded for normals that are not on the side of the
  // frame's; zero for no normal.
  Pair<FT> slope(const Vector& n) const
  {
    const FT c = -1 / (std::max)(dot(n, normal_), FT(1) / FT(1024));
    return {c * dot(n, e1_), c * dot(n, e2_)};
  }

private:
  Vector origin_, normal_, e1_, e2_;
};

// the x with m x = b; NaN if m is singular but for rounding
template <class FT>
Pair<FT> solve(const std::array<Pair<FT>, 2>& m, const Pair<FT>& b)
{
  const FT det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const FT size = m[0][0] * m[0][0] + m[0][1] * m[0][1] + m[1][0] * m[1][0] + m[1][1] * m[1][1];
  if (!(absolute_value(det) > 64 * machine_epsilon<FT>() * size)) {
    const FT nan(std::numeric_limits<double>::quiet_NaN());
    return {nan, nan};
  }
  return {(b[0] * m[1][1] - b[1] * m[0][1]) / det, (m[0][0] * b[1] - m[1][0] * b[0]) / det};
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_VECTORS_H
