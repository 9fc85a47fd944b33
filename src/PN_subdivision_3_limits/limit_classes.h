// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The classes that several sources of this library use, so that one compiles them.

#ifndef CGAL_PN_SUBDIVISION_3_LIMITS_LIMIT_CLASSES_H
#define CGAL_PN_SUBDIVISION_3_LIMITS_LIMIT_CLASSES_H

#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>

#define CGAL_PN_SUBDIVISION_3_LIMIT_CLASSES(EXTERN, SCHEME)                                        \
  EXTERN template class Limit_evaluation<compiled_once::SCHEME, double>;                           \
  EXTERN template class Creased_limits<compiled_once::SCHEME, double>;

#endif // CGAL_PN_SUBDIVISION_3_LIMITS_LIMIT_CLASSES_H
