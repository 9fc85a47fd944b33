// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_AS_FRACTION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_AS_FRACTION_H

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The fraction of small terms that a weight is but for rounding, by its continued fraction.
inline std::optional<std::pair<int, int>> as_fraction(long double x)
{
  const bool negative = x < 0;
  long double rest = std::abs(x);
  std::int64_t p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  for (int k = 0; k < 12; ++k) {
    const long double whole = std::floor(rest);
    if (whole > 1e6L) break;
    const auto a = static_cast<std::int64_t>(whole);
    const std::int64_t p = a * p1 + p0, q = a * q1 + q0;
    if (q > 100000) break;
    p0 = p1;
    q0 = q1;
    p1 = p;
    q1 = q;
    const long double value = static_cast<long double>(p) / static_cast<long double>(q);
    if (std::abs(value - std::abs(x)) <= 1e-15L)
      return std::make_pair(static_cast<int>(negative ? -p : p), static_cast<int>(q));
    if (rest - whole <= 0) break;
    rest = 1 / (rest - whole);
  }
  return std::nullopt;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_AS_FRACTION_H
