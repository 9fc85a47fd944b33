// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>

#include "mesh.h"
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_subdivide_to_limit(Mesh& mesh)
{
  subdivide_to_limit(mesh, linear(Loop_scheme()), parameters::tolerance(1e-3));
  subdivide_to_limit(mesh, linear(Loop_scheme()));
}

} // namespace header_in_use
