// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// PN_mask_3 over other number types than double: sphere data stay on the sphere as well as the
// numbers can tell, and exactly where they are exact.

#include "Named_shapes.h"
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
Control_mesh box()
{
  Control_mesh mesh = named_shapes::cube();
  for (Triple& p : mesh.points) p = {p[0], 2 * p[1], 2 * p[2]};
  mesh.normals = mesh.points;
  return mesh;
}

// The same sphere, with normals that are exactly unit.
Control_mesh octahedron()
{
  Control_mesh mesh = test_meshes::bipyramid(4);
  mesh.normals = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.points.clear();
  for (const Triple& n : mesh.normals) mesh.points.push_back({3 * n[0], 3 * n[1], 3 * n[2]});
  return mesh;
}

template <class Kernel, class Scheme = CatmullClark>
void keeps_sphere(unsigned int rounds, double tolerance, const Control_mesh& shape = box())
{
  using FT = typename Kernel::FT;
  Control<Mesh_of<Kernel>> control(shape);
  subdivide_pn<Scheme>(control, rounds);
  ASSERT_GT(num_vertices(control.mesh), shape.points.size());
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
