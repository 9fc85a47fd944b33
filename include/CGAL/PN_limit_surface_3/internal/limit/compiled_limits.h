// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_COMPILED_LIMITS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_COMPILED_LIMITS_H

// The limits of levels of double, which the library CGAL::PN_subdivision_3_limits has, see
// PN_subdivision_3/internal/meshes/compiled_levels.h.

#include <CGAL/PN_limit_surface_3/internal/limit/Creased_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>

#define CGAL_PN_SUBDIVISION_3_LIMITS_OF(EXTERN, SCHEME)                                            \
  EXTERN template class Limit_evaluation<compiled_once::SCHEME, double>;
#define CGAL_PN_SUBDIVISION_3_CREASED_LIMITS_OF(EXTERN, SCHEME)                                    \
  CGAL_PN_SUBDIVISION_3_LIMITS_OF(EXTERN, SCHEME)                                                  \
  EXTERN template class Creased_limits<compiled_once::SCHEME, double>;

#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
namespace CGAL::PN_subdivision_3::internal {

CGAL_PN_SUBDIVISION_3_CREASED_LIMITS_OF(extern, Any_of_quads)
CGAL_PN_SUBDIVISION_3_CREASED_LIMITS_OF(extern, Any_of_triangles)
CGAL_PN_SUBDIVISION_3_LIMITS_OF(extern, Any_of_sqrt3)
CGAL_PN_SUBDIVISION_3_CREASED_LIMITS_OF(extern, Linear_of_quads)
CGAL_PN_SUBDIVISION_3_CREASED_LIMITS_OF(extern, Linear_of_triangles)
CGAL_PN_SUBDIVISION_3_LIMITS_OF(extern, Linear_of_sqrt3)

} // namespace CGAL::PN_subdivision_3::internal
#endif

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_COMPILED_LIMITS_H
