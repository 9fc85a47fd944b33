// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/boost_multiprecision_floats.h>

#include <CGAL/Simple_cartesian.h>

namespace header_in_use {

bool is_positive(const boost::multiprecision::cpp_bin_float_50& x)
{
  return CGAL::is_finite(x) && CGAL::is_valid(x) && CGAL::is_positive(x);
}

} // namespace header_in_use
