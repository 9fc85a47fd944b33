// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// CGAL's header, which has no include guard, for sources that are compiled as one.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_EXACT_RATIONAL_H
#define CGAL_PN_SUBDIVISION_3_TEST_EXACT_RATIONAL_H

#include <CGAL/Exact_rational.h>

#endif // CGAL_PN_SUBDIVISION_3_TEST_EXACT_RATIONAL_H
