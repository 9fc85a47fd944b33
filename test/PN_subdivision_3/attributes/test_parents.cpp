// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Where refined elements come from: in the plane every child lies in its parent, all children of several rounds are
// children of children, and every kind of mesh says the same.

#include "Mesh_cases.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using namespace mesh_cases;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Kind = PN::Control_element::Kind;
using Elements = std::vector<PN::Control_element>;

struct Parents
{
  Elements vertices, edges, faces;
};

// what the visitor is told, in the order in which it is told
template <class Mesh>
struct Recorder
{
  using Traits = boost::graph_traits<Mesh>;

  void vertex_created(typename Traits::vertex_descriptor v, const PN::Control_element& origin)
  {
    EXPECT_TRUE(edges.empty() && faces.empty());
    vertices.push_back(v);
    parents.vertices.push_back(origin);
  }
  void edge_created(typename Traits::edge_descriptor e, const PN::Control_element& origin)
  {
    EXPECT_TRUE(faces.empty());
    edges.push_back(e);
    parents.edges.push_back(origin);
  }
  void face_created(typename Traits::face_descriptor f, const PN::Control_element& origin)
  {
    EXPECT_EQ(CGAL::halfedges_around_face(halfedge(f, *mesh), *mesh).empty(), false);
    faces.push_back(f);
    parents.faces.push_back(origin);
  }

  const Mesh* mesh;
  Parents parents;
  std::vector<typename Traits::vertex_descriptor> vertices;
  std::vector<typename Traits::edge_descriptor> edges;
  std::vector<typename Traits::face_descriptor> faces;
};

// refines linearly; the visitor must have been told of all elements in their order
template <class Mesh, class Scheme>
Parents refine(Mesh& mesh, const Scheme& scheme, unsigned rounds)
{
  Recorder<Mesh> recorder{&mesh, {}, {}, {}, {}};
  PN::subdivide(mesh, PN::linear(scheme),
                params::number_of_iterations(rounds).visitor(std::ref(recorder)));
  std::size_t i = 0;
  for (auto v : vertices(mesh)) EXPECT_EQ(recorder.vertices.at(i++), v);
  EXPECT_EQ(recorder.vertices.size(), i);
  i = 0;
  for (auto e : edges(mesh)) EXPECT_EQ(recorder.edges.at(i++), e);
  EXPECT_EQ(recorder.edges.size(), i);
  i = 0;
  for (auto f : faces(mesh)) EXPECT_EQ(recorder.faces.at(i++), f);
  EXPECT_EQ(recorder.faces.size(), i);
  return recorder.parents;
}

// A scheme that moves nothing: new vertices are at the middles of what they come from, those of corners halfway to
// the middle of their face.
template <class FT>
struct Middle_mask
{
  using Index = PN::Level_connectivity::Index;

  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    s.add(v, FT(1));
  }
  template <class Stencil>
  void edge(Index e, Stencil& s) const
  {
    s.add(level.target(2 * e), FT(0.5));
    s.add(level.target(2 * e + 1), FT(0.5));
  }
  template <class Stencil>
  void face(Index f, Stencil& s) const
  {
    share(level.halfedge_of_face(f), FT(1), s);
  }
  template <class Stencil>
  void corner(Index h, Stencil& s) const
  {
    share(h, FT(0.5), s);
  }
  template <class Stencil>
  void share(Index h, FT part, Stencil& s) const
  {
    const FT w = part / FT(int(level.degree(h)));
    for (Index g = level.next(h); g != h; g = level.next(g)) s.add(level.target(g), w);
    s.add_rest(level.target(h));
  }

  const PN::Level_connectivity& level;
};

template <class Host_>
struct Middle_scheme
{
  using Host = Host_;
  template <class FT>
  Middle_mask<FT> mask(const PN::Level_connectivity& level, unsigned) const
  {
    return {level};
  }
};

// \name The plane

using Point_2 = std::array<double, 2>;

Point_2 in_plane(const Kernel::Point_3& p)
{
  return {p.x(), p.y()};
}
double cross(const Point_2& a, const Point_2& b, const Point_2& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// the elements of a mesh in the plane, by their numbers
struct Figure
{
  explicit Figure(const Surface_mesh& mesh)
  {
    for (auto v : mesh.vertices()) vertices.push_back(in_plane(mesh.point(v)));
    for (auto e : mesh.edges())
      edges.push_back(
        {in_plane(mesh.point(mesh.vertex(e, 0))), in_plane(mesh.point(mesh.vertex(e, 1)))});
    for (auto f : mesh.faces()) {
      faces.emplace_back();
      for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        faces.back().push_back(in_plane(mesh.point(v)));
    }
  }

  // by how much a point is inside a convex face
  double depth_in_face(std::size_t f, const Point_2& p) const
  {
    double least = 1e9;
    const auto& polygon = faces[f];
    for (std::size_t i = 0; i < polygon.size(); ++i)
      least = std::min(least, cross(polygon[i], polygon[(i + 1) % polygon.size()], p));
    return least;
  }
  double distance_to_edge(std::size_t e, const Point_2& p) const
  {
    const auto& [a, b] = edges[e];
    const double l = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double t = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / (l * l);
    return std::abs(cross(a, b, p)) / l + std::max(0., std::max(-t, t - 1));
  }

  std::vector<Point_2> vertices;
  std::vector<std::array<Point_2, 2>> edges;
  std::vector<std::vector<Point_2>> faces;
};

constexpr double tiny = 1e-12;

// every child of `mesh` lies in its parent in the figure; of `is_checked` parents
template <class Is_checked>
void expect_inside(const Figure& control, const Surface_mesh& mesh, const Parents& parents,
                   const Is_checked& is_checked)
{
  const auto expect_point = [&](const Point_2& p, const PN::Control_element& origin) {
    if (origin.kind == Kind::vertex) {
      EXPECT_LT(std::hypot(p[0] - control.vertices[origin.index][0],
                           p[1] - control.vertices[origin.index][1]),
                tiny);
    } else if (origin.kind == Kind::edge)
      EXPECT_LT(control.distance_to_edge(origin.index, p), tiny);
    else
      EXPECT_GT(control.depth_in_face(origin.index, p), 1e-6);
  };
  const Figure refined(mesh);
  ASSERT_EQ(parents.vertices.size(), refined.vertices.size());
  ASSERT_EQ(parents.edges.size(), refined.edges.size());
  ASSERT_EQ(parents.faces.size(), refined.faces.size());
  std::size_t checked = 0;
  for (std::size_t v = 0; v < refined.vertices.size(); ++v)
    if (is_checked(parents.vertices[v])) expect_point(refined.vertices[v], parents.vertices[v]);
  for (std::size_t e = 0; e < refined.edges.size(); ++e)
    if (is_checked(parents.edges[e])) {
      const auto& [a, b] = refined.edges[e];
      EXPECT_NE(parents.edges[e].kind, Kind::vertex);
      expect_point({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}, parents.edges[e]);
      if (parents.edges[e].kind == Kind::edge)
        for (const Point_2& p : {a, b}) expect_point(p, parents.edges[e]);
    }
  for (std::size_t f = 0; f < refined.faces.size(); ++f)
    if (is_checked(parents.faces[f])) {
      ASSERT_EQ(parents.faces[f].kind, Kind::face);
      ++checked;
      for (const Point_2& p : refined.faces[f])
        EXPECT_GT(control.depth_in_face(parents.faces[f].index, p), -tiny);
    }
  EXPECT_GT(checked, 20u);
}

// a skew grid of n x n quads, some of which are split, joined or left out, and a component of one triangle
Soup planar(std::size_t n, bool triangles)
{
  Soup soup;
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      soup.points.push_back({double(i) + 0.3 * double(j), double(j) - 0.1 * double(i), 0});
  const auto v = [&](std::size_t i, std::size_t j) { return i * (n + 1) + j; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = v(i, j), b = v(i + 1, j), c = v(i + 1, j + 1), d = v(i, j + 1);
      if (triangles || (i == 1 && j == 2)) {
        soup.faces.push_back({a, b, c});
        soup.faces.push_back({a, c, d});
      } else if (i == 2 && j == 1)
        soup.faces.push_back({a, b, v(4, 1), v(4, 2), c, d});
      else if (!(i == 3 && j == 1) && !(i == 0 && j == 3))
        soup.faces.push_back({a, b, c, d});
    }
  const std::size_t first = soup.points.size();
  for (const Triple& p : {Triple{20, 0, 0}, Triple{21, 0, 0}, Triple{20, 2, 0}, Triple{30, 0, 0}})
    soup.points.push_back(p); // the last one is isolated
  soup.faces.push_back({first, first + 1, first + 2});
  return soup;
}

constexpr auto always = [](const PN::Control_element&) { return true; };

const Elements& of_kind(const Parents& parents, Kind kind)
{
  return kind == Kind::vertex ? parents.vertices
         : kind == Kind::edge ? parents.edges
                              : parents.faces;
}

// the parents of the second round are children of the first
Elements composed(const Elements& second, const Parents& first)
{
  Elements result;
  for (const PN::Control_element& x : second) result.push_back(of_kind(first, x.kind).at(x.index));
  return result;
}

TEST(Parents, ChildrenLieInThemInQuads)
{
  for (unsigned rounds : {1u, 2u, 3u}) {
    Surface_mesh mesh = built<Surface_mesh>(planar(5, false));
    const Figure control(mesh);
    const Parents parents = refine(mesh, Middle_scheme<PN::PQQ_host>(), rounds);
    expect_inside(control, mesh, parents, always);
    // a corner of a face makes 4^(rounds-1) faces
    std::map<PN::Control_element, std::size_t> children;
    for (const auto& p : parents.faces) ++children[p];
    for (std::size_t f = 0; f < control.faces.size(); ++f)
      EXPECT_EQ(children[(PN::Control_element{Kind::face, f})], control.faces[f].size()
                                                                  << (2 * (rounds - 1)));
    children.clear();
    for (const auto& p : parents.edges) ++children[p];
    for (std::size_t e = 0; e < control.edges.size(); ++e)
      EXPECT_EQ(children[(PN::Control_element{Kind::edge, e})], std::size_t(1) << rounds);
  }
}

TEST(Parents, ChildrenLieInThemInTriangles)
{
  for (unsigned rounds : {1u, 2u, 3u}) {
    Surface_mesh mesh = built<Surface_mesh>(planar(4, true));
    const Figure control(mesh);
    const Parents parents = refine(mesh, Middle_scheme<PN::PTQ_host>(), rounds);
    expect_inside(control, mesh, parents, always);
    std::map<PN::Control_element, std::size_t> children;
    for (const auto& p : parents.faces) ++children[p];
    for (const auto& c : children) EXPECT_EQ(c.second, std::size_t(1) << (2 * rounds));
  }
}

// On a regular grid of triangles nothing moves but near the border. Two rounds cut each triangle into nine.
TEST(Parents, ChildrenLieInThemInSqrt3AfterEvenRounds)
{
  const std::size_t n = 10;
  for (unsigned rounds : {2u, 4u}) {
    Surface_mesh mesh = built<Surface_mesh>(planar(n, true));
    const Figure control(mesh);
    std::vector<bool> is_far(control.vertices.size());
    for (std::size_t v = 0; v < (n + 1) * (n + 1); ++v) {
      const std::size_t i = v / (n + 1), j = v % (n + 1);
      is_far[v] = i > 2 && j > 2 && i + 2 < n && j + 2 < n;
    }
    std::map<Point_2, std::size_t> number;
    for (std::size_t v = 0; v < control.vertices.size(); ++v) number[control.vertices[v]] = v;
    const auto is_checked = [&](const PN::Control_element& c) {
      if (c.kind == Kind::vertex) return bool(is_far[c.index]);
      if (c.kind == Kind::edge)
        return is_far[number[control.edges[c.index][0]]] &&
               is_far[number[control.edges[c.index][1]]];
      for (const Point_2& p : control.faces[c.index])
        if (!is_far[number[p]]) return false;
      return true;
    };
    const Parents parents = refine(mesh, PN::Sqrt3_scheme(), rounds);
    expect_inside(control, mesh, parents, is_checked);
    std::map<PN::Control_element, std::size_t> children, parts;
    for (const auto& p : parents.faces) ++children[p];
    for (const auto& c : children)
      if (is_checked(c.first)) {
        EXPECT_EQ(c.second, rounds == 2 ? 9u : 81u);
      }
    for (const auto& p : parents.edges) ++parts[p];
    for (const auto& c : parts)
      if (c.first.kind == Kind::edge && is_checked(c.first)) {
        EXPECT_EQ(c.second, rounds == 2 ? 3u : 9u);
      }
  }
}

// The parts of a border edge of a sqrt(3) mesh lie on it, where it is straight.
TEST(Parents, OfSqrt3AtTheBorder)
{
  Surface_mesh mesh = built<Surface_mesh>(planar(6, true));
  const Figure control(mesh);
  std::vector<bool> is_border_edge;
  for (auto e : mesh.edges()) is_border_edge.push_back(mesh.is_border(e));
  const Parents parents = refine(mesh, PN::Sqrt3_scheme(), 2);
  const Figure refined(mesh);
  std::map<std::size_t, std::size_t> parts;
  std::size_t e = 0;
  for (auto edge : mesh.edges()) {
    const PN::Control_element p = parents.edges[e++];
    if (!mesh.is_border(edge)) continue;
    ASSERT_EQ(p.kind, Kind::edge);
    EXPECT_TRUE(is_border_edge[p.index]);
    ++parts[p.index];
  }
  for (const auto& p : parts) EXPECT_EQ(p.second, 3u);
  std::map<PN::Control_element, std::size_t> children;
  for (const auto& p : parents.faces) ++children[p];
  std::size_t sum = 0;
  for (const auto& c : children) sum += c.second;
  EXPECT_EQ(children.size(), control.faces.size());
  EXPECT_EQ(sum, refined.faces.size());
}

TEST(Parents, OfDooSabinLieWhereTheyComeFrom)
{
  Surface_mesh mesh = built<Surface_mesh>(planar(5, false));
  const Figure control(mesh);
  const Parents parents = refine(mesh, Middle_scheme<PN::DQQ_host>(), 1);
  const Figure refined(mesh);
  std::map<Kind, std::size_t> seen;
  for (std::size_t v = 0; v < refined.vertices.size(); ++v) {
    ASSERT_EQ(parents.vertices[v].kind, Kind::face);
    EXPECT_GT(control.depth_in_face(parents.vertices[v].index, refined.vertices[v]), 1e-6);
  }
  for (std::size_t f = 0; f < refined.faces.size(); ++f) {
    const PN::Control_element p = parents.faces[f];
    ++seen[p.kind];
    if (p.kind == Kind::face)
      for (const Point_2& q : refined.faces[f]) EXPECT_GT(control.depth_in_face(p.index, q), 1e-6);
    else if (p.kind == Kind::vertex)
      EXPECT_GT(refined.depth_in_face(f, control.vertices[p.index]), 1e-6);
    else {
      const auto& [a, b] = control.edges[p.index];
      EXPECT_GT(refined.depth_in_face(f, {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}), 1e-6);
    }
  }
  EXPECT_GT(seen[Kind::vertex], 5u);
  EXPECT_GT(seen[Kind::edge], 20u);
  for (std::size_t e = 0; e < refined.edges.size(); ++e) {
    const auto& [a, b] = refined.edges[e];
    const PN::Control_element p = parents.edges[e];
    if (p.kind == Kind::face) {
      EXPECT_GT(control.depth_in_face(p.index, a), 1e-6);
      EXPECT_GT(control.depth_in_face(p.index, b), 1e-6);
    } else { // it crosses the edge
      ASSERT_EQ(p.kind, Kind::edge);
      const auto& [c, d] = control.edges[p.index];
      EXPECT_LT(cross(c, d, a) * cross(c, d, b), 0);
    }
  }
}

template <class Scheme>
class Parents_of : public ::testing::Test
{};
using Composing_schemes =
  ::testing::Types<PN::CatmullClark_scheme, PN::Loop_scheme, PN::DooSabin_scheme>;
TYPED_TEST_SUITE(Parents_of, Composing_schemes, );

TYPED_TEST(Parents_of, SeveralRoundsAreThoseOfSingleRounds)
{
  const bool triangles = TypeParam::Host::refined_degree == 3;
  for (const Soup& soup : {triangles ? triangles_with_border() : mixed_with_border(),
                           triangles ? tetrahedron() : cube()}) {
    Surface_mesh mesh = built<Surface_mesh>(soup), single = built<Surface_mesh>(soup);
    const Parents parents = refine(mesh, TypeParam(), 3);
    const Parents first = refine(single, TypeParam(), 1);
    const Parents second = refine(single, TypeParam(), 1);
    const Parents third = refine(single, TypeParam(), 1);
    const Parents both{composed(second.vertices, first), composed(second.edges, first),
                       composed(second.faces, first)};
    EXPECT_EQ(parents.vertices, composed(third.vertices, both));
    EXPECT_EQ(parents.edges, composed(third.edges, both));
    EXPECT_EQ(parents.faces, composed(third.faces, both));
  }
}

// Positions count, not descriptors: a Polyhedron_3 and a Surface_mesh with removed elements say the same.
TYPED_TEST(Parents_of, AreTheSameForAllMeshes)
{
  const bool triangles = TypeParam::Host::refined_degree == 3;
  const Soup soup = triangles ? triangles_with_border() : mixed_with_border();
  Surface_mesh mesh = built<Surface_mesh>(soup), garbage;
  garbage.remove_vertex(garbage.add_vertex());
  build(soup, garbage);
  ASSERT_TRUE(garbage.has_garbage());
  Polyhedron polyhedron = built<Polyhedron>(soup);
  const Parents expected = refine(mesh, TypeParam(), 2);
  for (const Parents& parents :
       {refine(garbage, TypeParam(), 2), refine(polyhedron, TypeParam(), 2)}) {
    EXPECT_EQ(parents.vertices, expected.vertices);
    EXPECT_EQ(parents.faces, expected.faces);
    EXPECT_EQ(parents.edges.size(), expected.edges.size());
  }
}

struct Face_counter
{
  std::vector<int>* children; // of the control faces
  template <class Face>
  void face_created(Face, const PN::Control_element& parent)
  {
    EXPECT_TRUE(parent.kind == PN::Control_element::Kind::face);
    ++children->at(parent.index);
  }
};
// A visitor has the members that it needs, and is told after the mesh has been made.
TEST(Parents, VisitorsHaveWhatTheyNeed)
{
  Surface_mesh mesh = built<Surface_mesh>(cube());
  std::vector<int> children(6, 0);
  PN::subdivide(mesh, PN::CatmullClark_scheme(),
                params::number_of_iterations(2).visitor(Face_counter{&children}));
  EXPECT_EQ(children, std::vector<int>(6, 16));
  EXPECT_TRUE(is_linked(mesh));
}

TEST(Parents, MapsSayWhatVisitorsAreTold)
{
  Surface_mesh mesh = built<Surface_mesh>(mixed_with_border()), other = mesh;
  const Parents expected = refine(other, PN::DooSabin_scheme(), 2);
  auto face = mesh.add_property_map<Surface_mesh::Face_index, PN::Control_element>("parent").first;
  auto number = mesh.add_property_map<Surface_mesh::Face_index, int>("number", -1).first;
  auto vertex =
    mesh.add_property_map<Surface_mesh::Vertex_index, PN::Control_element>("parent").first;
  auto edge = mesh.add_property_map<Surface_mesh::Edge_index, PN::Control_element>("parent").first;
  // the least face at an edge or a vertex
  std::vector<int> of_edge, of_vertex;
  for (auto e : mesh.edges()) {
    int least = 1000;
    for (unsigned i : {0u, 1u})
      if (!mesh.is_border(mesh.halfedge(e, i)))
        least = std::min(least, int(mesh.face(mesh.halfedge(e, i)).idx()));
    of_edge.push_back(least);
  }
  for (auto v : mesh.vertices()) {
    int least = 1000;
    for (auto f : mesh.faces_around_target(mesh.halfedge(v)))
      if (f != Surface_mesh::null_face()) least = std::min(least, int(f.idx()));
    of_vertex.push_back(least);
  }
  PN::subdivide(mesh, PN::linear(PN::DooSabin_scheme()),
                PN::parameters::attributes(
                  PN::parameters::face_parents(face), PN::parameters::face_parents(number),
                  PN::parameters::vertex_parents(vertex), PN::parameters::edge_parents(edge))
                  .number_of_iterations(2));
  ASSERT_EQ(mesh.number_of_faces(), expected.faces.size());
  for (auto f : mesh.faces()) {
    const PN::Control_element p = expected.faces[f.idx()];
    EXPECT_EQ(face[f], p);
    EXPECT_EQ(number[f], p.kind == Kind::face   ? int(p.index)
                         : p.kind == Kind::edge ? of_edge[p.index]
                                                : of_vertex[p.index]);
  }
  for (auto v : mesh.vertices()) EXPECT_EQ(vertex[v], expected.vertices[v.idx()]);
  for (auto e : mesh.edges()) EXPECT_EQ(edge[e], expected.edges[e.idx()]);
}

} // namespace
