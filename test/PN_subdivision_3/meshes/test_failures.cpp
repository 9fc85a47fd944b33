// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Allocations and maps that fail everywhere in what is more than a plain round: creases, limits, every host.

#include "Failing_runs.h"
#include "support/Options.h"

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>

namespace {

using namespace failing_runs;

// The same for a map that fails at the n-th call and ever after: old values cannot be put back then, but the
// mesh is as large as before, and what comes out is the failure.
template <class Maker, class Job>
long fail_for_good(const Soup& soup, const Job& job)
{
  for (long k = 1;; ++k) {
    Tagged<Maker> tagged(soup);
    const auto before = faces_of(tagged.mesh);
    calls_left.fails_for_good = true;
    calls_left.number = k - 1;
    bool has_failed = false;
    try {
      job(tagged);
    } catch (const User_failure&) {
      has_failed = true;
    }
    calls_left.fails_for_good = false;
    calls_left.number = any_number;
    if (!has_failed) return k - 1;
    EXPECT_EQ(faces_of(tagged.mesh), before) << "after " << k;
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(tagged.mesh)) << "after " << k;
    if (testing::Test::HasFailure()) return k;
  }
}

template <class Maker>
class Strong_guarantee_of_features : public testing::Test
{};
using Makers = testing::Types<Compact_surface_mesh, Plain_polyhedron>;
TYPED_TEST_SUITE(Strong_guarantee_of_features, Makers, Maker_names);

TYPED_TEST(Strong_guarantee_of_features, Creases)
{
  const auto job = [](auto& t) {
    PN::CatmullClark_subdivision(
      t.mesh, t.creased(failing(t.sharp), failing(t.corners), failing(t.corner_normals)));
  };
  EXPECT_GE(fail_everywhere<TypeParam>(cube(), job, Failing::maps, false), 12 + 8 + 24);
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), job, Failing::maps, false),
            12 + 8 + 24);
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), job, Failing::allocations, false), 10);
}

TYPED_TEST(Strong_guarantee_of_features, Limits)
{
  const auto job = [](auto& t) {
    test_options::Limit_options options;
    options.max_depth = 3;
    PN::subdivide_to_limit(t.mesh, PN::Loop_scheme(),
                           PN::parameters::join(CGAL::parameters::number_of_iterations(0),
                                                options.pack(),
                                                params::vertex_normal_map(failing(t.normals))));
  };
  EXPECT_GE(fail_everywhere<TypeParam>(tetrahedron(), job, Failing::maps), 4);
  EXPECT_GE(fail_everywhere<TypeParam>(tetrahedron(), job, Failing::allocations), 4);
}

TYPED_TEST(Strong_guarantee_of_features, CreasedLimits)
{
  const auto scheme = PN::internal::with_border(PN::CatmullClark_scheme(), PN::Border::curve);
  test_options::Limit_options options;
  options.max_depth = 2;
  const auto subdivided = [&](auto& t) {
    PN::subdivide_to_limit(
      t.mesh, scheme,
      PN::parameters::join(options.pack(),
                           params::vertex_normal_map(failing(t.corner_normals))
                             .vertex_point_map(failing(get(CGAL::vertex_point, t.mesh)))));
  };
  const auto moved = [&](auto& t) {
    PN::subdivide_to_limit(
      t.mesh, scheme,
      PN::parameters::join(CGAL::parameters::number_of_iterations(0), options.pack(),
                           params::vertex_normal_map(failing(t.corner_normals))));
  };
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), subdivided, Failing::maps, false),
            13 + 24);
  EXPECT_GE(
    fail_everywhere<TypeParam>(mixed_with_border(), subdivided, Failing::allocations, false), 10);
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), moved, Failing::maps, false), 24);
}

TYPED_TEST(Strong_guarantee_of_features, WhatIsCarriedToTheLimit)
{
  test_options::Limit_options options;
  options.max_depth = 1;
  const auto job = [&](auto& t) {
    PN::subdivide_to_limit(
      t.mesh, PN::Loop_scheme(),
      PN::parameters::join(
        PN::parameters::attributes(PN::parameters::vertex_attribute(failing(t.corners)),
                                   PN::parameters::edge_attribute(failing(t.sharp)),
                                   PN::parameters::corner_attribute(failing(t.corner_normals))),
        options.pack(),
        params::vertex_normal_map(failing(t.normals))
          .vertex_point_map(failing(get(CGAL::vertex_point, t.mesh)))));
  };
  EXPECT_GE(fail_everywhere<TypeParam>(tetrahedron(), job, Failing::maps), 2 * 4 + 6 + 12);
  EXPECT_GE(fail_everywhere<TypeParam>(tetrahedron(), job, Failing::allocations), 10);
}

TYPED_TEST(Strong_guarantee_of_features, MapsThatFailForGood)
{
  const auto creases = [](auto& t) {
    PN::CatmullClark_subdivision(
      t.mesh, t.creased(failing(t.sharp), failing(t.corners), failing(t.corner_normals)));
  };
  EXPECT_GE(fail_for_good<TypeParam>(cube(), creases), 12 + 8 + 24);
  const auto limits = [](auto& t) {
    PN::subdivide_to_limit(t.mesh, PN::Loop_scheme(),
                           params::vertex_normal_map(failing(t.normals)).number_of_iterations(0));
  };
  EXPECT_GE(fail_for_good<TypeParam>(tetrahedron(), limits), 4);
}

TYPED_TEST(Strong_guarantee_of_features, EveryHost)
{
  const auto two_rounds = [](auto& t) {
    return params::number_of_iterations(2).vertex_normal_map(t.normals);
  };
  const Soup triangles = triangles_with_border();
  EXPECT_GE(fail_everywhere<TypeParam>(
              triangles, [&](auto& t) { PN::Sqrt3_subdivision(t.mesh, two_rounds(t)); },
              Failing::allocations),
            10);
  EXPECT_GE(fail_everywhere<TypeParam>(
              triangles, [&](auto& t) { PN::Butterfly_subdivision(t.mesh, two_rounds(t)); },
              Failing::allocations),
            10);
  EXPECT_GE(fail_everywhere<TypeParam>(
              cube(), [&](auto& t) { PN::Kobbelt_subdivision(t.mesh, two_rounds(t)); },
              Failing::allocations),
            10);
}

} // namespace
