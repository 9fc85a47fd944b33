// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// PN_mask_3 over other number types than double: sphere data stay on the sphere as well as the
// numbers can tell, and exactly where they are exact.

#include "PN_mask_3_cases.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpfr.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

namespace {

template <class Kernel>
using Mesh_of = CGAL::Surface_mesh<typename Kernel::Point_3>;

// A box in the sphere of radius 3: (1, 2, 2) with all signs; normals three times unit.
Soup box()
{
  Soup soup;
  for (int i = 0; i < 8; ++i)
    soup.points.push_back({i & 1 ? 1. : -1., i & 2 ? 2. : -2., i & 4 ? 2. : -2.});
  soup.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  return soup;
}

// The same sphere, with normals that are exactly unit.
Soup octahedron()
{
  Soup soup;
  soup.points = {{3, 0, 0}, {0, 3, 0}, {-3, 0, 0}, {0, -3, 0}, {0, 0, 3}, {0, 0, -3}};
  soup.faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
  return soup;
}

template <class Kernel, class Scheme = CatmullClark>
void keeps_sphere(unsigned int rounds, double tolerance, const Soup& soup = box())
{
  using FT = typename Kernel::FT;
  std::vector<Triple> normals = soup.points;
  for (Triple& n : normals)
    for (double& x : n) x /= soup.points.size() == 6 ? 3 : 1;
  Control<Mesh_of<Kernel>> control(soup, normals);
  subdivide_pn<Scheme>(control, rounds);
  ASSERT_GT(num_vertices(control.mesh), soup.points.size());
  for (auto v : vertices(control.mesh)) {
    const auto radius = control.mesh.point(v) - CGAL::ORIGIN;
    const FT excess = radius.squared_length() / FT(9) - FT(1);
    ASSERT_LE(CGAL::abs(excess), FT(tolerance)) << CGAL::to_double(excess);
    const FT normal_excess = get(control.normals, v).squared_length() - FT(1);
    ASSERT_LE(CGAL::abs(normal_excess), FT(tolerance)) << CGAL::to_double(normal_excess);
  }
}

TEST(PN_mask_3_numbers, Float)
{
  keeps_sphere<CGAL::Simple_cartesian<float>>(4, 4 * std::ldexp(1., -23));
}

TEST(PN_mask_3_numbers, LongDouble)
{
  keeps_sphere<CGAL::Simple_cartesian<long double>>(4, 8 * std::ldexp(1., -63));
}

TEST(PN_mask_3_numbers, Multiprecision)
{
  const auto precision = CGAL::Gmpfr::set_default_precision(300);
  keeps_sphere<CGAL::Simple_cartesian<CGAL::Gmpfr>>(3, std::ldexp(1., -296));
  CGAL::Gmpfr::set_default_precision(precision);
}

// No square root: normals are unit to the documented precision.
TEST(PN_mask_3_numbers, ExactWithoutSquareRoot)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  keeps_sphere<Kernel>(2, std::ldexp(1., -50));
  keeps_sphere<Kernel, DooSabin>(2, std::ldexp(1., -50));
}

// With square roots one round is exact, not only close.
TEST(PN_mask_3_numbers, ExactWithSquareRoot)
{
  keeps_sphere<CGAL::Simple_cartesian<CORE::Expr>>(1, 0, octahedron());
}

} // namespace
