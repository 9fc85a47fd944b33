// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_HEADERS_POLYGON_H
#define PN_SUBDIVISION_3_TEST_HEADERS_POLYGON_H

#include <CGAL/Simple_cartesian.h>

#include <utility>
#include <vector>

// What the headers are used with; included behind them.
using Kernel = CGAL::Simple_cartesian<double>;
using Polygon = std::vector<std::pair<Kernel::Point_2, Kernel::Vector_2>>;

#endif // PN_SUBDIVISION_3_TEST_HEADERS_POLYGON_H
