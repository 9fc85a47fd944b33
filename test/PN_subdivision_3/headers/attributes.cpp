// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/attributes.h>

#include "headers/mesh.h"

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_attributes(Mesh& mesh)
{
  const auto colors = mesh.add_property_map<Mesh::Vertex_index, double>("v:color").first;
  (void)parameters::attributes(parameters::vertex_attribute(colors));
}

} // namespace header_in_use
