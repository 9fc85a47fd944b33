// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_DISPLAY_MESH_H
#define PN_SUBDIVISION_3_DEMO_DISPLAY_MESH_H

#include "Refinement.h"

#include <vector>

namespace pn_demo {

// A surface as graphics hardware wants it: triangles, positions and normals in float. The normals are
// those of the faces around a vertex, weighted by area; an update costs what has moved.
class Display_mesh
{
public:
  // `vertices`: for each vertex of the faces its number in the points. Positions are relative to `origin`: numbers of 24
  // bits say little of a small mesh that is far away.
  Display_mesh(const Faces& faces, const std::vector<Index>& vertices, std::size_t points,
               const Point_3& origin);

  // The points of these numbers have moved.
  void update(const std::vector<Index>& moved, const std::vector<Point_3>& points);
  // Positions and normals from elsewhere, by the numbers of points.
  void set(const std::vector<Point_3>& points, const std::vector<Vector_3>& normals);

  const std::vector<float>& positions() const { return positions_; }
  const std::vector<float>& normals() const { return normals_; }
  const std::vector<Index>& triangles() const { return triangles_; }
  const Faces& faces() const { return faces_; }
  const std::vector<Index>& vertices() const { return vertices_; }

private:
  void compute_face_normal(Index f, const std::vector<Point_3>& points);
  void sum_normals(Index v);
  void put_position(Index v, const Point_3& p);

  Index first_corner(Index f) const { return f == 0 ? 0 : faces_.end[f - 1]; }

  Faces faces_;
  Point_3 origin_;
  std::vector<Index> vertices_;
  std::vector<Index> copies_end_, copies_;     // the vertices of each point
  std::vector<Index> incident_end_, incident_; // the faces of each vertex
  std::vector<Vector_3> face_normals_;
  std::vector<bool> is_face_marked_, is_vertex_marked_;
  std::vector<float> positions_, normals_;
  std::vector<Index> triangles_;
};

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_DISPLAY_MESH_H
