// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Written_digits.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace pn_subdivide {
namespace {

bool is_digit(char c)
{
  return c >= '0' && c <= '9';
}

double largest(const std::array<double, 3>& v)
{
  return (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

} // namespace

void Written_digits::see(const std::array<std::string_view, 3>& words,
                         const std::array<double, 3>& vector)
{
  const double x = largest(vector);
  if (!(x > 0) || !std::isfinite(x)) return;
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(vector[k]) == x) see(words[k]);
}

// "-12.50e-3" has 4 significant digits and 5 decimals.
void Written_digits::see(std::string_view word)
{
  int decimals = 0, significant = 0;
  bool is_behind_point = false;
  std::size_t i = 0;
  for (; i < word.size() && word[i] != 'e' && word[i] != 'E'; ++i) {
    if (word[i] == '.') is_behind_point = true;
    if (!is_digit(word[i])) continue;
    decimals += is_behind_point;
    significant += significant > 0 || word[i] != '0';
  }
  if (i < word.size()) {
    constexpr long most = 999; // beyond those of numbers
    const long exponent = std::strtol(std::string(word.substr(i + 1)).c_str(), nullptr, 10);
    decimals -= int((std::clamp)(exponent, -most, most));
  }
  decimals_ = (std::max)(decimals_, decimals);
  significant_ = (std::max)(significant_, significant);
}

double Written_digits::unit(const std::array<double, 3>& vector) const
{
  const double x = largest(vector);
  if (significant_ == none || !(x > 0)) return 0;
  return (std::max)(std::pow(10., -decimals_),
                    std::pow(10., std::floor(std::log10(x)) + 1 - significant_));
}

} // namespace pn_subdivide
