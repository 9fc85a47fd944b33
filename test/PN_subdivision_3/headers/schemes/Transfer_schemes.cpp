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

void use_transfer()
{
  const Level_connectivity level = connect();
  const auto quads = CatmullClark_scheme::Transfer().mask<double>(level, 1);
  const auto triangles = Loop_scheme::Transfer().mask<double>(level, 1);
  Row row;
  quads.vertex(0, row);
  quads.edge(0, row);
  quads.face(0, row);
  triangles.vertex(0, row);
  triangles.edge(0, row);
}

} // namespace header_in_use
