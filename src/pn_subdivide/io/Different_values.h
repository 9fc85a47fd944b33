// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_DIFFERENT_VALUES_H
#define PN_SUBDIVIDE_DIFFERENT_VALUES_H

#include "io/Mesh_data.h"

#include <cstddef>
#include <vector>

namespace pn_subdivide {

// Normals or texture points of a mesh's corners, where equal ones at the same vertex count once.
struct Different_values
{
  Different_values(const Mesh_data& mesh, const std::vector<Triple>& of_corners);

  std::vector<Triple> values;           // in the order of the first corners that have them
  std::vector<Mesh_data::Index> vertex; // of each
  std::vector<std::size_t> of_corner;   // which of them each corner has
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_DIFFERENT_VALUES_H
