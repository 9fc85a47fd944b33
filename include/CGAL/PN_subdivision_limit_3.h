// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_LIMIT_3_H
#define CGAL_PN_SUBDIVISION_LIMIT_3_H

/*!
\file PN_subdivision_limit_3.h
Limit surfaces: their points and normals, points between these, tessellation, and surfaces that follow their control data. Not included is what
needs \ref thirdpartyEigen "Eigen": `interpolate_limit_points.h` and `prescribe_limit_data.h`.
*/

#include <CGAL/PN_limit_surface_3/Face_patch.h>
#include <CGAL/PN_limit_surface_3/Limit_surface.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>

#endif // CGAL_PN_SUBDIVISION_LIMIT_3_H
