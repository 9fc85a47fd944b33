// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A program is linked to what its project asked for, and to nothing else that is on the machine.

#include <CGAL/PN_subdivision_3/version.h>

#ifdef EXPECTS_Eigen
#  include <Eigen/Core>
#endif
#ifdef EXPECTS_TBB
#  include <tbb/global_control.h>
#endif

#if defined(CGAL_LINKED_WITH_TBB) != defined(EXPECTS_TBB)
#  error "TBB is linked if and only if it was asked for"
#endif
#if defined(CGAL_EIGEN3_ENABLED) != defined(EXPECTS_Eigen)
#  error "Eigen is linked if and only if it was asked for"
#endif

int main()
{
#ifdef EXPECTS_TBB
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 0;
#else
  return 0;
#endif
}
