// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_H
#define CGAL_PN_FITTING_3_H

/*!
\file PN_fitting_3.h
Surfaces and curves through points, limits with prescribed normals and curvatures, and smoothed control normals. Needs
\ref thirdpartyEigen "Eigen".
*/

#include <CGAL/PN_fitting_3/interpolate_curve.h>
#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_fitting_3/prescribe_limit_data.h>
#include <CGAL/PN_fitting_3/smooth_control_normals.h>

#endif // CGAL_PN_FITTING_3_H
