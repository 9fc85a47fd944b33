// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/rows/Stencil.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

bool use_limit_neighborhood()
{
  constexpr Limit_neighborhood neighborhood{0, true, true, false};
  return neighborhood.is_spline;
}

} // namespace header_in_use
