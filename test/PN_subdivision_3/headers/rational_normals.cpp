// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/rational_normals.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;

Exact::Vector_3 short_normal(const Exact::Vector_3& v)
{
  const Rounded_exact_normals rounded(30);
  return rational_unit_normal(v, 30);
}

} // namespace header_in_use
