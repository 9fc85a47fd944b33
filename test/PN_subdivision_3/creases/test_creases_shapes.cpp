// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Parts of planes, cylinders and spheres stay exactly that, up to their creases.

#include "Crease_shapes.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/modified_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/modified_Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace crease_shapes;
using crease_levels::Crease_run;
using crease_levels::Index;
using crease_levels::Level_connectivity;
using crease_levels::triangulated;
using namespace CGAL::PN_subdivision_3;

// the group of every face after a round, in the documented order of the children
template <class Host>
std::vector<std::size_t> refined_groups(const Level_connectivity& level,
                                        const std::vector<std::size_t>& group)
{
  std::vector<std::size_t> first = group, others;
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    const Index m = level.degree(level.halfedge_of_face(f));
    for (Index i = 0; i + (std::is_same_v<Host, PQQ_host> ? 1 : 0) < m; ++i)
      others.push_back(group[f]);
  }
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

struct Deviation
{
  Real points = 0, normals = 0, border = 0;
};

// of all corners from the surface of their face, and of the border
template <class FT, class Scheme>
Deviation deviation(const Part& part, const Control& control, std::vector<std::size_t> group,
                    const Scheme& scheme, int rounds)
{
  Crease_run<FT, Scheme> run(control, scheme);
  for (int k = 0; k < rounds; ++k) {
    group = refined_groups<typename Scheme::Host>(run.level(), group);
    run.refine();
  }
  const auto vector = [](const auto& x) { return Vector(Real(x[0]), Real(x[1]), Real(x[2])); };
  Deviation d;
  const auto grow = [](Real& greatest, Real x) {
    if (!(x <= greatest)) greatest = x;
  };
  run.for_each_corner([&](Index f, Index v, Index slot) {
    const Surface& s = part.surfaces[group[f]];
    const Vector p = vector(run.point(slot));
    grow(d.points, s.distance(p));
    if (Crease_run<FT, Scheme>::is_pn)
      grow(d.normals, (vector(run.normal(slot)) - s.normal(p)).norm());
    if (part.of_border.empty() || !run.level().is_border_vertex(v)) return;
    Real least = std::numeric_limits<Real>::infinity();
    for (const Surface& b : part.of_border) least = (std::min)(least, b.distance(p));
    grow(d.border, least);
  });
  return d;
}

struct Shape
{
  const char* name;
  std::function<Part()> make;
  int rounds = 6;
};

std::string name_of(const ::testing::TestParamInfo<Shape>& info)
{
  return info.param.name;
}

class Crease_shapes : public ::testing::TestWithParam<Shape>
{
protected:
  // calls f(scheme, control, groups) for the schemes
  template <class Function>
  static void for_each_scheme(const Part& part, bool with_normals, const Function& f)
  {
    const Control polygons = part.control(with_normals), triangles = triangulated(polygons);
    std::vector<std::size_t> groups;
    for (std::size_t i = 0; i < part.faces.size(); ++i)
      groups.insert(groups.end(), part.faces[i].size() - 2, part.group[i]);
    f(CatmullClark_scheme(), polygons, part.group, "Catmull-Clark");
    f(modified_CatmullClark_scheme(), polygons, part.group, "modified Catmull-Clark");
    f(Loop_scheme(), triangles, groups, "Loop");
    f(modified_Loop_scheme(), triangles, groups, "modified Loop");
  }
};

TEST_P(Crease_shapes, Stay_exact)
{
  Part part = GetParam().make();
  part.place();
  const Real epsilon = std::numeric_limits<double>::epsilon();
  for_each_scheme(part, true,
                  [&](const auto& scheme, const Control& control,
                      const std::vector<std::size_t>& group, const char* name) {
                    const Deviation d =
                      deviation<double>(part, control, group, scheme, GetParam().rounds);
                    EXPECT_LE(d.points, 8 * epsilon * part.scale()) << name;
                    EXPECT_LE(d.border, 8 * epsilon * part.scale()) << name;
                    EXPECT_LE(d.normals, 8 * epsilon) << name;
                  });
}

// the linear schemes do not keep what is curved
TEST_P(Crease_shapes, Are_curved)
{
  const Part part = GetParam().make();
  bool is_curved = false;
  for (const Surface& s : part.surfaces) is_curved = is_curved || s.kind != Surface::plane;
  const Deviation d =
    deviation<double>(part, part.control(false), part.group, linear(CatmullClark_scheme()), 2);
  if (is_curved)
    EXPECT_GE(d.points, 0.02);
  else if (part.of_border.empty())
    EXPECT_LE(d.points, 1e-15);
  else
    EXPECT_GE(d.border, 0.02);
}

TEST_P(Crease_shapes, Stay_in_float)
{
  Part part = GetParam().make();
  part.place();
  const Real epsilon = std::numeric_limits<float>::epsilon();
  for_each_scheme(part, true,
                  [&](const auto& scheme, const Control& control,
                      const std::vector<std::size_t>& group, const char* name) {
                    const Deviation d = deviation<float>(part, control, group, scheme, 3);
                    EXPECT_LE(d.points, 8 * epsilon * part.scale()) << name;
                    EXPECT_LE(d.normals, 16 * epsilon) << name;
                  });
}

INSTANTIATE_TEST_SUITE_P(
  Parts, Crease_shapes,
  ::testing::Values(Shape{"cylinder_of_7_sides", [] { return capped_cylinder(uneven(7)); }},
                    Shape{"cylinder_of_4_sides", [] { return capped_cylinder(uneven(4)); }},
                    Shape{"cylinder_of_3_sides",
                          [] {
                            return capped_cylinder({0, Real(165) / 180 * pi, Real(250) / 180 * pi});
                          },
                          3},
                    Shape{"half_ball", half_ball}, Shape{"lens", lens}, Shape{"bullet", bullet},
                    Shape{"washer", washer}, Shape{"countersink", countersink},
                    Shape{"d_section", d_section}, Shape{"rounded_box", rounded_box},
                    Shape{"bolt", bolt}, Shape{"cube", cube},
                    Shape{"plate_with_hole", plate_with_hole}, Shape{"ball_cap", ball_cap},
                    Shape{"octant", octant}),
  name_of);

// no normals given: straight prisms all of whose side vertices are on creases
TEST(Crease_shapes_without_normals, Stay_exact)
{
  const auto solid = [](Part part) {
    part.place();
    return part;
  };
  Part prism;
  const auto angles = uneven(7);
  const Ring low = prism.ring(1, 0, angles), high = prism.ring(1, 2, angles);
  prism.tube(prism.add(upright_cylinder(1)), low, high);
  prism.face(prism.add(plane(0, -1)), low);
  prism.face(prism.add(plane(2, 1)), high);
  Real bar = 8 * Real(std::numeric_limits<double>::epsilon());
  for (const Part& part :
       {solid(prism), solid(washer()), solid(cube()), solid(plate_with_hole())}) {
    const Deviation d =
      deviation<double>(part, part.control(false), part.group, CatmullClark_scheme(), 5);
    EXPECT_LE(d.points, bar * part.scale());
    EXPECT_LE(d.border, bar * part.scale());
    EXPECT_LE(d.normals, bar);
  }
}

// \name Invariance
struct Slots
{
  std::vector<Vector> points, normals;
};

template <class Scheme>
Slots slots(const Control& control, const Scheme& scheme, int rounds)
{
  Crease_run<double, Scheme> run(control, scheme);
  run.refine(rounds);
  Slots s;
  for (Index i = 0; i < run.number_of_slots(); ++i) {
    const auto p = run.point(i), n = run.normal(i);
    s.points.emplace_back(p[0], p[1], p[2]);
    s.normals.emplace_back(n[0], n[1], n[2]);
  }
  return s;
}

// data on no simple surface, with semi-sharp edges
Control wavy()
{
  Part part = bolt();
  for (std::size_t i = 0; i < part.points.size(); ++i)
    part.points[i] +=
      Real(0.1) * Vector(std::sin(Real(3 * i)), std::cos(Real(5 * i)), std::sin(Real(7 * i)));
  Control c = part.control();
  int k = 0;
  for (auto& e : c.sharp_edges)
    if (++k % 4 == 0) e.second = 0.35 * k;
  return c;
}

TEST(Crease_invariance, Similarities_and_reversal_commute)
{
  const Control c = wavy();
  const Slots expected = slots(c, CatmullClark_scheme(), 3);
  const auto rotation =
    Eigen::Quaternion<Real>(Real(0.2), Real(0.7), Real(-0.4), Real(0.5)).normalized();
  const Vector by(Real(0.5), Real(-1.5), Real(0.75));
  Control moved = c;
  const auto change = [&](auto& x, Real factor, const Vector& shift) {
    const Vector y = factor * (rotation * Vector(x[0], x[1], x[2])) + shift;
    x = {double(y[0]), double(y[1]), double(y[2])};
  };
  for (auto& p : moved.points) change(p, 3, by);
  for (auto& n : moved.normals) change(n.second, 1, Vector(0, 0, 0));
  const Slots got = slots(moved, CatmullClark_scheme(), 3);
  ASSERT_EQ(got.points.size(), expected.points.size());
  const Real bar = 64 * Real(std::numeric_limits<double>::epsilon());
  for (std::size_t i = 0; i < got.points.size(); ++i) {
    EXPECT_LE((got.points[i] - (3 * (rotation * expected.points[i]) + by)).norm(), 10 * bar);
    EXPECT_LE((got.normals[i] - rotation * expected.normals[i]).norm(), bar);
  }
}

TEST(Crease_invariance, Reversal_of_orientation)
{
  const Control c = wavy();
  Control reversed = c;
  for (Face& f : reversed.faces) std::reverse(f.begin(), f.end());
  for (auto& n : reversed.normals)
    for (double& x : n.second) x = -x;
  Crease_run<double, CatmullClark_scheme> a(c, CatmullClark_scheme()),
    b(reversed, CatmullClark_scheme());
  a.refine();
  b.refine();
  // old vertices keep their numbers
  for (Index v = 0; v < c.points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a.point(v)[k], b.point(v)[k], 1e-14);
  // an edge is known by its ends
  std::map<Edge, Index> edges;
  const auto ends = [](const Level_connectivity& l, Index e) {
    return crease_levels::undirected(int(l.source(2 * e)), int(l.target(2 * e)));
  };
  const Level_connectivity before = crease_levels::level_of(c),
                           other = crease_levels::level_of(reversed);
  const Index n = before.number_of_vertices();
  for (Index e = 0; e < before.number_of_edges(); ++e) edges[ends(before, e)] = n + e;
  for (Index e = 0; e < other.number_of_edges(); ++e)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(a.point(edges.at(ends(other, e)))[k], b.point(n + e)[k], 1e-14);
}

TEST(Crease_invariance, Straight_creases_and_equal_normals_give_the_linear_scheme)
{
  Part part = cube();
  Control straight = part.control();
  for (auto& n : straight.normals) n.second = {0, 0, 1};
  const Slots pn = slots(straight, CatmullClark_scheme(), 3);
  const Slots lin = slots(straight, linear(CatmullClark_scheme()), 3);
  for (std::size_t i = 0; i < pn.points.size(); ++i)
    EXPECT_LE((pn.points[i] - lin.points[i]).norm(), 1e-15);
}

// \name Degenerate data
bool all_finite(const Slots& s)
{
  for (std::size_t i = 0; i < s.points.size(); ++i)
    if (!s.points[i].allFinite() || !s.normals[i].allFinite() || s.points[i].norm() > 50 ||
        s.normals[i].norm() > 1 + Real(1e-9))
      return false;
  return true;
}

TEST(Crease_degenerate_data, Gives_finite_results)
{
  const Control good = bolt().control();
  const auto expect_finite = [](const Control& c) {
    EXPECT_TRUE(all_finite(slots(c, CatmullClark_scheme(), 3)));
    EXPECT_TRUE(all_finite(slots(triangulated(c), Loop_scheme(), 3)));
  };
  Control c = good;
  for (auto& n : c.normals) n.second = {0, 0, 0};
  expect_finite(c); // no normals
  c = good;
  for (std::size_t i = 1; i < c.points.size(); i += 2) c.points[i] = c.points[i - 1];
  expect_finite(c); // edges without length
  for (auto& p : c.points) p = {1, 2, 3};
  expect_finite(c); // a single point
  c = good;
  for (auto& p : c.points) p = {p[0], 0, 0};
  expect_finite(c); // folded onto a line
  c = good;
  for (auto& n : c.normals) n.second = {0.6, 0.8, 0};
  expect_finite(c); // along some creases
  c = good;
  int k = 0;
  for (auto& n : c.normals)
    if (++k % 3 == 0)
      for (double& x : n.second) x = -x;
  expect_finite(c); // nearly opposite ones
  c = good;
  for (auto& e : c.sharp_edges) e.second = infinity;
  for (std::size_t f = 0; f < c.faces.size(); ++f)
    for (std::size_t i = 0; i < c.faces[f].size(); ++i)
      c.sharp_edges[crease_levels::undirected(c.faces[f][i],
                                              c.faces[f][(i + 1) % c.faces[f].size()])] = 0.5 * i;
  expect_finite(c); // creases everywhere
  c.normals.clear();
  expect_finite(c);
}

// a pole of many edges, each second one sharp: no time of the square of its valence
TEST(Crease_degenerate_data, Poles_of_large_valence)
{
  Control c;
  const int n = 20000;
  Index remaining = 0;
  c.points.push_back({0, 0, 1});
  for (int i = 0; i < n; ++i)
    c.points.push_back({std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0});
  for (int i = 0; i < n; ++i) {
    c.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
    c.sharp_edges[{0, 1 + i}] = i % 2 == 0 ? 0 : 0.5 + i % 3;
    remaining += c.sharp_edges[{0, 1 + i}] > 1;
  }
  Crease_run<double, CatmullClark_scheme> run(c, CatmullClark_scheme());
  run.refine();
  EXPECT_EQ(run.creases().stars.front().number_of_ends, remaining);
  // a dart at the pole
  for (auto& e : c.sharp_edges) e.second = e.first.second == 1 ? infinity : 0;
  Crease_run<double, CatmullClark_scheme> dart(c, CatmullClark_scheme());
  dart.refine();
  EXPECT_EQ(dart.creases().edges.size(), 2u);
}

} // namespace
