// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_H
#define CGAL_PN_SUBDIVISION_3_H

/*!
\file PN_subdivision_3.h
Schemes and the functions that subdivide meshes and curves. Not included are what needs other packages or
libraries (`PN_mask_3.h`, `analysis/subdivision_matrix.h`, `estimate_curvature.h`), what measures results
(`reproduction.h`, `analysis/extraordinary_curvature.h`, `analysis/extraordinary_eigenvalues.h`), the limit surface
(`limit_points.h`, `subdivide_to_limit.h`, `tessellate.h`, `curve_limit_points.h`,
`interpolate_limit_points.h`, `interpolate_curve.h`, `prescribe_limit_data.h`), and surfaces that follow their control data (`Surface_refiner.h`).
*/

#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/Grid_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/PN_subdivision_3/subdivision_methods_3.h>
#include <CGAL/PN_subdivision_3/version.h>
#include <CGAL/PN_subdivision_curve.h>

#endif // CGAL_PN_SUBDIVISION_3_H
