// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_ORIENT_OUTWARDS_H
#define PN_SUBDIVIDE_ORIENT_OUTWARDS_H

#include "io/Mesh_data.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pn_subdivide {

// Turns closed components of an oriented 2-manifold so that those that lie in no other one, or in an even number of
// others, are oriented outwards, and those in an odd number, which are cavities, the other way. What has a border or
// bounds no volume stays as it is. Components that cross each other lie in none of each other. Returns the number of
// components that were turned, and marks their faces, which begin with the same vertex as before.
std::size_t orient_outwards(Mesh_data& mesh, std::vector<bool>& is_turned);

struct Inside_out
{
  std::size_t number = 0, first_face = 0;
  std::string description() const; // for a warning
};

// Those of them that are oriented inwards and are no cavities.
Inside_out find_inside_out(const Mesh_data& mesh);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_ORIENT_OUTWARDS_H
