// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/parameters/Control_element.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

bool use_control_element(const Control_element& a, const Control_element& b)
{
  return a == b || a < b;
}

} // namespace header_in_use
