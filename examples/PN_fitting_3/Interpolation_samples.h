// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_INTERPOLATION_SAMPLES_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_INTERPOLATION_SAMPLES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

// Shapes as a scanner would deliver them: points at uneven distances, and the faces between.
namespace interpolation_samples {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Normals = Mesh::Property_map<Mesh::Vertex_index, Vector>;

struct Shape
{
  std::string name;
  std::function<Mesh()> samples;
  std::function<double(const Point&)> distance; // signed, to first order
};

// a number between -1 and 1 that depends on three others as if by chance
inline double noise(int a, int b, int c)
{
  const double x = 43758.5453 * std::sin(12.9898 * a + 78.233 * b + 37.719 * c);
  return 2 * (x - std::floor(x)) - 1;
}

// the faces of a cube cut in n x n, moved by up to a fifth of a cell, on an ellipsoid
inline Shape ellipsoid(int n = 8)
{
  constexpr double a = 1.5, b = 1, c = 0.7;
  const auto samples = [n] {
    Mesh mesh;
    std::map<std::array<int, 3>, Mesh::Vertex_index> vertices;
    const auto vertex = [&](const std::array<int, 3>& k) {
      const auto found = vertices.find(k);
      if (found != vertices.end()) return found->second;
      double d[3];
      for (int i = 0; i < 3; ++i) {
        const bool is_inner = k[i] != 0 && k[i] != n;
        const double moved =
          k[i] + (is_inner ? 0.2 * noise(k[i], k[(i + 1) % 3], k[(i + 2) % 3]) : 0);
        d[i] = std::tan(CGAL_PI / 4 * (2 * moved / n - 1));
      }
      const double length = std::hypot(d[0], d[1], d[2]);
      const Point p(a * d[0] / length, b * d[1] / length, c * d[2] / length);
      return vertices[k] = mesh.add_vertex(p);
    };
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, n})
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            std::vector<Mesh::Vertex_index> face;
            for (const auto& [di, dj] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
              std::array<int, 3> k{};
              k[axis] = side;
              k[(axis + 1) % 3] = side == 0 ? j + dj : i + di;
              k[(axis + 2) % 3] = side == 0 ? i + di : j + dj;
              face.push_back(vertex(k));
            }
            mesh.add_face(face);
          }
    return mesh;
  };
  const auto distance = [](const Point& p) {
    const double x = p.x() / a, y = p.y() / b, z = p.z() / c;
    return (x * x + y * y + z * z - 1) / (2 * std::hypot(x / a, y / b, z / c));
  };
  return {"ellipsoid", samples, distance};
}

// a grid of 16 x 16 points on a torus, each moved by up to a fifth of a cell
inline Shape torus(int n = 16)
{
  constexpr double major = 2.5, minor = 1;
  const auto samples = [n] {
    Mesh mesh;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double u = 2 * CGAL_PI * (i + 0.2 * noise(i, j, 1)) / n;
        const double v = 2 * CGAL_PI * (j + 0.2 * noise(i, j, 2)) / n;
        const double r = major + minor * std::cos(v);
        mesh.add_vertex(Point(r * std::cos(u), r * std::sin(u), minor * std::sin(v)));
      }
    const auto at = [n](int i, int j) { return Mesh::Vertex_index(i % n * n + j % n); };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return mesh;
  };
  const auto distance = [](const Point& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - major, p.z()) - minor;
  };
  return {"torus", samples, distance};
}

} // namespace interpolation_samples

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_INTERPOLATION_SAMPLES_H
