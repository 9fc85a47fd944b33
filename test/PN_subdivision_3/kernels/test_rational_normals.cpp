// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Unit normals of few bits in exact kernels.

#include "Mesh_cases.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/rational_normals.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

namespace {

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Q = CGAL::Gmpq;
using Vector = Kernel::Vector_3;

Q power_of_two(int e)
{
  Q x(1);
  for (; e > 0; --e) x *= 2;
  return x;
}

TEST(Rational_normals, AreUnitVectorsNearTheDirection)
{
  const Q tiny = Q(1) / power_of_two(900);
  const Vector vectors[] = {Vector(1, 2, 3),
                            Vector(Q(-5, 7), Q(1, 3), Q(11, 13)),
                            Vector(1, 1, 1),
                            Vector(0, 0, -4),
                            Vector(-1, tiny, 0),
                            Vector(tiny, -tiny, Q(2) * tiny),
                            Vector(Q(1) / tiny, Q(3) / tiny, Q(-1) / tiny)};
  for (const int bits : {1, 2, 10, 53, 160, 1500})
    for (const Vector& v : vectors) {
      const Vector n = PN::rational_unit_normal(v, bits);
      EXPECT_EQ(n * n, Q(1));
      EXPECT_GT(n * v, Q(0));
      // sin^2 <= (1.5 2^-bits)^2
      const Vector c = CGAL::cross_product(n, v);
      EXPECT_LE(Q(4) * power_of_two(2 * bits) * (c * c), Q(9) * (v * v)) << bits;
      for (int i = 0; i < 3; ++i)
        EXPECT_LE(n[i].denominator().bit_size(), std::size_t(2 * bits + 1)) << bits;
    }
}

TEST(Rational_normals, OfNothingAndOfWrongPrecision)
{
  EXPECT_EQ(PN::rational_unit_normal(Vector(0, 0, 0), 10), Vector(0, 0, 0));
  EXPECT_THROW(PN::rational_unit_normal(Vector(1, 0, 0), 0), std::invalid_argument);
  EXPECT_THROW(PN::Rounded_exact_normals(-3), std::invalid_argument);
}

template <class K>
struct Refined
{
  using FT = typename K::FT;
  using Mesh = CGAL::Surface_mesh<typename K::Point_3>;

  explicit Refined(unsigned rounds)
  {
    build(tetrahedron(), mesh);
    for (auto v : mesh.vertices())
      normals[v] = PN::rational_unit_normal(mesh.point(v) - CGAL::ORIGIN, 20);
    PN::Loop_subdivision(mesh, params::vertex_normal_map(normals).number_of_iterations(rounds));
  }

  Mesh mesh;
  typename Mesh::template Property_map<CGAL::SM_Vertex_index, typename K::Vector_3> normals =
    mesh.template add_property_map<CGAL::SM_Vertex_index, typename K::Vector_3>("n").first;
};

template <class K>
void expect_rounded_normals(unsigned rounds)
{
  using FT = typename K::FT;
  const Refined<K> plain(rounds);
  const auto refined = [rounds] {
    const PN::Rounded_exact_normals rounded(70);
    return Refined<K>(rounds);
  };
  const Refined<K> few_bits = refined();
  std::size_t units = 0;
  for (auto v : plain.mesh.vertices()) {
    const auto &n = few_bits.normals[v], &m = plain.normals[v];
    EXPECT_TRUE(n * n == FT(1));
    units += m * m == FT(1);
    EXPECT_LT(CGAL::to_double((n - m).squared_length()), 1e-28);
    EXPECT_LT(CGAL::to_double(CGAL::squared_distance(few_bits.mesh.point(v), plain.mesh.point(v))),
              1e-28);
  }
  // and it has ended: lengths are those of double again
  EXPECT_LT(units, plain.mesh.number_of_vertices());
  const Refined<K> after(rounds);
  for (auto v : plain.mesh.vertices()) EXPECT_TRUE(after.normals[v] == plain.normals[v]);
}

TEST(Rational_normals, OfRefinedVertices)
{
  expect_rounded_normals<Kernel>(2);
  expect_rounded_normals<CGAL::Exact_predicates_exact_constructions_kernel>(1);
}

} // namespace
