// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_SURFACE_TYPE_H
#define PN_SUBDIVISION_3_DEMO_SURFACE_TYPE_H

// In the place of the command's Surface_mesh, which is under the GPL.

#include "graph_traits_Array_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>

namespace pn_subdivide {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Surface = pn_demo::Array_mesh<Point_3>;

} // namespace pn_subdivide

#endif // PN_SUBDIVISION_3_DEMO_SURFACE_TYPE_H
