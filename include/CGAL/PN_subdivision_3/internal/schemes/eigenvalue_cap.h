// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_EIGENVALUE_CAP_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_EIGENVALUE_CAP_H

#include <CGAL/Uncertain.h>

#include <stdexcept>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// x with its absolute value cut to the bound. Where intervals do not decide, both are nearly equal.
template <class Number>
Number capped(const Number& x, const Number& bound)
{
  if (CGAL::certainly(bound < x)) return bound;
  const Number opposite = -bound;
  return CGAL::certainly(x < opposite) ? opposite : x;
}

inline double checked_cap(double cap)
{
  if (!(cap > 0 && cap <= 1))
    throw std::invalid_argument(
      "PN_subdivision_3: the cap of a modified scheme must be greater than 0 and at most 1");
  return cap;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_EIGENVALUE_CAP_H
