// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_CONTROL_MESH_H
#define PN_SUBDIVISION_3_DEMO_CONTROL_MESH_H

#include "io/Mesh_data.h"
#include "surface/Surface.h"
#include "surface/creases.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pn_demo {

using pn_subdivide::Corner_normal_map;
using pn_subdivide::Corner_value;
using pn_subdivide::Mesh_data;
using pn_subdivide::Point_3;
using pn_subdivide::Surface;
using pn_subdivide::Triple;
using pn_subdivide::Vector_3;
using pn_subdivide::Wedges;

using Edge_sharpness = Surface::Property_map<Surface::Edge_index, double>;

// Flat arrays that say all of a control mesh: what the page keeps for undo, and puts into addresses.
struct Mesh_state
{
  std::vector<double> points;             // x y z
  std::vector<std::uint32_t> degrees;     // of the faces
  std::vector<std::uint32_t> corners;     // the faces' vertices
  std::vector<double> corner_normals;     // x y z, or empty: to be estimated
  std::vector<std::uint32_t> sharp_edges; // pairs of vertices
  // of the vertices, or of the corners where creases have another one on each side; empty: 1, or as normals are estimated
  std::vector<double> roundness;
  std::vector<double> uv; // texture coordinates of the corners, or empty
};

// A control mesh with creases, and with a normal for each wedge of each vertex. Without creases that is
// a normal for each vertex that has faces. A roundness goes with each normal.
class Control_mesh
{
public:
  // The content of a PLY, OFF, OBJ or STL file; normals and the roundness are estimated where it has no normals but
  // those for shading, edges at which the normals of the file's corners differ are sharp. Throws Error with a line for the user.
  // With `repairs` what is no oriented manifold is made one, as the command's --repair does.
  static Control_mesh read(const std::string& content, const std::string& format, bool repairs);
  explicit Control_mesh(const Mesh_state& state);

  Mesh_state state() const;
  // Polygons are split into triangles; creases and normals stay.
  Control_mesh triangulated() const;
  bool has_only_triangles() const;

  const Surface& surface() const { return surface_; }
  const Wedges& wedges() const { return *wedges_; }
  std::size_t number_of_sharp_edges() const;
  bool is_sharp(Surface::Edge_index e) const { return sharpness_[e] > 0; }

  // of the face of a half-edge at its target
  const Vector_3& normal_at(Surface::Halfedge_index h) const { return normals_[h]; }
  const Corner_value& value_at(Surface::Halfedge_index h) const { return normals_.whole(h); }
  // of a vertex without creases; no normal and the roundness 1 where it has no face
  Corner_value value_at(Surface::Vertex_index v) const;
  void set_point(std::size_t v, const Point_3& p);
  void set_normal(std::size_t wedge, const Vector_3& n);

  // Wedges that change get estimated normals, others keep theirs.
  void set_sharp(std::size_t edge, bool is_sharp);
  std::size_t detect_creases(double degrees);

  void drop_normals();
  // and the roundness
  void estimate_normals();
  // Those of the sphere that fits the vertices best, about its center.
  void take_normals_of_sphere();

  // Whether that of some normal is not 1.
  bool has_roundness() const;
  void set_roundness(double w);
  void estimate_roundness();

  // Of a mesh that was read, for people: where the normals come from, and what was repaired.
  const std::string& normals_from() const { return normals_from_; }
  const std::string& repair() const { return repair_; }

  // Texture coordinates, two of each half-edge at its target; empty: none.
  const std::vector<double>& uv() const { return uv_; }

private:
  Control_mesh() = default;
  void fill(const Mesh_data& mesh);
  void mark_creases(const Mesh_data& mesh);
  void mark_edges_where_normals_differ();
  void replace_wedges();
  std::vector<Corner_value> estimate() const; // by half-edge
  template <class Function>
  void for_each_corner(const Function& f) const;

  Surface surface_;
  Corner_normal_map normals_;
  Edge_sharpness sharpness_;
  std::vector<double> uv_;
  std::string normals_from_, repair_;
  std::unique_ptr<Wedges> wedges_;
};

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_CONTROL_MESH_H
