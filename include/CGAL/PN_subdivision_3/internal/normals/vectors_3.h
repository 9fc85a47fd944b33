// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_VECTORS_3_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_VECTORS_3_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/average/Unit_normal_traits.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// the number type in which normals are estimated: float is widened
template <class FT>
using Wide_number = std::conditional_t<std::is_same_v<FT, float>, double, FT>;

// a sum of vectors that are as exact as double or FT, whichever is less, vanishes if it is shorter
// than this times the sum of their lengths
template <class FT>
double vanishing_tolerance()
{
  return 4096 * (std::max)(static_cast<double>(CGAL::to_double(machine_epsilon<FT>())),
                           std::numeric_limits<double>::epsilon());
}

template <class T>
Coordinates<T, 3> cross(const Coordinates<T, 3>& a, const Coordinates<T, 3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T>
Coordinates<double, 3> to_double_3(const Coordinates<T, 3>& a)
{
  return {close_double(a[0]), close_double(a[1]), close_double(a[2])};
}

inline double length(const Coordinates<double, 3>& a)
{
  return std::hypot(a[0], a[1], a[2]);
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

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_VECTORS_3_H
