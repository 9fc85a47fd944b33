// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_cgal_masks_3/Subdivision_method_3.h>

#include "mesh.h"

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_methods_of_cgal(Mesh& mesh)
{
  Subdivision_method_3::Sqrt3_subdivision(mesh);
}

} // namespace header_in_use
