// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SOUP_CHECK_H
#define PN_SUBDIVIDE_SOUP_CHECK_H

#include "io/Mesh_data.h"

#include <array>
#include <string>
#include <vector>

namespace pn_subdivide {

// An edge with one face: its ends, the one with the lower number first.
using Border_edge = std::array<Index, 2>;

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

// What keeps a polygon soup from being an oriented 2-manifold (with or without border).
struct Soup_defects
{
  struct Edges
  {
    std::size_t number = 0;
    Index first[2] = {0, 0};
  };
  struct Vertices
  {
    std::size_t number = 0;
    Index first = 0;
  };

  Edges crowded;    // edges with more than two faces
  Edges unoriented; // edges with two faces that go along them in the same direction
  Vertices pinched; // vertices where several fans of faces meet (bow-ties); they are looked for
                    // only where the edges are in order

  std::vector<Border_edge> border; // edges with one face, which are no defect

  bool none() const { return pinched.number == 0 && has_edges_in_order(); }
  bool has_edges_in_order() const { return crowded.number + unoriented.number == 0; }
  // one line, by the numbers of the file
  std::string description(const Mesh_data& mesh) const;
};

Soup_defects find_defects(const Mesh_data& mesh);

// Those at edges that have one face or more than two, and those without faces, in order.
std::vector<Index> vertices_at_open_edges(const Mesh_data& mesh);

// What no repair mends: no faces, coordinates that are not finite, a number of normals other than that of vertices.
// Throws Error, which names the first such element; vertices and faces are counted from 0.
void require_finite_elements(const Mesh_data& mesh);

// That, and a face of less than three vertices or that visits one twice.
void require_sound_elements(const Mesh_data& mesh);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SOUP_CHECK_H
