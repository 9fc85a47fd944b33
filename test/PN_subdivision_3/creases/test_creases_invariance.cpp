// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the result does not depend on, and what it is the same as.

#include "Crease_shapes.h"
#include "Sampled_surfaces.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace crease_shapes;
using namespace CGAL::PN_subdivision_3;

const Real epsilon = std::numeric_limits<double>::epsilon();

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
  c.sharp_vertices[30] = 1.4;
  return c;
}

// the largest side of a box about the points
Real box_of(const Control& c)
{
  Real greatest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto less = [&](const Triple& a, const Triple& b) { return a[k] < b[k]; };
    const auto [least, most] = std::minmax_element(c.points.begin(), c.points.end(), less);
    greatest = (std::max)(greatest, Real((*most)[k] - (*least)[k]));
  }
  return greatest;
}

// \name Similarities
Control transformed(Control c, const Eigen::Quaternion<Real>& rotation, Real factor,
                    const Vector& by)
{
  const auto change = [&](auto& x, Real by_factor, const Vector& shift) {
    const Vector y = by_factor * (rotation * Vector(x[0], x[1], x[2])) + shift;
    x = {double(y[0]), double(y[1]), double(y[2])};
  };
  for (auto& p : c.points) change(p, factor, by);
  for (auto& n : c.normals) change(n.second, 1, Vector(0, 0, 0));
  return c;
}

template <class Scheme>
void expect_similar(const Control& control, const Scheme& scheme)
{
  const Slots expected = slots(control, scheme, 3);
  const auto rotation =
    Eigen::Quaternion<Real>(Real(0.2), Real(0.7), Real(-0.4), Real(0.5)).normalized();
  const Vector by(Real(0.5), Real(-1.5), Real(0.75));
  const Slots got = slots(transformed(control, rotation, 3, by), scheme, 3);
  ASSERT_EQ(got.points.size(), expected.points.size());
  Real greatest = 0, of_normals = 0;
  for (std::size_t i = 0; i < got.points.size(); ++i) {
    greatest =
      (std::max)(greatest, (got.points[i] - (3 * (rotation * expected.points[i]) + by)).norm());
    of_normals = (std::max)(of_normals, (got.normals[i] - rotation * expected.normals[i]).norm());
  }
  EXPECT_LE(greatest, 3 * 8 * epsilon * box_of(control));
  EXPECT_LE(of_normals, 64 * epsilon); // of estimates, which compare and mix two normals
  // powers of 2: bit for bit
  Control large = control;
  for (auto& p : large.points)
    for (double& x : p) x *= 1024;
  Slots scaled = slots(large, scheme, 3);
  for (Vector& p : scaled.points) p /= 1024;
  EXPECT_TRUE(scaled == expected);
}

TEST(Crease_invariance, Similarities)
{
  expect_similar(wavy(), CatmullClark_scheme());
  expect_similar(wavy(), CatmullClark_scheme::Tuned());
  expect_similar(triangulated(wavy()), Loop_scheme());
  Control estimated = wavy();
  estimated.normals.clear();
  expect_similar(estimated, CatmullClark_scheme());
}

// \name The linear schemes
template <class Scheme>
void expect_linear(const Control& control, const Scheme& scheme)
{
  const Slots pn = slots(control, scheme, 3), lin = slots(control, linear(scheme), 3);
  ASSERT_EQ(pn.points.size(), lin.points.size());
  Real greatest = 0;
  for (std::size_t i = 0; i < pn.points.size(); ++i)
    greatest = (std::max)(greatest, (pn.points[i] - lin.points[i]).norm());
  EXPECT_LE(greatest, 8 * epsilon * box_of(control));
}

TEST(Crease_invariance, Without_tangents_and_with_equal_normals_is_the_linear_scheme)
{
  for (const bool are_zero : {true, false}) {
    Control c = wavy();
    c.has_zero_tangents = true;
    for (auto& n : c.normals) n.second = are_zero ? Triple{0, 0, 0} : Triple{0.6, 0, -0.8};
    expect_linear(c, CatmullClark_scheme());
    expect_linear(c, CatmullClark_scheme::Tuned());
    expect_linear(triangulated(c), Loop_scheme());
    expect_linear(triangulated(c), Loop_scheme::Tuned());
  }
  // other normals in other wedges
  Control c = bolt().control();
  c.has_zero_tangents = true;
  const Part part = bolt();
  std::map<std::size_t, Triple> of_group;
  for (auto& [corner, n] : c.normals)
    n = of_group.emplace(part.group[std::size_t(corner.first)], n).first->second;
  expect_linear(c, CatmullClark_scheme());
  // straight creases
  Control straight = crease_shapes::cube().control();
  for (auto& n : straight.normals) n.second = {0, 0, 1};
  expect_linear(straight, CatmullClark_scheme());
}

// \name Borders
TEST(Crease_invariance, Tagged_borders_are_curves_for_ever)
{
  for (Control curve : {ball_cap().control(), plate_with_hole().control()}) {
    Control tagged = curve;
    tagged.border = Border::surface;
    const Level_connectivity level = crease_levels::level_of(tagged);
    for (Index e = 0; e < level.number_of_edges(); ++e)
      if (level.is_border_edge(e))
        tagged.sharp_edges[undirected(int(level.source(2 * e)), int(level.target(2 * e)))] = 0.5;
    EXPECT_TRUE(slots(tagged, CatmullClark_scheme(), 3) == slots(curve, CatmullClark_scheme(), 3));
    EXPECT_TRUE(slots(triangulated(tagged), Loop_scheme(), 3) ==
                slots(triangulated(curve), Loop_scheme(), 3));
  }
}

// \name Schemes of normals
TEST(Crease_normal_schemes, The_same_scheme_changes_nothing)
{
  const Control c = wavy();
  EXPECT_TRUE(slots(c, with_normal_scheme(CatmullClark_scheme(), CatmullClark_scheme()), 3) ==
              slots(c, CatmullClark_scheme(), 3));
  const Control t = triangulated(c);
  EXPECT_TRUE(slots(t, with_normal_scheme(Loop_scheme(), Loop_scheme()), 3) ==
              slots(t, Loop_scheme(), 3));
}

// an icosahedron with a vertex on every edge: twelve vertices of valence 5, all others of 6
Control icosahedron()
{
  const auto mesh = sampled_surfaces::scattered(1, 0, 1, sampled_surfaces::on_sphere);
  Control c;
  c.points = mesh.points;
  c.faces = mesh.faces;
  for (std::size_t v = 12; v < c.points.size(); ++v)
    for (double& x : c.points[v]) x *= 0.85; // on the edges, not on the sphere
  for (std::size_t f = 0; f < c.faces.size(); ++f)
    for (const int v : c.faces[f]) c.normals[{int(f), v}] = mesh.normals[std::size_t(v)];
  return c;
}

// A dart of valence 5 has the plain rules, itself and the edges at it; so has a corner.
TEST(Crease_modified_schemes, Leave_extraordinary_darts_and_corners_alone)
{
  const Control c = icosahedron();
  const auto runs = [&](const Control& control) {
    return std::make_pair(slots(control, Loop_scheme::Tuned(), 1),
                          slots(control, Loop_scheme(), 1));
  };
  const auto neighbors = [&](int v) {
    std::set<std::size_t> result{std::size_t(v)};
    const Level_connectivity level = crease_levels::level_of(c);
    for (Index e = 0; e < level.number_of_edges(); ++e)
      if (level.source(2 * e) == Index(v) || level.target(2 * e) == Index(v))
        result.insert(level.number_of_vertices() + e);
    return result;
  };
  const auto number_of_changes = [&](const Control& control, int v) {
    const auto [modified, plain] = runs(control);
    std::size_t n = 0;
    for (const std::size_t i : neighbors(v)) n += modified.points[i] != plain.points[i];
    return n;
  };
  EXPECT_EQ(number_of_changes(c, 0), 6u);
  Control dart = c;
  int other = -1;
  for (const Face& f : c.faces)
    if (f[0] == 0) other = f[1];
  dart.sharp_edges[{0, other}] = infinity;
  EXPECT_EQ(number_of_changes(dart, 0), 0u);
  EXPECT_EQ(number_of_changes(dart, 5), 6u);
  // a dart of which less than a round is left is half gone, and what is gone has the rules of its valence
  Control half_gone = dart;
  half_gone.sharp_edges[{0, other}] = 0.5;
  EXPECT_EQ(number_of_changes(half_gone, 0), 6u);
  Control corner = c;
  corner.sharp_vertices[0] = infinity;
  EXPECT_EQ(number_of_changes(corner, 0), 0u);
  EXPECT_EQ(number_of_changes(corner, 5), 6u);
  // the normals of the modified scheme, the creases of the plain one
  const auto mixed = slots(dart, with_normal_scheme(Loop_scheme(), Loop_scheme::Tuned()), 1);
  const auto [modified, plain] = runs(dart);
  EXPECT_EQ(mixed.normals, modified.normals);
  for (const std::size_t i : neighbors(0)) EXPECT_EQ(mixed.points[i], plain.points[i]);
}

} // namespace
