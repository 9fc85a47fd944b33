// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How much is tested: what PN_TEST_FULL of CMake says.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_EXTENT_H
#define CGAL_PN_SUBDIVISION_3_TEST_EXTENT_H

#include <gtest/gtest.h>

#include <type_traits>

#ifdef PN_TEST_FULL
constexpr bool tests_are_full = true;
#else
constexpr bool tests_are_full = false;
#endif

// The types of a suite: all, or those whose instances everybody compiles who runs the tests.
template <class All, class Some>
using In_full = std::conditional_t<tests_are_full, All, Some>;

// The body of a single test of long_tests.txt, a generic lambda: what it names is not compiled where it is not run.
template <class Body>
void long_test(const Body& body)
{
#if defined(PN_TEST_FULL) || defined(PN_TEST_LONG_CASES)
  body(0);
#else
  static_cast<void>(body);
  GTEST_SKIP() << "does not apply: a long test, which is compiled with PN_TEST_FULL";
#endif
}

#endif // CGAL_PN_SUBDIVISION_3_TEST_EXTENT_H
