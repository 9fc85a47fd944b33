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

#include <array>
#include <cstddef>
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
std::vector<Index> first_near(const Mesh_data& mesh, double distance);

// Four units in the last place of the largest coordinate as a `float`, as cracks in STL files have.
double rounding_of_floats(const std::vector<Triple>& points);

struct Soup_repair
{
  std::size_t removed_degenerate_faces = 0;
  std::size_t split_faces = 0; // that visited a vertex twice and are still there, as one or more
  std::size_t removed_duplicate_faces = 0;
  std::size_t reversed_faces = 0;
  std::size_t added_vertices = 0; // copies, behind the old vertices
  std::size_t turned_components = 0;
  std::size_t turned_normals =
    0;                           // by turn_opposing_normals(), which repair_soup() leaves to others
  Index first_turned_normal = 0; // its vertex

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

// Orients the faces consistently and gives vertices and edges that join too many faces a copy for each part, which stand behind
// the old vertices. Faces that are turned change their `is_reversed`. Returns the number of copies.
std::size_t orient_soup(Mesh_data& mesh, std::vector<bool>& is_reversed);

// What a copy has from its vertex, but for the point.
inline void add_values_of_copy(Mesh_data& mesh, Index original)
{
  mesh.copied_from.push_back(original);
  if (mesh.has_normals()) mesh.normals.push_back(mesh.normals[original]);
  if (!mesh.roundness.empty()) mesh.roundness.push_back(mesh.roundness[original]);
  for (Column& column : mesh.attributes.of_vertices)
    column.values.push_back(column.values[original]);
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SOUP_REPAIR_H
