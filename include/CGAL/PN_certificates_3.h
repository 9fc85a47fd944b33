// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_H
#define CGAL_PN_CERTIFICATES_3_H

/*!
\file PN_certificates_3.h
Whether refined points are on a sphere, a cylinder, a cone or a torus, exactly or how far off; enclosures of limit points;
comparison with the linear scheme.
*/

#include <CGAL/PN_certificates_3/compare_with_linear.h>
#include <CGAL/PN_certificates_3/enclose.h>
#include <CGAL/PN_certificates_3/reproduction.h>

#endif // CGAL_PN_CERTIFICATES_3_H
