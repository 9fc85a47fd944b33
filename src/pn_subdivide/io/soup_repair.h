// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SOUP_REPAIR_H
#define PN_SUBDIVIDE_SOUP_REPAIR_H

#include "io/Mesh_data.h"

#include <string>
#include <vector>

namespace pn_subdivide {

struct Soup_repair
{
  std::size_t removed_degenerate_faces = 0;
  std::size_t split_faces = 0; // that visited a vertex twice and are still there, as one or more
  std::size_t removed_duplicate_faces = 0;
  std::size_t reversed_faces = 0;
  std::size_t added_vertices = 0; // copies, behind the old vertices
  std::size_t turned_components = 0;
  std::size_t turned_normals =
    0; // by turn_opposing_normals(), which repair_soup() leaves to others
  Mesh_data::Index first_turned_normal = 0; // its vertex

  bool changed_anything() const
  {
    return removed_degenerate_faces + split_faces + removed_duplicate_faces + reversed_faces +
             added_vertices + turned_components + turned_normals >
           0;
  }
  std::string description() const; // one line
};

// Makes an oriented 2-manifold of a soup:
// Faces that visit a vertex twice are split there, and what has less than three vertices is removed.
// If the soup is no oriented 2-manifold then, faces with the same vertices in the same order, whatever
// their orientation, are removed but for the first; the faces are oriented consistently, and vertices
// and edges that join too many faces get a copy for each part, with CGAL's orient_polygon_soup().
// Closed components are oriented outwards, cavities the other way, as orient_outwards() does it.
// Copies take the normal and the attributes of their original, parts of a face its attributes; normals are not reversed along with faces, because they
// say by themselves which way they point.
Soup_repair repair_soup(Mesh_data& mesh);

// Gives each of several fans of faces a vertex of its own where they meet, and returns how many vertices that adds. All edges
// must be in order.
std::size_t split_fans(Mesh_data& mesh);

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

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SOUP_REPAIR_H
