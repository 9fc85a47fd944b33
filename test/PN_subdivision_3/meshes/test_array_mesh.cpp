// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The mesh of the page and of the library for JavaScript: what is made of it is what is made of a Surface_mesh.

#include "Mesh_type_cases.h"

#include "../../../demo/PN_subdivision_3/modeler/graph_traits_Array_mesh.h"

#include <CGAL/PN_limit_surface_3/estimate_curvature.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>

#include <limits>
#include <stdexcept>
#include <utility>

using namespace mesh_type_cases;

namespace {

using Point = Kernel::Point_3;
using Array_mesh = pn_demo::Array_mesh<Point>;
using Array_vertex = Array_mesh::Vertex_index;

Array_mesh copy_of(const Mesh& mesh)
{
  Array_mesh result;
  result.resize(mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces());
  for (auto h : mesh.halfedges()) {
    const Array_mesh::Halfedge_index g(h.idx());
    result.set_target(g, Array_vertex(mesh.target(h)));
    result.set_next(g, Array_mesh::Halfedge_index(mesh.next(h)));
    if (!mesh.is_border(h)) result.set_face(g, Array_mesh::Face_index(mesh.face(h)));
  }
  for (auto v : mesh.vertices()) {
    result.point(Array_vertex(v)) = mesh.point(v);
    result.set_halfedge(Array_vertex(v), Array_mesh::Halfedge_index(mesh.halfedge(v)));
  }
  for (auto f : mesh.faces())
    result.set_halfedge(Array_mesh::Face_index(f), Array_mesh::Halfedge_index(mesh.halfedge(f)));
  return result;
}

template <class M>
std::vector<std::uint32_t> connectivity(const M& mesh)
{
  std::vector<std::uint32_t> all{mesh.number_of_vertices(), mesh.number_of_faces()};
  for (auto h : mesh.halfedges())
    all.insert(all.end(), {std::uint32_t(mesh.target(h)), std::uint32_t(mesh.source(h)),
                           std::uint32_t(mesh.next(h)), std::uint32_t(mesh.prev(h)),
                           std::uint32_t(mesh.face(h))});
  for (auto v : mesh.vertices()) all.push_back(mesh.halfedge(v));
  for (auto f : mesh.faces()) all.push_back(mesh.halfedge(f));
  return all;
}

template <class M>
auto add_normals(const Case& c, M& mesh)
{
  const auto map = mesh.template add_property_map<typename M::Vertex_index, Vector>("n").first;
  put_normals(normals(c.soup), mesh, map);
  return map;
}

struct Both
{
  explicit Both(const Case& c)
  {
    build(c.soup, surface_mesh);
    array_mesh = copy_of(surface_mesh);
  }
  Mesh surface_mesh;
  Array_mesh array_mesh;
};

} // namespace

TEST(Array_mesh, IsSubdividedAsSurfaceMeshIs)
{
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const auto expect_same = [&](const auto& subdivide) {
      Both both(c);
      const auto expected = add_normals(c, both.surface_mesh);
      const auto n = add_normals(c, both.array_mesh);
      subdivide(both.surface_mesh, params::number_of_iterations(2).vertex_normal_map(expected));
      subdivide(both.array_mesh, params::number_of_iterations(2).vertex_normal_map(n));
      EXPECT_EQ(connectivity(both.array_mesh), connectivity(both.surface_mesh));
      for (auto v : both.surface_mesh.vertices()) {
        EXPECT_EQ(both.array_mesh.point(Array_vertex(v)), both.surface_mesh.point(v));
        EXPECT_EQ(n[Array_vertex(v)], expected[v]);
      }
    };
    expect_same([&](auto& mesh, const auto& np) { mesh_type_cases::subdivide(c, mesh, np); });
    expect_same([](auto& mesh, const auto& np) { PN::subdivide(mesh, PN::DooSabin_scheme(), np); });
    if (c.loop)
      expect_same([](auto& mesh, const auto& np) { PN::subdivide(mesh, PN::Sqrt3_scheme(), np); });
  }
}

// of which the half-edge's vertices are asked for
TEST(Array_mesh, HasTheSharpEdgesOfSurfaceMesh)
{
  const auto refined = [](auto& mesh) {
    using M = std::decay_t<decltype(mesh)>;
    using Edge = typename M::Edge_index;
    const auto sharp = mesh.template add_property_map<Edge, double>("s", 0).first;
    for (unsigned e = 0; e < 4; ++e) sharp[Edge(e)] = 1 + e;
    PN::subdivide(mesh, PN::CatmullClark_scheme(),
                  params::number_of_iterations(2).edge_is_constrained_map(sharp));
    std::vector<double> values;
    for (auto e : mesh.edges()) values.push_back(sharp[e]);
    for (auto v : mesh.vertices())
      for (int k = 0; k < 3; ++k) values.push_back(mesh.point(v)[k]);
    return values;
  };
  Both both(cases()[0]);
  const std::vector<double> expected = refined(both.surface_mesh);
  EXPECT_EQ(refined(both.array_mesh), expected);
}

TEST(Array_mesh, HasTheCurvaturesOfSurfaceMesh)
{
  const auto curvatures = [](auto& mesh) {
    using M = std::decay_t<decltype(mesh)>;
    using Curvature = PN::Vertex_curvature<Kernel>;
    const auto map = mesh.template add_property_map<typename M::Vertex_index, Curvature>("c").first;
    PN::subdivide(mesh, PN::CatmullClark_scheme());
    PN::estimate_curvature(mesh, map);
    std::vector<double> values;
    for (auto v : mesh.vertices()) values.push_back(map[v].gaussian);
    return values;
  };
  Both both(cases()[1]);
  const std::vector<double> expected = curvatures(both.surface_mesh);
  EXPECT_EQ(curvatures(both.array_mesh), expected);
}

TEST(Array_mesh, RefusedIsLeftAlone)
{
  Both both(cases()[0]);
  Array_mesh& mesh = both.array_mesh;
  mesh.point(Array_vertex(3)) = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  const auto before = connectivity(mesh);
  EXPECT_THROW(PN::subdivide(mesh, PN::CatmullClark_scheme()), std::invalid_argument);
  EXPECT_EQ(connectivity(mesh), before);
}

TEST(Array_mesh, CopiesShareNothing)
{
  Both both(cases()[0]);
  Array_mesh& mesh = both.array_mesh;
  const auto n = add_normals(cases()[0], mesh);
  const Vector kept = n[Array_vertex(0)];
  Array_mesh copy = mesh;
  const auto of_copy = copy.property_map<Array_vertex, Vector>("n");
  ASSERT_TRUE(of_copy.second);
  EXPECT_EQ(of_copy.first[Array_vertex(0)], kept);
  of_copy.first[Array_vertex(0)] = Vector(9, 9, 9);
  copy.point(Array_vertex(0)) = Point(9, 9, 9);
  EXPECT_EQ(n[Array_vertex(0)], kept);
  EXPECT_EQ(mesh.point(Array_vertex(0)), both.surface_mesh.point(Mesh::Vertex_index(0)));
  // maps go with a mesh that is moved, and stay while it grows
  const Array_mesh moved = std::move(mesh);
  const auto of_moved = moved.property_map<Array_vertex, Vector>("n").first;
  EXPECT_EQ(of_moved[Array_vertex(0)], kept);
  n[Array_vertex(0)] = Vector(1, 2, 3);
  EXPECT_EQ(of_moved[Array_vertex(0)], Vector(1, 2, 3));
  // another type is another map
  EXPECT_FALSE((moved.property_map<Array_vertex, double>("n").second));
  copy = moved;
  copy.point(Array_vertex(1)) = Point(7, 7, 7);
  EXPECT_NE(moved.point(Array_vertex(1)), Point(7, 7, 7));
}
