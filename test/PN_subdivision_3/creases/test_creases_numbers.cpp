// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Creases in other number types: an exact round keeps rims and what is beside them exactly, intervals
// contain the result, float and multiprecision are as near as their precision says.

#include "Crease_shapes.h"
#include "One_root_number.h"
#include "Rational_shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpfr.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_subdivision_3/creases/Crease_average.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

namespace {

using namespace crease_shapes;
using namespace CGAL::PN_subdivision_3;
using rational_shapes::Rational;

// \name An exact round
using Exact = One_root_number;
using Exact_vector = Coordinates<Exact, 3>;
using Samples = std::vector<rational_shapes::Vector<Rational>>;

Exact_vector exact(const rational_shapes::Vector<Rational>& v)
{
  return {Exact(v[0]), Exact(v[1]), Exact(v[2])};
}

Exact dot(const Exact_vector& a, const Exact_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
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

struct Exact_part
{
  Samples points;
  Control control;
  std::vector<std::size_t> group; // 0: the curved side
  std::vector<Exact> heights;     // of the planes of the other groups
  bool is_sphere;
};

// a solid with the given rings, rounded or upright, between planes
Exact_part make_part(const std::vector<Samples>& rings, bool is_sphere)
{
  Exact_part part;
  part.is_sphere = is_sphere;
  const int n = int(rings[0].size());
  for (const Samples& ring : rings) part.points.insert(part.points.end(), ring.begin(), ring.end());
  const auto add = [&](Face f, std::size_t g) {
    part.control.faces.push_back(std::move(f));
    part.group.push_back(g);
  };
  Face bottom, top;
  const int last = n * (int(rings.size()) - 1);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    for (int k = 0; k < last; k += n) add({k + i, k + j, k + n + j, k + n + i}, 0);
    bottom.insert(bottom.begin(), i);
    top.push_back(last + i);
    part.control.sharp_edges[crease_levels::undirected(i, j)] = infinity;
    if (!is_sphere)
      part.control.sharp_edges[crease_levels::undirected(last + i, last + j)] = infinity;
  }
  part.heights = {Exact(rings[0][0][2]), Exact(rings.back()[0][2])};
  add(bottom, 1);
  add(top, is_sphere ? 0 : 2);
  part.control.points.resize(part.points.size());
  return part;
}

Exact_vector true_normal(const Exact_part& part, std::size_t group, const Exact_vector& p)
{
  if (group != 0) return {Exact(0), Exact(0), Exact(group == 1 ? -1 : 1)};
  return part.is_sphere ? p : Exact_vector{p[0], p[1], Exact(0)};
}

template <class Scheme>
void expect_exact_round(const Exact_part& part, const Control& control,
                        std::vector<std::size_t> group, const Scheme& scheme)
{
  using Refiner = internal::Level_refiner<Scheme, PN_average<Exact, 3>, internal::Creases<Exact>>;
  Level_connectivity level = crease_levels::level_of(control);
  auto creases = internal::Make_creases<Exact>(level, Border::surface)(
    [&](Index e) {
      const auto it = control.sharp_edges.find(
        crease_levels::undirected(int(level.source(2 * e)), int(level.target(2 * e))));
      return it == control.sharp_edges.end() ? 0. : it->second;
    },
    [](Index) { return 0.; });
  for (auto& e : creases.edges)
    for (Index side = 0; side < 2; ++side) {
      const Index h = e.halfedge(side);
      const Exact_vector p = exact(part.points[level.source(h)]),
                         q = exact(part.points[level.target(h)]);
      const Exact turn = p[0] * q[1] - p[1] * q[0];
      const Exact sign(turn < Exact(0) ? -1 : 1);
      e.tangent_from[side] = {-sign * p[1], sign * p[0], Exact(0)};
    }
  typename Refiner::Values values(creases.number_of_slots);
  const internal::Cut_copy<Exact> cut(level, creases);
  internal::for_each_corner(level, cut.connectivity(), [&](Index h, Index slot) {
    const Exact_vector p = exact(part.points[level.target(h)]);
    values[slot] = Point_normal<Exact, 3>{p, true_normal(part, group[level.face(h)], p)};
  });
  // the groups of the children
  std::vector<std::size_t> refined = group;
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    const Index m = level.degree(level.halfedge_of_face(f));
    const bool quads = std::is_same_v<typename Scheme::Host, PQQ_host>;
    refined.insert(refined.end(), quads ? m - 1 : m, group[f]);
  }
  Refiner refiner(scheme, std::move(level), std::move(creases), std::move(values));
  refiner.refine();
  const internal::Cut_copy<Exact> child(refiner.level(), refiner.creases());
  internal::for_each_corner(refiner.level(), child.connectivity(), [&](Index h, Index slot) {
    const Point_normal<Exact, 3> value = refiner.values()[slot];
    const std::size_t g = refined[refiner.level().face(h)];
    const Exact_vector n = true_normal(part, g, value.point);
    if (g == 0)
      EXPECT_TRUE(dot(n, n) == Exact(1)); // the point is on the sphere or cylinder
    else
      EXPECT_TRUE(value.point[2] == part.heights[g - 1]);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(value.normal[k] == n[k]);
  });
  EXPECT_GE(refiner.creases().edges.size(), 14u);
}

void expect_exact_round(const Exact_part& part)
{
  expect_exact_round(part, part.control, part.group, CatmullClark_scheme());
  std::vector<std::size_t> group;
  for (std::size_t f = 0; f < part.group.size(); ++f)
    group.insert(group.end(), part.control.faces[f].size() - 2, part.group[f]);
  expect_exact_round(part, triangulated(part.control), group, Loop_scheme());
}

TEST(Exact_creases, Capped_cylinder)
{
  expect_exact_round(
    make_part({rational_circle(Rational(0)), rational_circle(Rational(2))}, false));
}

TEST(Exact_creases, Half_ball)
{
  Samples ring;
  for (const Real a : uneven(7))
    ring.push_back(rational_shapes::unit_3(double(std::cos(a)), double(std::sin(a)), 0.8));
  expect_exact_round(make_part({rational_circle(Rational(0)), ring}, true));
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

TEST(Creases_in_numbers, Float)
{
  Part part = capped_cylinder(uneven(7));
  part.place();
  expect_near_double<float>(part.control(), CatmullClark_scheme(), 3,
                            8 * double(std::numeric_limits<float>::epsilon()));
  expect_near_double<float>(triangulated(semi_sharp_cylinder()), Loop_scheme(), 2,
                            16 * double(std::numeric_limits<float>::epsilon()));
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
