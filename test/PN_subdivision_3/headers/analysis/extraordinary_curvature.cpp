// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "analysis/extraordinary_curvature.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_extraordinary_curvature()
{
  (void)Extraordinary_vertex_zoom<CatmullClark_scheme>(CatmullClark_scheme(), 5);
}

} // namespace header_in_use
