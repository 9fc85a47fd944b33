// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_NEAR_POINTS_H
#define PN_SUBDIVIDE_NEAR_POINTS_H

#include "io/Mesh_data.h"

#include <vector>

namespace pn_subdivide {

// For each vertex the first of those that it is joined with: vertices without faces or at edges that do not
// have two faces, within the distance of each other or of some between them, the nearest first, but never
// two vertices of one face. Throws Error if the distance is so large that most points would be joined.
std::vector<Mesh_data::Index> first_near(const Mesh_data& mesh, double distance);

// Four units in the last place of the largest coordinate as a `float`, as cracks in STL files have.
double rounding_of_floats(const std::vector<Triple>& points);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_NEAR_POINTS_H
