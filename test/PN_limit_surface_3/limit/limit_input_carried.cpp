// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What subdivide_to_limit() carries besides, on meshes and numbers that the matrix of features does not have, and what
// is left where a visitor ends it.

#include "Mesh_cases.h"
#include "Mesh_with_attributes.h"
#include "support/Options.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <stdexcept>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using carrying_mesh::Mesh_with_attributes;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

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
  using FT = CGAL::Exact_rational;
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<FT>::Point_3>;
  compare<Mesh, CGAL::Sequential_tag, FT>(mesh_cases::triangles_with_border(),
                                          PN::linear(PN::Loop_scheme()));
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

} // namespace
