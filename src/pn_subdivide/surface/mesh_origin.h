// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SURFACE_MESH_ORIGIN_H
#define PN_SUBDIVIDE_SURFACE_MESH_ORIGIN_H

#include "io/Mesh_data.h"

#include <string>

namespace pn_subdivide {

// The origin of what becomes of the mesh by rounds of the scheme.
Mesh_origin origin_after(const Mesh_data& mesh, const std::string& scheme, unsigned rounds);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_MESH_ORIGIN_H
