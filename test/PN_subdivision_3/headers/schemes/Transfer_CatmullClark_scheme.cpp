// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/schemes/Transfer_schemes.h>

#include "headers/row.h"

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_ct_catmullclark()
{
  const Level_connectivity level = connect();
  const auto mask = CatmullClark_scheme::Transfer().mask<double>(level, 1);
  Row row;
  mask.vertex(0, row);
  mask.edge(0, row);
  mask.face(0, row);
}

} // namespace header_in_use
