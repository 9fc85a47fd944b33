// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_MERGE_POINTS_H
#define PN_SUBDIVIDE_MERGE_POINTS_H

#include "io/Mesh_data.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pn_subdivide {

struct Point_merge
{
  std::size_t merged_vertices = 0;               // that are gone: equal ones
  std::size_t joined_vertices = 0;               // others within the distance
  std::vector<std::string> differing_attributes; // of which only the value of the first is left
};

// Merges vertices with equal points into the first of them. Where their normals or texture coordinates
// differ, these become those of corners; of other attributes those of the first vertex are kept. Coordinates
// must be finite.
Point_merge merge_equal_points(Mesh_data& mesh);

// The same, and then for points within a distance as first_near() tells.
Point_merge merge_near_points(Mesh_data& mesh, double distance);

// For each vertex the first of those that it is joined with: vertices without faces or at edges that do not
// have two faces, within the distance of each other or of some between them, the nearest first, but never
// two vertices of one face. Throws Error if the distance is so large that most points would be joined.
std::vector<Mesh_data::Index> first_near(const Mesh_data& mesh, double distance);

// Four units in the last place of the largest coordinate as a `float`, as cracks in STL files have.
double rounding_of_floats(const std::vector<Triple>& points);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_MERGE_POINTS_H
