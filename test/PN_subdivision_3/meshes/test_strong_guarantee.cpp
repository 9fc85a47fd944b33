// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Whatever fails, wherever it fails: the mesh and its maps are as they were, and serve again.

#include "Failing_allocations.h"
#include "Failing_map.h"
#include "Mesh_cases.h"
#include "support/Options.h"

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <tuple>
#include <type_traits>

using namespace mesh_cases;
using failing_allocations::Allocation_limit;
using failing_maps::Calls_left;
using failing_maps::User_failure;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

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
    : slots(num_vertices(mesh), num_halfedges(mesh), num_faces(mesh))
    , coordinates(points(mesh))
  {
    for (auto v : vertices(mesh)) vertex.emplace_back(v, halfedge(v, mesh));
    for (auto h : halfedges(mesh))
      edge.emplace_back(h, opposite(h, mesh), next(h, mesh), prev(h, mesh), target(h, mesh),
                        face(h, mesh));
    for (auto f : faces(mesh)) polygon.emplace_back(f, halfedge(f, mesh));
  }
  bool operator==(const State& s) const
  {
    return slots == s.slots && vertex == s.vertex && edge == s.edge && polygon == s.polygon &&
           coordinates == s.coordinates;
  }

  std::tuple<std::size_t, std::size_t, std::size_t> slots; // removed elements included
  std::vector<std::pair<Vertex, Halfedge>> vertex;
  std::vector<std::tuple<Halfedge, Halfedge, Halfedge, Halfedge, Vertex, Face>> edge;
  std::vector<std::pair<Face, Halfedge>> polygon;
  std::vector<Triple> coordinates;
};

// properties of a Surface_mesh's user, with default values whose copies allocate
struct Properties
{
  using Text = std::vector<std::string>;
  Surface_mesh::Property_map<Surface_mesh::Vertex_index, std::string> vertex;
  Surface_mesh::Property_map<Surface_mesh::Edge_index, std::string> edge;
  Surface_mesh::Property_map<Surface_mesh::Halfedge_index, int> halfedge;
  Surface_mesh::Property_map<Surface_mesh::Face_index, std::string> face;

  explicit Properties(Surface_mesh& mesh)
  {
    const std::string fallback = "a default value too long to be kept inside of a string";
    vertex = mesh.add_property_map<Surface_mesh::Vertex_index, std::string>("u", fallback).first;
    edge = mesh.add_property_map<Surface_mesh::Edge_index, std::string>("u", fallback).first;
    halfedge = mesh.add_property_map<Surface_mesh::Halfedge_index, int>("u", -1).first;
    face = mesh.add_property_map<Surface_mesh::Face_index, std::string>("u", fallback).first;
    for (auto v : mesh.vertices()) vertex[v] = "vertex " + std::to_string(int(v));
    for (auto e : mesh.edges()) edge[e] = "edge " + std::to_string(int(e));
    for (auto h : mesh.halfedges()) halfedge[h] = int(h);
    for (auto f : mesh.faces()) face[f] = "face " + std::to_string(int(f));
  }
  bool are_as_before(const Surface_mesh& mesh) const
  {
    for (auto v : mesh.vertices())
      if (vertex[v] != "vertex " + std::to_string(int(v))) return false;
    for (auto e : mesh.edges())
      if (edge[e] != "edge " + std::to_string(int(e))) return false;
    for (auto h : mesh.halfedges())
      if (halfedge[h] != int(h)) return false;
    for (auto f : mesh.faces())
      if (face[f] != "face " + std::to_string(int(f))) return false;
    return true;
  }
};

struct No_properties
{
  explicit No_properties(const Polyhedron&) {}
  bool are_as_before(const Polyhedron&) const { return true; }
};

// \name The meshes

struct Compact_surface_mesh
{
  using Mesh = Surface_mesh;
  using User_properties = Properties;
  static void make(const Soup& soup, Mesh& mesh) { build(soup, mesh); }
  static std::size_t removed(const Mesh& mesh)
  {
    return mesh.number_of_removed_vertices() + mesh.number_of_removed_edges() +
           mesh.number_of_removed_faces();
  }
};

// fewer removed edges and faces than the first round adds, so that both ways of adding occur
struct Surface_mesh_with_garbage : Compact_surface_mesh
{
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
  using User_properties = No_properties;
  static void make(const Soup& soup, Mesh& mesh) { build(soup, mesh); }
  static std::size_t removed(const Mesh&) { return 0; }
};

template <class Maker>
class Strong_guarantee : public ::testing::Test
{};
using Makers = ::testing::Types<Compact_surface_mesh, Surface_mesh_with_garbage, Plain_polyhedron>;
struct Maker_names
{
  template <class Maker>
  static std::string GetName(int)
  {
    if (std::is_same_v<Maker, Compact_surface_mesh>) return "Surface_mesh";
    if (std::is_same_v<Maker, Surface_mesh_with_garbage>) return "Surface_mesh_with_garbage";
    return "Polyhedron_3";
  }
};
TYPED_TEST_SUITE(Strong_guarantee, Makers, Maker_names);

struct Failing_visitor
{
  long* calls_left;
  void round_done(unsigned, std::size_t) const
  {
    if (--*calls_left == 0) throw User_failure();
  }
};

// \name One subdivision that may fail

// Lets the n-th occurrence fail for n = 1, 2, ... until none fails; after each failure all must be
// as before. Returns how many failed.
template <class Maker, class Attempt>
long fail_everywhere(const Soup& soup, const Attempt& attempt)
{
  using Mesh = typename Maker::Mesh;
  Mesh mesh;
  Maker::make(soup, mesh);
  auto n = get(CGAL::dynamic_vertex_property_t<Vector>(), mesh);
  put_normals(normals(soup), mesh, n);
  const typename Maker::User_properties properties(mesh);
  const State<Mesh> state(mesh);
  const auto old_normals = values(mesh, n);
  const std::size_t removed = Maker::removed(mesh);

  Mesh untroubled;
  Maker::make(soup, untroubled);
  auto m = get(CGAL::dynamic_vertex_property_t<Vector>(), untroubled);
  put_normals(normals(soup), untroubled, m);
  const std::string message = attempt(untroubled, m, std::numeric_limits<long>::max());
  EXPECT_EQ(message, "");

  for (long k = 1;; ++k) {
    if (attempt(mesh, n, k).empty()) {
      EXPECT_EQ(points(mesh), points(untroubled));
      EXPECT_EQ(values(mesh, n), values(untroubled, m));
      EXPECT_EQ(faces_of(mesh), faces_of(untroubled));
      EXPECT_TRUE(is_linked(mesh));
      return k - 1;
    }
    const bool as_before = State<Mesh>(mesh) == state && values(mesh, n) == old_normals &&
                           properties.are_as_before(mesh) && Maker::removed(mesh) == removed;
    EXPECT_TRUE(as_before) << "after failure " << k;
    if (!as_before) return k;
  }
}

template <class Tag, class Mesh, class Np>
void subdivide_as_asked(bool loop, Mesh& mesh, const Np& np)
{
  if (loop)
    PN::Loop_subdivision<Tag>(mesh, np);
  else
    PN::CatmullClark_subdivision<Tag>(mesh, np);
}

// returns what failed, nothing if nothing did
template <class Function>
std::string failure_of(const Function& f)
{
  try {
    f();
    return "";
  } catch (const User_failure&) {
    return "user";
  } catch (const std::bad_alloc&) {
    return "memory";
  }
}

template <class Maker, class Tag>
long fail_in_maps(const Soup& soup, bool loop)
{
  return fail_everywhere<Maker>(soup, [&](auto& mesh, auto n, long k) {
    Calls_left left(k - 1, true);
    const auto np = params::number_of_iterations(2)
                      .vertex_point_map(failing(get(CGAL::vertex_point, mesh), left))
                      .vertex_normal_map(failing(n, left));
    return failure_of([&] { subdivide_as_asked<Tag>(loop, mesh, np); });
  });
}

template <class Maker, class Tag>
long fail_in_allocations(const Soup& soup, bool loop, unsigned rounds)
{
  return fail_everywhere<Maker>(soup, [&](auto& mesh, auto n, long k) {
    const auto np = params::number_of_iterations(rounds).vertex_normal_map(n);
    return failure_of([&] {
      const Allocation_limit limit(k);
      subdivide_as_asked<Tag>(loop, mesh, np);
    });
  });
}

// attributes of every kind, which must have their old values after a failure, too
template <class Maker>
long fail_with_attributes()
{
  return fail_everywhere<Maker>(mixed_with_border(), [&](auto& mesh, auto n, long k) {
    auto t = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    auto u = get(CGAL::dynamic_halfedge_property_t<double>(), mesh);
    auto v = get(CGAL::dynamic_halfedge_property_t<double>(), mesh);
    auto id = get(CGAL::dynamic_face_property_t<int>(), mesh);
    auto mark = get(CGAL::dynamic_edge_property_t<int>(), mesh);
    int i = 0;
    for (auto x : vertices(mesh)) put(t, x, ++i);
    for (auto f : faces(mesh)) put(id, f, ++i);
    for (auto e : edges(mesh)) put(mark, e, ++i);
    for (auto h : halfedges(mesh))
      if (!is_border(h, mesh)) {
        put(u, h, get(t, target(h, mesh)) + 100 * (get(id, face(h, mesh)) % 2)); // with seams
        put(v, h, 0.5 * get(u, h));
      }
    const std::string failure = failure_of([&] {
      const auto np = params::number_of_iterations(2).vertex_normal_map(n);
      const auto attributes = test_options::attributes(
        PN::parameters::vertex_attribute(t), PN::parameters::corner_attribute(u),
        PN::parameters::corner_attribute(v, PN::Corner_rule::all),
        PN::parameters::face_attribute(id), PN::parameters::edge_attribute(mark));
      const Allocation_limit limit(k);
      PN::subdivide(mesh, PN::CatmullClark_scheme(),
                    PN::parameters::join(PN::parameters::attributes(attributes), np));
    });
    if (failure.empty()) return failure;
    i = 0;
    for (auto x : vertices(mesh)) EXPECT_EQ(get(t, x), ++i);
    for (auto f : faces(mesh)) EXPECT_EQ(get(id, f), ++i);
    for (auto e : edges(mesh)) EXPECT_EQ(get(mark, e), ++i);
    for (auto h : halfedges(mesh))
      if (!is_border(h, mesh)) {
        EXPECT_EQ(get(u, h), get(t, target(h, mesh)) + 100 * (get(id, face(h, mesh)) % 2));
        EXPECT_EQ(get(v, h), 0.5 * get(u, h));
      }
    return failure;
  });
}

} // namespace

// Reading takes 2 calls a vertex, and one more a point to keep it; writing two for each new vertex.
TYPED_TEST(Strong_guarantee, PropertyMaps)
{
  EXPECT_GE((fail_in_maps<TypeParam, CGAL::Sequential_tag>(mixed_with_border(), false)), 2 * 109);
  EXPECT_GE((fail_in_maps<TypeParam, CGAL::Sequential_tag>(triangles_with_border(), true)), 2 * 88);
}

TYPED_TEST(Strong_guarantee, Allocations)
{
  for (unsigned rounds : {1u, 2u}) {
    EXPECT_GE(
      (fail_in_allocations<TypeParam, CGAL::Sequential_tag>(mixed_with_border(), false, rounds)),
      10);
    EXPECT_GE(
      (fail_in_allocations<TypeParam, CGAL::Sequential_tag>(triangles_with_border(), true, rounds)),
      10);
  }
}

TYPED_TEST(Strong_guarantee, Attributes)
{
  EXPECT_GE(fail_with_attributes<TypeParam>(), 40);
}

// Doo-Sabin makes a mesh compact at last. If the memory for it is lacking, that is left to the
// user.
TYPED_TEST(Strong_guarantee, DooSabin)
{
  const auto compact = [](auto& mesh) {
    if constexpr (std::is_same_v<std::decay_t<decltype(mesh)>, Surface_mesh>)
      mesh.collect_garbage();
  };
  const long in_allocations =
    fail_everywhere<TypeParam>(mixed_with_border(), [&](auto& mesh, auto n, long k) {
      const auto np = params::number_of_iterations(2).vertex_normal_map(n);
      const std::string failure = failure_of([&] {
        const Allocation_limit limit(k);
        PN::DooSabin_subdivision(mesh, np);
      });
      if (failure.empty()) compact(mesh);
      return failure;
    });
  EXPECT_GE(in_allocations, 10);
  const long in_maps =
    fail_everywhere<TypeParam>(mixed_with_border(), [&](auto& mesh, auto n, long k) {
      Calls_left left(k - 1, true);
      return failure_of(
        [&] { PN::DooSabin_subdivision(mesh, params::vertex_normal_map(failing(n, left))); });
    });
  EXPECT_GE(in_maps, 13 + 20); // 13 are read, 20 written
}

TYPED_TEST(Strong_guarantee, Visitor)
{
  const long failures = fail_everywhere<TypeParam>(cube(), [](auto& mesh, auto n, long k) {
    const auto np =
      params::number_of_iterations(3).vertex_normal_map(n).visitor(Failing_visitor{&k});
    return failure_of([&] { PN::CatmullClark_subdivision(mesh, np); });
  });
  EXPECT_EQ(failures, 3);
}

#ifdef CGAL_LINKED_WITH_TBB
TYPED_TEST(Strong_guarantee, PropertyMapsWithThreads)
{
  EXPECT_GE((fail_in_maps<TypeParam, CGAL::Parallel_tag>(mixed_with_border(), false)), 2 * 109);
}

// The allocations of TBB itself are among those that fail.
TYPED_TEST(Strong_guarantee, AllocationsWithThreads)
{
  EXPECT_GE((fail_in_allocations<TypeParam, CGAL::Parallel_tag>(mixed_with_border(), false, 2)),
            10);
}
#endif

// A map that goes on failing: nothing is promised of what it holds, but of the mesh.
TYPED_TEST(Strong_guarantee, ConnectivitySurvivesAMapThatGoesOnFailing)
{
  using Mesh = typename TypeParam::Mesh;
  Mesh mesh;
  TypeParam::make(mixed_with_border(), mesh);
  const State<Mesh> state(mesh);
  // all new vertices are written (17 edges, 5 faces) and one old one; the second old one fails
  Calls_left puts_left(17 + 5 + 1);
  puts_left.fails_for_good = true;
  const auto map = failing(get(CGAL::vertex_point, mesh), puts_left);
  EXPECT_THROW(PN::CatmullClark_subdivision(mesh, params::vertex_point_map(map)), User_failure);
  EXPECT_EQ(num_vertices(mesh), std::get<0>(state.slots));
  EXPECT_EQ(State<Mesh>(mesh).edge, state.edge);
  EXPECT_EQ(State<Mesh>(mesh).polygon, state.polygon);
}
