// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Creases in other number types: the average keeps circles exactly, intervals contain the result, multiprecision is as near
// as its precision says.

#include "Crease_shapes.h"
#include "One_root_number.h"
#include "Rational_shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpfr.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_subdivision_3/creases/Crease_average.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

namespace {

using namespace crease_shapes;
using namespace CGAL::PN_subdivision_3;
using rational_shapes::Rational;

// \name The exact average
using Exact = One_root_number;
using Exact_vector = Coordinates<Exact, 3>;
using Samples = std::vector<rational_shapes::Vector<Rational>>;

Exact_vector exact(const rational_shapes::Vector<Rational>& v)
{
  return {Exact(v[0]), Exact(v[1]), Exact(v[2])};
}

// rational points of the unit circle at this height
Samples rational_circle(const Rational& z)
{
  Samples circle;
  for (const Real a : uneven(7)) {
    const auto p = rational_shapes::unit_2(double(std::cos(a)), double(std::sin(a)));
    circle.push_back({p[0], p[1], z});
  }
  return circle;
}

// any affine weights: a circle in space and the normals of all surfaces of revolution along it
TEST(Exact_creases, Any_weights_keep_circles)
{
  const Samples circle = rational_circle(Rational(3));
  const std::vector<std::vector<int>> weights{{8, 8}, {-1, 9, 9, -1}, {4, 19, 4}, {1, 16, 10}};
  for (const auto& row : weights) {
    int sum = 0;
    for (const int w : row) sum += w;
    std::vector<Crease_average<Exact, 3>::Entry> entries;
    std::vector<Exact_vector> around, slanted;
    for (std::size_t j = 0; j < row.size(); ++j) {
      const Exact_vector m = exact(circle[j]);
      entries.push_back({Exact(Rational(row[j], sum)), m, {-m[1], m[0], Exact(0)}});
      slanted.push_back(
        {Exact(Rational(3, 5)) * m[0], Exact(Rational(3, 5)) * m[1], Exact(Rational(4, 5))});
    }
    const Crease_average<Exact, 3> average(entries.data(), entries.data() + entries.size());
    const Exact_vector p = average.point(), t = average.tangent();
    EXPECT_TRUE(p[0] * p[0] + p[1] * p[1] == Exact(1));
    EXPECT_TRUE(p[2] == Exact(3));
    EXPECT_TRUE(t[0] == -p[1] && t[1] == p[0] && t[2] == Exact(0));
    const Exact_vector n = average.normal([&](std::size_t j) { return slanted[j]; });
    EXPECT_TRUE(n[0] == Exact(Rational(3, 5)) * p[0] && n[1] == Exact(Rational(3, 5)) * p[1] &&
                n[2] == Exact(Rational(4, 5)));
  }
}

// \name Kernels
// rounds of the capped cylinder in FT beside those in double
template <class FT, class Scheme>
void expect_near_double(const Control& control, const Scheme& scheme, int rounds, double bar)
{
  Crease_run<FT, Scheme> run(control, scheme);
  Crease_run<double, Scheme> expected(control, scheme);
  run.refine(rounds);
  expected.refine(rounds);
  ASSERT_EQ(run.number_of_slots(), expected.number_of_slots());
  for (Index slot = 0; slot < run.number_of_slots(); ++slot)
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(CGAL::to_double(run.point(slot)[k]), expected.point(slot)[k], bar);
      EXPECT_NEAR(CGAL::to_double(run.normal(slot)[k]), expected.normal(slot)[k], bar);
    }
}

Control semi_sharp_cylinder()
{
  Part part = capped_cylinder(uneven(5));
  part.place();
  Control c = part.control();
  int k = 0;
  for (auto& edge : c.sharp_edges)
    if (++k % 3 == 0) edge.second = 0.3 * k;
  c.sharp_vertices[2] = 0.7;
  return c;
}

TEST(Creases_in_numbers, Exact_constructions)
{
  using FT = CGAL::Exact_predicates_exact_constructions_kernel::FT;
  expect_near_double<FT>(semi_sharp_cylinder(), CatmullClark_scheme(), 1, 1e-13);
  // estimated normals
  expect_near_double<FT>(capped_cylinder(uneven(5)).control(false), CatmullClark_scheme(), 1,
                         1e-13);
}

TEST(Creases_in_numbers, Multiprecision)
{
  expect_near_double<CGAL::Gmpfr>(semi_sharp_cylinder(), CatmullClark_scheme(), 2, 1e-13);
}

TEST(Creases_in_numbers, Intervals_contain_the_cylinder)
{
  using Interval = CGAL::Interval_nt<true>;
  const Part part = capped_cylinder(uneven(5));
  Crease_run<Interval, CatmullClark_scheme> run(part.control(), CatmullClark_scheme());
  run.refine(2);
  std::size_t rims = 0;
  for (const auto& star : run.creases().stars) {
    const auto p = run.point(star.vertex);
    const Interval square = p[0] * p[0] + p[1] * p[1];
    // the given points are on the circle up to rounding
    EXPECT_LE(square.inf(), 1 + 1e-15);
    EXPECT_GE(square.sup(), 1 - 1e-15);
    EXPECT_LE(square.sup() - square.inf(), 1e-11);
    ++rims;
  }
  EXPECT_EQ(rims, 40u);
}

using Wide = CGAL::Interval_nt<>;
using Wide_kernel = CGAL::Simple_cartesian<Wide>;
using Wide_mesh = CGAL::Surface_mesh<Wide_kernel::Point_3>;

auto wide_normals(Wide_mesh& mesh)
{
  return mesh.add_property_map<Wide_mesh::Halfedge_index, Wide_kernel::Vector_3>("h:n").first;
}

// A triangle whose border is a crease. The rows of the mask at its vertices meet a normal that is opposite
// to theirs up to an angle at which its height begins to fade: wide intervals do not decide that.
void add_triangle(Wide_mesh& mesh, double angle)
{
  const auto normals = wide_normals(mesh);
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}),
             c = mesh.add_vertex({0, 1, 0});
  const auto f = mesh.add_face(a, b, c);
  const auto wide = [](double x) { return Wide(x - 1e-4, x + 1e-4); };
  for (auto h : halfedges_around_face(mesh.halfedge(f), mesh)) {
    const double turn = mesh.target(h) == a ? angle : 0;
    normals[h] = Wide_kernel::Vector_3(wide(0), wide(std::sin(turn)), wide(std::cos(turn)));
  }
}

void add_octahedron(Wide_mesh& mesh)
{
  const auto normals = wide_normals(mesh);
  const auto pole = [&](double x, double y, double z) { return mesh.add_vertex({x, y, z}); };
  const auto north = pole(0, 0, 1), south = pole(0, 0, -1);
  const decltype(north) equator[] = {pole(1, 0, 0), pole(0, 1, 0), pole(-1, 0, 0), pole(0, -1, 0)};
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.add_face(equator[i], equator[(i + 1) % 4], north);
    mesh.add_face(equator[(i + 1) % 4], equator[i], south);
  }
  for (auto h : halfedges_around_target(north, mesh)) normals[h] = {0, 0, 1};
  for (auto h : halfedges_around_target(south, mesh)) normals[h] = {0, 0, -1};
  for (const auto v : equator)
    for (auto h : halfedges_around_target(v, mesh)) normals[h] = mesh.point(v) - CGAL::ORIGIN;
}

void refine(Wide_mesh& mesh, Border border)
{
  subdivide(mesh, Loop_scheme(), parameters::border(border).vertex_normal_map(wide_normals(mesh)));
}

// the angles that are not decided
std::vector<double> undecided_angles(Border border)
{
  std::vector<double> undecided;
  for (double angle = 2.35; angle < 2.75; angle += 0.0002) {
    Wide_mesh mesh;
    add_triangle(mesh, angle);
    try {
      refine(mesh, border);
    } catch (const std::domain_error&) {
      undecided.push_back(angle);
    }
  }
  return undecided;
}

TEST(Creases_in_numbers, Intervals_need_to_decide_what_is_used_only)
{
  EXPECT_FALSE(undecided_angles(Border::surface).empty()); // there they are used
  EXPECT_TRUE(undecided_angles(Border::fixed).empty());
}

TEST(Creases_in_numbers, What_is_not_decided_leaves_the_rest_of_its_block)
{
  Wide_mesh alone;
  add_octahedron(alone);
  refine(alone, Border::fixed);
  const std::vector<double> angles = undecided_angles(Border::surface);
  ASSERT_FALSE(angles.empty());
  for (const double angle : angles) {
    Wide_mesh both; // 24 new vertices
    add_triangle(both, angle);
    add_octahedron(both);
    refine(both, Border::fixed);
    for (const auto v : alone.vertices()) {
      const unsigned i = v;
      const Wide_mesh::Vertex_index w(i < 6 ? i + 3 : i + 6); // 3 vertices and 3 edges before
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(both.point(w)[k].inf(), alone.point(v)[k].inf()) << angle << ' ' << v;
        EXPECT_EQ(both.point(w)[k].sup(), alone.point(v)[k].sup()) << angle << ' ' << v;
      }
    }
  }
}

} // namespace
