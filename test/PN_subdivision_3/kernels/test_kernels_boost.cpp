// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Floating point types of Boost.Multiprecision, with the traits of the package's header alone.

#include "Mesh_cases.h"

#include <CGAL/Gmpfr.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/boost_multiprecision_floats.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <limits>
#include <stdexcept>

namespace {

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

template <class FT>
struct Data
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  using Vector = typename Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Vertex = typename Mesh::Vertex_index;

  static Vertex vertex(int i) { return Vertex(static_cast<typename Vertex::size_type>(i)); }
  static FT epsilon() { return std::numeric_limits<FT>::epsilon(); }
};

using Boost_floats = testing::Types<boost::multiprecision::cpp_bin_float_100
#ifdef CGAL_USE_MPFR
                                    ,
                                    boost::multiprecision::mpfr_float_100
#endif
#ifdef CGAL_PN_SUBDIVISION_3_HAS_FLOAT128
                                    ,
                                    boost::multiprecision::float128
#endif
                                    >;

template <class FT>
class Boost_float : public testing::Test
{};
TYPED_TEST_SUITE(Boost_float, Boost_floats, );

// control points on a sphere of squared radius 3 with normals through its center
TYPED_TEST(Boost_float, KeepsSpheres)
{
  using D = Data<TypeParam>;
  typename D::Mesh mesh;
  build(tetrahedron(), mesh);
  auto normals = mesh.template add_property_map<typename D::Vertex, typename D::Vector>("n").first;
  for (auto v : mesh.vertices()) normals[v] = mesh.point(v) - CGAL::ORIGIN;
  PN::Loop_subdivision(mesh, params::vertex_normal_map(normals).number_of_iterations(2));
  const TypeParam tolerance = TypeParam(100) * D::epsilon();
  for (auto v : mesh.vertices()) {
    const typename D::Vector p = mesh.point(v) - CGAL::ORIGIN;
    EXPECT_LE(CGAL::abs(TypeParam(p * p - TypeParam(3))), tolerance);
    EXPECT_LE(CGAL::abs(TypeParam(normals[v] * normals[v] - TypeParam(1))), tolerance);
  }
}

// 1 - beta of valence 5 is the greater root of (128 x - 63)^2 = 125
TYPED_TEST(Boost_float, HasCosinesOfItsOwnPrecision)
{
  using D = Data<TypeParam>;
  typename D::Mesh mesh;
  build(bipyramid(5), mesh);
  PN::subdivide(mesh, PN::linear(PN::Loop_scheme()));
  const TypeParam x = mesh.point(D::vertex(0)).x(), y = TypeParam(128) * x - TypeParam(63);
  EXPECT_LE(CGAL::abs(TypeParam(y * y - TypeParam(125))), TypeParam(1e5) * D::epsilon());
}

TYPED_TEST(Boost_float, RefusesNaNAndInfinity)
{
  using D = Data<TypeParam>;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), -HUGE_VAL}) {
    typename D::Mesh mesh;
    build(bipyramid(5), mesh);
    mesh.point(D::vertex(3)) = {TypeParam(0), TypeParam(bad), TypeParam(1)};
    EXPECT_THROW(PN::Loop_subdivision(mesh), std::invalid_argument) << bad;
    EXPECT_EQ(mesh.number_of_faces(), 10u);
  }
}

// Angles in the number type: at the origin edges to (1, 0, 0), (0, 1, 0) and (0, 1, 1) include 90, 45 and 90 degrees,
// so that the angle-weighted normal is along (1, sqrt(2), 2 - sqrt(2)).
template <class FT>
void expect_angle_weighted_normal(const FT& epsilon)
{
  using D = Data<FT>;
  typename D::Mesh mesh;
  build(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1}},
             {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}},
        mesh);
  auto normals = mesh.template add_property_map<typename D::Vertex, typename D::Vector>("n").first;
  PN::estimate_control_normals(
    mesh, normals, PN::parameters::control_normal_estimate(PN::Control_normal_estimate::angle));
  const FT root = FT(CGAL::sqrt(FT(2)));
  const typename D::Vector n = normals[D::vertex(0)], expected(FT(1), root, FT(FT(2) - root));
  EXPECT_LE(
    CGAL::to_double(FT(CGAL::cross_product(n, expected).squared_length() / (epsilon * epsilon))),
    1e4);
  EXPECT_LT(CGAL::to_double(FT(n * expected)), 0);
}

TEST(Boost_floats, NormalsAreWeightedByAnglesInTheNumberType)
{
  using boost::multiprecision::cpp_bin_float_100;
  expect_angle_weighted_normal<cpp_bin_float_100>(
    std::numeric_limits<cpp_bin_float_100>::epsilon());
  expect_angle_weighted_normal<double>(std::numeric_limits<double>::epsilon());
  const auto old = CGAL::Gmpfr::set_default_precision(300);
  CGAL::Gmpfr epsilon(1);
  for (int i = 1; i < 300; ++i) epsilon = epsilon / 2;
  expect_angle_weighted_normal<CGAL::Gmpfr>(epsilon);
  CGAL::Gmpfr::set_default_precision(old);
}

// The transfer of curvature in the number type: in 50 digits the normals are those of 100, and those of long double
// are, too, to its precision.
template <class FT, class Scheme>
std::vector<FT> transferred(const Scheme& scheme)
{
  using D = Data<FT>;
  typename D::Mesh mesh;
  build(bipyramid(5), mesh);
  auto normals = mesh.template add_property_map<typename D::Vertex, typename D::Vector>("n").first;
  int i = 0;
  for (auto v : mesh.vertices()) {
    const FT a = FT(i) * FT(0.3125), b = FT(i % 3) * FT(0.25);
    mesh.point(v) = {FT(i == 0 || i == 6 ? 0 : i % 2 + 1), FT(i * i % 5) - FT(2), FT(i % 4) * a};
    normals[v] = typename D::Vector(b, FT(0.125) * a, FT(1));
    ++i;
  }
  PN::subdivide(mesh, scheme, params::vertex_normal_map(normals).number_of_iterations(2));
  std::vector<FT> result;
  for (auto v : mesh.vertices())
    for (int c = 0; c < 3; ++c) result.push_back(normals[v][c]);
  return result;
}

template <class Scheme>
void expect_transfer_in_the_number_type(const Scheme& scheme)
{
  using Less = boost::multiprecision::cpp_bin_float_50;
  using More = boost::multiprecision::cpp_bin_float_100;
  const std::vector<Less> less = transferred<Less>(scheme);
  const std::vector<More> more = transferred<More>(scheme);
  const std::vector<long double> doubles = transferred<long double>(scheme);
  ASSERT_EQ(less.size(), more.size());
  More largest(0);
  for (std::size_t i = 0; i < less.size(); ++i) {
    const More difference = CGAL::abs(More(More(less[i]) - more[i]));
    if (largest < difference) largest = difference;
    EXPECT_LE(CGAL::abs(More(more[i] - More(doubles[i]))), More(3e-17)) << i; // in double: 1e-16
  }
  EXPECT_LE(largest, More(1e-45));
  EXPECT_GT(largest, More(1e-60)); // something has been computed
}

TEST(Boost_floats, CurvatureIsTransferredInTheNumberType)
{
  expect_transfer_in_the_number_type(PN::Loop_scheme::Transfer());
}

} // namespace
