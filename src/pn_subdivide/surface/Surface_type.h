// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SURFACE_TYPE_H
#define PN_SUBDIVIDE_SURFACE_TYPE_H

// The mesh of the command. The page has another one, found in its place: a mesh that is not under the GPL.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace pn_subdivide {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Surface = CGAL::Surface_mesh<Point_3>;

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_TYPE_H
