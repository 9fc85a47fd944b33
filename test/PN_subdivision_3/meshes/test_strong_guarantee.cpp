// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Whatever fails, wherever it fails: the mesh and its maps are as they were, and serve again.

#include "Failing_runs.h"
#include "support/Options.h"

using namespace failing_runs;

namespace {

template <class Maker>
class Strong_guarantee : public ::testing::Test
{};
using Makers = ::testing::Types<Compact_surface_mesh, Surface_mesh_with_garbage, Plain_polyhedron>;
TYPED_TEST_SUITE(Strong_guarantee, Makers, Maker_names);

struct Failing_visitor
{
  void round_done(unsigned, std::size_t) const { calls_left.count(); }
};

template <class Maker, class Tag>
long fail_in_maps(const Soup& soup, bool loop)
{
  const auto job = [loop](auto& t) {
    const auto np = params::number_of_iterations(2)
                      .vertex_point_map(failing(get(CGAL::vertex_point, t.mesh)))
                      .vertex_normal_map(failing(t.normals));
    loop ? PN::Loop_subdivision<Tag>(t.mesh, np) : PN::CatmullClark_subdivision<Tag>(t.mesh, np);
  };
  return fail_everywhere<Maker>(soup, job, Failing::maps);
}

template <class Maker, class Tag>
long fail_in_allocations(const Soup& soup, bool loop, unsigned rounds)
{
  const auto job = [=](auto& t) {
    const auto np = params::number_of_iterations(rounds).vertex_normal_map(t.normals);
    loop ? PN::Loop_subdivision<Tag>(t.mesh, np) : PN::CatmullClark_subdivision<Tag>(t.mesh, np);
  };
  return fail_everywhere<Maker>(soup, job, Failing::allocations);
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

// of every kind, which must have their old values after a failure, too
TYPED_TEST(Strong_guarantee, Attributes)
{
  const auto job = [](auto& t) {
    const auto np = params::number_of_iterations(2).vertex_normal_map(t.normals);
    const auto attributes = test_options::attributes(
      PN::parameters::vertex_attribute(t.corners), PN::parameters::corner_attribute(t.charts),
      PN::parameters::corner_attribute(t.corner_normals, PN::Corner_rule::all),
      PN::parameters::face_attribute(t.ids), PN::parameters::edge_attribute(t.sharp));
    PN::subdivide(t.mesh, PN::CatmullClark_scheme(),
                  PN::parameters::join(PN::parameters::attributes(attributes), np));
  };
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), job, Failing::allocations), 40);
}

// Doo-Sabin makes a mesh compact at last. If the memory for it is lacking, that is left to the
// user.
TYPED_TEST(Strong_guarantee, DooSabin)
{
  const auto compacted = [](auto& t) {
    PN::DooSabin_subdivision(t.mesh, params::number_of_iterations(2).vertex_normal_map(t.normals));
    const failing_allocations::Allocation_limit none(any_number);
    if constexpr (std::is_same_v<typename TypeParam::Mesh, Surface_mesh>) t.mesh.collect_garbage();
  };
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), compacted, Failing::allocations), 10);
  const auto in_maps = [](auto& t) {
    PN::DooSabin_subdivision(t.mesh, params::vertex_normal_map(failing(t.normals)));
  };
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), in_maps, Failing::maps),
            13 + 20); // 13 are read, 20 written
}

TYPED_TEST(Strong_guarantee, Visitor)
{
  const auto job = [](auto& t) {
    PN::CatmullClark_subdivision(
      t.mesh,
      params::number_of_iterations(3).vertex_normal_map(t.normals).visitor(Failing_visitor()));
  };
  EXPECT_EQ(fail_everywhere<TypeParam>(cube(), job, Failing::maps), 3);
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
  failing_maps::Calls_left puts_left(17 + 5 + 1);
  puts_left.fails_for_good = true;
  const auto map = failing_maps::failing(get(CGAL::vertex_point, mesh), puts_left);
  EXPECT_THROW(PN::CatmullClark_subdivision(mesh, params::vertex_point_map(map)), User_failure);
  const State<Mesh> after(mesh);
  EXPECT_EQ(after.slots, state.slots);
  EXPECT_EQ(after.edge, state.edge);
  EXPECT_EQ(after.polygon, state.polygon);
}
