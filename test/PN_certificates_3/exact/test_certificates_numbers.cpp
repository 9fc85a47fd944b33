// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Certificates in number types that round otherwise than the processor does, of shapes of other kernels, and
// beyond the range of double.

#include <CGAL/Exact_rational.h>
#include <CGAL/Gmpfr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_subdivision_3/boost_multiprecision_floats.h>
#include <CGAL/PN_subdivision_3/rational_normals.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/sqrt_extension_normals.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#ifdef CGAL_USE_GMPXX
#  include <CGAL/mpq_class.h>
#endif

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using CGAL::certainly;
using CGAL::certainly_not;

template <class FT>
using Kernel_of = CGAL::Simple_cartesian<FT>;

void expect_tight(const CGAL::Interval_nt<>& x, double expected)
{
  EXPECT_LE(x.inf(), expected);
  EXPECT_GE(x.sup(), expected * (1 - 1e-15));
  EXPECT_LE(x.sup() - x.inf(), 8 * std::numeric_limits<double>::epsilon() * x.sup());
}

// (1, 2^-200, 0) is 2^-401 (1 - 2^-402 + ...) outside the unit sphere
template <class FT>
void expect_refuted()
{
  using K = Kernel_of<FT>;
  const typename K::Sphere_3 sphere(typename K::Point_3(0, 0, 0), FT(1));
  const typename K::Point_3 p(FT(1), FT(std::ldexp(1., -200)), FT(0));
  EXPECT_TRUE(certainly_not(PN::is_on(p, sphere)));
  expect_tight(PN::distance_interval(p, sphere), std::ldexp(1., -401));
  EXPECT_TRUE(certainly(PN::is_on(typename K::Point_3(0, 0, -1), sphere)));
}

TEST(Certificates_of_rounded_numbers, KnowWhatIsBelowTheirRounding)
{
  expect_refuted<boost::multiprecision::cpp_bin_float_100>();
  expect_refuted<CGAL::Gmpfr>();
#ifdef CGAL_PN_SUBDIVISION_3_HAS_FLOAT128
  expect_refuted<boost::multiprecision::float128>();
#endif
}

// 2^-200 in units of 2^-399
TEST(Certificates_of_rounded_numbers, CountUnitsOfTheNumberType)
{
  const auto old = CGAL::Gmpfr::set_default_precision(400);
  using K = Kernel_of<CGAL::Gmpfr>;
  const K::Plane_3 plane(K::Point_3(0, 0, 0), K::Vector_3(0, 0, 1));
  const K::Point_3 p(3, 5, CGAL::Gmpfr(std::ldexp(1., -200)));
  expect_tight(PN::distance_in_ulps(p, plane), std::ldexp(1., 199));
  CGAL::Gmpfr::set_default_precision(old);
}

// Numbers far beyond the range of double: a sphere of radius 10^-400 or 10^400, and points at twice the radius or
// at a radius and 10^-1200 of it.
TEST(Certificates_beyond_the_range_of_double, AreTight)
{
  using Q = CGAL::Exact_rational;
  using K = Kernel_of<Q>;
  Q tiny(1);
  for (int i = 0; i < 400; ++i) tiny = tiny / Q(10);
  const double denormal = std::numeric_limits<double>::denorm_min();
  for (const Q& radius : {tiny, Q(Q(1) / tiny)}) {
    const K::Sphere_3 sphere(K::Point_3(0, 0, 0), Q(radius * radius));
    const K::Point_3 twice(Q(Q(2) * radius), 0, 0);
    expect_tight(PN::distance_in_ulps(twice, sphere), 0x1p52);
    const auto distance = PN::distance_interval(twice, sphere);
    if (radius == tiny) {
      EXPECT_EQ(distance.inf(), 0);
      EXPECT_LE(distance.sup(), 4 * denormal);
    } else {
      EXPECT_GE(distance.inf(), std::numeric_limits<double>::max());
    }
    const K::Point_3 near(Q(radius * (Q(1) + tiny * tiny * tiny)), 0, 0);
    EXPECT_TRUE(certainly_not(PN::is_on(near, sphere, 0.)));
    EXPECT_LE(PN::distance_in_ulps(near, sphere).sup(), 4 * denormal);
  }
}

// 10^-400 is no double, but a number of 300 bits
TEST(Certificates_beyond_the_range_of_double, TakeCoordinatesAsTheyAre)
{
  const auto old = CGAL::Gmpfr::set_default_precision(300);
  using K = Kernel_of<CGAL::Gmpfr>;
  CGAL::Gmpfr tiny(1);
  for (int i = 0; i < 1300; ++i) tiny = tiny / 2;
  const K::Sphere_3 sphere(K::Point_3(0, 0, 0), CGAL::Gmpfr(1));
  EXPECT_TRUE(certainly_not(PN::is_on(K::Point_3(1, tiny, 0), sphere)));
  const K::Sphere_3 small(K::Point_3(0, 0, 0), CGAL::Gmpfr(tiny * tiny));
  EXPECT_TRUE(certainly(PN::is_on(K::Point_3(0, tiny, 0), small)));
  EXPECT_LE(PN::distance_interval(K::Point_3(0, tiny * 2, 0), small).sup(),
            4 * std::numeric_limits<double>::denorm_min()); // 2^-1300
  CGAL::Gmpfr::set_default_precision(old);
}

// \name Numbers with one square root: a cube with rational points on the unit sphere
struct Cube_with_roots
{
  using K = Kernel_of<CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq, CGAL::Tag_true>>;
  using Mesh = CGAL::Surface_mesh<K::Point_3>;

  Cube_with_roots()
  {
    using P = K::Point_3;
    CGAL::make_hexahedron(P(-1, -1, -1), P(1, -1, -1), P(1, 1, -1), P(-1, 1, -1), P(-1, 1, 1),
                          P(-1, -1, 1), P(1, -1, 1), P(1, 1, 1), mesh);
    for (auto v : mesh.vertices()) {
      normals[v] = PN::rational_unit_normal(mesh.point(v) - CGAL::ORIGIN, 20);
      mesh.point(v) = CGAL::ORIGIN + normals[v];
    }
  }
  void refine()
  {
    PN::subdivide(mesh, PN::CatmullClark_scheme(), CGAL::parameters::vertex_normal_map(normals));
  }
  auto deviation() const
  {
    return PN::mesh_deviation(mesh, K::Sphere_3(CGAL::ORIGIN, 1),
                              CGAL::parameters::vertex_normal_map(normals));
  }

  Mesh mesh;
  Mesh::Property_map<CGAL::SM_Vertex_index, K::Vector_3> normals =
    mesh.add_property_map<CGAL::SM_Vertex_index, K::Vector_3>("n").first;
};

TEST(Certificates_with_roots, ProveOrRefute)
{
  Cube_with_roots cube;
  cube.refine();
  EXPECT_EQ(cube.mesh.number_of_vertices(), 26u);
  const auto exact = cube.deviation();
  EXPECT_TRUE(certainly(exact.points_are_on_shape) && certainly(exact.normals_are_exact));
  EXPECT_STREQ(exact.advice, "");
  const CGAL::SM_Vertex_index last(25);
  cube.mesh.point(last) =
    cube.mesh.point(last) + CGAL::Gmpq(std::ldexp(1., -60)) * cube.normals[last];
  const auto moved = cube.deviation();
  EXPECT_TRUE(certainly_not(moved.points_are_on_shape));
  EXPECT_EQ(moved.farthest_point, last);
}

// of an edge whose ends have roots, in the words of CGAL where its preconditions are on
TEST(Certificates_with_roots, RefuseWhatNeedsMoreThanOne)
{
  using FT = Cube_with_roots::K::FT;
  using Traits = PN::Unit_normal_traits<FT>;
  EXPECT_THROW(Traits::inverse_length(FT(1, 1, 2)), std::domain_error);
  EXPECT_THROW(Traits::inverse_length(FT(0, 1, 2) * FT(0, 1, 2)), std::domain_error);
  EXPECT_TRUE(Traits::inverse_length(FT(CGAL::Gmpq(9, 4))) == FT(CGAL::Gmpq(2, 3)));
  Cube_with_roots cube;
  cube.refine();
  EXPECT_THROW(cube.refine(), std::logic_error);
  EXPECT_EQ(cube.mesh.number_of_vertices(), 26u);
  EXPECT_TRUE(certainly(cube.deviation().points_are_on_shape));
}

// points (1, 1, 0) and (1, 1, 2^-30) of doubles, a sphere of squared radius 2 of another kernel
template <class FT>
void expect_shapes_are_taken(const FT& two)
{
  using K = Kernel_of<FT>;
  using Double = Kernel_of<double>;
  using Interval = Kernel_of<CGAL::Interval_nt<>>;
  const typename K::Sphere_3 sphere(typename K::Point_3(0, 0, 0), two);
  EXPECT_TRUE(certainly(PN::is_on(Double::Point_3(1, 1, 0), sphere)));
  EXPECT_TRUE(certainly_not(PN::is_on(Double::Point_3(1, 1, 0x1p-30), sphere)));
  EXPECT_TRUE(CGAL::possibly(PN::is_on(Interval::Point_3(1, 1, 0), sphere)));
  EXPECT_TRUE(certainly_not(PN::is_on(Interval::Point_3(1, 1, 1), sphere)));
}

TEST(Certificates_of_mixed_kernels, TakeShapesOfExactAndOfRoundedNumbers)
{
  expect_shapes_are_taken(CGAL::Gmpq(2));
#ifdef CGAL_USE_GMPXX
  expect_shapes_are_taken(mpq_class(2));
#endif
  expect_shapes_are_taken(CGAL::Gmpfr(2));
  // 1.1 is a fraction, and no double
  using K = Kernel_of<CGAL::Gmpq>;
  const K::Sphere_3 sphere(K::Point_3(0, 0, 0), CGAL::Gmpq(11, 10));
  const double root = std::sqrt(1.1);
  EXPECT_TRUE(certainly_not(PN::is_on(Kernel_of<double>::Point_3(root, 0, 0), sphere)));
  EXPECT_LE(PN::distance_in_ulps(Kernel_of<double>::Point_3(root, 0, 0), sphere).sup(), 1);
}

} // namespace
