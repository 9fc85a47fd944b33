// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SURFACE_H
#define PN_SUBDIVIDE_SURFACE_H

#include "io/Mesh_data.h"
#include "surface/Surface_type.h"

#include <CGAL/PN_subdivision_3/parameters/Estimated_control_normals.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pn_subdivide {

namespace PN = CGAL::PN_subdivision_3;

using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using Edge = Surface::Edge_index;
using Face = Surface::Face_index;
using Normal_map = Surface::Property_map<Vertex, Vector_3>;
using Roundness_map = Surface::Property_map<Vertex, double>;
// of a half-edge's face at its target
using Corner_value = PN::internal::Normal_and_roundness<Kernel>;

// The normals of corners, with their roundness.
struct Corner_normal_map
{
  using key_type = Halfedge;
  using value_type = Vector_3;
  using reference = Vector_3;
  using category = boost::read_write_property_map_tag;

  static constexpr bool goes_with_roundness = true;

  const Corner_value& whole(key_type h) const { return values[h]; }
  void put_whole(key_type h, const Corner_value& value) const { values[h] = value; }
  Vector_3& operator[](key_type h) const { return values[h].normal; }
  friend Vector_3 get(const Corner_normal_map& map, key_type h) { return map[h]; }
  friend void put(const Corner_normal_map& map, key_type h, const Vector_3& n) { map[h] = n; }

  Surface::Property_map<Halfedge, Corner_value> values;
};

// Of vertices with several wedges what these have, with the half-edges that they begin at, clockwise. The first
// wedge of a border vertex may be missing, and has the normal and the roundness of the vertex.
using Wedge_list = std::vector<std::pair<Halfedge, Corner_value>>;

inline Point_3 to_point(const Triple& t)
{
  return {t[0], t[1], t[2]};
}
inline Vector_3 to_vector(const Triple& t)
{
  return {t[0], t[1], t[2]};
}
template <class Point_or_vector>
Triple to_triple(const Point_or_vector& p)
{
  return {p.x(), p.y(), p.z()};
}

// The mesh of a soup that is an oriented 2-manifold, with its normals. Vertices and faces keep their
// order, vertices without faces are there too. Numbers and half-edges are as Surface_mesh::add_face()
// makes them; the time is near-linear, also where a vertex has a hundred thousand neighbors, round
// which add_face() walks for each face. Throws Error if an edge has more than two faces, or two that
// run along it in one direction, or if the mesh is too large.
Surface make_surface(const Mesh_data& mesh);

// The property map of this name and type, if there is one; CGAL 6 has an optional where older versions have a pair.
template <class Element, class Value>
auto find_property_map(const Surface& surface, const std::string& name)
{
  using Found = std::optional<Surface::Property_map<Element, Value>>;
  auto found = surface.property_map<Element, Value>(name);
  if constexpr (std::is_same_v<decltype(found), Found>)
    return found;
  else
    return found.second ? Found(found.first) : Found();
}

// Those of a mesh that has some.
std::optional<Normal_map> normals_of(const Surface& surface);
std::optional<Corner_normal_map> corner_normals_of(const Surface& surface);

// That of a mesh that has one.
std::optional<Roundness_map> roundness_of(const Surface& surface);
// 1 at all vertices, whatever it has been
Roundness_map add_roundness(Surface& surface);

// Gives each corner the normal of its vertex, which there must be, and its roundness.
Corner_normal_map add_corner_normals(Surface& surface);

// What it has or, where it has none, gets.
inline Corner_normal_map corner_normals_or_added(Surface& surface)
{
  const std::optional<Corner_normal_map> given = corner_normals_of(surface);
  return given ? *given : add_corner_normals(surface);
}
inline Roundness_map roundness_or_added(Surface& surface)
{
  const std::optional<Roundness_map> given = roundness_of(surface);
  return given ? *given : add_roundness(surface);
}

// Takes the values of the corners off the mesh, in the order of its half-edges; those of the vertices if there
// are none.
std::vector<Corner_value> take_corner_normals(Surface& surface);
// Gives each corner the values of its wedge.
void put_corner_normals(Surface& surface, const Wedge_list& wedges);
// those of vertices and of corners
void remove_normals(Surface& surface);
void remove_normals_and_roundness(Surface& surface);

// zero at all vertices; the mesh must have none yet
Normal_map add_normals(Surface& surface);

// Points, normals and faces in the order of the mesh, which must not hold garbage.
Mesh_data to_mesh_data(const Surface& surface, const Wedge_list& wedges = {});

// The half-edges that stand for the corners of the faces, face by face in the order of to_mesh_data():
// each ends at its corner.
std::vector<Halfedge> corners_of(const Surface& surface);

struct Triangulation
{
  std::size_t split_faces = 0;
  // For each half-edge of a face the one that stood for its corner before; empty if no face was split.
  std::vector<Halfedge> old_corner;
};

// Splits each face of n > 3 vertices into n - 2 triangles, also one without area. Corners keep their normals.
Triangulation triangulate(Surface& surface);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_H
