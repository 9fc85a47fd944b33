// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_limit_surface_3/estimate_curvature.h>

#include "mesh.h"

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_curvature(Mesh& mesh)
{
  const auto map = mesh.add_property_map<Mesh::Vertex_index, Vertex_curvature<Kernel>>("v:k").first;
  estimate_curvature(mesh, map);
}

} // namespace header_in_use
