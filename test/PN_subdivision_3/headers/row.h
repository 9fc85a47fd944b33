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

template <class Scheme>
void use_triangle_rules(const Scheme& scheme)
{
  const CGAL::PN_subdivision_3::Level_connectivity level = connect();
  const auto mask = scheme.template mask<double>(level, 1);
  Row row;
  mask.vertex(0, row);
  mask.edge(0, row);
}

template <class Scheme>
void use_quad_rules(const Scheme& scheme)
{
  use_triangle_rules(scheme);
  const CGAL::PN_subdivision_3::Level_connectivity level = connect();
  Row row;
  scheme.template mask<double>(level, 1).face(0, row);
}

#endif // PN_SUBDIVISION_3_TEST_HEADERS_ROW_H
