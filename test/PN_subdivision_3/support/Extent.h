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

#include <type_traits>

#ifdef PN_TEST_FULL
constexpr bool tests_are_full = true;
#else
constexpr bool tests_are_full = false;
#endif

// The types of a suite: all, or those whose instances everybody compiles who runs the tests.
template <class All, class Some>
using In_full = std::conditional_t<tests_are_full, All, Some>;

#endif // CGAL_PN_SUBDIVISION_3_TEST_EXTENT_H
