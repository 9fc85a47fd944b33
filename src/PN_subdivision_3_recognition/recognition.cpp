// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Recognition, compiled once.

#include <CGAL/PN_recognition_3/internal/Evidence.cpp>
#include <CGAL/PN_recognition_3/internal/Found_regions.cpp>
#include <CGAL/PN_recognition_3/internal/Part.cpp>
#include <CGAL/PN_recognition_3/internal/Patches.cpp>
#include <CGAL/PN_recognition_3/internal/Plane_of_polygon.cpp>
#include <CGAL/PN_recognition_3/internal/Prism_filter.cpp>
#include <CGAL/PN_recognition_3/internal/Region.cpp>
#include <CGAL/PN_recognition_3/internal/Region_borders.cpp>
#include <CGAL/PN_recognition_3/internal/Segments.cpp>
#include <CGAL/PN_recognition_3/internal/Shape.cpp>
#include <CGAL/PN_recognition_3/internal/arcs.cpp>
#include <CGAL/PN_recognition_3/internal/guess_shapes.cpp>
#include <CGAL/PN_recognition_3/internal/surfaces.cpp>
