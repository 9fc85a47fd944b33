// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Kernels with intervals: of doubles, and, where MPFI is found, of any precision.

#include "Mesh_cases.h"
#include "Messages.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_USE_MPFI
#  include <CGAL/Gmpfi.h>
#endif

#include <utility>

using namespace mesh_cases;
using messages::message_of;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

template <class FT>
FT interval(double lower, double upper)
{
  return FT(std::make_pair(lower, upper));
}

// [lower, upper], rounded outward
template <class FT>
std::pair<double, double> ends(const FT& x)
{
  return CGAL::to_interval(x);
}

template <class FT>
struct Interval_tetrahedron
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  using Vector = typename Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Vertex = typename Mesh::Vertex_index;

  explicit Interval_tetrahedron(const std::vector<Vector>& normals)
  {
    build(tetrahedron(), mesh);
    for (Vertex v : mesh.vertices()) n[v] = normals[v];
  }
  static std::vector<Vector> equal_normals(const Vector& n) { return std::vector<Vector>(4, n); }

  void subdivide() { PN::Loop_subdivision(mesh, params::vertex_normal_map(n)); }

  Mesh mesh;
  typename Mesh::template Property_map<Vertex, Vector> n =
    mesh.template add_property_map<Vertex, Vector>("n").first;
};

#ifdef CGAL_USE_MPFI
using Intervals = testing::Types<CGAL::Interval_nt<true>, CGAL::Gmpfi>;
#else
using Intervals = testing::Types<CGAL::Interval_nt<true>>;
#endif

// Gmpfi with 200 bits
template <class FT>
class Interval_kernel : public testing::Test
{
protected:
  Interval_kernel()
  {
    if constexpr (PN::internal::Has_default_precision<FT>::value)
      old_ = FT::set_default_precision(200);
  }
  ~Interval_kernel() override
  {
    if constexpr (PN::internal::Has_default_precision<FT>::value) FT::set_default_precision(old_);
  }

private:
  long old_ = 0;
};
TYPED_TEST_SUITE(Interval_kernel, Intervals, );

TYPED_TEST(Interval_kernel, ContainsTheResultOfLongDouble)
{
  using Data = Interval_tetrahedron<TypeParam>;
  using Reference = CGAL::Simple_cartesian<long double>;
  CGAL::Surface_mesh<Reference::Point_3> exact;
  build(tetrahedron(), exact);
  auto m = exact.add_property_map<CGAL::SM_Vertex_index, Reference::Vector_3>("n").first;
  std::vector<typename Data::Vector> control;
  for (const Triple& x : normals(tetrahedron()))
    control.emplace_back(TypeParam(x[0]), TypeParam(x[1]), TypeParam(x[2]));
  put_normals(normals(tetrahedron()), exact, m);
  Data intervals(control);
  intervals.subdivide();
  PN::Loop_subdivision(exact, params::vertex_normal_map(m));
  for (auto v : exact.vertices())
    for (int k = 0; k < 3; ++k) {
      const auto [inf, sup] = ends(intervals.mesh.point(v)[k]);
      EXPECT_LE(inf, exact.point(v)[k]);
      EXPECT_GE(sup, exact.point(v)[k]);
      EXPECT_LT(sup - inf, 1e-13);
    }
}

// control normals that are unit vectors only up to rounding, and the normals of a call's result
TYPED_TEST(Interval_kernel, ServesForSeveralCalls)
{
  using Data = Interval_tetrahedron<TypeParam>;
  Data intervals(Data::equal_normals({TypeParam(0.48), TypeParam(0.6), TypeParam(0.64)}));
  intervals.subdivide();
  intervals.subdivide();
  EXPECT_EQ(intervals.mesh.number_of_faces(), 64u);
  for (auto v : intervals.mesh.vertices())
    for (int k = 0; k < 3; ++k) {
      const auto [inf, sup] = ends(intervals.n[v][k]);
      const double exact[] = {0.48, 0.6, 0.64};
      EXPECT_LT(inf, exact[k] + 1e-15);
      EXPECT_GT(sup, exact[k] - 1e-15);
      EXPECT_LT(sup - inf, 1e-13);
    }
}

// weights that are negative for certain and for uncertain
TYPED_TEST(Interval_kernel, ServesForTheSchemeOfKobbelt)
{
  CGAL::Surface_mesh<typename Interval_tetrahedron<TypeParam>::Kernel::Point_3> intervals;
  CGAL::Surface_mesh<CGAL::Simple_cartesian<long double>::Point_3> exact;
  build(cube(), intervals);
  build(cube(), exact);
  PN::subdivide(intervals, PN::linear(PN::Kobbelt_scheme()));
  PN::subdivide(exact, PN::linear(PN::Kobbelt_scheme()));
  for (auto v : exact.vertices())
    for (int k = 0; k < 3; ++k) {
      const auto [inf, sup] = ends(intervals.point(v)[k]);
      EXPECT_LE(inf, exact.point(v)[k] + 1e-15L);
      EXPECT_GE(sup, exact.point(v)[k] - 1e-15L);
      EXPECT_LT(sup - inf, 1e-13);
    }
}

TYPED_TEST(Interval_kernel, UndecidedComparisonsAreRefusedByName)
{
  // whether the sum at an edge vanishes depends on the interval
  using Data = Interval_tetrahedron<TypeParam>;
  auto control = Data::equal_normals({0, 0, 1});
  control[0] = {0, 0, -1};
  control[1] = {0, 0, 1};
  control[2] = {0, interval<TypeParam>(-1e-9, 1e-9), 1};
  control[3] = {0, 0, -1};
  Data opposite(control);
  const auto old = opposite.mesh;
  const std::string message = message_of<std::domain_error>([&] { opposite.subdivide(); });
  EXPECT_NE(message.find("vertex"), std::string::npos) << message;
  EXPECT_NE(message.find("precision"), std::string::npos) << message;
  EXPECT_EQ(faces_of(opposite.mesh), faces_of(old));
  EXPECT_EQ(points(opposite.mesh), points(old));
}

TYPED_TEST(Interval_kernel, UndecidedControlNormalsAreRefusedByName)
{
  using Data = Interval_tetrahedron<TypeParam>;
  auto control = Data::equal_normals({0, 0, 1});
  control[2] = {0, 0, interval<TypeParam>(0, 1)}; // zero or not
  Data zero_or_not(control);
  EXPECT_NE(message_of<std::domain_error>([&] { zero_or_not.subdivide(); }).find("vertex 2"),
            std::string::npos);
}

// which component is the largest, or whether two are equal, has no part in it
TYPED_TEST(Interval_kernel, EqualComponentsOfNormalsNeedNotBeToldApart)
{
  using Data = Interval_tetrahedron<TypeParam>;
  const TypeParam third = TypeParam(1) / TypeParam(3);
  for (const double size : {1., 0x1p-600, 0x1p600}) {
    std::vector<typename Data::Vector> control;
    for (const auto& [x, y] : {std::pair<int, int>{1, 1}, {1, -1}, {-1, 1}, {-1, -1}})
      control.emplace_back(third * TypeParam(x * size), third * TypeParam(y * size),
                           TypeParam(size));
    Data data(control);
    EXPECT_EQ(message_of<std::domain_error>([&] { data.subdivide(); }), "") << size;
    // |(1/3, 1/3, 1)|^2 = 11/9
    const auto [inf, sup] = ends(TypeParam(data.n[CGAL::SM_Vertex_index(0)].z()));
    EXPECT_GT(inf, 0.3);
    EXPECT_LT(sup - inf, 1e-13);
  }
}

// what is estimated is an interval, or what cannot be decided is named
TYPED_TEST(Interval_kernel, NormalsAreEstimatedOrRefused)
{
  using Data = Interval_tetrahedron<TypeParam>;
  typename Data::Mesh plain, blurred;
  build(tetrahedron(), plain);
  build(tetrahedron(), blurred);
  EXPECT_EQ(message_of<std::domain_error>([&] { PN::Loop_subdivision(plain); }), "");
  EXPECT_EQ(plain.number_of_faces(), 16u);
  // intervals that overlap
  for (auto v : blurred.vertices()) {
    const auto p = blurred.point(v);
    const TypeParam wide = interval<TypeParam>(-3, 3);
    blurred.point(v) = {p.x() + wide, p.y() + wide, p.z() + wide};
  }
  const auto scheme =
    PN::internal::with_normal_estimate(PN::Loop_scheme(), PN::Control_normal_estimate::reciprocal);
  EXPECT_NE(
    message_of<std::domain_error>([&] { PN::subdivide(blurred, scheme); }).find("precision"),
    std::string::npos);
}

// cosines are enclosed, not rounded: the new point of a vertex of valence 5, of which
// 64 beta = 40 - (3 + 2 cos(72 degrees))^2 with 2 cos = (sqrt(5) - 1)/2
TYPED_TEST(Interval_kernel, WeightsContainTheRealOnes)
{
  using Kernel = CGAL::Simple_cartesian<TypeParam>;
  CGAL::Surface_mesh<typename Kernel::Point_3> mesh;
  build(bipyramid(5), mesh);
  PN::subdivide(mesh, PN::linear(PN::Loop_scheme()));
  const TypeParam x = mesh.point(CGAL::SM_Vertex_index(0)).x();
  // 1 - beta = (24 + (5 + sqrt(5))^2 / 4) / 64 is the greater root of (128 x - 63)^2 = 125
  const TypeParam y = TypeParam(128) * x - TypeParam(63);
  const TypeParam rest = y * y - TypeParam(125);
  EXPECT_TRUE(CGAL::possibly(rest == TypeParam(0)));
  EXPECT_LT(ends(rest).second - ends(rest).first, 1e-11);
  EXPECT_GT(ends(x).first, 0.5);
}

} // namespace
