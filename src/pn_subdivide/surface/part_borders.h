// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PART_BORDERS_H
#define PN_SUBDIVIDE_PART_BORDERS_H

#include "io/Mesh_data.h"
#include "surface/Recognized_part.h"
#include "surface/creases.h"

namespace pn_subdivide {

// Borders of a part that is open become curves: lines and arcs where they are those of planes, with corners between them, and
// elsewhere with corners where they turn by more than arcs do.
void put_part_borders(Creases& creases, const Mesh_data& mesh, const Recognized_part& part);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PART_BORDERS_H
