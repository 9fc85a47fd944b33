// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The same subdivision for every type of mesh and every kind of property map.

#include "Mesh_type_cases.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <set>
#include <string>

using namespace mesh_type_cases;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

// A mesh of the user's own, derived from Surface_mesh as CGAL's manual shows.
struct Named_mesh : CGAL::Surface_mesh<Kernel::Point_3>
{
  std::string name;
};
#define CGAL_GRAPH_TRAITS_INHERITANCE_CLASS_NAME Named_mesh
#define CGAL_GRAPH_TRAITS_INHERITANCE_BASE_CLASS_NAME CGAL::Surface_mesh<Kernel::Point_3>
#include <CGAL/boost/graph/graph_traits_inheritance_macros.h>

namespace {

// the number of border half-edges that vertices with a border do not show
std::size_t hidden_borders(const Mesh& mesh)
{
  std::size_t n = 0;
  for (auto v : mesh.vertices()) {
    if (mesh.is_isolated(v)) continue;
    bool border = false;
    for (auto h : CGAL::halfedges_around_target(v, mesh)) border = border || mesh.is_border(h);
    n += border != mesh.is_border(v, false);
  }
  return n;
}

TEST(Mesh_types, SurfaceMeshWithEpick)
{
  expect_same_as_surface_mesh<Epick, CGAL::Surface_mesh<Epick::Point_3>>();
}

TEST(Mesh_types, DerivedFromSurfaceMesh)
{
  expect_same_as_surface_mesh<Kernel, Named_mesh>();
}

TEST(Mesh_types, Polyhedron)
{
  expect_same_as_surface_mesh<Kernel, CGAL::Polyhedron_3<Kernel>>();
  expect_same_as_surface_mesh<Epick, CGAL::Polyhedron_3<Epick>>();
  expect_same_as_surface_mesh<Kernel,
                              CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>();
}

TEST(Mesh_types, PolyhedronIsValidAfterNormalizingTheBorder)
{
  for (const Case& c : cases()) {
    CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3> mesh;
    build(c.soup, mesh);
    subdivide(c, mesh, params::number_of_iterations(2));
    mesh.normalize_border();
    EXPECT_TRUE(mesh.is_valid(false, 3)) << c.name;
  }
}

TEST(Mesh_types, SurfaceMeshKeepsItsBorderConvention)
{
  for (const Case& c : cases())
    for (bool with_removed_elements : {false, true}) {
      Mesh mesh;
      build(c.soup, mesh);
      if (with_removed_elements) mesh.remove_vertex(mesh.add_vertex());
      subdivide(c, mesh, params::number_of_iterations(2));
      EXPECT_EQ(hidden_borders(mesh), 0u) << c.name;
      EXPECT_TRUE(mesh.is_valid(false)) << c.name;
    }
}

// \name Property maps of the user's

// those of the mesh stay as they are
template <class M>
void expect_same_with_associative_maps()
{
  using Vertex = typename boost::graph_traits<M>::vertex_descriptor;
  const Kernel::Point_3 origin(0, 0, 0);
  for (const Case& c : cases()) {
    M mesh;
    std::map<Vertex, Kernel::Point_3> point_of;
    std::map<Vertex, Vector> normal_of;
    const boost::associative_property_map p(point_of);
    build(c.soup, mesh, p);
    const auto of_mesh = get(CGAL::vertex_point, mesh);
    for (auto v : vertices(mesh)) put(of_mesh, v, origin);
    const Result result = with_maps(c, mesh, p, boost::associative_property_map(normal_of));
    EXPECT_TRUE(result == reference(c)) << c.name;
    auto v = vertices(mesh).begin();
    for (std::size_t i = 0; i < c.soup.points.size(); ++i) EXPECT_EQ(get(of_mesh, *v++), origin);
  }
}

TEST(Property_maps, Associative)
{
  expect_same_with_associative_maps<Mesh>();
  expect_same_with_associative_maps<CGAL::Polyhedron_3<Kernel>>();
}

TEST(Property_maps, VectorsWithAnIndexMap)
{
  for (const Case& c : cases()) {
    Mesh mesh;
    const auto index = get(boost::vertex_index, mesh);
    const Result expected = reference(c);
    std::vector<Kernel::Point_3> point_of(expected.points.size(), CGAL::ORIGIN);
    std::vector<Vector> normal_of(expected.points.size(), CGAL::NULL_VECTOR);
    const auto p = boost::make_iterator_property_map(point_of.begin(), index);
    const auto n = boost::make_iterator_property_map(normal_of.begin(), index);
    build(c.soup, mesh, p);
    EXPECT_TRUE(with_maps(c, mesh, p, n) == expected) << c.name;
  }
}

TEST(Property_maps, DynamicPoints)
{
  for (const Case& c : cases()) {
    Mesh mesh;
    const auto p = get(CGAL::dynamic_vertex_property_t<Kernel::Point_3>(), mesh);
    EXPECT_TRUE(with_dynamic_normals<Kernel>(c, mesh, p) == reference(c)) << c.name;
  }
}

// Points of EPICK in the mesh, the map gives those of another kernel.
TEST(Property_maps, PointsOfAnotherKernelDecideTheNumberType)
{
  using Float = CGAL::Simple_cartesian<float>;
  CGAL::Surface_mesh<Epick::Point_3> mesh;
  auto p = mesh.add_property_map<Mesh::Vertex_index, Float::Point_3>("p").first;
  build(cube(), mesh, p);
  PN::CatmullClark_subdivision(mesh, params::vertex_point_map(p));
  CGAL::Surface_mesh<Float::Point_3> expected;
  build(cube(), expected);
  PN::CatmullClark_subdivision(expected);
  EXPECT_EQ(values(mesh, p), points(expected));
}

// \name Removed elements of a Surface_mesh

struct Properties
{
  Mesh::Property_map<Mesh::Vertex_index, int> vertex;
  Mesh::Property_map<Mesh::Halfedge_index, int> halfedge;
  Mesh::Property_map<Mesh::Edge_index, int> edge;
  Mesh::Property_map<Mesh::Face_index, std::string> face;
};

// each element gets its own value
Properties add_properties(Mesh& mesh)
{
  Properties p{mesh.add_property_map<Mesh::Vertex_index, int>("int", -1).first,
               mesh.add_property_map<Mesh::Halfedge_index, int>("int", -2).first,
               mesh.add_property_map<Mesh::Edge_index, int>("int", -3).first,
               mesh.add_property_map<Mesh::Face_index, std::string>("string", "new").first};
  for (auto v : mesh.vertices()) p.vertex[v] = int(v);
  for (auto h : mesh.halfedges()) p.halfedge[h] = int(h);
  for (auto e : mesh.edges()) p.edge[e] = int(e);
  for (auto f : mesh.faces()) p.face[f] = std::to_string(int(f));
  return p;
}

// the case's mesh among removed vertices, edges and faces: at the front and at the end
Mesh with_garbage(const Soup& soup)
{
  Mesh mesh;
  const auto other = [&](double x) {
    const auto h =
      CGAL::make_tetrahedron(Kernel::Point_3(x, 0, 0), Kernel::Point_3(x, 1, 0),
                             Kernel::Point_3(x, 0, 1), Kernel::Point_3(x + 1, 0, 0), mesh);
    std::vector<Mesh::Face_index> all;
    for (auto f : CGAL::faces_around_target(h, mesh)) all.push_back(f);
    all.push_back(mesh.face(mesh.opposite(mesh.prev(h))));
    return all;
  };
  std::vector<Mesh::Face_index> removed = other(7);
  build(soup, mesh);
  const auto back = other(9);
  removed.insert(removed.end(), back.begin(), back.end());
  for (auto f : removed) CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  return mesh;
}

TEST(Removed_elements, ResultIsThatOfTheCompactMesh)
{
  for (const Case& c : cases()) {
    Mesh mesh = with_garbage(c.soup);
    ASSERT_EQ(mesh.number_of_removed_vertices(), 8u);
    ASSERT_EQ(mesh.number_of_removed_edges(), 12u);
    ASSERT_EQ(mesh.number_of_removed_faces(), 8u);
    ASSERT_EQ(mesh.number_of_faces(), c.soup.faces.size());
    Mesh compact = built<Mesh>(c.soup);
    for (Mesh* m : {&mesh, &compact}) {
      auto n = m->add_property_map<Mesh::Vertex_index, Vector>("n").first;
      put_normals(normals(c.soup), *m, n);
      subdivide(c, *m, params::number_of_iterations(2).vertex_normal_map(n));
    }
    EXPECT_TRUE(is_linked(mesh));
    EXPECT_TRUE(mesh.is_valid(false));
    EXPECT_EQ(points(mesh), points(compact)) << c.name;
    EXPECT_EQ(values(mesh, mesh.add_property_map<Mesh::Vertex_index, Vector>("n").first),
              values(compact, compact.add_property_map<Mesh::Vertex_index, Vector>("n").first));
    EXPECT_EQ(faces_of(mesh), faces_of(compact)) << c.name;
    EXPECT_EQ(mesh.number_of_edges(), compact.number_of_edges());
    // removed elements stay removed, until the user collects them
    EXPECT_EQ(mesh.number_of_removed_vertices(), 8u);
    EXPECT_EQ(mesh.number_of_removed_edges(), 12u);
    EXPECT_EQ(mesh.number_of_removed_faces(), 8u);
    EXPECT_TRUE(mesh.does_recycle_garbage());
    mesh.collect_garbage();
    EXPECT_EQ(mesh.num_faces(), compact.num_faces());
    EXPECT_TRUE(is_linked(mesh));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  }
}

// Maps of the mesh follow when it is made compact; others would not, hence it is not.
TEST(Removed_elements, DooSabinKeepsPointsAndNormalsTogether)
{
  for (const bool own_map : {false, true}) {
    Mesh mesh = with_garbage(cube()), compact = built<Mesh>(cube());
    std::map<Mesh::Vertex_index, Vector> outside;
    auto n = mesh.add_property_map<Mesh::Vertex_index, Vector>("n").first;
    auto compact_n = compact.add_property_map<Mesh::Vertex_index, Vector>("n").first;
    put_normals(normals(cube()), mesh, n);
    put_normals(normals(cube()), compact, compact_n);
    for (auto v : mesh.vertices()) outside[v] = n[v];
    const boost::associative_property_map<std::map<Mesh::Vertex_index, Vector>> outside_n(outside);
    if (own_map)
      PN::DooSabin_subdivision(mesh, params::vertex_normal_map(n));
    else
      PN::DooSabin_subdivision(mesh, params::vertex_normal_map(outside_n));
    PN::DooSabin_subdivision(compact, params::vertex_normal_map(compact_n));

    EXPECT_EQ(mesh.has_garbage(), !own_map);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    std::map<Mesh::Point, Vector> expected;
    for (auto v : compact.vertices()) expected[compact.point(v)] = compact_n[v];
    ASSERT_EQ(mesh.number_of_vertices(), expected.size());
    for (auto v : mesh.vertices()) {
      ASSERT_EQ(expected.count(mesh.point(v)), 1u);
      EXPECT_EQ(own_map ? n[v] : outside[v], expected[mesh.point(v)]);
    }
  }
}

// \name Property maps that the user holds while the mesh is subdivided

TEST(Properties_of_the_user, StayValidAndKeepTheirValues)
{
  for (const Case& c : cases())
    for (bool garbage : {false, true}) {
      Mesh mesh;
      if (garbage)
        mesh = with_garbage(c.soup);
      else
        build(c.soup, mesh);
      const Mesh old = mesh;
      const Properties p = add_properties(mesh);
      subdivide(c, mesh, params::number_of_iterations(1));
      SCOPED_TRACE(std::string(c.name) + (garbage ? " with garbage" : ""));

      std::map<int, int> count;
      for (auto v : mesh.vertices())
        if (std::size_t(v) < old.num_vertices())
          EXPECT_EQ(p.vertex[v], int(v));
        else
          EXPECT_EQ(p.vertex[v], -1);

      // an old face's value is on exactly one of its children, whose corners are among its own
      // corners, the new vertices of its edges and its own new vertex
      const std::size_t vertices = old.num_vertices(), edges = old.number_of_edges();
      const auto old_position = [](const auto& range, auto x) {
        return std::size_t(std::distance(range.begin(), std::find(range.begin(), range.end(), x)));
      };
      std::map<std::string, std::vector<Mesh::Face_index>> by_value;
      for (auto f : mesh.faces()) by_value[p.face[f]].push_back(f);
      EXPECT_EQ(by_value.size(), old.number_of_faces() + 1);
      for (auto f : old.faces()) {
        const auto& children = by_value[std::to_string(int(f))];
        ASSERT_EQ(children.size(), 1u);
        std::set<std::size_t> corners{vertices + edges + old_position(old.faces(), f)};
        for (auto h : CGAL::halfedges_around_face(old.halfedge(f), old)) {
          corners.insert(old.target(h));
          corners.insert(vertices + old_position(old.edges(), old.edge(h)));
        }
        for (auto v : CGAL::vertices_around_face(mesh.halfedge(children[0]), mesh))
          EXPECT_EQ(corners.count(v), 1u);
      }

      // an old edge's value is on exactly one edge, one of its halves; a half-edge's likewise
      std::map<int, std::vector<Mesh::Edge_index>> edges_by_value;
      for (auto e : mesh.edges()) edges_by_value[p.edge[e]].push_back(e);
      EXPECT_EQ(edges_by_value.size(), old.number_of_edges() + 1);
      for (auto e : old.edges()) {
        const auto& halves = edges_by_value[int(e)];
        ASSERT_EQ(halves.size(), 1u);
        const auto h = mesh.halfedge(halves[0]), g = old.halfedge(e);
        EXPECT_TRUE(mesh.source(h) == old.source(g) || mesh.target(h) == old.target(g));
        EXPECT_EQ(p.halfedge[h], int(g));
        EXPECT_EQ(p.halfedge[mesh.opposite(h)], int(old.opposite(g)));
        const auto new_vertex = mesh.source(h) == old.source(g) ? mesh.target(h) : mesh.source(h);
        EXPECT_GE(std::size_t(new_vertex), old.num_vertices());
      }
    }
}

// \name geom_traits and visitor

struct Visitor
{
  std::vector<std::pair<unsigned, std::size_t>>* seen;
  void round_done(unsigned k, std::size_t n) { seen->emplace_back(k, n); }
};

// without faces, too
TEST(Visitor_parameter, IsCalledAfterEachRound)
{
  Mesh mesh = built<Mesh>(cube()), lonely;
  lonely.add_vertex(Kernel::Point_3(1, 2, 3));
  std::vector<std::pair<unsigned, std::size_t>> seen;
  for (Mesh* m : {&mesh, &lonely})
    PN::CatmullClark_subdivision(*m, params::number_of_iterations(3).visitor(Visitor{&seen}));
  const std::vector<std::pair<unsigned, std::size_t>> expected{{1, 24}, {2, 96}, {3, 384},
                                                               {1, 0},  {2, 0},  {3, 0}};
  EXPECT_EQ(seen, expected);
}

// Computing in float must show: the number type is that of the traits.
TEST(Geom_traits_parameter, DecidesTheNumberType)
{
  const auto subdivided = [](const auto& np) {
    Mesh mesh;
    build(mixed_with_border(), mesh);
    PN::CatmullClark_subdivision(mesh, np.number_of_iterations(2));
    return points(mesh);
  };
  const auto plain = subdivided(params::geom_traits(Kernel()));
  const auto in_float = subdivided(params::geom_traits(CGAL::Simple_cartesian<float>()));
  ASSERT_EQ(plain.size(), in_float.size());
  double largest = 0;
  for (std::size_t i = 0; i < plain.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(in_float[i][k], double(float(in_float[i][k])));
      largest = std::max(largest, std::abs(plain[i][k] - in_float[i][k]));
    }
  EXPECT_GT(largest, 1e-9);
  EXPECT_LT(largest, 1e-5);
}

// --- property maps of a Surface_mesh by name, with CGAL 5 and with CGAL 6 ---

using CGAL::PN_subdivision_3::internal::find_property_map;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

template <class Element, class Value>
void expect_found_by_name_and_type(Mesh mesh, const Value& value)
{
  const Element first(0);
  EXPECT_FALSE((find_property_map<Element, Value>(mesh, "x")));
  mesh.add_property_map<Element, Value>("x").first[first] = value;
  const Mesh copy = mesh;
  const auto map = find_property_map<Element, Value>(copy, "x");
  ASSERT_TRUE(map);
  EXPECT_EQ((*map)[first], value);
  EXPECT_FALSE((find_property_map<Element, Value>(copy, "y")));
  EXPECT_FALSE((find_property_map<Element, char>(copy, "x")));
}

TEST(Property_maps, AreFoundByNameAndType)
{
  Mesh mesh;
  mesh.add_face(mesh.add_vertex({0, 0, 0}), mesh.add_vertex({1, 0, 0}), mesh.add_vertex({0, 1, 0}));
  expect_found_by_name_and_type<Mesh::Vertex_index>(mesh, Kernel::Vector_3(1, 2, 3));
  expect_found_by_name_and_type<Mesh::Halfedge_index>(mesh, Kernel::Vector_3(4, 5, 6));
  expect_found_by_name_and_type<Mesh::Edge_index>(mesh, 0.5);
  expect_found_by_name_and_type<Mesh::Face_index>(mesh, std::string("face"));
  const auto points = find_property_map<Mesh::Vertex_index, Kernel::Point_3>(mesh, "v:point");
  ASSERT_TRUE(points);
  EXPECT_EQ((*points)[Mesh::Vertex_index(1)], Kernel::Point_3(1, 0, 0));
}

} // namespace
