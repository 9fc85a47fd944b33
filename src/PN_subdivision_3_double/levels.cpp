// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/internal/attributes/Refined_attributes.h>
#include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>

namespace CGAL::PN_subdivision_3::internal {

CGAL_PN_SUBDIVISION_3_LEVELS()
CGAL_PN_SUBDIVISION_3_ATTRIBUTES_OF_ALL()

} // namespace CGAL::PN_subdivision_3::internal
