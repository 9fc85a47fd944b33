// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_COMPILED_LIMITS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_COMPILED_LIMITS_H

// The limits of a level are the same for all meshes, maps and kernels of a number type. For double and the usual schemes the library
// CGAL::PN_subdivision_3_limits has them (src/PN_subdivision_3_limits), and what is linked to it does not compile them again.
// Where it is linked to TBB it does: classes differ.

#include <CGAL/PN_limit_surface_3/internal/limit/Creased_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Scheme_on_host.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#if defined(CGAL_PN_SUBDIVISION_3_LIMITS) && !defined(CGAL_LINKED_WITH_TBB)
namespace CGAL::PN_subdivision_3::internal {

extern template class Limit_evaluation<With_roundness<CatmullClark_scheme, double>, double>;
extern template class Creased_limits<With_roundness<CatmullClark_scheme, double>, double>;
extern template class Limit_evaluation<With_roundness<Loop_scheme, double>, double>;
extern template class Creased_limits<With_roundness<Loop_scheme, double>, double>;
extern template class Limit_evaluation<With_roundness<Scheme_on_host<PQQ_host, double>, double>,
                                       double>;
extern template class Creased_limits<With_roundness<Scheme_on_host<PQQ_host, double>, double>,
                                     double>;
extern template class Limit_evaluation<With_roundness<Scheme_on_host<PTQ_host, double>, double>,
                                       double>;
extern template class Creased_limits<With_roundness<Scheme_on_host<PTQ_host, double>, double>,
                                     double>;

} // namespace CGAL::PN_subdivision_3::internal
#endif

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_COMPILED_LIMITS_H
