// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>

#include "headers/row.h"

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_doosabin()
{
  const Level_connectivity level = connect();
  const auto mask = DooSabin_scheme().mask<double>(level, 1);
  Row row;
  mask.corner(0, row);
}

} // namespace header_in_use
