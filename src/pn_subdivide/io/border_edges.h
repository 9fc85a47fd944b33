// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_BORDER_EDGES_H
#define PN_SUBDIVIDE_BORDER_EDGES_H

#include "io/Mesh_data.h"

#include <array>
#include <string>
#include <vector>

namespace pn_subdivide {

// An edge with one face: its ends, the one with the lower number first.
using Border_edge = std::array<Mesh_data::Index, 2>;

// Border edges that lie on others: there the surface is open although it may not be meant to be.
struct Border_contacts
{
  std::size_t border_edges = 0;
  std::size_t equal = 0; // both ends are equal points
  std::size_t near = 0;  // both ends are equal but for the distance
  std::size_t along = 0; // a part of one edge lies on another (T-junctions)

  bool any() const { return equal + near + along > 0; }
  // one line; joins_equal: the option to name
  std::string description(double distance_of_diagonal, const std::string& joins_equal) const;
};

// Only those with both ends at the same points.
std::size_t number_of_equal(const Mesh_data& mesh, const std::vector<Border_edge>& edges);

// Copies that repair_soup() made of the same vertices are apart because they have to be, and do not
// count.
Border_contacts find_border_contacts(const Mesh_data& mesh, const std::vector<Border_edge>& edges,
                                     double distance);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_BORDER_EDGES_H
