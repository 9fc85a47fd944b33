// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A refiner of a mesh with creases is compared with a new call of subdivide().

#include "Extent.h"
#include "Feature_matrix.h"
#include "Mesh_cases.h"
#include "Mesh_with_attributes.h"
#include "Messages.h"
#include "Surface_refiner_cases.h"
#include "support/Exact_rational.h"
#include "support/Options.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/Polyhedron_3.h>

using namespace surface_refiner_cases;

#ifdef CGAL_LINKED_WITH_TBB
using Parallel_tag = CGAL::Parallel_tag;
#else
using Parallel_tag = CGAL::Sequential_tag;
#endif

TEST(Creased_refiner, CatmullClark)
{
  for (unsigned seed = 1; seed < 6; ++seed) {
    expect_as_subdivide(quads_and_others(), PN::CatmullClark_scheme(), 3, seed);
    expect_as_subdivide(triangles(), PN::CatmullClark_scheme(), 1, seed);
  }
}
TEST(Creased_refiner, LoopOnSeveralThreads)
{
  for (unsigned seed = 1; seed < 6; ++seed)
    expect_as_subdivide<Parallel_tag>(triangles(), PN::Loop_scheme(), 3, seed);
}
TEST(Creased_refiner, EstimatedNormals)
{
  for (unsigned seed = 1; seed < 6; ++seed)
    expect_as_subdivide(quads_and_others(), PN::CatmullClark_scheme(), 2, seed, false);
}
TEST(Creased_refiner, LinearScheme)
{
  expect_as_subdivide(quads_and_others(), PN::linear(PN::CatmullClark_scheme()), 3, 1);
}
TEST(Creased_refiner, BordersThatAreCreases)
{
  for (const PN::Border border :
       {PN::Border::surface, PN::Border::curve, PN::Border::corners, PN::Border::fixed})
    expect_as_subdivide(triangles(), PN::internal::with_border(PN::Loop_scheme::Tuned(), border), 3,
                        1);
}

// What is far from the change is left alone, though creases are evaluated everywhere.
TEST(Creased_refiner, ReachesNoMoreThanWithoutCreases)
{
  Mesh mesh = grid(16);
  auto normals = add_normals(mesh);
  auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e", false).first;
  for (auto e : mesh.edges())
    sharp[e] = mesh.vertex(e, 0).idx() / 17 == 8 && mesh.vertex(e, 1).idx() / 17 == 8;
  const auto np = params::number_of_iterations(3).vertex_normal_map(normals);
  PN::Surface_refiner creased(mesh, PN::CatmullClark_scheme(), np.edge_is_constrained_map(sharp));
  PN::Surface_refiner smooth(mesh, PN::CatmullClark_scheme(), np);
  EXPECT_TRUE(creased.update().empty());
  creased.set_point(Vertex(3 * 17 + 3), Point(3, 3, 1));
  smooth.set_point(Vertex(3 * 17 + 3), Point(3, 3, 1));
  EXPECT_EQ(creased.update(), smooth.update()); // no crease is near
  EXPECT_GT(creased.memory(), smooth.memory());

  // a point beyond the crease is not reached by one on this side
  creased.set_point(Vertex(6 * 17 + 8), Point(8, 6, 1));
  for (const auto v : creased.update()) EXPECT_LE(creased.points()[v].y(), 8.);
}

TEST(Creased_refiner, RefusesTheNormalOfAVertexThatHasSeveral)
{
  Mesh mesh;
  build(cube(), mesh, mesh.points());
  auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e", true).first;
  PN::Surface_refiner refiner(mesh, PN::CatmullClark_scheme(),
                              params::number_of_iterations(2).edge_is_constrained_map(sharp));
  const auto before = refiner.points();
  messages::expect_refused([&] { refiner.set_normal(Vertex(3), Vector(0, 0, 1)); },
                           {"control vertex 3"});
  EXPECT_TRUE(refiner.update().empty());
  EXPECT_EQ(refiner.points(), before);
  // the mean of the normals of three faces
  const Point corner = mesh.point(Vertex(3));
  EXPECT_GT(refiner.control_normal(Vertex(3)) * (corner - CGAL::ORIGIN), 1.7);

  EXPECT_THROW(
    PN::Surface_refiner(mesh, PN::DooSabin_scheme(), params::edge_is_constrained_map(sharp)),
    std::invalid_argument);
}

// One point of a mesh whose border is a crease moves. The points of the refiner against those of subdivide().
template <class K, class Concurrency_tag, class Scheme, class Is_same>
void expect_numbers_as_subdivide(const Scheme& scheme, const Is_same& is_same)
{
  CGAL::Surface_mesh<typename K::Point_3> mesh;
  build(mixed_with_border(), mesh, mesh.points());
  auto normals = mesh.template add_property_map<Vertex, typename K::Vector_3>("n").first;
  for (Vertex v : mesh.vertices())
    normals[v] = typename K::Vector_3(0.25 * (v.idx() % 3), 0.125, 1);
  const auto refine = [&](const auto& np) {
    PN::Surface_refiner<decltype(mesh), Scheme, K, Concurrency_tag> refiner(mesh, scheme, np);
    const typename K::Point_3 moved = mesh.point(Vertex(0)) + typename K::Vector_3(0, 0.125, 0.25);
    refiner.set_point(Vertex(0), moved);
    EXPECT_FALSE(refiner.update().empty());
    mesh.point(Vertex(0)) = moved;
    PN::subdivide<Concurrency_tag>(mesh, scheme, np);
    ASSERT_EQ(refiner.points().size(), mesh.number_of_vertices());
    for (Vertex v : mesh.vertices())
      for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(is_same(refiner.points()[v][c], mesh.point(v)[c])) << v;
  };
  if constexpr (PN::internal::Is_linear<Scheme>::value)
    refine(params::number_of_iterations(2));
  else
    refine(params::number_of_iterations(2).vertex_normal_map(normals));
}

TEST(Creased_refiner, IntervalsOnSeveralThreads)
{
  long_test([](auto) {
    using Interval = CGAL::Interval_nt<false>;
    const Interval::Protector protector;
    const auto is_same = [](const Interval& a, const Interval& b) {
      return a.inf() == b.inf() && a.sup() == b.sup();
    };
    using K = CGAL::Simple_cartesian<Interval>;
    const auto scheme = PN::internal::with_border(PN::CatmullClark_scheme(), PN::Border::curve);
    expect_numbers_as_subdivide<K, CGAL::Sequential_tag>(scheme, is_same);
    expect_numbers_as_subdivide<K, Parallel_tag>(scheme, is_same);
  });
}

TEST(Creased_refiner, ExactConstructionsOnSeveralThreads)
{
  long_test([](auto) {
    using K = CGAL::Exact_predicates_exact_constructions_kernel;
    const auto is_same = [](const K::FT& a, const K::FT& b) { return a == b; };
    const auto scheme =
      PN::linear(PN::internal::with_border(PN::CatmullClark_scheme(), PN::Border::curve));
    expect_numbers_as_subdivide<K, CGAL::Sequential_tag>(scheme, is_same);
    expect_numbers_as_subdivide<K, Parallel_tag>(scheme, is_same);
  });
}

// --- normals of corners that are edited, and attributes in maps: what subdivide() gives, by bytes ---

namespace {

using namespace feature_matrix;
using carrying_mesh::Mesh_with_attributes;

const Kernel::Point_3 moved(0.3, -0.2, 0.7);
const Vector turned(1, 2, 4);

// vertices of the control mesh: one beside the creases, and one on two of them
const Mesh::Vertex_index outer(10);
Mesh::Vertex_index on_creases(const Case& c)
{
  std::vector<int> sharp(c.mesh.number_of_vertices());
  for (auto e : c.mesh.edges())
    for (int i : {0, 1})
      if (c.sharpness[e] > 0 && ++sharp[c.mesh.vertex(e, unsigned(i)).idx()] == 2)
        return c.mesh.vertex(e, unsigned(i));
  return Mesh::null_vertex();
}

TEST(Refiner_with_normals_of_corners, FollowsPointsAndNormals)
{
  Case plain("catmull-clark", Crease_kind::edges, Attribute_kind::none),
    edited("catmull-clark", Crease_kind::edges, Attribute_kind::none);
  const Mesh::Vertex_index v = on_creases(edited);
  ASSERT_TRUE(v.is_valid());
  run(edited, Of_corners(), [&](Case& c, const auto& scheme, const auto& np) {
    PN::Surface_refiner refiner(c.mesh, scheme, np);
    refiner.set_point(v, moved);
    refiner.set_normal(outer, turned);
    EXPECT_LT(refiner.update().size(), refiner.number_of_vertices());
    messages::expect_refused([&] { refiner.set_normal(v, turned); }, {"given by its corners"});
    c.mesh.clear_without_removing_property_maps();
    refiner.build_mesh(c.mesh, params::vertex_normal_map(c.corner_normals));
  });
  plain.mesh.point(v) = moved;
  for (auto h : CGAL::halfedges_around_target(outer, plain.mesh))
    if (!plain.mesh.is_border(h)) plain.corner_normals[h] = turned;
  run(plain, Of_corners(), Plain());
  EXPECT_TRUE(same_bytes(edited.points(), plain.points()));
  EXPECT_TRUE(same_bytes(edited.all_corner_normals(), plain.all_corner_normals()));
}

template <class Control, class Built, class Number, class Concurrency_tag = CGAL::Sequential_tag,
          class Scheme>
void compare(const mesh_cases::Soup& soup, const Scheme& scheme,
             const std::vector<unsigned>& numbers_of_rounds = {0, 1, 2})
{
  for (const unsigned rounds : numbers_of_rounds) {
    Mesh_with_attributes<Control, Number> control(soup), plain(soup);
    Mesh_with_attributes<Built, Number> built;
    const auto np = params::number_of_iterations(rounds);
    const PN::Surface_refiner<Control, Scheme, CGAL::Simple_cartesian<Number>, Concurrency_tag>
      refiner(control.mesh, scheme,
              PN::parameters::join(PN::parameters::attributes(control.attributes()), np));
    refiner.build_mesh(built.mesh, PN::parameters::attributes(built.attributes()));
    PN::subdivide(plain.mesh, scheme,
                  PN::parameters::join(PN::parameters::attributes(plain.attributes()), np));
    EXPECT_EQ(built.carried(), plain.carried()) << rounds << " rounds";
    EXPECT_EQ(control.carried(), (Mesh_with_attributes<Control, Number>(soup).carried()));
  }
}

TEST(Refiner_with_attributes, InMapsOfOtherMeshes)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const PN::CatmullClark_scheme scheme;
  compare<Polyhedron, Mesh, double>(mesh_cases::mixed_with_border(), scheme);
  compare<Mesh, Polyhedron, double>(mesh_cases::mixed_with_border(), scheme);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Refiner_with_attributes, OnSeveralThreads)
{
  compare<Mesh, Mesh, double, CGAL::Parallel_tag>(
    mesh_cases::mixed_with_border(), PN::CatmullClark_scheme(), {5}); // some chunks of vertices
}
#endif

TEST(Refiner_with_attributes, InExactNumbers)
{
  long_test([](auto) {
    using FT = CGAL::Exact_rational;
    using Exact_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<FT>::Point_3>;
    compare<Exact_mesh, Exact_mesh, FT>(mesh_cases::triangles_with_border(),
                                        PN::linear(PN::Loop_scheme()));
  });
}

TEST(Refiner_with_attributes, ThatAreOthersAreRefused)
{
  Mesh_with_attributes<Mesh> control(mesh_cases::mixed_with_border()), built;
  const PN::Surface_refiner refiner(control.mesh, PN::CatmullClark_scheme(),
                                    PN::parameters::attributes(control.attributes()));
  const auto expect_refusal = [&](auto&& attributes) {
    EXPECT_THROW(refiner.build_mesh(built.mesh, PN::parameters::attributes(attributes)),
                 std::invalid_argument);
    EXPECT_TRUE(built.mesh.is_empty());
  };
  const auto vertices = PN::parameters::vertex_attribute(built.of_vertices);
  const auto corners = PN::parameters::corner_attribute(built.of_corners);
  const auto edges = PN::parameters::edge_attribute(built.of_edges);
  expect_refusal(test_options::attributes(vertices, corners, edges));
  expect_refusal(test_options::attributes(corners, vertices, edges,
                                          PN::parameters::face_attribute(built.of_faces)));
  expect_refusal(test_options::attributes(vertices, corners, edges, vertices));
  PN::Attribute_table table;
  expect_refusal(table);
  refiner.build_mesh(built.mesh); // attributes may be left out
  EXPECT_EQ(built.mesh.number_of_vertices(), refiner.number_of_vertices());
}

} // namespace
