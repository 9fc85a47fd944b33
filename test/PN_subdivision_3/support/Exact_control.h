// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control meshes with rational points and rational unit normals, and one exact round of a scheme.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_EXACT_CONTROL_H
#define CGAL_PN_SUBDIVISION_3_TEST_EXACT_CONTROL_H

#include "One_root_number.h"
#include "Rational_shapes.h"
#include "Scheme_runs.h"

struct Exact_control
{
  using Number = One_root_number;
  using Point = One_root_kernel::Point_3;
  using Vector = One_root_kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = Mesh::Vertex_index;

  // samples of a shape; the points of the mesh say their directions
  Exact_control(const rational_shapes::Shape& shape, const test_meshes::Control_mesh& control)
  {
    for (const test_meshes::Triple& d : control.points) {
      const rational_shapes::Sample s = shape.sample(d);
      add(point(s.point), vector(s.normal));
    }
    add_faces(control);
  }

  // the points as they are, the normals nearly
  explicit Exact_control(const test_meshes::Control_mesh& control)
  {
    for (std::size_t i = 0; i < control.points.size(); ++i) {
      const test_meshes::Triple &p = control.points[i], &n = control.normals[i];
      const bool none = n == test_meshes::Triple{0, 0, 0};
      add(Point(p[0], p[1], p[2]),
          none ? Vector(0, 0, 0) : vector(rational_shapes::unit_3(n[0], n[1], n[2])));
    }
    add_faces(control);
  }

  // the map of the copy is that of its own mesh
  Exact_control(const Exact_control& other)
    : mesh(other.mesh)
  {}

  template <class Scheme>
  void refine(const Scheme& scheme, unsigned rounds = 1)
  {
    CGAL::PN_subdivision_3::subdivide(
      mesh, scheme, CGAL::parameters::number_of_iterations(rounds).vertex_normal_map(normals));
  }

  // changes every control point and every control normal
  template <class Of_point, class Of_normal>
  void change(const Of_point& of_point, const Of_normal& of_normal)
  {
    for (auto v : mesh.vertices()) {
      mesh.point(v) = of_point(mesh.point(v));
      normals[v] = of_normal(normals[v]);
    }
  }

  bool is_on(const rational_shapes::Shape& shape, Vertex v) const
  {
    return is_on(shape, mesh.point(v), normals[v]);
  }
  static bool is_on(const rational_shapes::Shape& shape, const Point& p, const Vector& n)
  {
    return rational_shapes::is_exactly_on<Number>(shape, {p.x(), p.y(), p.z()},
                                                  {n.x(), n.y(), n.z()});
  }
  std::size_t number_of_vertices_off(const rational_shapes::Shape& shape) const
  {
    std::size_t off = 0;
    for (auto v : mesh.vertices()) off += !is_on(shape, v);
    return off;
  }

  static Point point(const rational_shapes::Vector<rational_shapes::Rational>& p)
  {
    return Point(p[0], p[1], p[2]);
  }
  static Vector vector(const rational_shapes::Vector<rational_shapes::Rational>& v)
  {
    return Vector(v[0], v[1], v[2]);
  }

  Mesh mesh;
  Mesh::Property_map<Vertex, Vector> normals = mesh.add_property_map<Vertex, Vector>("n").first;

private:
  void add(const Point& p, const Vector& n) { normals[mesh.add_vertex(p)] = n; }

  void add_faces(const test_meshes::Control_mesh& control)
  {
    for (const reference::Face& face : control.faces) {
      std::vector<Vertex> corners;
      for (int v : face) corners.emplace_back(Mesh::size_type(v));
      mesh.add_face(corners);
    }
  }
};

#endif // CGAL_PN_SUBDIVISION_3_TEST_EXACT_CONTROL_H
