// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_HEADERS_ROW_H
#define PN_SUBDIVISION_3_TEST_HEADERS_ROW_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

CGAL::PN_subdivision_3::Level_connectivity connect();

struct Row
{
  using Index = CGAL::PN_subdivision_3::Level_connectivity::Index;
  void add(Index, double) {}
  void add_rest(Index) {}
};

#endif // PN_SUBDIVISION_3_TEST_HEADERS_ROW_H
