// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_certificates_3/compare_with_linear.h>

#include "mesh.h"
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

bool use_comparison(const Mesh& mesh)
{
  return compare_with_linear(mesh, Loop_scheme()).is_swollen() ||
         compare_with_linear(mesh, mesh, mesh).is_folded();
}

} // namespace header_in_use
