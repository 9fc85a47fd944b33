// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the functions refuse, by which words, and that they have touched nothing; and the limiting
// cases that have defined results. None of it depends on NDEBUG.

#include "Mesh_cases.h"
#include "Messages.h"

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>

using namespace mesh_cases;
using messages::expect_words;
using messages::message_of;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Face = Mesh::Face_index;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// everything that a Surface_mesh stores, without walking through its connectivity
struct State
{
  explicit State(const Mesh& mesh)
  {
    for (auto v : mesh.vertices()) {
      links.push_back(mesh.halfedge(v));
      add(mesh.point(v));
    }
    for (auto h : mesh.halfedges())
      links.insert(links.end(), {std::size_t(mesh.target(h)), std::size_t(mesh.next(h)),
                                 std::size_t(mesh.prev(h)), std::size_t(mesh.face(h))});
    for (auto f : mesh.faces()) links.push_back(mesh.halfedge(f));
    links.insert(links.end(), {mesh.num_vertices(), mesh.num_halfedges(), mesh.num_faces(),
                               mesh.number_of_vertices(), mesh.number_of_faces()});
  }
  template <class Point_or_vector>
  void add(const Point_or_vector& p)
  {
    for (int k = 0; k < 3; ++k) {
      std::uint64_t bits;
      const double x = p[k];
      std::memcpy(&bits, &x, sizeof bits);
      values.push_back(bits);
    }
  }
  bool operator==(const State& s) const { return links == s.links && values == s.values; }

  std::vector<std::size_t> links;
  std::vector<std::uint64_t> values; // bit by bit: NaN equals itself
};

Mesh::Property_map<Vertex, Vector> add_normals(Mesh& mesh)
{
  auto n = mesh.add_property_map<Vertex, Vector>("n", Vector(0, 0, 1)).first;
  return n;
}

// The mesh is refused by all functions, in these words, and nothing of it changes.
void expect_refused(Mesh mesh, const std::vector<std::string>& words)
{
  auto n = add_normals(mesh);
  State before(mesh);
  for (auto v : mesh.vertices()) before.add(n[v]);
  const auto np = params::number_of_iterations(2).vertex_normal_map(n);
  const std::vector<std::string> messages{
    message_of([&] { PN::subdivide(mesh, PN::CatmullClark_scheme(), np); }),
    message_of([&] { PN::subdivide(mesh, PN::CatmullClark_scheme()); }),
    message_of([&] { PN::subdivide(mesh, PN::linear(PN::CatmullClark_scheme())); }),
    message_of([&] { PN::subdivide(mesh, PN::Loop_scheme(), np); }),
    message_of([&] { PN::estimate_control_normals(mesh, n); })};
  State after(mesh);
  for (auto v : mesh.vertices()) after.add(n[v]);
  EXPECT_TRUE(before == after);
  for (const std::string& message : messages) expect_words(message, words);
}

} // namespace

// \name Faces

TEST(Bad_input, LoopTakesTrianglesOnly)
{
  Mesh mesh = built<Mesh>(mixed_with_border());
  const State before(mesh);
  const std::string message = message_of([&] { PN::subdivide(mesh, PN::Loop_scheme()); });
  expect_words(message, {"face 0", "4", "triangles"});
  EXPECT_TRUE(State(mesh) == before);

  Polyhedron polyhedron;
  build(mixed_with_border(), polyhedron);
  const auto p = points(polyhedron);
  expect_words(message_of([&] { PN::subdivide(polyhedron, PN::Loop_scheme()); }),
               {"face number 0", "4", "triangles"});
  EXPECT_EQ(points(polyhedron), p);
  EXPECT_EQ(polyhedron.size_of_facets(), 5u);
}

// the only quad is the last face of many
TEST(Bad_input, LoopNamesTheFace)
{
  Soup soup = triangles_with_border();
  soup.points.push_back({2.5, 1, 0});
  soup.points.push_back({2.5, 2, 0});
  soup.faces.push_back({2, 8, 10, 11});
  Mesh mesh = built<Mesh>(soup);
  expect_words(message_of([&] { PN::subdivide(mesh, PN::Loop_scheme()); }),
               {"face 9 ", "4 corners"});
}

TEST(Bad_input, FaceOfDegreeTwo)
{
  // the edge 0-1 of a triangle doubled, with a face of two corners between
  Mesh mesh = built<Mesh>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const Halfedge h = mesh.halfedge(Vertex(0), Vertex(1)), outer = mesh.opposite(h);
  const Halfedge before = mesh.prev(outer), after = mesh.next(outer);
  const Halfedge g = mesh.add_edge(Vertex(0), Vertex(1)), o = mesh.opposite(g);
  const Face f = mesh.add_face();
  mesh.set_next(outer, g);
  mesh.set_next(g, outer);
  mesh.set_face(outer, f);
  mesh.set_face(g, f);
  mesh.set_halfedge(f, g);
  mesh.set_face(o, Mesh::null_face());
  mesh.set_next(before, o);
  mesh.set_next(o, after);
  mesh.set_halfedge(Vertex(0), o);
  mesh.set_halfedge(Vertex(1), before);
  expect_refused(mesh, {"face 1", "2 corners"});
}

// \name Values

TEST(Bad_input, PointsThatAreNotFinite)
{
  for (double x : {not_a_number, infinity, -infinity})
    for (int k = 0; k < 3; ++k) {
      Mesh mesh = built<Mesh>(tetrahedron());
      double p[3] = {1, 2, 3};
      p[k] = x;
      mesh.point(Vertex(2)) = Point(p[0], p[1], p[2]);
      expect_refused(mesh, {"point", "vertex 2", "not finite"});
    }
  Mesh mesh = built<Mesh>(tetrahedron());
  mesh.add_vertex(Point(0, not_a_number, 0)); // without edges
  expect_refused(mesh, {"point", "vertex 4", "not finite"});
}

TEST(Bad_input, NormalsThatAreNotFinite)
{
  for (double x : {not_a_number, infinity, -infinity})
    for (int k = 0; k < 3; ++k) {
      Mesh mesh = built<Mesh>(tetrahedron());
      auto n = add_normals(mesh);
      double m[3] = {0, 0, 1};
      m[k] = x;
      n[Vertex(3)] = Vector(m[0], m[1], m[2]);
      const State before(mesh);
      const auto refuse = [&] {
        PN::subdivide(mesh, PN::Loop_scheme(), params::vertex_normal_map(n));
      };
      expect_words(message_of(refuse), {"normal", "vertex 3", "not finite"});
      EXPECT_TRUE(State(mesh) == before);
      EXPECT_EQ(n[Vertex(0)], Vector(0, 0, 1));
      // the linear twin does not read them
      EXPECT_NO_THROW(
        PN::subdivide(mesh, PN::linear(PN::Loop_scheme()), params::vertex_normal_map(n)));
      EXPECT_EQ(mesh.number_of_faces(), 16u);
    }
}

TEST(Bad_input, PointsThatOverflowAreRefusedInTheEnd)
{
  Soup large = cube();
  for (Triple& p : large.points)
    for (double& x : p) x *= 1.7e308;
  Mesh mesh = built<Mesh>(large);
  auto n = add_normals(mesh);
  const State before(mesh);
  const auto refuse = [&] {
    PN::subdivide(mesh, PN::CatmullClark_scheme(), params::vertex_normal_map(n));
  };
  expect_words(message_of<std::overflow_error>(refuse), {"new vertex", "out of the range"});
  EXPECT_TRUE(State(mesh) == before);
}

TEST(Bad_input, FloatValuesThatAreNotFinite)
{
  using Float = CGAL::Simple_cartesian<float>;
  CGAL::Surface_mesh<Float::Point_3> mesh;
  build(cube(), mesh);
  mesh.point(Vertex(5)) = Float::Point_3(0, 0, std::numeric_limits<float>::infinity());
  expect_words(message_of([&] { PN::subdivide(mesh, PN::CatmullClark_scheme()); }),
               {"point", "vertex 5", "not finite"});
}

TEST(Bad_input, APolyhedronNamesVerticesByTheirPosition)
{
  Polyhedron mesh;
  build(cube(), mesh);
  std::next(mesh.vertices_begin(), 6)->point() = Point(not_a_number, 0, 0);
  expect_words(message_of([&] { PN::subdivide(mesh, PN::CatmullClark_scheme()); }),
               {"point", "vertex number 6", "not finite"});
  EXPECT_EQ(mesh.size_of_vertices(), 8u);
}

// \name Sizes

// A cube has 6 * 4^k faces, 24 * 4^k half-edges and 6 * 4^k + 2 vertices after k rounds; the
// half-edges exceed 2^32 - 2 at k = 14 (24 * 4^13 = 1.6e9).
TEST(Bad_input, MoreElementsThanTheIndexTypeNumbers)
{
  Mesh mesh = built<Mesh>(cube());
  const State before(mesh);
  for (unsigned rounds : {14u, 15u, 20u, 1000000u, std::numeric_limits<unsigned>::max()}) {
    const std::string message = message_of<std::length_error>([&] {
      PN::subdivide(mesh, PN::CatmullClark_scheme(), params::number_of_iterations(rounds));
    });
    expect_words(message, {"round 14", "1610612738 vertices", "6442450944 half-edges",
                           "1610612736 faces", "at most 13 rounds"});
    EXPECT_TRUE(State(mesh) == before);
  }
}

TEST(Bad_input, ANegativeNumberOfIterations)
{
  Mesh mesh = built<Mesh>(cube());
  expect_words(message_of([&] {
                 PN::subdivide(mesh, PN::CatmullClark_scheme(), params::number_of_iterations(-1));
               }),
               {"number of iterations", "negative"});
}

// A tetrahedron has 4 * 4^k triangles with 12 * 4^k half-edges.
TEST(Bad_input, MoreElementsThanTheIndexTypeNumbersInAPolyhedron)
{
  Polyhedron mesh;
  build(tetrahedron(), mesh);
  const std::string message = message_of<std::length_error>(
    [&] { PN::subdivide(mesh, PN::Loop_scheme(), params::number_of_iterations(99)); });
  expect_words(message, {"round 15", "12884901888 half-edges", "at most 14 rounds"});
  EXPECT_EQ(mesh.size_of_facets(), 4u);
}

// \name Connectivity

TEST(Bad_input, BowTieOfTwoBorderGaps)
{
  // two triangles that share vertex 2 only, as any soup of theirs is read
  Mesh mesh =
    built<Mesh>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 2, 0}, {1, 2, 0}}, {{0, 1, 2}, {2, 4, 3}}});
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  expect_refused(mesh, {"vertex 2", "bow-tie", "duplicate"});
}

TEST(Bad_input, BowTieOfTwoClosedFans)
{
  // vertex 7 of the second tetrahedron becomes vertex 3 of the first
  Mesh mesh = built<Mesh>(tetrahedron());
  build(tetrahedron(), mesh);
  for (auto h : CGAL::halfedges_around_target(Vertex(7), mesh)) {
    ASSERT_EQ(mesh.target(h), Vertex(7));
    mesh.set_target(h, Vertex(3));
  }
  mesh.remove_vertex(Vertex(7));
  expect_refused(mesh, {"vertex 3", "bow-tie"});
  mesh.collect_garbage();
  expect_refused(mesh, {"vertex 3", "bow-tie"});
}

TEST(Bad_input, EdgeWithoutFaces)
{
  Mesh linked = built<Mesh>(tetrahedron());
  const Vertex v = linked.add_vertex(Point(5, 0, 0)), w = linked.add_vertex(Point(6, 0, 0));
  const Halfedge h = linked.add_edge(v, w);
  const Mesh unlinked = linked;
  linked.set_next(h, linked.opposite(h));
  linked.set_next(linked.opposite(h), h);
  linked.set_halfedge(w, h);
  linked.set_halfedge(v, linked.opposite(h));
  expect_refused(linked, {"edge", "half-edge 12", "no face on either side"});
  expect_refused(unlinked, {"edge", "half-edge 12", "no face on either side"});
}

TEST(Bad_input, DanglingEdgeInsideOfAFace)
{
  // from vertex 0 into the face 3 2 1 0 of a cube
  Mesh mesh = built<Mesh>(cube());
  const Vertex v = mesh.add_vertex(Point(0, 0, -1));
  Halfedge h = mesh.halfedge(Face(0));
  while (mesh.target(h) != Vertex(0)) h = mesh.next(h);
  const Halfedge after = mesh.next(h), in = mesh.add_edge(Vertex(0), v), out = mesh.opposite(in);
  mesh.set_next(h, in);
  mesh.set_next(in, out);
  mesh.set_next(out, after);
  mesh.set_face(in, Face(0));
  mesh.set_face(out, Face(0));
  mesh.set_halfedge(v, in);
  expect_refused(mesh, {"vertex 8", "dangling"});
}

TEST(Bad_input, LinksThatAreNoneOrContradictEachOther)
{
  const Halfedge h(5);
  struct Break
  {
    void (*in)(Mesh&, Halfedge);
    std::vector<std::string> words;
  };
  const Break all[] = {
    {[](Mesh& m, Halfedge g) { m.set_target(g, Vertex()); }, {"half-edge 5 ", "target"}},
    {[](Mesh& m, Halfedge g) { m.set_target(g, Vertex(8)); }, {"half-edge 5 ", "target"}},
    {[](Mesh& m, Halfedge g) { m.set_next_only(g, Halfedge()); }, {"half-edge 5 ", "next"}},
    {[](Mesh& m, Halfedge g) { m.set_next_only(g, Halfedge(24)); }, {"half-edge 5 ", "next"}},
    {[](Mesh& m, Halfedge g) { m.set_face(g, Face(6)); }, {"half-edge 5 ", "face"}},
    {[](Mesh& m, Halfedge g) { m.set_next_only(g, m.opposite(g)); }, {"half-edge 5 ", "broken"}},
    // the target of another half-edge
    {[](Mesh& m, Halfedge g) { m.set_target(g, m.target(m.next(m.next(g)))); },
     {"half-edge", "broken"}},
    // the face on the other side
    {[](Mesh& m, Halfedge g) { m.set_face(g, m.face(m.opposite(g))); }, {"half-edge", "broken"}},
    // a face lost: its side is no border either
    {[](Mesh& m, Halfedge g) { m.set_face(g, Mesh::null_face()); }, {"half-edge", "broken"}},
    // a face and a vertex that store a half-edge of others, or none
    {[](Mesh& m, Halfedge) { m.set_halfedge(Face(2), m.halfedge(Face(3))); },
     {"face 2 ", "half-edge"}},
    {[](Mesh& m, Halfedge) { m.set_halfedge(Face(2), Halfedge()); }, {"face 2 ", "half-edge"}},
    {[](Mesh& m, Halfedge) { m.set_halfedge(Vertex(4), m.halfedge(Vertex(5))); },
     {"vertex 4 ", "half-edge"}},
    {[](Mesh& m, Halfedge) { m.set_halfedge(Vertex(4), Halfedge(77)); },
     {"vertex 4 ", "half-edge"}},
    {[](Mesh& m, Halfedge) { m.set_halfedge(Vertex(4), Halfedge()); },
     {"vertex 4 ", "stores no half-edge"}}};
  for (const Break& broken : all) {
    Mesh mesh = built<Mesh>(cube());
    broken.in(mesh, h);
    expect_refused(mesh, broken.words);
  }
}

TEST(Bad_input, ARemovedFaceThatHalfEdgesName)
{
  Mesh mesh = built<Mesh>(cube());
  mesh.remove_face(Face(2));
  expect_words(message_of([&] { PN::subdivide(mesh, PN::CatmullClark_scheme()); }),
               {"half-edge", "no valid face"});
  EXPECT_EQ(mesh.number_of_faces(), 5u);
  EXPECT_EQ(mesh.number_of_vertices(), 8u);
}

TEST(Bad_input, AFaceOfTwoLoops)
{
  // top and bottom of a cube as one face
  Mesh mesh = built<Mesh>(cube());
  for (auto h : CGAL::halfedges_around_face(mesh.halfedge(Face(1)), mesh))
    mesh.set_face(h, Face(0));
  mesh.remove_face(Face(1));
  expect_refused(mesh, {"face 0 ", "loops"});
}

// the same check through BGL
TEST(Bad_input, BrokenLinksOfAPolyhedron)
{
  using Traits = boost::graph_traits<Polyhedron>;
  const auto refused = [](const auto& breaks, const std::vector<std::string>& words) {
    Polyhedron mesh;
    build(cube(), mesh);
    std::vector<Traits::halfedge_descriptor> h;
    for (auto g : halfedges(mesh)) h.push_back(g);
    breaks(mesh, h);
    expect_words(message_of([&] { PN::subdivide(mesh, PN::CatmullClark_scheme()); }), words);
    EXPECT_EQ(mesh.size_of_vertices(), 8u);
    EXPECT_EQ(mesh.size_of_halfedges(), 24u);
    EXPECT_EQ(mesh.size_of_facets(), 6u);
  };
  using Base = Polyhedron::HalfedgeDS::Halfedge::Base;
  using Halfedges = std::vector<Traits::halfedge_descriptor>;
  const auto base = [](auto h) -> Base& { return *h; };
  refused([&](Polyhedron&, Halfedges& h) { base(h[5]).set_next(Traits::null_halfedge()); },
          {"half-edge number 5", "next"});
  refused([&](Polyhedron& m, Halfedges& h) { set_target(h[5], Traits::null_vertex(), m); },
          {"half-edge number 5", "target"});
  refused([&](Polyhedron& m, Halfedges& h) { set_face(h[5], face(opposite(h[5], m), m), m); },
          {"half-edge number", "broken"});
  refused([&](Polyhedron& m, Halfedges& h) { set_halfedge(face(h[0], m), h[1], m); },
          {"face number 0", "half-edge"});
  Polyhedron other;
  build(tetrahedron(), other);
  refused([&](Polyhedron& m, Halfedges& h) { set_target(h[5], *vertices(other).begin(), m); },
          {"half-edge number 5", "target"});
}

// \name Defined results

TEST(Limiting_cases, AnEmptyMeshStaysEmpty)
{
  Mesh mesh;
  auto n = add_normals(mesh);
  PN::subdivide(mesh, PN::CatmullClark_scheme(),
                params::number_of_iterations(40).vertex_normal_map(n));
  PN::subdivide(mesh, PN::Loop_scheme());
  PN::estimate_control_normals(mesh, n);
  EXPECT_TRUE(mesh.is_empty());
  EXPECT_EQ(mesh.num_vertices() + mesh.num_edges() + mesh.num_faces(), 0u);
  Polyhedron polyhedron;
  PN::subdivide(polyhedron, PN::Loop_scheme());
  EXPECT_TRUE(polyhedron.empty());
}

// not even looked at
TEST(Limiting_cases, ZeroIterationsLeaveAnyMeshAsItIs)
{
  Mesh mesh = built<Mesh>(mixed_with_border());
  auto n = add_normals(mesh);
  mesh.point(Vertex(1)) = Point(not_a_number, infinity, 0);
  n[Vertex(1)] = Vector(not_a_number, 0, 0);
  mesh.set_next_only(Halfedge(3), Halfedge());
  State before(mesh);
  before.add(n[Vertex(1)]);
  const auto np = params::number_of_iterations(0).vertex_normal_map(n);
  PN::subdivide(mesh, PN::CatmullClark_scheme(), np);
  PN::subdivide(mesh, PN::Loop_scheme(), np);
  State after(mesh);
  after.add(n[Vertex(1)]);
  EXPECT_TRUE(before == after);
}

TEST(Limiting_cases, VerticesWithoutEdgesStayWhereTheyAre)
{
  for (bool loop : {false, true}) {
    const Soup soup = loop ? tetrahedron() : cube();
    Mesh with, without;
    const Vertex first = with.add_vertex(Point(0.1, 0.2, 0.3));
    build(soup, with);
    build(soup, without);
    const Vertex last = with.add_vertex(Point(7.1, 0, 1e300));
    auto n = add_normals(with);
    auto m = add_normals(without);
    const Vector unit(0.6, 0, -0.8);
    n[first] = unit;
    n[last] = Vector(0, 0, 0);
    const auto refine = [loop](Mesh& mesh, auto map) {
      const auto np = params::number_of_iterations(3).vertex_normal_map(map);
      loop ? PN::subdivide(mesh, PN::Loop_scheme(), np)
           : PN::subdivide(mesh, PN::CatmullClark_scheme(), np);
    };
    refine(with, n);
    refine(without, m);
    EXPECT_EQ(with.point(first), Point(0.1, 0.2, 0.3));
    EXPECT_EQ(with.point(last), Point(7.1, 0, 1e300));
    EXPECT_EQ(n[first], unit);
    EXPECT_EQ(n[last], Vector(0, 0, 0));
    EXPECT_TRUE(with.is_isolated(first) && with.is_isolated(last));
    EXPECT_EQ(with.number_of_vertices(), without.number_of_vertices() + 2);
    // the others come in the same order
    auto p = points(with);
    p.erase(p.begin() + std::size_t(last));
    p.erase(p.begin());
    EXPECT_EQ(p, points(without));
  }
}

TEST(Limiting_cases, VerticesAlone)
{
  Mesh mesh;
  mesh.add_vertex(Point(1, 2, 3));
  PN::subdivide(mesh, PN::CatmullClark_scheme(), params::number_of_iterations(100));
  EXPECT_EQ(mesh.number_of_vertices(), 1u);
  EXPECT_EQ(mesh.point(Vertex(0)), Point(1, 2, 3));
  Polyhedron polyhedron;
  build(Soup{{{1, 2, 3}}, {}}, polyhedron);
  PN::subdivide(polyhedron, PN::Loop_scheme());
  EXPECT_EQ(polyhedron.vertices_begin()->point(), Point(1, 2, 3));
}

// all points coincide: there are no normals, and all stays there
TEST(Limiting_cases, AMeshWithoutArea)
{
  Soup soup = cube();
  for (auto& p : soup.points) p = {0.1, 0.2, 0.3};
  Mesh mesh = built<Mesh>(soup);
  PN::subdivide(mesh, PN::CatmullClark_scheme(), params::number_of_iterations(2));
  EXPECT_EQ(mesh.number_of_faces(), 96u);
  for (auto v : mesh.vertices())
    EXPECT_LT(CGAL::squared_distance(mesh.point(v), Point(0.1, 0.2, 0.3)), 1e-31);
}

TEST(Limiting_cases, ZeroAreaFacesAddNothingToAnEstimate)
{
  // a flat square with a degenerate triangle (collinear: 0, 1, 4) along one edge
  const Soup soup{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}},
                  {{0, 1, 2, 3}, {1, 0, 4}}};
  Mesh mesh = built<Mesh>(soup);
  auto n = add_normals(mesh);
  PN::estimate_control_normals(mesh, n);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(n[Vertex(i)], Vector(0, 0, 1));
  EXPECT_EQ(n[Vertex(4)], Vector(0, 0, 0));
}
