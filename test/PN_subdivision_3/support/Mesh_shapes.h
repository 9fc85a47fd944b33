// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Shapes of control meshes, their classes, and operations that make one from another.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_MESH_SHAPES_H
#define CGAL_PN_SUBDIVISION_3_TEST_MESH_SHAPES_H

#include "reference/Face_list.h"

#include <array>
#include <map>
#include <random>
#include <string>

namespace test_meshes {

using Triple = std::array<double, 3>;
using Faces = std::vector<reference::Face>;

struct Control_mesh
{
  std::string name;
  std::vector<Triple> points;
  Faces faces;
  std::vector<Triple> normals = {};
};

inline Triple unit(const Triple& v)
{
  const long double x = v[0], y = v[1], z = v[2], length = std::sqrt(x * x + y * y + z * z);
  return {double(x / length), double(y / length), double(z / length)};
}

// --- classes ---

inline bool all_faces_have_degree(const Control_mesh& mesh, std::size_t m)
{
  return std::all_of(mesh.faces.begin(), mesh.faces.end(),
                     [m](const reference::Face& f) { return f.size() == m; });
}

inline reference::Face_list face_list(const Control_mesh& mesh)
{
  return reference::Face_list(int(mesh.points.size()), mesh.faces);
}

inline bool is_closed(const Control_mesh& mesh)
{
  const reference::Face_list list = face_list(mesh);
  for (const auto& [a, b] : list.edges())
    if (list.is_border(a, b)) return false;
  return true;
}

inline bool has_isolated_vertex(const Control_mesh& mesh)
{
  const reference::Face_list list = face_list(mesh);
  for (int v = 0; v < list.number_of_vertices(); ++v)
    if (list.ring(v).empty()) return true;
  return false;
}

// Whether no vertex joins several fans of faces.
inline bool is_without_bow_tie(const Control_mesh& mesh)
{
  const reference::Face_list list = face_list(mesh);
  std::vector<std::size_t> corners(mesh.points.size(), 0);
  for (const reference::Face& f : mesh.faces)
    for (int v : f) ++corners[std::size_t(v)];
  for (int v = 0; v < list.number_of_vertices(); ++v) {
    const std::size_t n = list.ring(v).size();
    if (n != 0 && corners[std::size_t(v)] != (list.is_border(v) ? n - 1 : n)) return false;
  }
  return true;
}

inline std::vector<int> interior_valences(const Control_mesh& mesh)
{
  const reference::Face_list list = face_list(mesh);
  std::vector<int> valences;
  for (int v = 0; v < list.number_of_vertices(); ++v)
    if (!list.is_border(v) && !list.ring(v).empty()) valences.push_back(int(list.ring(v).size()));
  std::sort(valences.begin(), valences.end());
  valences.erase(std::unique(valences.begin(), valences.end()), valences.end());
  return valences;
}

// --- shapes ---

// Two poles of valence n over a wavy ring.
inline Control_mesh bipyramid(int n)
{
  Control_mesh mesh{"bipyramid " + std::to_string(n), {}, {}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159 * (i + 0.25 * std::sin(2.0 * i)) / n;
    mesh.points.push_back({1.6 * std::cos(angle), 1.4 * std::sin(angle), 0.15 * std::cos(3.0 * i)});
  }
  mesh.points.push_back({0.1, 0.05, 1.3});
  mesh.points.push_back({-0.07, 0.12, -1.2});
  for (int i = 0; i < n; ++i) {
    mesh.faces.push_back({i, (i + 1) % n, n});
    mesh.faces.push_back({(i + 1) % n, i, n + 1});
  }
  return mesh;
}

// Adds a vertex of valence 3 in every `step`-th triangle, somewhat outside of it.
inline Control_mesh with_centers(Control_mesh mesh, std::size_t step)
{
  mesh.name += " with centers";
  const std::size_t number_of_faces = mesh.faces.size();
  for (std::size_t f = 0; f < number_of_faces; f += step) {
    const reference::Face t = mesh.faces[f];
    const int c = int(mesh.points.size());
    Triple center{};
    for (int v : t)
      for (std::size_t k = 0; k < 3; ++k) center[k] += 0.37 * mesh.points[std::size_t(v)][k];
    mesh.points.push_back(center);
    mesh.faces[f] = {t[0], t[1], c};
    mesh.faces.push_back({t[1], t[2], c});
    mesh.faces.push_back({t[2], t[0], c});
  }
  return mesh;
}

// Cuts every polygon into quads about its center.
inline Control_mesh in_quads(const Control_mesh& mesh)
{
  Control_mesh result{mesh.name + " in quads", mesh.points, {}};
  std::map<std::pair<int, int>, int> middle;
  const auto add_mean = [&](const reference::Face& vertices, double factor) {
    Triple mean{};
    for (int v : vertices)
      for (std::size_t k = 0; k < 3; ++k)
        mean[k] += factor * mesh.points[std::size_t(v)][k] / double(vertices.size());
    result.points.push_back(mean);
    return int(result.points.size()) - 1;
  };
  for (const reference::Face& f : mesh.faces)
    for (std::size_t i = 0; i < f.size(); ++i) {
      const int a = f[i], b = f[(i + 1) % f.size()];
      if (middle.count({a, b}) == 0) middle[{a, b}] = middle[{b, a}] = add_mean({a, b}, 1.07);
    }
  for (const reference::Face& f : mesh.faces) {
    const int center = add_mean(f, 1.15);
    for (std::size_t i = 0; i < f.size(); ++i) {
      const int before = f[(i + f.size() - 1) % f.size()], after = f[(i + 1) % f.size()];
      result.faces.push_back({f[i], middle.at({f[i], after}), center, middle.at({before, f[i]})});
    }
  }
  return result;
}

// nx times ny cells that are triangles, quads, or both with a hexagon now and then.
enum class Cells { triangles, quads, mixed };

inline void add_cell(const reference::Face& q, std::size_t index, Cells cells, Faces& faces)
{
  if (cells == Cells::quads || (cells == Cells::mixed && index % 3 != 0)) {
    faces.push_back(q);
  } else if (index % 2 == 0) {
    faces.push_back({q[0], q[1], q[2]});
    faces.push_back({q[0], q[2], q[3]});
  } else {
    faces.push_back({q[0], q[1], q[3]});
    faces.push_back({q[1], q[2], q[3]});
  }
}

// A patch, a tube (closed along x) or a torus.
inline Control_mesh grid(int nx, int ny, bool closed_x, bool closed_y, Cells cells)
{
  Control_mesh mesh{closed_y ? "torus" : closed_x ? "tube" : "patch", {}, {}};
  const int px = closed_x ? nx : nx + 1, py = closed_y ? ny : ny + 1;
  for (int j = 0; j < py; ++j)
    for (int i = 0; i < px; ++i) {
      const double x = i + 0.2 * std::sin(1.7 * i + j), y = j + 0.2 * std::cos(2.1 * j + i);
      const double s = 6.28 * x / nx, t = 6.28 * y / ny;
      if (closed_y)
        mesh.points.push_back(
          {(3 + std::cos(t)) * std::cos(s), (3 + std::cos(t)) * std::sin(s), std::sin(t)});
      else if (closed_x)
        mesh.points.push_back({2 * std::cos(s), 2 * std::sin(s), 0.8 * y});
      else
        mesh.points.push_back({x, y, 0.5 * std::sin(x) * std::cos(0.8 * y)});
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int right = (i + 1) % px, up = (j + 1) % py;
      add_cell({px * j + i, px * j + right, px * up + right, px * up + i}, std::size_t(3 * j + i),
               cells, mesh.faces);
    }
  return mesh;
}

// The sides of a box of unit cells.
inline Control_mesh box_of_cells(const std::array<int, 3>& cells)
{
  Control_mesh mesh{"box of cells", {}, {}};
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = index.try_emplace(p, int(mesh.points.size()));
    if (is_new) mesh.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return it->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < cells[(axis + 1) % 3]; ++i)
        for (int j = 0; j < cells[(axis + 2) % 3]; ++j) {
          reference::Face f;
          for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            std::array<int, 3> p{};
            p[axis] = side * cells[axis];
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = j + dj;
            f.push_back(vertex(p));
          }
          if (side == 0) std::reverse(f.begin(), f.end());
          mesh.faces.push_back(f);
        }
  return mesh;
}

// A prism over an n-gon with a pyramid on top: triangles, quads and the n-gon.
inline Control_mesh house(int n)
{
  Control_mesh mesh{"house " + std::to_string(n), {}, {{}}};
  for (int level = 0; level < 2; ++level)
    for (int i = 0; i < n; ++i) {
      const double angle = 6.28 * (i + 0.3 * std::sin(3.0 * i)) / n;
      mesh.points.push_back(
        {2 * std::cos(angle), 1.7 * std::sin(angle), 1.5 * level - 0.8 + 0.1 * (i % 2)});
    }
  mesh.points.push_back({0.1, -0.2, 1.9});
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.faces[0].insert(mesh.faces[0].begin(), i);
    mesh.faces.push_back({i, j, n + j, n + i});
    mesh.faces.push_back({n + i, n + j, 2 * n});
  }
  return mesh;
}

inline Control_mesh single_polygon(int n)
{
  Control_mesh mesh{"single " + std::to_string(n) + "-gon", {}, {{}}};
  for (int i = 0; i < n; ++i) {
    mesh.points.push_back({std::cos(6.28 * i / n), 1.3 * std::sin(6.28 * i / n), 0.1 * (i % 2)});
    mesh.faces[0].push_back(i);
  }
  return mesh;
}

// The faces about the vertex 0 of valence n: n sectors of a grid with `rings` cells along a side.
inline Control_mesh star(int n, int rings, Cells cells)
{
  const bool triangles = cells == Cells::triangles;
  Control_mesh mesh{"star " + std::to_string(n), {{0, 0, 0}}, {}};
  std::map<std::array<int, 3>, int> index; // (spoke, along it, along the next one)
  const auto vertex = [&](int spoke, int i, int j) {
    if (i == 0 && j == 0) return 0;
    if (i == 0) return index.at({(spoke + 1) % n, j, 0});
    return index.at({spoke, i, j});
  };
  const auto last = [&](int i) { return triangles ? rings - i : rings; };
  for (int s = 0; s < n; ++s)
    for (int i = 1; i <= rings; ++i)
      for (int j = 0; j <= last(i); ++j) {
        const double a = 6.2831853 * s / n, b = 6.2831853 * (s + 1) / n;
        index[{s, i, j}] = int(mesh.points.size());
        mesh.points.push_back({i * std::cos(a) + j * std::cos(b), i * std::sin(a) + j * std::sin(b),
                               0.3 * std::sin(i + 2.0 * j + s)});
      }
  for (int s = 0; s < n; ++s)
    for (int i = 0; i < rings; ++i)
      for (int j = 0; j < last(i); ++j) {
        const int a = vertex(s, i, j), b = vertex(s, i + 1, j), d = vertex(s, i, j + 1);
        if (!triangles) {
          mesh.faces.push_back({a, b, vertex(s, i + 1, j + 1), d});
          continue;
        }
        mesh.faces.push_back({a, b, d});
        if (j + 1 < last(i)) mesh.faces.push_back({b, vertex(s, i + 1, j + 1), d});
      }
  mesh.normals.assign(mesh.points.size(), {0, 0, 0});
  return mesh;
}

// --- operations ---

// Takes faces away at random, a third of them, and keeps a manifold without isolated vertices.
inline Control_mesh part_of(Control_mesh mesh, unsigned seed)
{
  mesh.name = "part of " + mesh.name;
  std::mt19937 generator(seed);
  for (std::size_t left = mesh.faces.size() / 3; left > 0; --left) {
    const std::size_t f = generator() % mesh.faces.size();
    Control_mesh smaller = mesh;
    smaller.faces.erase(smaller.faces.begin() + std::ptrdiff_t(f));
    if (is_without_bow_tie(smaller) && !has_isolated_vertex(smaller)) mesh = smaller;
  }
  return mesh;
}

inline Control_mesh united(Control_mesh a, const Control_mesh& b)
{
  a.name += " and " + b.name;
  const int shift = int(a.points.size());
  for (const Triple& p : b.points) a.points.push_back({p[0] + 7.3, p[1], p[2] - 0.4});
  for (reference::Face f : b.faces) {
    for (int& v : f) v += shift;
    a.faces.push_back(f);
  }
  return a;
}

inline Control_mesh with_isolated_vertices(Control_mesh mesh)
{
  mesh.name += " with isolated vertices";
  for (reference::Face& f : mesh.faces)
    for (int& v : f) v += 1;
  mesh.points.insert(mesh.points.begin(), {9.5, 8.25, 7.125});
  mesh.points.push_back({-9.1, 0.3, 0.7});
  return mesh;
}

} // namespace test_meshes

#endif // CGAL_PN_SUBDIVISION_3_TEST_MESH_SHAPES_H
