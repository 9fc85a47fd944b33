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
Surfaces of mechanical parts that a mesh approximates, triangulation of their planes, and arcs of curves.
*/

#include <CGAL/PN_recognition_3/recognize_arcs.h>
#include <CGAL/PN_recognition_3/recognize_surfaces.h>
#include <CGAL/PN_recognition_3/triangulate_planes.h>

#endif // CGAL_PN_RECOGNITION_3_H
