// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_BOUNDING_BOX_H
#define PN_SUBDIVIDE_BOUNDING_BOX_H

#include "io/Mesh_data.h"

#include <string>
#include <vector>

namespace pn_subdivide {

// The smallest box along the axes that holds the points; there must be one.
struct Bounding_box
{
  explicit Bounding_box(const std::vector<Triple>& points);

  Triple low, high;
};

double diagonal_of(const Bounding_box& box);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_BOUNDING_BOX_H
