// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_CLOSED_SAMPLES_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_CLOSED_SAMPLES_H

#include "Order_samples.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// Control meshes of a closed surface of about the radius 1, with its points and normals: a cubic surface
// that is no quadric, and has no symmetry.
namespace closed_samples {

using order_samples::Kernel;
using order_samples::Mesh;
using order_samples::Normals;
using order_samples::Point;
using order_samples::unit;
using order_samples::Vector;

inline double implicit(const Vector& p)
{
  const double x = p.x(), y = p.y(), z = p.z();
  return x * x + 1.3 * y * y + .8 * z * z + .5 * x * y * z + .25 * x * x * x - .2 * y * z * z - 1;
}

inline Vector gradient(const Vector& p)
{
  const double x = p.x(), y = p.y(), z = p.z();
  return {2 * x + .5 * y * z + .75 * x * x, 2.6 * y + .5 * x * z - .2 * z * z,
          1.6 * z + .5 * x * y - .4 * y * z};
}

// the point in a direction from the origin
inline Vector on_surface(const Vector& direction)
{
  Vector p = unit(direction);
  for (int i = 0; i < 12; ++i) p = p - implicit(p) / (gradient(p) * p) * p;
  return p;
}

// the distance of p from the surface, and the normal of the surface there
inline double distance(const Point& point, Vector* normal = nullptr)
{
  const Vector p = point - CGAL::ORIGIN;
  Vector foot = p, n;
  for (int i = 0; i < 3; ++i) {
    n = gradient(foot);
    foot = foot - implicit(foot) / n.squared_length() * n;
  }
  if (normal != nullptr) *normal = unit(n);
  return (p - foot) * unit(n);
}

// a mesh of directions becomes one of points of the surface, with normals in the map "v:normal"
inline void put_on_surface(Mesh& mesh)
{
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  for (const auto v : mesh.vertices()) {
    const Vector p = on_surface(mesh.point(v) - CGAL::ORIGIN);
    mesh.point(v) = CGAL::ORIGIN + p;
    normals[v] = unit(gradient(p));
  }
}

// The Delaunay triangulation of n scattered directions: a spiral of even density whose points are moved
// at random by up to `off` of their distance.
inline Mesh scattered(std::size_t n, double off = .5)
{
  using Hull_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  order_samples::Random random;
  const double pi = std::acos(-1.), step = off * std::sqrt(4 * pi / double(n));
  std::vector<Hull_kernel::Point_3> directions;
  std::map<Hull_kernel::Point_3, Mesh::Vertex_index> vertices; // the hull has them in another order
  Mesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * double(i) + 1) / double(n), r = std::sqrt(1 - z * z);
    const double angle = pi * (3 - std::sqrt(5.)) * double(i);
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    const Vector moved{step * random(), step * random(), step * random()}; // in this order
    const Vector v = unit(Vector(x, y, z) + moved);
    directions.emplace_back(v.x(), v.y(), v.z());
    vertices[directions.back()] = mesh.add_vertex(CGAL::ORIGIN + v);
  }
  CGAL::Surface_mesh<Hull_kernel::Point_3> hull;
  CGAL::convex_hull_3(directions.begin(), directions.end(), hull);
  for (const auto f : hull.faces()) {
    std::vector<Mesh::Vertex_index> corners;
    for (const auto v : hull.vertices_around_face(hull.halfedge(f)))
      corners.push_back(vertices.at(hull.point(v)));
    mesh.add_face(corners);
  }
  put_on_surface(mesh);
  return mesh;
}

// a cube whose faces are cut into n times n quads, evenly in angles
inline Mesh cube(int n)
{
  Mesh mesh;
  std::map<std::array<int, 3>, Mesh::Vertex_index> found;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [entry, is_new] = found.try_emplace(at);
    if (is_new) {
      const auto x = [&](std::size_t k) { return std::tan(std::acos(-1.) / 4 * at[k] / n); };
      entry->second = mesh.add_vertex(Point(x(0), x(1), x(2)));
    }
    return entry->second;
  };
  const auto add_face = [&](std::size_t axis, int side, int i, int j) {
    std::vector<Mesh::Vertex_index> corners;
    for (const auto& [a, b] : {std::pair(i, j), {i + 2, j}, {i + 2, j + 2}, {i, j + 2}}) {
      std::array<int, 3> at;
      at[axis] = side;
      at[(axis + 1) % 3] = a;
      at[(axis + 2) % 3] = b;
      corners.push_back(vertex(at));
    }
    if (side < 0) std::reverse(corners.begin(), corners.end());
    mesh.add_face(corners);
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int side : {-n, n})
      for (int i = -n; i < n; i += 2)
        for (int j = -n; j < n; j += 2) add_face(axis, side, i, j);
  put_on_surface(mesh);
  return mesh;
}

} // namespace closed_samples

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_CLOSED_SAMPLES_H
