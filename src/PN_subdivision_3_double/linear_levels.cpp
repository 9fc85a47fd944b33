// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/internal/attributes/compiled_attributes.h>
#include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>

namespace CGAL::PN_subdivision_3::internal {

CGAL_PN_SUBDIVISION_3_CREASED_ROUNDS(, Linear_of_quads)
CGAL_PN_SUBDIVISION_3_CREASED_ROUNDS(, Linear_of_triangles)
CGAL_PN_SUBDIVISION_3_ROUNDS(, Linear_of_corners)
CGAL_PN_SUBDIVISION_3_ROUNDS(, Linear_of_sqrt3)
CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(, PQQ_host, Linear_of_quads)
CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(, PTQ_host, Linear_of_triangles)
CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(, DQQ_host, Linear_of_corners)
CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(, Sqrt3_host, Linear_of_sqrt3)

} // namespace CGAL::PN_subdivision_3::internal
