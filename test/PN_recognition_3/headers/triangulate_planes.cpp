// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/triangulate_planes.h>

#include "mesh.h"

#include <vector>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

std::size_t use_triangulate_planes(Mesh& mesh)
{
  const auto patches = mesh.add_property_map<Mesh::Face_index, int>("f:surface").first;
  const std::vector<Recognized_surface> surfaces(1);
  return triangulate_planes(mesh, patches, surfaces).size();
}

} // namespace header_in_use
