// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_CURVE_H
#define CGAL_PN_SUBDIVISION_CURVE_H

/*!
\file PN_subdivision_curve.h
Point-normal subdivision of curves in the plane and in space. Not included are their limits (`curve_limit_points.h`); interpolation
is in `PN_fitting_3.h`, arcs are in `PN_recognition_3.h`.
*/

#include <CGAL/PN_curves/curve_control_normals.h>
#include <CGAL/PN_curves/curve_corners.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_curves/subdivide_curve.h>

#endif // CGAL_PN_SUBDIVISION_CURVE_H
