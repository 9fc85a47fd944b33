// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NEEDS_EIGEN_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NEEDS_EIGEN_H

// Included first by public headers: the compiler stops here instead of five includes deep.
#if !__has_include(<Eigen/Core>)
#  error "PN_subdivision_3: this header needs Eigen (CGAL::PN_subdivision_3_Eigen, libeigen3-dev)"
#endif
#include <Eigen/Core>

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NEEDS_EIGEN_H
