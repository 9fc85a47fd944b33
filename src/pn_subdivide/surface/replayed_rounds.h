// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_REPLAYED_ROUNDS_H
#define PN_SUBDIVIDE_REPLAYED_ROUNDS_H

#include "io/Mesh_data.h"
#include "surface/Surface.h"

#include <optional>

namespace pn_subdivide {

// The faces of the mesh as its origin numbers their edges, without points; nothing if it has no origin, or another
// one than it says.
std::optional<Surface> replayed_rounds(const Mesh_data& mesh);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_REPLAYED_ROUNDS_H
