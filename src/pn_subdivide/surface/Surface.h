// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SURFACE_H
#define PN_SUBDIVIDE_SURFACE_H

#include "io/Mesh_data.h"

#include <CGAL/Surface_mesh.h>

namespace pn_subdivide {

using Surface = CGAL::Surface_mesh<Point_3>;

// Vertices and faces keep the order of the soup, vertices without faces are there too. Throws Error
// if CGAL refuses a face. Normals are not passed on.
Surface make_surface(const Mesh_data& mesh);

// Points and faces in the order of the mesh, which must not hold garbage.
Mesh_data to_mesh_data(const Surface& surface);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_H
