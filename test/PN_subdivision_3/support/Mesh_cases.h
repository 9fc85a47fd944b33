// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Small control meshes of any type with control normals, and what the tests compare of meshes.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_MESH_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_MESH_CASES_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace mesh_cases {

using Triple = std::array<double, 3>;
using Polygon = std::vector<std::size_t>;

struct Soup
{
  std::vector<Triple> points;
  std::vector<Polygon> faces;
};

inline Soup cube()
{
  return {{{-1, -1, -1},
           {1, -1, -1},
           {1, 1, -1},
           {-1, 1, -1},
           {-1, -1, 1},
           {1, -1, 1},
           {1, 1, 1},
           {-1, 1, 1}},
          {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

inline Soup tetrahedron()
{
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

// a quad, a triangle and a pentagon about an interior vertex, and a component of two quads
inline Soup mixed_with_border()
{
  return {{{0, 0, 0.4},
           {1, 0.1, 0},
           {0.9, 1.1, 0.2},
           {-0.2, 1, 0.1},
           {-1.2, 0.3, 0},
           {-0.8, -0.9, 0},
           {0.4, -1.2, 0.1},
           {3, 0, 0},
           {4, 0, 0.1},
           {4, 1, 0},
           {3, 1.2, 0.3},
           {5, 0.1, 0.2},
           {5.2, 1, 0}},
          {{0, 1, 2, 3}, {0, 3, 4}, {0, 4, 5, 6, 1}, {7, 8, 9, 10}, {8, 11, 12, 9}}};
}

// a fan of seven triangles about vertex 0, and two more on its rim
inline Soup triangles_with_border()
{
  Soup soup{{{0, 0, 0.5}}, {}};
  for (int i = 0; i < 7; ++i)
    soup.points.push_back({std::cos(0.9 * i), 1.1 * std::sin(0.9 * i), 0.1 * (i % 3)});
  for (std::size_t i = 1; i <= 7; ++i) soup.faces.push_back({0, i, i % 7 + 1});
  soup.points.push_back({1.6, 0.8, 0.1});
  soup.points.push_back({-1.7, 0.2, -0.2});
  soup.faces.push_back({2, 1, 8});
  soup.faces.push_back({5, 4, 9});
  return soup;
}

// with apexes of valence n, vertices 0 and n + 1; the x of the first one is 1, that of all others 0
inline Soup bipyramid(std::size_t n)
{
  Soup soup;
  for (std::size_t i = 0; i < n + 2; ++i)
    soup.points.push_back({i == 0 ? 1. : 0., double(i * i % 5), double(i % 3)});
  for (std::size_t i = 1; i <= n; ++i) {
    soup.faces.push_back({0, i, i % n + 1});
    soup.faces.push_back({n + 1, i % n + 1, i});
  }
  return soup;
}

// no unit vectors, none of them the surface's; the last one is zero
inline std::vector<Triple> normals(const Soup& soup)
{
  std::vector<Triple> result;
  for (const Triple& p : soup.points)
    result.push_back({p[0] + 0.2 * p[1], p[1] - 0.1, p[2] + 0.3 + 0.1 * p[0] * p[0]});
  result.back() = {0, 0, 0};
  return result;
}

// of a soup, or of whatever else has points and faces
template <class Shape, class Mesh, class Point_map>
void build(const Shape& shape, Mesh& mesh, Point_map points)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Point = typename boost::property_traits<Point_map>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  std::vector<Vertex> v;
  for (const Triple& p : shape.points) {
    v.push_back(add_vertex(mesh));
    set_halfedge(v.back(), boost::graph_traits<Mesh>::null_halfedge(), mesh);
    put(points, v.back(), Point(FT(p[0]), FT(p[1]), FT(p[2])));
  }
  for (const auto& f : shape.faces) {
    std::vector<Vertex> corners;
    for (const auto i : f) corners.push_back(v[std::size_t(i)]);
    ASSERT_NE(CGAL::Euler::add_face(corners, mesh), boost::graph_traits<Mesh>::null_face());
  }
}

template <class Shape, class Mesh>
void build(const Shape& shape, Mesh& mesh)
{
  build(shape, mesh, get(CGAL::vertex_point, mesh));
}

template <class Mesh, class Shape = Soup>
Mesh built(const Shape& shape)
{
  Mesh mesh;
  build(shape, mesh);
  return mesh;
}

template <class Mesh, class Normal_map>
void put_normals(const std::vector<Triple>& n, const Mesh& mesh, Normal_map map)
{
  using Normal = typename boost::property_traits<Normal_map>::value_type;
  std::size_t i = 0;
  for (auto v : vertices(mesh)) {
    put(map, v, Normal(n[i][0], n[i][1], n[i][2]));
    ++i;
  }
}

template <class Mesh, class Map>
std::vector<Triple> values(const Mesh& mesh, Map map)
{
  std::vector<Triple> result;
  for (auto v : vertices(mesh)) {
    const auto x = get(map, v);
    result.push_back({CGAL::to_double(x.x()), CGAL::to_double(x.y()), CGAL::to_double(x.z())});
  }
  return result;
}

template <class Mesh>
std::vector<Triple> points(const Mesh& mesh)
{
  return values(mesh, get(CGAL::vertex_point, mesh));
}

// the faces as cycles of positions of vertices, each from its least one on, sorted
template <class Mesh>
std::vector<Polygon> faces_of(const Mesh& mesh)
{
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> position;
  for (auto v : vertices(mesh)) position.emplace(v, position.size());
  std::vector<Polygon> result;
  for (auto f : faces(mesh)) {
    Polygon p;
    for (auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) p.push_back(position.at(v));
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    result.push_back(p);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// whether a mesh (that may have vertices without edges) is linked as its type promises
template <class Mesh>
::testing::AssertionResult is_linked(const Mesh& mesh)
{
  using Traits = boost::graph_traits<Mesh>;
  const auto fail = [](const char* what) { return ::testing::AssertionFailure() << what; };
  std::size_t border = 0, corners = 0;
  for (auto h : halfedges(mesh)) {
    if (prev(next(h, mesh), mesh) != h || next(prev(h, mesh), mesh) != h)
      return fail("next and prev differ");
    if (target(opposite(next(h, mesh), mesh), mesh) != target(h, mesh))
      return fail("next does not continue");
    if (face(next(h, mesh), mesh) != face(h, mesh)) return fail("next has another face");
    if (opposite(opposite(h, mesh), mesh) != h || opposite(h, mesh) == h)
      return fail("opposite is no involution");
    border += face(h, mesh) == Traits::null_face();
  }
  std::size_t edge_count = 0;
  for (auto e : edges(mesh)) {
    ++edge_count;
    if (edge(halfedge(e, mesh), mesh) != e) return fail("edge of half-edge of edge");
  }
  for (auto f : faces(mesh)) {
    if (face(halfedge(f, mesh), mesh) != f) return fail("half-edge of face has another face");
    corners += degree(f, mesh);
  }
  if (corners + border != 2 * edge_count) return fail("faces do not reach all half-edges");
  std::size_t fans = 0;
  for (auto v : vertices(mesh)) {
    if (halfedge(v, mesh) == Traits::null_halfedge()) continue;
    if (target(halfedge(v, mesh), mesh) != v) return fail("half-edge of vertex has another target");
    for (auto h : CGAL::halfedges_around_target(v, mesh)) {
      if (target(h, mesh) != v) return fail("fan of vertex leaves it");
      ++fans;
    }
  }
  if (fans != 2 * edge_count) return fail("fans of vertices do not reach all half-edges");
  return ::testing::AssertionSuccess();
}

} // namespace mesh_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_MESH_CASES_H
