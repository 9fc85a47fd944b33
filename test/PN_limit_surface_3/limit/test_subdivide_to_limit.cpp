// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// subdivide_to_limit(): what it carries, and what it is made of.

#include "Extent.h"
#include "Limit_cases.h"
#include "Mesh_cases.h"
#include "Mesh_with_attributes.h"
#include "Messages.h"
#include "Schemes.h"
#include "support/Exact_rational.h"
#include "support/Options.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/Polyhedron_3.h>

namespace {

using namespace limit_cases;
namespace params = CGAL::parameters;

// --- what is carried besides, and what is left where a visitor ends it ---

using carrying_mesh::Mesh_with_attributes;

template <class Mesh, class Concurrency_tag, class Number, class Scheme>
void compare(const mesh_cases::Soup& soup, const Scheme& scheme)
{
  for (const unsigned rounds : {0u, 1u, 2u}) {
    Mesh_with_attributes<Mesh, Number> limit(soup), plain(soup);
    const auto np = params::number_of_iterations(rounds);
    PN::subdivide_to_limit<Concurrency_tag>(
      limit.mesh, scheme, PN::parameters::join(PN::parameters::attributes(limit.attributes()), np));
    PN::subdivide<Concurrency_tag>(
      plain.mesh, scheme, PN::parameters::join(PN::parameters::attributes(plain.attributes()), np));
    EXPECT_EQ(limit.carried(), plain.carried()) << rounds << " rounds";
    EXPECT_NE(mesh_cases::points(limit.mesh), mesh_cases::points(plain.mesh));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(limit.mesh));
  }
}

TEST(Carried_to_the_limit, OnEveryMesh)
{
  const PN::CatmullClark_scheme scheme;
  compare<Surface_mesh, CGAL::Sequential_tag, double>(mesh_cases::mixed_with_border(), scheme);
  compare<CGAL::Polyhedron_3<Kernel>, CGAL::Sequential_tag, double>(mesh_cases::mixed_with_border(),
                                                                    scheme);
#ifdef CGAL_LINKED_WITH_TBB
  compare<Surface_mesh, CGAL::Parallel_tag, double>(mesh_cases::mixed_with_border(), scheme);
#endif
}

TEST(Carried_to_the_limit, InExactNumbers)
{
  long_test([](auto) {
    using FT = CGAL::Exact_rational;
    using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<FT>::Point_3>;
    compare<Mesh, CGAL::Sequential_tag, FT>(mesh_cases::triangles_with_border(),
                                            PN::linear(PN::Loop_scheme()));
  });
}

struct Cancelled : std::runtime_error
{
  Cancelled()
    : std::runtime_error("cancelled")
  {}
};

// ends the call at the n-th time that it is told something
struct Canceller
{
  void count() const
  {
    if (--*left == 0) throw Cancelled();
  }
  void round_done(unsigned, std::size_t) const { count(); }
  void face_created(Surface_mesh::Face_index, const PN::Control_element&) const { count(); }

  int* left;
};

TEST(Carried_to_the_limit, AVisitorCancelsBeforeTheMeshIsTouched)
{
  const mesh_cases::Soup soup = mesh_cases::mixed_with_border();
  Mesh_with_attributes<Surface_mesh> whole(soup);
  const auto np = params::number_of_iterations(3);
  const PN::CatmullClark_scheme scheme;
  PN::subdivide_to_limit(whole.mesh, scheme,
                         PN::parameters::join(PN::parameters::attributes(whole.attributes()), np));
  for (int n = 1; n <= 5; ++n) {
    Mesh_with_attributes<Surface_mesh> c(soup), before(soup);
    int left = n;
    const Canceller visitor{&left};
    EXPECT_THROW(
      PN::subdivide_to_limit(
        c.mesh, scheme,
        PN::parameters::join(PN::parameters::attributes(c.attributes()), np.visitor(visitor))),
      Cancelled);
    // faces are told of when all is there
    const auto& expected = n <= 3 ? before : whole;
    EXPECT_EQ(c.carried(), expected.carried()) << n;
    EXPECT_EQ(mesh_cases::points(c.mesh), mesh_cases::points(expected.mesh)) << n;
    EXPECT_TRUE(c.mesh.is_valid());
  }
}

// the rounds can be done, the limits cannot
TEST(Carried_to_the_limit, WithoutLimitsNothingIsChanged)
{
  const mesh_cases::Soup soup = mesh_cases::mixed_with_border();
  Mesh_with_attributes<Surface_mesh> c(soup), before(soup);
  test_options::Limit_options wrong;
  wrong.tolerance = -1;
  EXPECT_THROW(
    PN::subdivide_to_limit(c.mesh, PN::CatmullClark_scheme(),
                           PN::parameters::join(PN::parameters::attributes(c.attributes()),
                                                wrong.pack(), params::number_of_iterations(2))),
    std::invalid_argument);
  EXPECT_EQ(c.carried(), before.carried());
  EXPECT_EQ(c.mesh.number_of_vertices(), before.mesh.number_of_vertices());
}

// --- subdivide_to_limit() is subdivide() and move_to_limit(), but leaves a mesh as it was where either fails ---

template <class Mesh>
struct With_normals
{
  explicit With_normals(const mesh_cases::Soup& soup)
  {
    mesh_cases::build(soup, mesh);
    normals = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), mesh);
    mesh_cases::put_normals(mesh_cases::normals(soup), mesh, normals);
  }

  Mesh mesh;
  typename boost::property_map<Mesh, CGAL::dynamic_vertex_property_t<Kernel::Vector_3>>::type
    normals;
};

// normals of the first vertices
template <class A, class B>
void expect_same(With_normals<A>& a, With_normals<B>& b, std::size_t number_of_normals)
{
  ASSERT_EQ(num_vertices(a.mesh), num_vertices(b.mesh));
  ASSERT_EQ(num_faces(a.mesh), num_faces(b.mesh));
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(a.mesh));
  auto w = vertices(b.mesh).begin();
  for (auto v : vertices(a.mesh)) {
    EXPECT_EQ(get(CGAL::vertex_point, a.mesh, v), get(CGAL::vertex_point, b.mesh, *w));
    if (number_of_normals > 0) {
      EXPECT_EQ(get(a.normals, v), get(b.normals, *w));
      --number_of_normals;
    }
    ++w;
  }
}

template <class Mesh, class Concurrency_tag, class Scheme>
void compare(const mesh_cases::Soup& soup, const Scheme& scheme)
{
  for (const unsigned rounds : {0u, 1u, 3u})
    for (const bool surface_normals : {false, true}) {
      With_normals<Mesh> one(soup), two(soup);
      const std::size_t old_vertices = num_vertices(one.mesh);
      const auto np = [](auto& m, unsigned k) {
        return params::vertex_normal_map(m.normals).number_of_iterations(k);
      };
      test_options::Limit_options options;
      options.surface_normals = surface_normals;
      const PN::Limit_report report = PN::subdivide_to_limit<Concurrency_tag>(
        one.mesh, scheme, PN::parameters::join(options.pack(), np(one, rounds)));
      PN::subdivide(two.mesh, scheme, np(two, rounds));
      options.rounds_done = rounds;
      const PN::Limit_report expected = PN::subdivide_to_limit(
        two.mesh, scheme,
        PN::parameters::join(CGAL::parameters::number_of_iterations(0), options.pack(),
                             params::vertex_normal_map(two.normals)));
      // what is not asked for is not set at new vertices
      const bool has_all_normals = surface_normals || !PN::internal::Is_linear<Scheme>::value;
      expect_same(one, two, has_all_normals ? num_vertices(one.mesh) : old_vertices);
      EXPECT_EQ(report.error, expected.error);
      EXPECT_EQ(report.number_of_stand_ins, expected.number_of_stand_ins);
    }
}

TEST(Subdivide_to_limit, IsSubdivideAndMoveToLimit)
{
  long_test([](auto) {
    compare<Surface_mesh, CGAL::Sequential_tag>(mesh_cases::mixed_with_border(),
                                                PN::CatmullClark_scheme());
    compare<CGAL::Polyhedron_3<Kernel>, CGAL::Sequential_tag>(mesh_cases::mixed_with_border(),
                                                              PN::CatmullClark_scheme());
    // whose rounds differ at the border
    compare<Surface_mesh, CGAL::Sequential_tag>(mesh_cases::triangles_with_border(),
                                                PN::Sqrt3_scheme());
#ifdef CGAL_LINKED_WITH_TBB
    compare<Surface_mesh, CGAL::Parallel_tag>(mesh_cases::mixed_with_border(),
                                              PN::CatmullClark_scheme());
#endif
  });
}

// with a linear scheme normals that are not asked for stay as they are at old vertices
TEST(Subdivide_to_limit, OfALinearSchemeWritesNormalsOnlyWhenAskedFor)
{
  compare<Surface_mesh, CGAL::Sequential_tag>(mesh_cases::mixed_with_border(),
                                              PN::linear(PN::CatmullClark_scheme()));
}

TEST(Subdivide_to_limit, RunsOutsideTheMapsAndWithoutNormals)
{
  Surface_mesh empty;
  EXPECT_TRUE(PN::subdivide_to_limit(empty, PN::CatmullClark_scheme()).is_within_tolerance());
  Surface_mesh one, two;
  mesh_cases::build(mesh_cases::mixed_with_border(), one);
  two = one;
  PN::subdivide_to_limit(one, PN::CatmullClark_scheme(),
                         PN::parameters::roundness(1)); // as that of given normals
  // normals are estimated once, on the control mesh
  const auto normals =
    two.add_property_map<Surface_mesh::Vertex_index, Kernel::Vector_3>("n").first;
  PN::estimate_control_normals(two, normals);
  PN::subdivide_to_limit(two, PN::CatmullClark_scheme(), params::vertex_normal_map(normals));
  for (auto v : one.vertices()) EXPECT_EQ(one.point(v), two.point(v));
}

// The rounds can be done, the limits cannot.
TEST(Subdivide_to_limit, AFailureLeavesTheMeshAsItWas)
{
  Surface_mesh mesh;
  mesh_cases::build(mesh_cases::mixed_with_border(), mesh);
  const auto points = [&] {
    return std::vector<Kernel::Point_3>(mesh.points().begin(), mesh.points().end());
  };
  const auto expect_refusal = [&](const auto& scheme, const test_options::Limit_options& options,
                                  const std::string& what) {
    const auto before = points();
    messages::expect_refused<std::exception>(
      [&] {
        PN::subdivide_to_limit(
          mesh, scheme, PN::parameters::join(options.pack(), params::number_of_iterations(2)));
      },
      {what});
    EXPECT_EQ(points(), before);
    EXPECT_TRUE(mesh.is_valid());
  };
  const PN::CatmullClark_scheme scheme;
  expect_refusal(PN::internal::with_border(PN::Kobbelt_scheme(), PN::Border::curve),
                 test_options::Limit_options(), "has no rules for creases");
  test_options::Limit_options counted;
  counted.rounds_done = 2;
  expect_refusal(scheme, counted, "leave rounds_done 0");
  test_options::Limit_options wrong;
  wrong.tolerance = -1;
  expect_refusal(scheme, wrong, "tolerance");
  const PN::CatmullClark_scheme::Tuned late(0.5, 20);
  expect_refusal(late, test_options::Limit_options(), "first round");
}

} // namespace
