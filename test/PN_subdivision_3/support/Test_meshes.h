// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control meshes by class: closed and bordered, triangles, quads and any polygons, valences 3 to
// 14, several components, corners, isolated vertices. All coordinates and normals are uneven.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_TEST_MESHES_H
#define CGAL_PN_SUBDIVISION_3_TEST_TEST_MESHES_H

#include "Mesh_shapes.h"

namespace test_meshes {

// --- normals ---

// The area vectors of the faces about each vertex, tilted at random by up to about 20 degrees.
inline void set_uneven_normals(Control_mesh& mesh, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<> noise(-0.2, 0.2);
  mesh.normals.assign(mesh.points.size(), Triple{0, 0, 0});
  for (const reference::Face& f : mesh.faces) {
    Triple area{};
    for (std::size_t i = 0; i < f.size(); ++i) {
      const Triple& a = mesh.points[std::size_t(f[i])];
      const Triple& b = mesh.points[std::size_t(f[(i + 1) % f.size()])];
      for (std::size_t k = 0; k < 3; ++k)
        area[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
    area = unit(area);
    for (int v : f)
      for (std::size_t k = 0; k < 3; ++k) mesh.normals[std::size_t(v)][k] += area[k];
  }
  for (Triple& n : mesh.normals) {
    if (n == Triple{0, 0, 0}) n = {0, 0, 1};
    n = unit(n);
    for (double& x : n) x += noise(generator);
    n = unit(n);
  }
}

// Any directions: every fifth normal is missing, every third one nearly opposite to its
// predecessor.
inline void set_wild_normals(Control_mesh& mesh, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<> any(-1, 1);
  mesh.normals.assign(mesh.points.size(), Triple{0, 0, 0});
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    Triple& n = mesh.normals[i];
    if (i % 5 == 4) continue;
    n = unit({any(generator), any(generator), any(generator)});
    if (i % 3 == 2 && mesh.normals[i - 1] != Triple{0, 0, 0})
      for (std::size_t k = 0; k < 3; ++k) n[k] = -mesh.normals[i - 1][k] + 0.07 * n[k];
    n = unit(n);
  }
}

// --- the suite ---

inline std::vector<Control_mesh> shapes()
{
  std::vector<Control_mesh> suite;
  // triangles
  for (int n : {3, 5, 8, 14}) suite.push_back(with_centers(bipyramid(n), 3));
  for (int n : {4, 12}) suite.push_back(bipyramid(n));
  suite.push_back(with_centers(with_centers(bipyramid(9), 2), 2));
  suite.push_back(grid(5, 4, true, true, Cells::triangles));
  suite.push_back(grid(6, 3, true, false, Cells::triangles));
  suite.push_back(grid(4, 5, false, false, Cells::triangles));
  suite.push_back(part_of(grid(7, 6, false, false, Cells::triangles), 3));
  suite.push_back(part_of(with_centers(bipyramid(11), 2), 1));
  suite.push_back(grid(5, 1, false, false, Cells::triangles));
  suite.push_back(single_polygon(3));
  for (int n : {4, 7}) suite.push_back(star(n, 2, Cells::triangles));
  // quads
  for (int n : {3, 5, 7, 12}) suite.push_back(in_quads(bipyramid(n)));
  suite.push_back(grid(5, 6, true, true, Cells::quads));
  suite.push_back(grid(6, 4, true, false, Cells::quads));
  suite.push_back(grid(5, 4, false, false, Cells::quads));
  suite.push_back(part_of(in_quads(bipyramid(6)), 5));
  suite.push_back(part_of(grid(7, 6, false, false, Cells::quads), 2));
  suite.push_back(grid(4, 1, false, false, Cells::quads));
  suite.push_back(single_polygon(4));
  for (int n : {3, 5}) suite.push_back(star(n, 2, Cells::quads));
  // any polygons
  for (int n : {3, 5, 9}) suite.push_back(house(n));
  suite.push_back(part_of(house(7), 4));
  suite.push_back(grid(5, 4, true, true, Cells::mixed));
  suite.push_back(part_of(grid(7, 5, false, false, Cells::mixed), 6));
  suite.push_back(single_polygon(7));
  // several components
  suite.push_back(united(bipyramid(7), part_of(grid(4, 4, false, false, Cells::triangles), 9)));
  suite.push_back(united(in_quads(bipyramid(4)), grid(4, 3, false, false, Cells::quads)));
  suite.push_back(
    united(united(house(6), single_polygon(5)), grid(3, 4, true, false, Cells::mixed)));
  suite.push_back(with_isolated_vertices(with_centers(bipyramid(6), 4)));
  suite.push_back(with_isolated_vertices(part_of(grid(5, 4, false, false, Cells::quads), 8)));
  return suite;
}

inline const std::vector<Control_mesh>& all()
{
  static const std::vector<Control_mesh> suite = [] {
    std::vector<Control_mesh> result = shapes();
    unsigned seed = 1;
    for (Control_mesh& mesh : result) set_uneven_normals(mesh, seed++);
    return result;
  }();
  return suite;
}

} // namespace test_meshes

#endif // CGAL_PN_SUBDIVISION_3_TEST_TEST_MESHES_H
