// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Every scheme and function with exact kernels, multiprecision and intervals.

#include "Kernel_cases.h"
#include "analysis/curve_analysis.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpfr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#ifdef CGAL_USE_CORE
#  include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#endif

namespace {

using namespace kernel_cases;

// No square root: unit length to the documented 2^-48, squared 2^-47.
TEST(Exact_kernel, Epeck)
{
  expect_everything<CGAL::Exact_predicates_exact_constructions_kernel>(1e-13, std::ldexp(1., -47));
}

TEST(Exact_kernel, Gmpq)
{
  expect_subdivision<CGAL::Simple_cartesian<CGAL::Gmpq>>(2e-14, std::ldexp(1., -47));
}

// Lengths of any size have an inverse, to the same precision.
TEST(Exact_kernel, InverseLengthsBeyondTheRangeOfDouble)
{
  using FT = CGAL::Exact_predicates_exact_constructions_kernel::FT;
  FT huge(3);
  for (int i = 0; i < 3; ++i) huge *= FT(std::ldexp(1., 700));
  for (const FT& x : {huge, FT(FT(1) / huge)}) {
    const FT inverse = PN::Unit_normal_traits<FT>::inverse_length(x);
    EXPECT_LE(CGAL::abs(inverse * inverse * x - FT(1)), FT(std::ldexp(1., -46)));
  }
}

// The interval of a lazy number may be wide where its exact value is not known yet.
TEST(Exact_kernel, LazyNumbersAreMeasuredAsPreciselyAsOthers)
{
  using K = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto blurred = [](double x) { return K::FT(x) + K::FT(1e9) - K::FT(1e9); };
  std::vector<K::Point_2> lazy;
  std::vector<curve_cases::Double::Point_2> plain;
  for (int i = 0; i < 60; ++i) {
    const double x = std::cos(i / 10.), y = std::sin(i / 10.);
    lazy.emplace_back(blurred(x), blurred(y));
    plain.emplace_back(x, y);
  }
  const auto bends = PN::discrete_curvature(lazy, PN::Curve_end::none);
  const auto expected = PN::discrete_curvature(plain, PN::Curve_end::none);
  for (std::size_t i = 0; i < bends.size(); ++i) EXPECT_EQ(bends[i], expected[i]) << i;
}

#ifdef CGAL_USE_CORE
TEST(Exact_kernel, EpeckWithSqrt)
{
  expect_everything<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt>(1e-13, 0);
}
#endif

#ifdef CGAL_USE_MPFR
// The precision is that of the type when the call is made.
TEST(Multiprecision_kernel, Gmpfr)
{
  for (int bits : {100, 300}) {
    const auto old = CGAL::Gmpfr::set_default_precision(bits);
    expect_everything<CGAL::Simple_cartesian<CGAL::Gmpfr>>(1e-13, std::ldexp(1., 3 - bits));
    CGAL::Gmpfr::set_default_precision(old);
  }
}
#endif

#ifdef CGAL_USE_MPFR
TEST(Multiprecision_kernel, TolerancesBelowTheRangeOfDouble)
{
  const auto old = CGAL::Gmpfr::set_default_precision(3000);
  CGAL::Gmpfr tolerance = PN::Unit_normal_traits<CGAL::Gmpfr>::unit_tolerance();
  for (int i = 0; i < 2997; ++i) tolerance = tolerance + tolerance;
  EXPECT_EQ(tolerance, CGAL::Gmpfr(1));
  CGAL::Gmpfr::set_default_precision(old);
}
#endif

// The middles of the intervals; what they contain is the subject of test_certificates_intervals.cpp.
TEST(Interval_kernel, ProtectedIntervals)
{
  expect_everything<CGAL::Simple_cartesian<CGAL::Interval_nt<true>>>(1e-13, 1e-14);
}

} // namespace
