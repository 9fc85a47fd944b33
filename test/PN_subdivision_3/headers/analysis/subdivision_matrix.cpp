// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "analysis/subdivision_matrix.h"
#include "../mesh.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_matrix(const Mesh& mesh)
{
  (void)subdivision_matrix(mesh, Loop_scheme());
}

} // namespace header_in_use
