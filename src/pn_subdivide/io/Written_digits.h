// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_WRITTEN_DIGITS_H
#define PN_SUBDIVIDE_WRITTEN_DIGITS_H

#include <array>
#include <string_view>

namespace pn_subdivide {

// With how many digits a text has vectors. Trailing zeros may be left out and vectors may have any length, so the
// largest coordinates count, and among these the one with the most digits.
class Written_digits
{
public:
  void see(const std::array<std::string_view, 3>& words, const std::array<double, 3>& vector);
  // for whole numbers that are no text
  void see_whole_number() { see("1"); }

  // What the last digit of a vector counts; 0 where nothing has been seen, as in binary files.
  double unit(const std::array<double, 3>& vector) const;

private:
  void see(std::string_view word);

  int decimals_ = none, significant_ = none;
  static constexpr int none = -1000;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_WRITTEN_DIGITS_H
