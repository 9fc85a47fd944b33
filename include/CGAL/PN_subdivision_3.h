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
Schemes and the functions that subdivide meshes. Other packages have curves (`PN_subdivision_curve.h`), the limit surface and
`Surface_refiner` (`PN_subdivision_limit_3.h`), fitting (`PN_fitting_3.h`), recognition (`PN_recognition_3.h`), certificates
(`PN_certificates_3.h`) and \cgal's own masks (`PN_cgal_masks_3.h`). Not included are files (`control_mesh_io.h`), pieces (`refine_in_pieces.h`),
`estimate_curvature.h` and schemes chosen at run time (`schemes/Any_scheme.h`).
*/

#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Grid_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/PN_subdivision_3/subdivision_methods_3.h>
#include <CGAL/PN_subdivision_3/version.h>

#endif // CGAL_PN_SUBDIVISION_3_H
