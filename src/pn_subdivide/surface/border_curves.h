// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_BORDER_CURVES_H
#define PN_SUBDIVIDE_BORDER_CURVES_H

#include "io/Mesh_data.h"
#include "surface/Recognized_part.h"
#include "surface/creases.h"

namespace pn_subdivide {

// Copies that were made of edges of more than two faces become creases with the same tangents, and with corners where one of
// them has a corner: the sheets keep one curve, which they would leave each by its own normals.
void put_common_curves(Creases& creases, const Mesh_data& mesh);

// The other half of that, when the roundness is known: the least of the copies is that of all.
void share_roundness(Mesh_data& mesh);

// Borders of a part that is open become curves: lines and arcs where they are those of planes, with corners between them, and
// elsewhere with corners where they turn by more than arcs do.
void put_part_borders(Creases& creases, const Mesh_data& mesh, const Recognized_part& part);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_BORDER_CURVES_H
