// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Enclosures: as narrow as asked for, by as much precision as it takes.

#include "Mesh_cases.h"
#include "Messages.h"

#ifdef CGAL_USE_MPFI

#  include <CGAL/Gmpq.h>
#  include <CGAL/PN_certificates_3/enclose.h>
#  include <CGAL/PN_subdivision_3.h>
#  include <CGAL/PN_subdivision_3/boost_multiprecision_floats.h>

#  include <cstddef>
#  include <stdexcept>
#  include <string>

namespace {

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// a tetrahedron on a sphere about the origin, whose normals are rounded
template <class K>
struct Control
{
  using Mesh = CGAL::Surface_mesh<typename K::Point_3>;
  Control()
  {
    build(tetrahedron(), mesh);
    for (auto v : mesh.vertices()) normals[v] = mesh.point(v) - CGAL::ORIGIN;
  }
  Mesh mesh;
  typename Mesh::template Property_map<CGAL::SM_Vertex_index, typename K::Vector_3> normals =
    mesh.template add_property_map<CGAL::SM_Vertex_index, typename K::Vector_3>("n").first;
};

using Double = CGAL::Simple_cartesian<double>;

TEST(Enclosures, AreNoWiderThanAskedFor)
{
  const Control<Double> control;
  const auto np = params::vertex_normal_map(control.normals);
  long last_bits = 0;
  for (const double width : {1e-3, 1e-15, 1e-60}) {
    const PN::Enclosure e = PN::enclose(control.mesh, PN::Loop_scheme(), 3, width, np);
    EXPECT_LE(e.width, width);
    EXPECT_GE(e.bits, last_bits);
    last_bits = e.bits;
    EXPECT_EQ(e.mesh.number_of_faces(), 256u);
    for (auto v : e.mesh.vertices()) {
      const auto p = e.mesh.point(v) - CGAL::ORIGIN;
      // on the sphere of squared radius 3
      const CGAL::Gmpfi square = p * p;
      EXPECT_TRUE(square.inf() <= 3 && square.sup() >= 3);
      for (int c = 0; c < 3; ++c) EXPECT_LE(CGAL::to_double(p[c].sup() - p[c].inf()), width);
    }
  }
  EXPECT_GT(last_bits, 200);
}

// of an estimate, by a map and by a number: what doubles make of it, too
TEST(Enclosures, KnowTheRoundness)
{
  const Control<Double> control;
  const auto estimate = PN::estimate_control_normals(control.mesh);
  for (auto v : control.mesh.vertices())
    put(estimate.roundness_map(), v, double(std::size_t(v)) / 4);
  const auto expect_rounded = [&](const auto& np) {
    const PN::Enclosure e = PN::enclose(control.mesh, PN::Loop_scheme(), 1, 1e-15, np(estimate));
    auto rounded = control.mesh;
    PN::subdivide(rounded, PN::Loop_scheme(), np(estimate.clone()));
    for (auto v : rounded.vertices())
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(CGAL::to_double(e.mesh.point(v)[c]), rounded.point(v)[c], 1e-14);
  };
  expect_rounded([](const auto& n) { return params::vertex_normal_map(n); });
  expect_rounded([](const auto& n) { return PN::parameters::roundness(.5).vertex_normal_map(n); });
}

// the real weights of valence 5 with their irrational cosine: 1 - beta is a root of (128 x - 63)^2 = 125
TEST(Enclosures, ContainTheSchemeWithItsRealWeights)
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<CGAL::Gmpq>::Point_3> mesh;
  build(bipyramid(5), mesh);
  const PN::Enclosure e = PN::enclose(mesh, PN::linear(PN::Loop_scheme()), 1, 1e-100);
  const CGAL::Gmpfi y = 128 * e.mesh.point(CGAL::SM_Vertex_index(0)).x() - 63, rest = y * y - 125;
  EXPECT_TRUE(rest.inf() <= 0 && rest.sup() >= 0);
  EXPECT_LE(CGAL::to_double(rest.sup() - rest.inf()), 1e-90);
}

// The weights of modified schemes, of cosines, roots and bounds: 50 digits of another number type are in them, up to
// its rounding.
template <class Scheme>
void expect_around_fifty_digits(const Scheme& scheme)
{
  using FT = boost::multiprecision::cpp_bin_float_50;
  CGAL::Surface_mesh<Double::Point_3> mesh;
  CGAL::Surface_mesh<CGAL::Simple_cartesian<FT>::Point_3> expected;
  build(bipyramid(7), mesh);
  build(bipyramid(7), expected);
  PN::subdivide(expected, PN::linear(scheme), params::number_of_iterations(3));
  const PN::Enclosure e = PN::enclose(mesh, PN::linear(scheme), 3, 1e-60);
  ASSERT_EQ(e.mesh.number_of_vertices(), expected.number_of_vertices());
  for (auto v : expected.vertices())
    for (int c = 0; c < 3; ++c) {
      // a number of 50 digits is a sum of few doubles
      FT rest = expected.point(v)[c];
      CGAL::Gmpfi x = e.mesh.point(v)[c];
      for (int i = 0; i < 5; ++i) {
        const double head = CGAL::to_double(rest);
        x -= CGAL::Gmpfi(head);
        rest -= head;
      }
      EXPECT_LE(CGAL::to_double(CGAL::abs(x)), 1e-47);
    }
}

TEST(Enclosures, OfModifiedSchemesHaveTheirRealWeights)
{
  expect_around_fifty_digits(PN::Loop_scheme::Tuned());
  expect_around_fifty_digits(PN::Loop_scheme::Tuned(PN::Scheme_parameter(1, 3)));
}

TEST(Enclosures, EndAtTheCeiling)
{
  const Control<Double> control;
  const auto np = params::vertex_normal_map(control.normals);
  const auto old = CGAL::Gmpfi::get_default_precision();
  messages::expect_refused<std::domain_error>(
    [&] { PN::enclose(control.mesh, PN::Loop_scheme(), 2, 1e-200, np, 128); }, {"128 bits"});
  EXPECT_EQ(CGAL::Gmpfi::get_default_precision(), old);
  EXPECT_THROW(PN::enclose(control.mesh, PN::Loop_scheme(), 1, -1., np), std::invalid_argument);
}

} // namespace

#else

TEST(Enclosures, AreNoWiderThanAskedFor)
{
  GTEST_SKIP() << "left out, as it may be: MPFI not found";
}

#endif
