// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_ERROR_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_ERROR_H

#include <algorithm>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Averages L_k of a limit mask come closer to the limit by steps |L_{k+1} - L_k|, which become a geometric
// series of some ratio. An estimate of |limit - L_{k+1}| / |L_{k+1} - L_k|: 3/2 of the sum of that series, and
// 1 at least, while it is not one yet; up to 0.8 was measured then.
inline double limit_error_factor(double ratio)
{
  return (std::max)(1., 1.5 * ratio / (1 - ratio));
}

// The error after a step. A step may be small by chance, two in a row hardly are.
inline double limit_error(double factor, double ratio, double step, double& last_step)
{
  const double error = factor * (std::max)(step, ratio * last_step);
  last_step = step;
  return error;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_ERROR_H
