// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/estimate_corner_normals.h>

#include "mesh.h"

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_estimate_corners(Mesh& mesh)
{
  const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp").first;
  estimate_corner_normals(
    mesh, sharp, mesh.add_property_map<Mesh::Halfedge_index, Kernel::Vector_3>("h:normal").first);
}

} // namespace header_in_use
