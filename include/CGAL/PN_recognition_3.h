// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_RECOGNITION_3_H
#define CGAL_PN_RECOGNITION_3_H

/*!
\file PN_recognition_3.h
Surfaces of mechanical parts that a mesh approximates, and arcs of curves. Not included is `triangulate_planes.h`, which is under
the GPL.
*/

#include <CGAL/PN_recognition_3/recognize_arcs.h>
#include <CGAL/PN_recognition_3/recognize_surfaces.h>

#endif // CGAL_PN_RECOGNITION_3_H
