// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Exact kernels: what they are exact in. That all kernels give the same results is the subject of test_kernels_exact.cpp.

#include "Mesh_cases.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_USE_CORE
#  include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#endif

#include <stdexcept>

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

// The new normal is exactly parallel to the sum of the control normals as they were normalized.
TEST(Kernels, ExactNormalsKeepTheirDirection)
{
  using K = CGAL::Simple_cartesian<CGAL::Gmpq>;
  using Mesh = CGAL::Surface_mesh<K::Point_3>;
  Mesh mesh;
  build(tetrahedron(), mesh);
  auto n = mesh.add_property_map<Mesh::Vertex_index, K::Vector_3>("n").first;
  // rational unit vectors: quadruples 1 + 4 + 4 = 9, 4 + 9 + 36 = 49, 1 + 16 + 64 = 81, 9 + 16 = 25
  const CGAL::Gmpq third(1, 3), seventh(1, 7), ninth(1, 9), fifth(1, 5);
  const std::vector<K::Vector_3> control{
    K::Vector_3(1, 2, 2) * third, K::Vector_3(2, 3, -6) * seventh, K::Vector_3(-8, 4, 1) * ninth,
    K::Vector_3(0, -3, 4) * fifth};
  for (auto v : mesh.vertices()) n[v] = control[v];
  const Mesh old = mesh;
  PN::Loop_subdivision(mesh, params::vertex_normal_map(n));
  std::size_t i = 4;
  for (auto e : old.edges()) {
    const auto h = old.halfedge(e);
    const K::Vector_3 sum = CGAL::Gmpq(3, 8) * (control[old.source(h)] + control[old.target(h)]) +
                            CGAL::Gmpq(1, 8) * (control[old.target(old.next(h))] +
                                                control[old.target(old.next(old.opposite(h)))]);
    const K::Vector_3 m = n[Mesh::Vertex_index(i++)];
    EXPECT_EQ(CGAL::cross_product(m, sum), CGAL::NULL_VECTOR);
    EXPECT_GT(m * sum, 0);
  }
  EXPECT_EQ(i, 10u);
}

// opposite but for 2^-600: the square of the sum's length is below the range of double. The arc from
// a to b is half a circle, whose normals point inwards.
TEST(Kernels, ExactSumsOfAnyLengthHaveADirection)
{
  using K = CGAL::Exact_predicates_exact_constructions_kernel;
  const K::FT tiny = K::FT(std::ldexp(1., -300)) * K::FT(std::ldexp(1., -300));
  CGAL::Surface_mesh<K::Point_3> mesh;
  auto n = mesh.add_property_map<CGAL::SM_Vertex_index, K::Vector_3>("n", {0, 0, 1}).first;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0});
  mesh.add_face(a, b, mesh.add_vertex({0, 1, 0}));
  n[a] = {1, 0, 0};
  n[b] = {-1, tiny, 0};
  PN::Loop_subdivision(mesh, params::vertex_normal_map(n));
  int found = 0;
  for (auto v : mesh.vertices())
    if (CGAL::squared_distance(mesh.point(v), K::Point_3(0.5, -0.5, 0)) < K::FT(1e-20)) {
      ++found;
      EXPECT_NEAR(CGAL::to_double(n[v].y()), 1, 1e-13);
      EXPECT_NEAR(CGAL::to_double(n[v].x()), 0, 1e-13);
      EXPECT_EQ(n[v].z(), 0);
    }
  EXPECT_EQ(found, 1);
}

// The linear twin in rational numbers, by hand.
TEST(Kernels, LinearTwinIsExact)
{
  using K = CGAL::Exact_predicates_exact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<K::Point_3>;
  using FT = K::FT;
  Mesh mesh;
  build(cube(), mesh);
  // a corner moved by 1/3, which no binary number is
  mesh.point(Mesh::Vertex_index(6)) = K::Point_3(FT(4) / 3, 1, 1);
  PN::subdivide(mesh, PN::linear(PN::CatmullClark_scheme()));
  // order: 8 old, 12 edge vertices, 6 face vertices, the cube's faces as in the soup
  EXPECT_EQ(mesh.point(Mesh::Vertex_index(20)), K::Point_3(0, 0, -1));
  EXPECT_EQ(mesh.point(Mesh::Vertex_index(21)), K::Point_3(FT(1) / 12, 0, 1));
  // vertex of valence 3: (mean of face points + 2 mean of edge midpoints) / 3, x only:
  // faces 1/12, 13/12, 1/12; midpoints (-1 + 4/3)/2, (1 + 4/3)/2, (1 + 4/3)/2
  const FT q = (FT(1) / 12 + FT(13) / 12 + FT(1) / 12) / 3;
  const FT r = (FT(1) / 6 + FT(7) / 6 + FT(7) / 6) / 3;
  EXPECT_EQ(mesh.point(Mesh::Vertex_index(6)).x(), (q + 2 * r) / 3);
}

#ifdef CGAL_USE_CORE
// Exact with square root: from unit normals of a sphere, points stay on it exactly.
TEST(Kernels, ExactWithSqrtStaysOnTheSphere)
{
  using K = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt;
  using Mesh = CGAL::Surface_mesh<K::Point_3>;
  Mesh mesh;
  build(tetrahedron(), mesh);
  auto n = mesh.add_property_map<Mesh::Vertex_index, K::Vector_3>("n").first;
  for (auto v : mesh.vertices()) n[v] = mesh.point(v) - CGAL::ORIGIN;
  PN::Loop_subdivision(mesh, params::vertex_normal_map(n));
  EXPECT_EQ(mesh.number_of_faces(), 16u);
  // the vertices by symmetry: |p|^2 = 3, n = p/|p|
  const auto p = mesh.point(Mesh::Vertex_index(4)) - CGAL::ORIGIN;
  EXPECT_TRUE(p * p == K::FT(3));
  EXPECT_TRUE(n[Mesh::Vertex_index(4)] * n[Mesh::Vertex_index(4)] == K::FT(1));
}
#endif

// \name Parameters of schemes

// 1/20 is no double. The bottom row of a strip of quadrilaterals has the rule of four points.
TEST(Kernels, ParametersMayBeFractions)
{
  using K = CGAL::Simple_cartesian<CGAL::Gmpq>;
  using FT = K::FT;
  const auto weight = [](const PN::Scheme_parameter& tension) {
    CGAL::Surface_mesh<K::Point_3> mesh;
    std::vector<CGAL::SM_Vertex_index> v;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 2; ++j) v.push_back(mesh.add_vertex({FT(i == 2 ? 1 : 0), FT(i), FT(j)}));
    for (std::size_t i = 0; i < 3; ++i)
      mesh.add_face(v[2 * i], v[2 * i + 2], v[2 * i + 3], v[2 * i + 1]);
    PN::subdivide(mesh, PN::linear(PN::Kobbelt_scheme(tension)));
    for (auto u : mesh.vertices())
      if (mesh.point(u).y() == FT(3, 2) && mesh.point(u).z() == 0) return mesh.point(u).x();
    return FT(0);
  };
  EXPECT_EQ(weight(PN::Scheme_parameter(1, 20)), FT(11, 20));
  EXPECT_EQ(weight(PN::Scheme_parameter(1, 16)), FT(9, 16));
  EXPECT_EQ(weight(0.0625), FT(9, 16));
  EXPECT_NE(weight(0.05), FT(11, 20));
  EXPECT_THROW(PN::Scheme_parameter(1, 0), std::invalid_argument);
  EXPECT_THROW(PN::Kobbelt_scheme(PN::Scheme_parameter(1, 2)), std::invalid_argument);
  EXPECT_THROW(PN::Loop_scheme::Tuned(PN::Scheme_parameter(-1, 3)), std::invalid_argument);
}

} // namespace
