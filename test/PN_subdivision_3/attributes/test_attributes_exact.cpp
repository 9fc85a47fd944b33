// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Attributes in exact arithmetic: a linear function of the position stays that function of the linear result, by every
// scheme, on creases too.

#include "Mesh_cases.h"
#include "Random_creases.h"
#include "support/Exact_rational.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
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

using FT = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<FT>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

FT linear_function(const Kernel::Point_3& p)
{
  return FT(3) * p.x() - FT(2) * p.y() + p.z() / FT(3) + FT(1);
}

// a type of the user's that takes weights in double, on its right
struct Load
{
  double force = 0;
  friend Load operator+(const Load& a, const Load& b) { return {a.force + b.force}; }
  friend Load operator*(const Load& a, double w) { return {a.force * w}; }
};

Soup with_isolated_vertex(Soup soup)
{
  soup.points.push_back({7, 7, 7});
  return soup;
}

template <class Scheme>
class Exact_attributes : public ::testing::Test
{};
using Schemes = ::testing::Types<PN::CatmullClark_scheme, PN::Loop_scheme, PN::DooSabin_scheme,
                                 PN::Sqrt3_scheme, PN::Butterfly_scheme, PN::Kobbelt_scheme>;
TYPED_TEST_SUITE(Exact_attributes, Schemes, );

TYPED_TEST(Exact_attributes, LinearFunctionsStay)
{
  using Scheme = TypeParam;
  constexpr bool is_quads = std::is_same_v<Scheme, PN::Kobbelt_scheme>;
  constexpr bool is_triangles = Scheme::Host::refined_degree == 3;
  std::vector<Soup> soups{is_triangles ? tetrahedron() : cube()};
  if (!is_quads)
    soups.push_back(
      with_isolated_vertex(is_triangles ? triangles_with_border() : mixed_with_border()));
  for (const Soup& soup : soups) {
    Mesh mesh;
    build(soup, mesh);
    auto t = mesh.add_property_map<Mesh::Vertex_index, FT>("t").first;
    auto v = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v").first;
    auto c = mesh.add_property_map<Mesh::Vertex_index, FT>("c").first;
    auto load = mesh.add_property_map<Mesh::Vertex_index, Load>("load").first;
    auto label = mesh.add_property_map<Mesh::Vertex_index, int>("label").first;
    auto d = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("d").first;
    for (auto x : mesh.vertices()) {
      t[x] = linear_function(mesh.point(x));
      load[x].force = CGAL::to_double(t[x]);
      d[x] = v[x] = mesh.point(x) - CGAL::ORIGIN;
      label[x] = 5 + int(x.idx());
      c[x] = FT(5) / FT(7);
    }
    PN::subdivide(mesh, PN::linear(Scheme()),
                  PN::parameters::attributes(
                    PN::parameters::vertex_attribute(t), PN::parameters::vertex_attribute(v),
                    PN::parameters::vertex_attribute(c), PN::parameters::vertex_attribute(load),
                    PN::parameters::vertex_attribute(label), PN::parameters::direction_attribute(d))
                    .number_of_iterations(2));
    ASSERT_GT(mesh.number_of_vertices(), soup.points.size());
    for (auto x : mesh.vertices()) {
      EXPECT_EQ(t[x], linear_function(mesh.point(x)));
      EXPECT_NEAR(load[x].force, CGAL::to_double(t[x]), 1e-13);
      EXPECT_EQ(v[x], mesh.point(x) - CGAL::ORIGIN);
      EXPECT_EQ(c[x], FT(5) / FT(7));
      EXPECT_TRUE(label[x] >= 5 && label[x] < 5 + int(soup.points.size()));
      EXPECT_EQ(CGAL::cross_product(d[x], v[x]), CGAL::NULL_VECTOR);
      if (v[x] != CGAL::NULL_VECTOR) {
        EXPECT_NEAR(CGAL::to_double(d[x].squared_length()), 1, 1e-13);
      }
    }
  }
}

// a cube of 2 x 2 quads a side
Soup box()
{
  const auto control = random_creases::box();
  Soup soup{control.points, {}};
  for (const auto& f : control.faces) soup.faces.emplace_back(f.begin(), f.end());
  return soup;
}

Soup triangulated(const Soup& soup)
{
  Soup result{soup.points, {}};
  for (const Polygon& f : soup.faces)
    for (std::size_t i = 2; i < f.size(); ++i) result.faces.push_back({f[0], f[i - 1], f[i]});
  return result;
}

template <class Scheme>
class Creased_attributes : public ::testing::Test
{};
using Creasing_schemes = ::testing::Types<PN::CatmullClark_scheme, PN::Loop_scheme>;
TYPED_TEST_SUITE(Creased_attributes, Creasing_schemes, );

// sharp and semi-sharp edges and vertices at random, closed and with a border under every rule for it
TYPED_TEST(Creased_attributes, LinearFunctionsStayOnCreases)
{
  const double sharpness[] = {0, 0, 0, 0.25, 1, 1.5, 2.75, std::numeric_limits<double>::infinity()};
  unsigned random = 1;
  const auto any = [&] { return sharpness[(random = random * 1103515245u + 12345u) >> 16 & 7u]; };
  for (int n = 0; n < 12; ++n) {
    const bool is_closed = n % 3 != 0;
    Soup soup = is_closed ? box() : mixed_with_border();
    if (TypeParam::Host::refined_degree == 3) soup = triangulated(soup);
    Mesh mesh;
    build(soup, mesh);
    auto edges = mesh.add_property_map<Mesh::Edge_index, double>("s", 0).first;
    auto vertices = mesh.add_property_map<Mesh::Vertex_index, double>("s", 0).first;
    for (auto e : mesh.edges()) edges[e] = any();
    for (auto v : mesh.vertices())
      if (v.idx() % 7 == 3) vertices[v] = any();
    auto t = mesh.add_property_map<Mesh::Vertex_index, FT>("t").first;
    auto corner = mesh.add_property_map<Mesh::Halfedge_index, FT>("corner").first;
    for (auto v : mesh.vertices()) t[v] = linear_function(mesh.point(v));
    for (auto h : mesh.halfedges()) corner[h] = t[mesh.target(h)];
    const PN::Border borders[] = {PN::Border::surface, PN::Border::curve, PN::Border::corners,
                                  PN::Border::fixed};
    PN::subdivide(mesh, PN::internal::with_border(PN::linear(TypeParam()), borders[n / 3]),
                  PN::parameters::attributes(PN::parameters::vertex_attribute(t),
                                             PN::parameters::corner_attribute(corner))
                    .number_of_iterations(3)
                    .edge_is_constrained_map(edges)
                    .vertex_is_constrained_map(vertices));
    for (auto v : mesh.vertices()) EXPECT_EQ(t[v], linear_function(mesh.point(v)));
    if (!is_closed) continue; // a chart with one face at a border vertex stays there
    for (auto h : mesh.halfedges()) EXPECT_EQ(corner[h], t[mesh.target(h)]);
  }
}

// Charts that meet a crease: what changes is the chart's border only, and seams stay halves of seams.
TYPED_TEST(Creased_attributes, ChartsMeetCreases)
{
  Soup soup = box();
  if (TypeParam::Host::refined_degree == 3) soup = triangulated(soup);
  Mesh mesh;
  build(soup, mesh);
  auto edges = mesh.add_property_map<Mesh::Edge_index, double>("s", 0).first;
  for (auto e : mesh.edges()) {
    const auto p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    if (p.z() == FT(2) && q.z() == FT(2)) edges[e] = 1.5;
  }
  auto corner = mesh.add_property_map<Mesh::Halfedge_index, FT>("corner").first;
  auto chart = mesh.add_property_map<Mesh::Face_index, int>("chart").first;
  for (auto f : mesh.faces()) {
    bool is_left = true;
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      is_left = is_left && mesh.point(v).x() <= FT(1);
    chart[f] = is_left ? 0 : 100;
  }
  const auto value = [&](Mesh::Halfedge_index h) {
    return FT(linear_function(mesh.point(mesh.target(h))) + FT(chart[mesh.face(h)]));
  };
  for (auto h : mesh.halfedges()) corner[h] = value(h);
  auto parent = mesh.add_property_map<Mesh::Edge_index, PN::Control_element>("parent").first;
  const auto is_seam = [&](Mesh::Edge_index e) {
    const auto h = mesh.halfedge(e, 0), o = mesh.halfedge(e, 1);
    return corner[h] != corner[mesh.prev(o)] || corner[mesh.prev(h)] != corner[o];
  };
  std::vector<bool> was_seam;
  for (auto e : mesh.edges()) was_seam.push_back(is_seam(e));
  PN::subdivide(mesh, PN::linear(TypeParam()),
                PN::parameters::attributes(PN::parameters::corner_attribute(corner),
                                           PN::parameters::face_attribute(chart),
                                           PN::parameters::edge_parents(parent))
                  .number_of_iterations(2)
                  .edge_is_constrained_map(edges));
  std::size_t away = 0, seams = 0;
  for (auto e : mesh.edges()) {
    const bool expected =
      parent[e].kind == PN::Control_element::Kind::edge && was_seam[parent[e].index];
    EXPECT_EQ(is_seam(e), expected);
    seams += expected;
  }
  EXPECT_GT(seams, 0u);
  for (auto v : mesh.vertices()) {
    bool is_on_seam = false;
    for (auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
      is_on_seam = is_on_seam || is_seam(mesh.edge(h));
    if (is_on_seam) continue;
    bool is_near_seam = false; // two rings, that is one of the round before
    for (auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
      for (auto w : mesh.vertices_around_face(h))
        for (auto g : mesh.halfedges_around_target(mesh.halfedge(w)))
          for (auto x : mesh.vertices_around_face(g))
            for (auto k : mesh.halfedges_around_target(mesh.halfedge(x)))
              is_near_seam = is_near_seam || is_seam(mesh.edge(k));
    if (is_near_seam) continue;
    ++away;
    for (auto h : mesh.halfedges_around_target(mesh.halfedge(v))) EXPECT_EQ(corner[h], value(h));
  }
  EXPECT_GT(away, 10u);
}

// A number type is no condition: doubles on an exact mesh, exact numbers on a Polyhedron_3.
TEST(Exact_attributes_of_a_polyhedron, InMapsOfTheirOwn)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Polyhedron mesh;
  build(mixed_with_border(), mesh);
  auto t = get(CGAL::dynamic_vertex_property_t<FT>(), mesh);
  auto x = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  for (auto v : vertices(mesh)) {
    put(t, v, linear_function(v->point()));
    put(x, v, CGAL::to_double(v->point().x()));
  }
  PN::subdivide(mesh, PN::linear(PN::CatmullClark_scheme()),
                PN::parameters::attributes(PN::parameters::vertex_attribute(t),
                                           PN::parameters::vertex_attribute(x))
                  .number_of_iterations(2));
  for (auto v : vertices(mesh)) {
    EXPECT_EQ(get(t, v), linear_function(v->point()));
    EXPECT_EQ(get(x, v), CGAL::to_double(v->point().x()));
  }
}

} // namespace
