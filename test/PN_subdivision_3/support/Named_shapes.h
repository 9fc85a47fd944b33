// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// About 80 tiny control meshes by name: poles, solids, prisms, pyramids, fans, strips, holes, components, faces
// of any degree, vertices of valence 2, creases; and those that are no surfaces for a scheme.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_NAMED_SHAPES_H
#define CGAL_PN_SUBDIVISION_3_TEST_NAMED_SHAPES_H

#include "Test_meshes.h"

#include <limits>

namespace named_shapes {

using namespace test_meshes;
using Crease_tags = std::map<reference::Edge, double>; // of edges, both directions

struct Shape
{
  Control_mesh mesh;
  Crease_tags creases = {};
};

inline Triple on_circle(double radius, double turns, double z)
{
  const double angle = 2 * 3.141592653589793 * turns;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

inline Control_mesh renamed(Control_mesh mesh, const std::string& name)
{
  mesh.name = name;
  return mesh;
}

// --- solids ---

inline Control_mesh tetrahedron()
{
  return {"tetrahedron",
          {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

inline Control_mesh cube()
{
  Control_mesh mesh{"cube", {}, {}};
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back({i & 1 ? 1. : -1., i & 2 ? 1. : -1., i & 4 ? 1. : -1.});
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

// Two rings of n, turned by half a step against each other, between two n-gons.
inline Control_mesh antiprism(int n)
{
  Control_mesh mesh{"antiprism " + std::to_string(n), {}, {{}, {}}};
  for (int i = 0; i < 2 * n; ++i)
    mesh.points.push_back(on_circle(1.2, i / (2. * n), i % 2 == 0 ? -0.6 : 0.7));
  for (int i = 0; i < 2 * n; ++i) {
    const int a = i, b = (i + 1) % (2 * n), c = (i + 2) % (2 * n);
    mesh.faces.push_back(i % 2 == 0 ? reference::Face{a, c, b} : reference::Face{a, b, c});
    auto& cap = mesh.faces[std::size_t(i % 2)];
    cap.insert(i % 2 == 0 ? cap.begin() : cap.end(), i);
  }
  return mesh;
}

// The antiprism with a pole over either n-gon: n = 5 gives the icosahedron.
inline Control_mesh capped_antiprism(int n)
{
  Control_mesh mesh = antiprism(n);
  mesh.name = "capped " + mesh.name;
  const Faces caps(mesh.faces.begin(), mesh.faces.begin() + 2);
  mesh.faces.erase(mesh.faces.begin(), mesh.faces.begin() + 2);
  for (std::size_t side = 0; side < 2; ++side) {
    const int pole = int(mesh.points.size());
    mesh.points.push_back({0, 0, side == 0 ? -1.3 : 1.4});
    for (std::size_t i = 0; i < caps[side].size(); ++i)
      mesh.faces.push_back({caps[side][i], caps[side][(i + 1) % caps[side].size()], pole});
  }
  return mesh;
}

// A vertex for each face and a face for each vertex of a closed mesh.
inline Control_mesh dual(const Control_mesh& mesh, const std::string& name)
{
  const reference::Face_list list = test_meshes::face_list(mesh);
  Control_mesh result{name, {}, {}};
  for (const reference::Face& f : mesh.faces) {
    Triple mean{};
    for (int v : f)
      for (std::size_t k = 0; k < 3; ++k)
        mean[k] += mesh.points[std::size_t(v)][k] / double(f.size());
    result.points.push_back(mean);
  }
  for (int v = 0; v < list.number_of_vertices(); ++v) {
    result.faces.emplace_back();
    for (int u : list.ring(v)) result.faces.back().push_back(list.face(v, u));
  }
  return result;
}

inline Control_mesh prism(int n)
{
  Control_mesh mesh{"prism " + std::to_string(n), {}, {{}, {}}};
  for (int i = 0; i < 2 * n; ++i)
    mesh.points.push_back(on_circle(1 + 0.1 * (i % 3), i / double(n), i < n ? -0.8 : 0.9));
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.faces.push_back({i, j, n + j, n + i});
    mesh.faces[0].insert(mesh.faces[0].begin(), i);
    mesh.faces[1].push_back(n + i);
  }
  return mesh;
}

inline Control_mesh pyramid(int n)
{
  Control_mesh mesh{"pyramid " + std::to_string(n), {}, {{}}};
  for (int i = 0; i < n; ++i) {
    mesh.points.push_back(on_circle(1.3, (i + 0.1 * (i % 2)) / n, -0.4));
    mesh.faces[0].insert(mesh.faces[0].begin(), i);
    mesh.faces.push_back({i, (i + 1) % n, n});
  }
  mesh.points.push_back({0.1, 0, 1.1});
  return mesh;
}

// Quads between two poles of valence n: n = 3 has the faces of a cube.
inline Control_mesh quads_between_poles(int n)
{
  Control_mesh mesh{"quads between poles " + std::to_string(n), {{0, 0, 1.2}, {0, 0, -1.1}}, {}};
  for (int i = 0; i < 2 * n; ++i)
    mesh.points.push_back(on_circle(1.3, i / (2. * n), i % 2 == 0 ? 0.4 : -0.35));
  for (int i = 0; i < n; ++i) {
    const int a = 2 + 2 * i, b = a + 1, c = 2 + (2 * i + 2) % (2 * n),
              d = 2 + (2 * i + 3) % (2 * n);
    mesh.faces.push_back({0, a, b, c});
    mesh.faces.push_back({1, d, c, b});
  }
  return mesh;
}

// --- open ones ---

// The grid without the cells that are named.
inline Control_mesh grid_without(int nx, int ny, Cells cells, const std::vector<int>& holes,
                                 const std::string& name)
{
  Control_mesh mesh = grid(nx, ny, false, false, Cells::quads);
  const Faces quads = mesh.faces;
  mesh.faces.clear();
  for (std::size_t i = 0; i < quads.size(); ++i)
    if (std::count(holes.begin(), holes.end(), int(i)) == 0)
      add_cell(quads[i], i, cells, mesh.faces);
  return renamed(mesh, name);
}

// --- valence 2 ---

// Two n-gons back to back.
inline Control_mesh pillow(int n)
{
  Control_mesh mesh{"pillow " + std::to_string(n), {}, {{}, {}}};
  for (int i = 0; i < n; ++i) {
    mesh.points.push_back(on_circle(1, i / double(n), 0.2 * (i % 3)));
    mesh.faces[0].push_back(i);
    mesh.faces[1].insert(mesh.faces[1].begin(), i);
  }
  return mesh;
}

// --- creases ---

// Every k-th edge of the list of edges gets the next of a few sharpnesses.
inline Shape creased(Control_mesh mesh, std::size_t k, const std::vector<double>& sharpness)
{
  Shape shape{std::move(mesh)};
  shape.mesh.name += ", every edge of " + std::to_string(k) + " a crease";
  const reference::Face_list list = test_meshes::face_list(shape.mesh);
  std::size_t i = 0;
  for (const auto& [a, b] : list.edges()) {
    const double s = i % k == 0 ? sharpness[i / k % sharpness.size()] : 0;
    shape.creases[{a, b}] = shape.creases[{b, a}] = s;
    ++i;
  }
  return shape;
}

// --- the suite ---

inline void add_triangles(std::vector<Control_mesh>& all)
{
  for (int n : {3, 4, 5, 6, 7, 8, 12, 24, 64, 360}) all.push_back(bipyramid(n));
  all.push_back(tetrahedron());
  all.push_back(renamed(capped_antiprism(5), "icosahedron"));
  for (int n : {3, 4, 7}) all.push_back(capped_antiprism(n));
  for (int n : {3, 5, 6, 9})
    all.push_back(renamed(star(n, 1, Cells::triangles), "fan " + std::to_string(n)));
  all.push_back(renamed(grid(5, 1, false, false, Cells::triangles), "strip of triangles"));
  all.push_back(renamed(grid(5, 1, true, false, Cells::triangles), "ring of triangles"));
  all.push_back(grid_without(5, 5, Cells::triangles, {6, 18}, "triangles with two holes"));
  all.push_back(renamed(grid(4, 3, true, true, Cells::triangles), "torus of triangles"));
  all.push_back(pillow(3));
  all.push_back(single_polygon(3));
  all.push_back(united(tetrahedron(), single_polygon(3)));
  all.push_back(with_isolated_vertices(bipyramid(5)));
}

inline void add_quads(std::vector<Control_mesh>& all)
{
  all.push_back(cube());
  for (int n : {4, 5, 6, 8, 16, 64, 360}) all.push_back(quads_between_poles(n));
  all.push_back(in_quads(tetrahedron()));
  for (int n : {3, 5, 6, 9})
    all.push_back(renamed(star(n, 1, Cells::quads), "fan of quads " + std::to_string(n)));
  all.push_back(renamed(grid(4, 1, false, false, Cells::quads), "strip of quads"));
  all.push_back(renamed(grid(5, 1, true, false, Cells::quads), "ring of quads"));
  all.push_back(grid_without(5, 5, Cells::quads, {6, 18}, "quads with two holes"));
  all.push_back(grid_without(3, 3, Cells::quads, {0, 2, 6, 8}, "cross of quads"));
  all.push_back(renamed(grid(4, 3, true, true, Cells::quads), "torus of quads"));
  all.push_back(pillow(4));
  all.push_back({"two quads about a vertex of valence 2",
                 {{-1, 0, 0}, {0, 0, 0.3}, {1, 0, 0}, {0, 1, 0.1}, {0, -1, 0}},
                 {{0, 1, 2, 3}, {2, 1, 0, 4}}});
  all.push_back(single_polygon(4));
  all.push_back(united(cube(), grid(2, 2, false, false, Cells::quads)));
}

inline void add_mixed(std::vector<Control_mesh>& all)
{
  all.push_back(dual(capped_antiprism(5), "dodecahedron"));
  for (int n : {3, 5, 6, 12}) all.push_back(prism(n));
  for (int n : {4, 5, 8}) all.push_back(antiprism(n));
  for (int n : {4, 5, 7, 12}) all.push_back(pyramid(n));
  all.push_back(house(5));
  for (int n : {5, 6, 12}) all.push_back(single_polygon(n));
  for (int n : {5, 12}) all.push_back(pillow(n));
  all.push_back(renamed(grid(5, 4, true, true, Cells::mixed), "torus of triangles and quads"));
  all.push_back(grid_without(6, 5, Cells::mixed, {7, 21}, "triangles and quads with two holes"));
  all.push_back(dual(bipyramid(9), "prism with 9-gons by duality"));
  all.push_back(united(united(prism(5), pyramid(6)), pillow(3)));
  all.push_back(with_isolated_vertices(pyramid(5)));
  // components that touch in a point, each with a vertex of its own there
  Control_mesh touching{"triangles that touch",
                        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.2}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}},
                        {{0, 1, 2}, {3, 4, 5}}};
  all.push_back(touching);
}

inline void add_creased(std::vector<Shape>& all)
{
  const double infinity = std::numeric_limits<double>::infinity();
  all.push_back(creased(cube(), 1, {infinity}));
  all.push_back(creased(cube(), 2, {infinity, 1.5, 0.4}));
  all.push_back(creased(bipyramid(8), 3, {infinity, 1, 0.5}));
  all.push_back(creased(tetrahedron(), 1, {infinity, 2.5}));
  all.push_back(creased(prism(6), 3, {infinity}));
  all.push_back(creased(grid_without(5, 5, Cells::triangles, {6}, "triangles with a hole"), 4,
                        {infinity, 0.7}));
  all.push_back(
    creased(grid_without(5, 5, Cells::quads, {6}, "quads with a hole"), 5, {infinity, 0.7, 2}));
  all.push_back(creased(pyramid(12), 4, {infinity, 3}));
}

inline const std::vector<Shape>& all()
{
  static const std::vector<Shape> suite = [] {
    std::vector<Control_mesh> meshes;
    add_triangles(meshes);
    add_quads(meshes);
    add_mixed(meshes);
    std::vector<Shape> result;
    for (Control_mesh& mesh : meshes) result.push_back({std::move(mesh)});
    add_creased(result);
    return result;
  }();
  return suite;
}

// A vertex of valence 2 that is no border vertex.
inline bool has_interior_valence_2(const Control_mesh& mesh)
{
  const std::vector<int> valences = interior_valences(mesh);
  return !valences.empty() && valences.front() == 2;
}

// --- normals ---

enum class Normals { linear, exact, missing, opposite, random };

constexpr Normals all_normals[] = {Normals::linear, Normals::exact, Normals::missing,
                                   Normals::opposite, Normals::random};

inline const char* name_of(Normals n)
{
  const char* const names[] = {"linear", "exact", "missing", "opposite", "random"};
  return names[int(n)];
}

constexpr double radius = 2;

// Moves the points onto a sphere about the origin, where they have exact normals. The rays go through a point
// beside their mean, so that open shapes do not collapse.
inline void move_to_sphere(Control_mesh& mesh)
{
  Triple mean{};
  for (const Triple& p : mesh.points)
    for (std::size_t k = 0; k < 3; ++k) mean[k] += p[k] / double(mesh.points.size());
  mean[2] -= is_closed(mesh) ? 0.05 : 2.3;
  for (Triple& p : mesh.points) {
    for (std::size_t k = 0; k < 3; ++k) p[k] -= mean[k];
    p = unit(p);
  }
  mesh.normals = mesh.points;
  for (Triple& p : mesh.points)
    for (double& x : p) x *= radius;
}

// about the origin, with its normals
inline Control_mesh on_unit_sphere(Control_mesh mesh)
{
  for (Triple& p : mesh.points) p = unit(p);
  mesh.normals = mesh.points;
  return mesh;
}

inline Control_mesh with_normals(Control_mesh mesh, Normals n)
{
  mesh.normals.assign(mesh.points.size(), Triple{0, 0, 0});
  if (n == Normals::exact)
    move_to_sphere(mesh);
  else if (n == Normals::random)
    set_wild_normals(mesh, unsigned(mesh.points.size()));
  else if (n == Normals::missing) { // every second one
    set_uneven_normals(mesh, 7);
    for (std::size_t i = 0; i < mesh.normals.size(); i += 2) mesh.normals[i] = {0, 0, 0};
  } else if (n == Normals::opposite)
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
      mesh.normals[i] = i % 2 == 0 ? Triple{0, 0.6, 0.8} : Triple{0, -0.6, -0.8};
  return mesh;
}

} // namespace named_shapes

#endif // CGAL_PN_SUBDIVISION_3_TEST_NAMED_SHAPES_H
