// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Random parts: nearly all must be entirely right.

#include "Part_marks.h"
#include "Random_parts.h"

#include <gtest/gtest.h>

using namespace synthetic_parts;

TEST(Recognized_random, parts)
{
  int wrong = 0;
  const std::uint32_t first = 1000, number = 200;
  for (std::uint32_t seed = first; seed < first + number; ++seed) {
    const Random_part random(seed);
    const Part_marks marks(random.part(), recognition_of(random.part()));
    if (marks.is_right()) continue;
    ++wrong;
    std::cout << random.part().name << ": " << marks.text() << '\n';
    EXPECT_FALSE(random.is_small_prism()) << random.part().name << " is a prism or a pyramid";
  }
  EXPECT_LE(wrong, static_cast<int>(number) / 20);
}
