// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_FILE_ROUNDING_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_FILE_ROUNDING_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

inline bool is_float(double x)
{
  return x == double(float(x));
}

inline bool has_decimal_form(double x, const char* format, int digits)
{
  char text[400];
  if (std::snprintf(text, sizeof text, format, digits, x) >= int(sizeof text)) return false;
  return std::strtod(text, nullptr) == x;
}

// How far the numbers of a file may be from what was meant: it holds floats, or decimals of few digits, or else `double`s
// with what computations have left in them.
inline double file_rounding(const std::vector<double>& x)
{
  double largest = 0;
  bool are_floats = true;
  for (const double c : x) {
    largest = (std::max)(largest, std::abs(c));
    are_floats = are_floats && is_float(c);
  }
  if (are_floats) return std::ldexp(largest, -24);
  const auto all_but_one_percent_have = [&](const char* format, int digits) {
    std::size_t others = 0;
    for (const double c : x)
      if (!has_decimal_form(c, format, digits) && 100 * ++others > x.size()) return false;
    return true;
  };
  for (int digits = 5; digits <= 9; ++digits)
    if (all_but_one_percent_have("%.*e", digits - 1))
      return 0.5 * std::pow(10., std::floor(std::log10(largest)) - digits + 1);
  for (int digits = 3; digits <= 7; ++digits)
    if (all_but_one_percent_have("%.*f", digits)) return 0.5 * std::pow(10., -digits);
  return std::ldexp(largest, -50);
}

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_FILE_ROUNDING_H
