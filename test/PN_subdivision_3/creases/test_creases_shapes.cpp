// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Parts of planes, cylinders and spheres stay exactly that, up to their creases.

#include "Crease_shapes.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace {

using namespace crease_shapes;
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
  int float_bar = 1; // of points in units of float
};

std::string name_of(const ::testing::TestParamInfo<Shape>& info)
{
  return info.param.name;
}

class Crease_shapes : public ::testing::TestWithParam<Shape>
{};

// calls f(scheme, control, groups, name) for the schemes
template <class Function>
void for_each_scheme(const Part& part, const Function& f)
{
  const Control polygons = part.control(), triangles = triangulated(polygons);
  std::vector<std::size_t> groups;
  for (std::size_t i = 0; i < part.faces.size(); ++i)
    groups.insert(groups.end(), part.faces[i].size() - 2, part.group[i]);
  f(CatmullClark_scheme(), polygons, part.group, "Catmull-Clark");
  f(CatmullClark_scheme::Tuned(), polygons, part.group, "modified Catmull-Clark");
  f(Loop_scheme(), triangles, groups, "Loop");
  f(Loop_scheme::Tuned(), triangles, groups, "modified Loop");
}

template <class FT>
void expect_to_stay(const Shape& shape, int rounds, Real points, Real border)
{
  Part part = shape.make();
  part.place();
  const Real epsilon = std::numeric_limits<FT>::epsilon();
  for_each_scheme(part, [&](const auto& scheme, const Control& control,
                            const std::vector<std::size_t>& group, const char* name) {
    const Deviation d = deviation<FT>(part, control, group, scheme, rounds);
    EXPECT_LE(d.points, points * epsilon * part.scale()) << name;
    EXPECT_LE(d.border, border * epsilon * part.scale()) << name;
    EXPECT_LE(d.normals, 8 * epsilon) << name;
  });
}

TEST_P(Crease_shapes, Stay_exact)
{
  expect_to_stay<double>(GetParam(), GetParam().rounds, 8, 8);
}

TEST_P(Crease_shapes, Stay_in_float)
{
  expect_to_stay<float>(GetParam(), 3, GetParam().float_bar, 8);
}

INSTANTIATE_TEST_SUITE_P(
  Parts, Crease_shapes,
  ::testing::Values(Shape{"cylinder_of_7_sides", [] { return capped_cylinder(uneven(7)); }},
                    Shape{"cylinder_of_4_sides", [] { return capped_cylinder(uneven(4)); }},
                    Shape{"cylinder_of_3_sides",
                          [] {
                            return capped_cylinder({0, Real(165) / 180 * pi, Real(250) / 180 * pi});
                          },
                          3, 8},
                    Shape{"half_ball", half_ball}, Shape{"lens", lens}, Shape{"bullet", bullet},
                    Shape{"washer", washer}, Shape{"countersink", countersink},
                    Shape{"d_section", d_section}, Shape{"rounded_box", rounded_box},
                    Shape{"bolt", bolt}, Shape{"cube", cube},
                    Shape{"plate_with_hole", plate_with_hole}, Shape{"half_disk", half_disk},
                    Shape{"ball_cap", ball_cap}, Shape{"octant", octant}),
  name_of);

// The normals of a truncated cone are kept along its rims, which stay circles; the side between them is
// near the cone only.
TEST(Crease_shapes_beside_others, Rims_of_a_truncated_cone_stay_exact)
{
  const Real slant = std::sqrt(Real(1.25));
  Part part;
  const auto angles = uneven(7);
  const Ring low = part.ring(2, 0, angles), high = part.ring(1, 2, angles);
  part.tube(part.add(upright_cylinder(1)), low, high);
  part.face(part.add(plane(0, -1)), low);
  part.face(part.add(plane(2, 1)), high);
  Control control = part.control();
  for (auto& [corner, n] : control.normals)
    if (part.group[std::size_t(corner.first)] == 0)
      n = {double(n[0] / slant), double(n[1] / slant), double(0.5L / slant)};
  const Eigen::Quaternion<Real> turn =
    Eigen::Quaternion<Real>(Real(0.62), Real(-0.31), Real(0.47), Real(0.55)).normalized();
  const Vector by(Real(0.3), Real(-0.2), Real(0.25));
  const auto move = [&](auto& x, const Vector& shift) {
    const Vector y = turn * Vector(x[0], x[1], x[2]) + shift;
    x = {double(y[0]), double(y[1]), double(y[2])};
  };
  for (auto& p : control.points) move(p, by);
  for (auto& n : control.normals) move(n.second, Vector(0, 0, 0));
  part.place();
  const Real bar = 8 * Real(std::numeric_limits<double>::epsilon());
  const auto expect_rims = [&](const Control& c, const auto& scheme) {
    Crease_run<double, std::decay_t<decltype(scheme)>> run(c, scheme);
    run.refine(6);
    std::set<Index> rims;
    for (const auto& star : run.creases().stars) rims.insert(star.vertex);
    EXPECT_EQ(rims.size(), 2u * 7 * 64);
    Real of_points = 0, of_normals = 0, of_side = 0;
    run.for_each_corner([&](Index, Index v, Index slot) {
      const auto x = run.point(slot), m = run.normal(slot);
      const Vector p = turn.conjugate() * (Vector(x[0], x[1], x[2]) - by),
                   n = turn.conjugate() * Vector(m[0], m[1], m[2]),
                   away = Vector(p[0], p[1], 0).normalized(),
                   of_cone = (away + Vector(0, 0, Real(0.5))) / slant;
      const Real from_cone = (std::hypot(p[0], p[1]) - (2 - p[2] / 2)) / slant;
      if (p[2] > Real(0.01) && p[2] < Real(1.99))
        of_side = (std::max)(of_side, std::abs(from_cone));
      if (rims.count(v) == 0) return;
      of_points = (std::max)(
        {of_points, std::abs(from_cone), (std::min)(std::abs(p[2]), std::abs(2 - p[2]))});
      of_normals =
        (std::max)(of_normals, (std::min)({(n - of_cone).norm(), (n - Vector(0, 0, 1)).norm(),
                                           (n + Vector(0, 0, 1)).norm()}));
    });
    EXPECT_LE(of_points, bar * part.scale());
    EXPECT_LE(of_normals, bar);
    EXPECT_LE(of_side, 0.02);
    EXPECT_GE(of_side, 1e-4);
  };
  expect_rims(control, CatmullClark_scheme());
  expect_rims(triangulated(control), Loop_scheme());
}

// \name Borders
Real border_distance(Part part, Border border, const std::vector<Surface>& of_border,
                     bool is_linear)
{
  part.border = border;
  part.of_border = of_border;
  const Control c = part.control();
  return (is_linear ? deviation<double>(part, c, part.group, linear(CatmullClark_scheme()), 4)
                    : deviation<double>(part, c, part.group, CatmullClark_scheme(), 4))
    .border;
}

// The points of a ball's border stay on the ball by the rule of surfaces, but not on the circle.
TEST(Crease_shapes_borders, Are_circles_as_curves_only)
{
  const Real radius = std::cos(Real(0.3));
  const std::vector<std::pair<Part, std::vector<Surface>>> cases{
    {plate_with_hole(), plate_with_hole().of_border}, {ball_cap(), {upright_cylinder(radius)}}};
  for (const auto& [part, circles] : cases) {
    EXPECT_LE(border_distance(part, Border::curve, circles, false), 1e-15);
    EXPECT_GE(border_distance(part, Border::surface, circles, false), 0.01);
    EXPECT_GE(border_distance(part, Border::curve, circles, true), 0.05);
  }
}

// A hole moves out to its circle, the plane about it is refined as by the linear scheme: faces fold over
// if the ring around it is narrow.
Real least_turn(int n, Real ratio, int rounds)
{
  Part part;
  std::vector<Real> angles;
  for (int i = 0; i < n; ++i) angles.push_back(2 * pi * Real(i) / Real(n));
  const Ring hole = part.ring(1, 0, angles), ring = part.ring(ratio, 0, angles),
             outside = part.ring(3 * ratio, 0, angles);
  const auto s = part.add(plane(0, 1));
  part.tube(s, hole, ring);
  part.tube(s, ring, outside);
  part.border = Border::curve;
  Crease_run<double, CatmullClark_scheme> run(part.control(), CatmullClark_scheme());
  run.refine(rounds);
  Real least = 1;
  const Level_connectivity& level = run.level();
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    const Index h = level.halfedge_of_face(f), k = level.next(level.next(h));
    const auto at = [&](Index g) {
      const auto p = run.point(level.target(g));
      return Vector(p[0], p[1], p[2]);
    };
    const Vector area = (at(k) - at(h)).cross(at(level.next(k)) - at(level.next(h)));
    least = (std::min)(least, area[2]);
  }
  return least;
}

// the least ratio of the radii for three rounds, and for any number of them
TEST(Crease_shapes_borders, Holes_need_a_ring)
{
  struct Case
  {
    int n;
    Real in_three_rounds, in_all;
  };
  for (const Case& c : {Case{4, Real(2.46), Real(2.72)}, Case{6, Real(1.54), Real(1.64)},
                        Case{8, Real(1.28), Real(1.35)}}) {
    EXPECT_GT(least_turn(c.n, c.in_three_rounds + Real(0.01), 3), 0) << c.n;
    EXPECT_LT(least_turn(c.n, c.in_three_rounds - Real(0.01), 3), 0) << c.n;
    EXPECT_LT(least_turn(c.n, c.in_three_rounds + Real(0.01), 5), 0) << c.n;
    EXPECT_GT(least_turn(c.n, c.in_all, 5), 0) << c.n;
  }
}

// bit for bit
TEST(Crease_shapes_borders, Planes_of_no_height_stay)
{
  for (const Part& part :
       {plate_with_hole(), capped_cylinder(uneven(7)), washer(), half_ball(), d_section()}) {
    std::vector<std::size_t> group = part.group;
    Crease_run<double, CatmullClark_scheme> run(part.control(), CatmullClark_scheme());
    for (int k = 0; k < 4; ++k) {
      group = refined_groups<PQQ_host>(run.level(), group);
      run.refine();
    }
    std::size_t corners = 0;
    run.for_each_corner([&](Index f, Index, Index slot) {
      const Surface& s = part.surfaces[group[f]];
      if (s.kind != Surface::plane || s.point[2] != 0 || std::abs(s.direction[2]) != 1) return;
      ++corners;
      EXPECT_EQ(run.point(slot)[2], 0);
      EXPECT_EQ(run.normal(slot)[0], 0);
      EXPECT_EQ(run.normal(slot)[1], 0);
      EXPECT_EQ(run.normal(slot)[2], double(s.direction[2]));
    });
    EXPECT_GE(corners, 256u);
  }
}

// no normals given, all side vertices on creases; prisms are the subject of test_creases_mesh.cpp
TEST(Crease_shapes_without_normals, Stay_exact)
{
  const auto solid = [](Part part) {
    part.place();
    return part;
  };
  Real bar = 8 * Real(std::numeric_limits<double>::epsilon());
  for (const Part& part : {solid(washer()), solid(cube()), solid(plate_with_hole())}) {
    const Deviation d =
      deviation<double>(part, part.control(false), part.group, CatmullClark_scheme(), 5);
    EXPECT_LE(d.points, bar * part.scale());
    EXPECT_LE(d.border, bar * part.scale());
    EXPECT_LE(d.normals, bar);
  }
}

} // namespace
