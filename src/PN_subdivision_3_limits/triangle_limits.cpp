// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "limit_classes.h"

#include <CGAL/PN_limit_surface_3/internal/tessellation/run_tessellation.h>

namespace CGAL::PN_subdivision_3::internal {

CGAL_PN_SUBDIVISION_3_LIMIT_CLASSES(, Any_of_triangles)
CGAL_PN_SUBDIVISION_3_LIMIT_CLASSES(, Linear_of_triangles)
CGAL_PN_SUBDIVISION_3_OF_TRIANGLES(CGAL_PN_SUBDIVISION_3_LIMITS_OF, )
CGAL_PN_SUBDIVISION_3_OF_TRIANGLES(CGAL_PN_SUBDIVISION_3_TESSELLATION_OF, )
CGAL_PN_SUBDIVISION_3_LIMITS_OF(, Any_of_sqrt3, No_creases)
CGAL_PN_SUBDIVISION_3_LIMITS_OF(, Linear_of_sqrt3, No_creases)

} // namespace CGAL::PN_subdivision_3::internal
