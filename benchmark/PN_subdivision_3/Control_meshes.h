// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_CONTROL_MESHES_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_CONTROL_MESHES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Closed control meshes of sizes in small steps, with extraordinary vertices, and normals that are
// not those of the positions, so that no average is a trivial one.
namespace Control_meshes {

// a torus-like tube whose radius varies: `rings` times `segments` quads
inline Mesh tube(int rings, int segments, bool triangles)
{
  const double pi = std::acos(-1.0);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < segments; ++j) {
      const double a = 2 * pi * i / rings, b = 2 * pi * j / segments;
      const double r = 1 + 0.2 * std::cos(3 * a) + 0.1 * std::sin(2 * b);
      v.push_back(
        mesh.add_vertex(Kernel::Point_3((3 + r * std::cos(b)) * std::cos(a),
                                        (3 + r * std::cos(b)) * std::sin(a), r * std::sin(b))));
    }
  const auto at = [&](int i, int j) { return v[(i % rings) * segments + j % segments]; };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < segments; ++j)
      if (!triangles)
        mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      else if ((i * 7 + j * 3) % 5 < 3) { // either diagonal: valences 4 to 8
        mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      } else {
        mesh.add_face(at(i, j), at(i + 1, j), at(i, j + 1));
        mesh.add_face(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  return mesh;
}

inline Mesh quads(int rings, int segments)
{
  return tube(rings, segments, false);
}

inline Mesh triangles(int rings, int segments)
{
  return tube(rings, segments, true);
}

// The same mesh, its vertices and faces in random order, so that neighbors are far apart in memory.
inline Mesh shuffled(const Mesh& mesh)
{
  std::mt19937 random(1);
  std::vector<Mesh::Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  std::shuffle(vertices.begin(), vertices.end(), random);
  std::shuffle(faces.begin(), faces.end(), random);
  Mesh result;
  std::vector<Mesh::Vertex_index> new_vertex(vertices.size());
  for (Mesh::Vertex_index v : vertices) new_vertex[v] = result.add_vertex(mesh.point(v));
  for (Mesh::Face_index f : faces) {
    std::vector<Mesh::Vertex_index> corners;
    for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(new_vertex[v]);
    result.add_face(corners);
  }
  return result;
}

inline Mesh shuffled_quads(int rings, int segments)
{
  return shuffled(quads(rings, segments));
}

inline Mesh shuffled_triangles(int rings, int segments)
{
  return shuffled(triangles(rings, segments));
}

// adds unit normals that differ from those of the surface
inline Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3> add_normals(Mesh& mesh)
{
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Vector_3 p = mesh.point(v) - CGAL::ORIGIN;
    const double l = std::hypot(p.x(), p.y());
    const Kernel::Vector_3 n(p.x() * (l - 3) / l, p.y() * (l - 3) / l, p.z());
    normals[v] = n / std::sqrt(n.squared_length());
  }
  return normals;
}

} // namespace Control_meshes

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_CONTROL_MESHES_H
