// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CGAL_MASKS_3_H
#define CGAL_PN_CGAL_MASKS_3_H

/*!
\file PN_cgal_masks_3.h
Point-normal masks for \cgal's package 3D Surface Subdivision Methods.
*/

#include <CGAL/PN_cgal_masks_3/PN_mask_3.h>
#include <CGAL/PN_cgal_masks_3/Subdivision_method_3.h>

#endif // CGAL_PN_CGAL_MASKS_3_H
