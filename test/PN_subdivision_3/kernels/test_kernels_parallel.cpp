// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Several threads give what one gives, bit for bit: number types with settings of the thread
// (rounding, precision) and without, on every kind of mesh.

#include "Extent.h"

#include <CGAL/Gmpfr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB

#  include <tbb/global_control.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// What a thread has to take over from its caller, and what tells two numbers apart.
template <class FT>
struct Setting
{
  static constexpr int rounds = CGAL::Algebraic_structure_traits<FT>::Is_exact::value ? 1 : 2;
  static bool same(const FT& a, const FT& b) { return a == b; }
};
template <>
struct Setting<CGAL::Gmpfr>
{
  static constexpr int rounds = 2;
  Setting() { CGAL::Gmpfr::set_default_precision(1000); }
  ~Setting() { CGAL::Gmpfr::set_default_precision(53); }
  static bool same(const CGAL::Gmpfr& a, const CGAL::Gmpfr& b)
  {
    return a == b && a.get_precision() == 1000 && b.get_precision() == 1000;
  }
};
template <bool is_protected>
struct Setting<CGAL::Interval_nt<is_protected>>
{
  using Interval = CGAL::Interval_nt<is_protected>;
  static constexpr int rounds = 2;
  static bool same(const Interval& a, const Interval& b)
  {
    return a.inf() == b.inf() && a.sup() == b.sup();
  }
  CGAL::Protect_FPU_rounding<!is_protected> upward;
};

// a bulging grid of triangles, large enough for several pieces; 1/3 and other weights are rounded
template <class Kernel, class Mesh>
void make_grid(Mesh& mesh)
{
  using FT = typename Kernel::FT;
  const int n = 20;
  CGAL::make_grid(
    n, n, mesh,
    [](auto i, auto j) {
      const int x = int(i) - 10, y = int(j) - 9;
      return typename Kernel::Point_3(FT(x), FT(y), FT(x * x + x * y) / FT(97));
    },
    true);
}

template <class Mesh>
struct Result
{
  using Point = typename boost::property_traits<
    typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  std::vector<std::pair<Point, typename Kernel::Vector_3>> values;
  std::vector<std::size_t> corners;
};

template <class Concurrency_tag, class Mesh>
Result<Mesh> refined(Mesh mesh)
{
  using Kernel = typename Result<Mesh>::Kernel;
  using FT = typename Kernel::FT;
  auto points = get(CGAL::vertex_point, mesh);
  auto normals = get(CGAL::dynamic_vertex_property_t<typename Kernel::Vector_3>(), mesh);
  int k = 0;
  for (auto v : vertices(mesh)) {
    put(normals, v, typename Kernel::Vector_3(FT(k % 7) / FT(20), FT(k % 5) / FT(30), FT(1)));
    ++k;
  }
  PN::CatmullClark_subdivision<Concurrency_tag>(
    mesh, params::number_of_iterations(Setting<FT>::rounds).vertex_normal_map(normals));
  Result<Mesh> result;
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> index;
  for (auto v : vertices(mesh)) {
    index.emplace(v, index.size());
    result.values.emplace_back(get(points, v), get(normals, v));
  }
  for (auto f : faces(mesh))
    for (auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      result.corners.push_back(index.at(v));
  return result;
}

template <class Mesh>
void expect_same_in_parallel(const Mesh& mesh)
{
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  using FT = typename Result<Mesh>::Kernel::FT;
  const Result<Mesh> one = refined<CGAL::Sequential_tag>(mesh);
  for (int run = 0; run < 2; ++run) {
    const Result<Mesh> several = refined<CGAL::Parallel_tag>(mesh);
    EXPECT_EQ(one.corners, several.corners);
    ASSERT_EQ(one.values.size(), several.values.size());
    std::size_t differing = 0;
    for (std::size_t v = 0; v < one.values.size(); ++v)
      for (int c = 0; c < 3; ++c)
        differing += !Setting<FT>::same(one.values[v].first[c], several.values[v].first[c]) ||
                     !Setting<FT>::same(one.values[v].second[c], several.values[v].second[c]);
    EXPECT_EQ(differing, 0u);
  }
}

template <class FT>
using Kernel_of = CGAL::Simple_cartesian<FT>;

} // namespace

template <class FT>
class Parallel : public testing::Test
{};
using Number_types = In_full<testing::Types<float, double, CGAL::Gmpq, CGAL::Gmpfr,
                                            CGAL::Interval_nt<true>, CGAL::Interval_nt<false>>,
                             testing::Types<CGAL::Gmpfr, CGAL::Interval_nt<true>>>;
TYPED_TEST_SUITE(Parallel, Number_types, );

TYPED_TEST(Parallel, SurfaceMesh)
{
  [[maybe_unused]] const Setting<TypeParam> setting;
  CGAL::Surface_mesh<typename Kernel_of<TypeParam>::Point_3> mesh;
  make_grid<Kernel_of<TypeParam>>(mesh);
  expect_same_in_parallel(mesh);
}

TYPED_TEST(Parallel, SurfaceMeshWithRemovedElements)
{
  [[maybe_unused]] const Setting<TypeParam> setting;
  CGAL::Surface_mesh<typename Kernel_of<TypeParam>::Point_3> mesh;
  make_grid<Kernel_of<TypeParam>>(mesh);
  mesh.remove_vertex(mesh.add_vertex());
  expect_same_in_parallel(mesh);
}

TYPED_TEST(Parallel, Polyhedron)
{
  [[maybe_unused]] const Setting<TypeParam> setting;
  CGAL::Polyhedron_3<Kernel_of<TypeParam>> mesh;
  make_grid<Kernel_of<TypeParam>>(mesh);
  expect_same_in_parallel(mesh);
}

#endif // CGAL_LINKED_WITH_TBB
