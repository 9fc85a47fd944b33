// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_limit_surface_3/internal/limit/compiled_limits.h>

namespace CGAL::PN_subdivision_3::internal {

template class Limit_evaluation<With_roundness<Scheme_on_host<PTQ_host, double>, double>, double>;
template class Creased_limits<With_roundness<Scheme_on_host<PTQ_host, double>, double>, double>;

} // namespace CGAL::PN_subdivision_3::internal
