// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Calls that fail everywhere, in maps and in allocations: the mesh and its maps are as they were, and serve again.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_FAILING_RUNS_H
#define CGAL_PN_SUBDIVISION_3_TEST_FAILING_RUNS_H

#include "Failing_allocations.h"
#include "Failing_map.h"
#include "Mesh_cases.h"

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <optional>
#include <string>
#include <tuple>
#include <type_traits>

namespace failing_runs {

using namespace mesh_cases;
using failing_maps::User_failure;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

constexpr long any_number = std::numeric_limits<long>::max();

// the calls of all maps, reads among them
inline failing_maps::Calls_left calls_left(any_number, true);

template <class Map>
auto failing(const Map& map)
{
  return failing_maps::failing(map, calls_left);
}

// \name The meshes

struct Compact_surface_mesh
{
  using Mesh = Surface_mesh;
  static constexpr const char* name = "Surface_mesh";
  static void make(const Soup& soup, Mesh& mesh) { build(soup, mesh); }
};

// fewer removed edges and faces than the first round adds, so that both ways of adding occur
struct Surface_mesh_with_garbage
{
  using Mesh = Surface_mesh;
  static constexpr const char* name = "Surface_mesh_with_garbage";
  static void make(const Soup& soup, Mesh& mesh)
  {
    const auto triangle = [&] {
      std::array<Mesh::Vertex_index, 3> v{mesh.add_vertex(), mesh.add_vertex(), mesh.add_vertex()};
      return mesh.add_face(v[0], v[1], v[2]);
    };
    const auto first = triangle();
    build(soup, mesh);
    const auto last = triangle();
    for (auto f : {first, last}) {
      const auto h = mesh.halfedge(f);
      const std::array<Mesh::Vertex_index, 3> v{mesh.source(h), mesh.target(h),
                                                mesh.target(mesh.next(h))};
      CGAL::Euler::remove_face(h, mesh);
      for (auto w : v)
        if (!mesh.is_removed(w)) mesh.remove_vertex(w);
    }
  }
};

struct Plain_polyhedron
{
  using Mesh = Polyhedron;
  static constexpr const char* name = "Polyhedron_3";
  static void make(const Soup& soup, Mesh& mesh) { build(soup, mesh); }
};

struct Maker_names
{
  template <class Maker>
  static std::string GetName(int)
  {
    return Maker::name;
  }
};

// \name What must be as before

// all that BGL shows of a mesh, descriptor by descriptor
template <class Mesh>
struct State
{
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Face = typename Traits::face_descriptor;

  explicit State(const Mesh& mesh)
    : slots{num_vertices(mesh), num_halfedges(mesh), num_faces(mesh)}
    , coordinates(points(mesh))
  {
    for (auto v : vertices(mesh)) vertex.emplace_back(v, halfedge(v, mesh));
    for (auto h : halfedges(mesh))
      edge.emplace_back(h, opposite(h, mesh), next(h, mesh), prev(h, mesh), target(h, mesh),
                        face(h, mesh));
    for (auto f : faces(mesh)) polygon.emplace_back(f, halfedge(f, mesh));
    if constexpr (std::is_same_v<Mesh, Surface_mesh>)
      slots.insert(slots.end(), {mesh.number_of_removed_vertices(), mesh.number_of_removed_edges(),
                                 mesh.number_of_removed_faces()});
  }
  bool operator==(const State& s) const
  {
    return slots == s.slots && vertex == s.vertex && edge == s.edge && polygon == s.polygon &&
           coordinates == s.coordinates;
  }

  std::vector<std::size_t> slots; // removed elements included
  std::vector<std::pair<Vertex, Halfedge>> vertex;
  std::vector<std::tuple<Halfedge, Halfedge, Halfedge, Halfedge, Vertex, Face>> edge;
  std::vector<std::pair<Face, Halfedge>> polygon;
  std::vector<Triple> coordinates;
};

// properties of a Surface_mesh's user, with default values whose copies allocate
template <class Mesh>
struct Properties
{
  explicit Properties(Mesh&) {}
  std::vector<std::string> all(const Mesh&) const { return {}; }
};
template <>
struct Properties<Surface_mesh>
{
  Surface_mesh::Property_map<Surface_mesh::Vertex_index, std::string> vertex;
  Surface_mesh::Property_map<Surface_mesh::Edge_index, std::string> edge;
  Surface_mesh::Property_map<Surface_mesh::Halfedge_index, std::string> halfedge;
  Surface_mesh::Property_map<Surface_mesh::Face_index, std::string> face;

  explicit Properties(Surface_mesh& mesh)
  {
    const std::string fallback = "a default value too long to be kept inside of a string";
    const auto add = [&](auto& map, const auto& elements, const char* kind) {
      using Map = std::decay_t<decltype(map)>;
      using Element = typename boost::property_traits<Map>::key_type;
      map = mesh.add_property_map<Element, std::string>("u", fallback).first;
      for (auto x : elements) map[x] = kind + std::to_string(int(x));
    };
    add(vertex, mesh.vertices(), "vertex ");
    add(edge, mesh.edges(), "edge ");
    add(halfedge, mesh.halfedges(), "half-edge ");
    add(face, mesh.faces(), "face ");
  }
  std::vector<std::string> all(const Surface_mesh& mesh) const
  {
    std::vector<std::string> result;
    for (auto v : mesh.vertices()) result.push_back(vertex[v]);
    for (auto e : mesh.edges()) result.push_back(edge[e]);
    for (auto h : mesh.halfedges()) result.push_back(halfedge[h]);
    for (auto f : mesh.faces()) result.push_back(face[f]);
    return result;
  }
};

// a mesh with all that it may have
template <class Maker_>
struct Tagged
{
  using Maker = Maker_;
  using Mesh = typename Maker::Mesh;
  template <class Tag>
  using Map = typename boost::property_map<Mesh, Tag>::type;

  explicit Tagged(const Soup& soup)
  {
    Maker::make(soup, mesh);
    normals = get(CGAL::dynamic_vertex_property_t<Vector>(), mesh);
    sharp = get(CGAL::dynamic_edge_property_t<double>(), mesh);
    corners = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    corner_normals = get(CGAL::dynamic_halfedge_property_t<Vector>(), mesh);
    charts = get(CGAL::dynamic_halfedge_property_t<double>(), mesh);
    ids = get(CGAL::dynamic_face_property_t<int>(), mesh);
    put_normals(mesh_cases::normals(soup), mesh, normals);
    int i = 0;
    for (auto e : edges(mesh)) put(sharp, e, ++i % 3 == 0 ? 1.5 : 0);
    for (auto v : vertices(mesh)) put(corners, v, ++i % 5 == 0 ? 1 : 0);
    for (auto f : faces(mesh)) put(ids, f, ++i);
    for (auto h : halfedges(mesh)) {
      put(corner_normals, h, ++i % 4 == 0 ? CGAL::NULL_VECTOR : Vector(0.1 * (i % 7), 0.2, 1));
      const bool is_odd = !is_border(h, mesh) && get(ids, face(h, mesh)) % 2 == 1;
      put(charts, h, get(corners, target(h, mesh)) + (is_odd ? 100 : 0)); // with seams
    }
    properties.emplace(mesh);
  }
  template <class... Maps>
  auto creased(const Maps&... maps) const
  {
    const auto [s, c, n] = std::make_tuple(maps...);
    return params::number_of_iterations(2)
      .edge_is_constrained_map(s)
      .vertex_is_constrained_map(c)
      .vertex_normal_map(n);
  }

  // everything, element by element
  auto state() const
  {
    std::vector<double> numbers;
    std::vector<Vector> of_corners;
    for (auto e : edges(mesh)) numbers.push_back(get(sharp, e));
    for (auto v : vertices(mesh)) numbers.push_back(get(corners, v));
    for (auto f : faces(mesh)) numbers.push_back(get(ids, f));
    for (auto h : halfedges(mesh)) {
      numbers.push_back(get(charts, h));
      of_corners.push_back(get(corner_normals, h));
    }
    return std::make_tuple(State<Mesh>(mesh), values(mesh, normals), numbers, of_corners,
                           properties->all(mesh));
  }

  Mesh mesh;
  Map<CGAL::dynamic_vertex_property_t<Vector>> normals;
  Map<CGAL::dynamic_edge_property_t<double>> sharp;
  Map<CGAL::dynamic_vertex_property_t<double>> corners;
  Map<CGAL::dynamic_halfedge_property_t<Vector>> corner_normals;
  Map<CGAL::dynamic_halfedge_property_t<double>> charts;
  Map<CGAL::dynamic_face_property_t<int>> ids;
  std::optional<Properties<Mesh>> properties;
};

// \name Calls that may fail

enum class Failing { maps, allocations };

// Lets the n-th call or allocation fail for n = 1, 2, ... until none fails; after each all must be as before, and
// in the end the job is done as if nothing had been. Returns how many failed.
template <class Maker, class Job>
long fail_everywhere(const Soup& soup, const Job& job, Failing what, bool has_vertex_normals = true)
{
  Tagged<Maker> tagged(soup), untroubled(soup);
  job(untroubled);
  const auto state = tagged.state();
  for (long k = 1;; ++k) {
    std::string failed;
    try {
      const failing_allocations::Allocation_limit limit(what == Failing::maps ? any_number : k);
      calls_left.number = what == Failing::maps ? k - 1 : any_number;
      job(tagged);
    } catch (const User_failure&) {
      failed = "a map";
    } catch (const std::bad_alloc&) {
      failed = "an allocation";
    }
    calls_left.number = any_number;
    if (failed.empty()) {
      EXPECT_EQ(points(tagged.mesh), points(untroubled.mesh));
      EXPECT_EQ(faces_of(tagged.mesh), faces_of(untroubled.mesh));
      EXPECT_TRUE(is_linked(tagged.mesh));
      if (has_vertex_normals) { // else, those of new elements are anything
        EXPECT_EQ(values(tagged.mesh, tagged.normals), values(untroubled.mesh, untroubled.normals));
      }
      return k - 1;
    }
    const bool is_as_before = tagged.state() == state;
    EXPECT_TRUE(is_as_before) << "after failure " << k << " of " << failed;
    if (!is_as_before) return k;
  }
}

} // namespace failing_runs

#endif // CGAL_PN_SUBDIVISION_3_TEST_FAILING_RUNS_H
