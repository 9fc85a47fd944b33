// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_EIGENVALUE_CAP_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_EIGENVALUE_CAP_H

#include <CGAL/PN_subdivision_3/internal/average/Interval_bounds.h>
#include <CGAL/PN_subdivision_3/internal/average/is_interval.h>
#include <CGAL/PN_subdivision_3/schemes/Scheme_parameter.h>
#include <CGAL/Uncertain.h>

#include <stdexcept>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// x with its absolute value cut to the bound. Where intervals do not decide, both are nearly equal.
template <class Number>
Number capped(const Number& x, const Number& bound)
{
  const Number opposite = -bound;
  if (CGAL::certainly(bound < x)) return bound;
  if (CGAL::certainly(x < opposite)) return opposite;
  if constexpr (is_interval_v<Number>) { // where it is not decided, what contains both
    if (CGAL::possibly(bound < x)) return interval_around_both(x, bound);
    if (CGAL::possibly(x < opposite)) return interval_around_both(x, opposite);
  }
  return x;
}

inline const Scheme_parameter& checked_cap(const Scheme_parameter& cap)
{
  if (!(cap.to_double() > 0 && cap.to_double() <= 1))
    throw std::invalid_argument(
      "PN_subdivision_3: the cap of a modified scheme must be greater than 0 and at most 1");
  return cap;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_EIGENVALUE_CAP_H
