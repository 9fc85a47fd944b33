// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>

#include "headers/mesh.h"

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_estimate(Mesh& mesh)
{
  estimate_control_normals(mesh, normals_of(mesh));
  const auto normals = estimate_control_normals(mesh);
  put(normals, *mesh.vertices().begin(), normals[*mesh.vertices().begin()]);
}

} // namespace header_in_use
