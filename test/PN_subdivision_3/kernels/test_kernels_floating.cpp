// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Every scheme and function with the kernels of hardware floating point, and with a number type of
// the user's own that models a field with square root.

#include "Kernel_cases.h"
#include "Tracked_double.h"

namespace {

using namespace kernel_cases;

template <class FT>
constexpr double epsilon = double(std::numeric_limits<FT>::epsilon());

TEST(Floating_kernel, Float)
{
  expect_everything<CGAL::Simple_cartesian<float>>(2e-5, 4 * epsilon<float>);
}

TEST(Floating_kernel, LongDouble)
{
  expect_everything<CGAL::Simple_cartesian<long double>>(1e-13, 4 * epsilon<long double>);
}

TEST(Floating_kernel, OwnFieldWithSquareRoot)
{
  const std::size_t before = Tracked_double::square_roots();
  expect_everything<CGAL::Simple_cartesian<Tracked_double>>(1e-13, 4 * epsilon<double>);
  EXPECT_GT(Tracked_double::square_roots(), before + 100);
}

} // namespace
