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
#include "io/border_edges.h"

#include <string>
#include <vector>

namespace pn_subdivide {

// What keeps a polygon soup from being an oriented 2-manifold (with or without border).
struct Soup_defects
{
  struct Edges
  {
    std::size_t number = 0;
    Mesh_data::Index first[2] = {0, 0};
  };
  struct Vertices
  {
    std::size_t number = 0;
    Mesh_data::Index first = 0;
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
std::vector<Mesh_data::Index> vertices_at_open_edges(const Mesh_data& mesh);

// What no repair mends: no faces, coordinates that are not finite, a number of normals other than that of vertices.
// Throws Error, which names the first such element; vertices and faces are counted from 0.
void require_finite_elements(const Mesh_data& mesh);

// That, and a face of less than three vertices or that visits one twice.
void require_sound_elements(const Mesh_data& mesh);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SOUP_CHECK_H
