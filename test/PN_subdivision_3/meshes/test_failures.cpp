// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Allocations and maps that fail everywhere in what is more than a plain round: creases, limits, every host.

#include "Failing_allocations.h"
#include "Failing_map.h"
#include "Mesh_cases.h"
#include "support/Options.h"

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <tuple>

namespace {

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

using failing_maps::User_failure;

constexpr long any_number = std::numeric_limits<long>::max();

// the calls of all maps, reads among them
failing_maps::Calls_left calls_left(any_number, true);

template <class Map>
auto failing(const Map& map)
{
  return failing_maps::failing(map, calls_left);
}

// a mesh with all that it may have
template <class Mesh_>
struct Tagged
{
  using Mesh = Mesh_;
  template <class Tag>
  using Map = typename boost::property_map<Mesh, Tag>::type;

  explicit Tagged(const Soup& soup)
  {
    build(soup, mesh);
    normals = get(CGAL::dynamic_vertex_property_t<Vector>(), mesh);
    sharp = get(CGAL::dynamic_edge_property_t<double>(), mesh);
    corners = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    corner_normals = get(CGAL::dynamic_halfedge_property_t<Vector>(), mesh);
    put_normals(mesh_cases::normals(soup), mesh, normals);
    int i = 0;
    for (auto e : edges(mesh)) put(sharp, e, ++i % 3 == 0 ? 1.5 : 0);
    for (auto v : vertices(mesh)) put(corners, v, ++i % 5 == 0 ? 1 : 0);
    for (auto h : halfedges(mesh))
      put(corner_normals, h, ++i % 4 == 0 ? CGAL::NULL_VECTOR : Vector(0.1 * (i % 7), 0.2, 1));
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
  std::tuple<std::size_t, std::vector<Triple>, std::vector<Triple>, std::vector<double>,
             std::vector<Triple>, std::vector<Polygon>>
  state() const
  {
    std::vector<double> numbers;
    std::vector<Triple> of_corners;
    for (auto e : edges(mesh)) numbers.push_back(get(sharp, e));
    for (auto v : vertices(mesh)) numbers.push_back(get(corners, v));
    for (auto h : halfedges(mesh)) {
      const Vector n = get(corner_normals, h);
      of_corners.push_back({n.x(), n.y(), n.z()});
    }
    return {num_halfedges(mesh), points(mesh),  values(mesh, normals), numbers,
            of_corners,          faces_of(mesh)};
  }

  Mesh mesh;
  Map<CGAL::dynamic_vertex_property_t<Vector>> normals;
  Map<CGAL::dynamic_edge_property_t<double>> sharp;
  Map<CGAL::dynamic_vertex_property_t<double>> corners;
  Map<CGAL::dynamic_halfedge_property_t<Vector>> corner_normals;
};

// Lets the n-th call or allocation fail for n = 1, 2, ... until none fails; after each all must be as before, and
// in the end the job is done as if nothing had been. Returns how many failed.
template <class Mesh, class Job>
long fail_everywhere(const Soup& soup, const Job& job, bool in_maps)
{
  Tagged<Mesh> tagged(soup), untroubled(soup);
  job(untroubled);
  const auto state = tagged.state();
  for (long k = 1;; ++k) {
    try {
      const failing_allocations::Allocation_limit limit(in_maps ? any_number : k);
      calls_left.number = in_maps ? k - 1 : any_number;
      job(tagged);
      calls_left.number = any_number;
    } catch (const User_failure&) {
      calls_left.number = any_number;
      EXPECT_TRUE(tagged.state() == state) << "after failure " << k << " of a map";
      if (!(tagged.state() == state)) return k;
      continue;
    } catch (const std::bad_alloc&) {
      EXPECT_TRUE(tagged.state() == state) << "after failure " << k << " of an allocation";
      if (!(tagged.state() == state)) return k;
      continue;
    }
    // not what maps hold that were not given: of new elements that is anything
    EXPECT_EQ(points(tagged.mesh), points(untroubled.mesh));
    EXPECT_EQ(faces_of(tagged.mesh), faces_of(untroubled.mesh));
    return k - 1;
  }
}

// The same for a map that fails at the n-th call and ever after: old values cannot be put back then, but the
// mesh is as large as before, and what comes out is the failure.
template <class Mesh, class Job>
long fail_for_good(const Soup& soup, const Job& job)
{
  for (long k = 1;; ++k) {
    Tagged<Mesh> tagged(soup);
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

template <class Mesh>
class Strong_guarantee_of_features : public testing::Test
{};
using Meshes = testing::Types<Surface_mesh, Polyhedron>;
struct Mesh_names
{
  template <class Mesh>
  static std::string GetName(int)
  {
    return std::is_same_v<Mesh, Surface_mesh> ? "Surface_mesh" : "Polyhedron_3";
  }
};
TYPED_TEST_SUITE(Strong_guarantee_of_features, Meshes, Mesh_names);

TYPED_TEST(Strong_guarantee_of_features, Creases)
{
  const auto job = [](auto& t) {
    PN::CatmullClark_subdivision(
      t.mesh, t.creased(failing(t.sharp), failing(t.corners), failing(t.corner_normals)));
  };
  EXPECT_GE(fail_everywhere<TypeParam>(cube(), job, true), 12 + 8 + 24);
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), job, true), 12 + 8 + 24);
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), job, false), 10);
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
  EXPECT_GE(fail_everywhere<TypeParam>(tetrahedron(), job, true), 4);
  EXPECT_GE(fail_everywhere<TypeParam>(tetrahedron(), job, false), 4);
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
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), subdivided, true), 13 + 24);
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), subdivided, false), 10);
  EXPECT_GE(fail_everywhere<TypeParam>(mixed_with_border(), moved, true), 24);
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
  EXPECT_GE(fail_everywhere<TypeParam>(tetrahedron(), job, true), 2 * 4 + 6 + 12);
  EXPECT_GE(fail_everywhere<TypeParam>(tetrahedron(), job, false), 10);
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
              triangles, [&](auto& t) { PN::Sqrt3_subdivision(t.mesh, two_rounds(t)); }, false),
            10);
  EXPECT_GE(fail_everywhere<TypeParam>(
              triangles, [&](auto& t) { PN::Butterfly_subdivision(t.mesh, two_rounds(t)); }, false),
            10);
  EXPECT_GE(fail_everywhere<TypeParam>(
              cube(), [&](auto& t) { PN::Kobbelt_subdivision(t.mesh, two_rounds(t)); }, false),
            10);
}

} // namespace
