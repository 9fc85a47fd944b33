// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control meshes with random creases.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_RANDOM_CREASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_RANDOM_CREASES_H

#include "Crease_levels.h"
#include "Mesh_shapes.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>

#include <cmath>
#include <limits>
#include <random>

namespace random_creases {

using namespace crease_levels;

constexpr double infinity = std::numeric_limits<double>::infinity();

inline double random_between(std::mt19937& random, double least, double greatest)
{
  return least + (greatest - least) * (double(random() >> 8) / double(1 << 24));
}

inline Control box_of_cells(const std::array<int, 3>& cells)
{
  const test_meshes::Control_mesh mesh = test_meshes::box_of_cells(cells);
  Control c;
  c.points = mesh.points;
  c.faces = mesh.faces;
  return c;
}
inline Control box()
{
  return box_of_cells({2, 2, 2});
}

// a grid of quads with a quad split into triangles and two joined to a hexagon
inline Control patch()
{
  Control c;
  const int n = 5;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) c.points.push_back({double(i), double(j), std::sin(i + 0.5 * j)});
  const auto v = [&](int i, int j) { return i * n + j; };
  for (int i = 0; i + 1 < n; ++i)
    for (int j = 0; j + 1 < n; ++j) {
      if (i == 1 && j == 2) {
        c.faces.push_back({v(1, 2), v(2, 2), v(2, 3)});
        c.faces.push_back({v(1, 2), v(2, 3), v(1, 3)});
      } else if (i == 2 && j == 1) {
        c.faces.push_back({v(2, 1), v(3, 1), v(4, 1), v(4, 2), v(3, 2), v(2, 2)});
      } else if (!(i == 3 && j == 1))
        c.faces.push_back({v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1)});
    }
  return c;
}

inline void perturb(Control& c, std::mt19937& random)
{
  for (Triple& p : c.points)
    for (double& x : p) x += random_between(random, -0.2, 0.2);
}

// one normal to a wedge, near that of a face of it
inline void give_normals(Control& c, std::mt19937& random)
{
  for (Index f = 0; f < c.faces.size(); ++f)
    for (const int v : c.faces[f]) c.normals[{int(f), v}] = {0, 0, 1}; // any, for the slots
  Crease_run<double, CatmullClark_scheme> run(c, CatmullClark_scheme());
  std::map<Index, Triple> of_slot;
  run.for_each_corner([&](Index f, Index v, Index slot) {
    if (of_slot.count(slot) == 0) {
      const Face& face = c.faces[f];
      const std::size_t m = face.size();
      const std::size_t i = std::size_t(std::find(face.begin(), face.end(), int(v)) - face.begin());
      const Triple &p = c.points[std::size_t(face[i])],
                   &q = c.points[std::size_t(face[(i + 1) % m])],
                   &r = c.points[std::size_t(face[(i + m - 1) % m])];
      Triple n;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, o = (k + 2) % 3;
        n[k] = (q[l] - p[l]) * (r[o] - p[o]) - (q[o] - p[o]) * (r[l] - p[l]) +
               random_between(random, -0.3, 0.3);
      }
      const double length = std::hypot(n[0], n[1], n[2]);
      for (double& x : n) x /= length;
      of_slot[slot] = n;
    }
    c.normals[{int(f), int(v)}] = of_slot[slot];
  });
}

// sharpness of a share of the edges and of some vertices
inline void tag(Control& c, std::mt19937& random, double share, const std::vector<double>& values)
{
  for (const Face& face : c.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Edge e = undirected(face[i], face[(i + 1) % face.size()]);
      if (c.sharp_edges.count(e) != 0) continue;
      const bool is_sharp = random_between(random, 0, 1) < share;
      c.sharp_edges[e] = is_sharp ? values[random() % values.size()] : 0;
    }
  for (std::size_t v = 0; v < c.points.size(); ++v)
    if (random_between(random, 0, 1) < 0.08)
      c.sharp_vertices[int(v)] = values[random() % values.size()];
}

} // namespace random_creases

#endif // CGAL_PN_SUBDIVISION_3_TEST_RANDOM_CREASES_H
