// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How the result depends on the data: continuously, and it is finite where these are degenerate.

#include "Crease_shapes.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <gtest/gtest.h>

namespace {

using namespace crease_shapes;
using namespace CGAL::PN_subdivision_3;

// \name Scans

// Two sheets that meet in a crease of unit edges.
class Sheets
{
public:
  // the sheets go from the curve along directions[side]; with normals unless these are empty
  Sheets(const std::vector<Vector>& curve, const std::array<Vector, 2>& directions,
         const std::vector<std::array<Vector, 2>>& normals = {})
  {
    const auto n = int(curve.size());
    for (const Vector& p : curve)
      for (int j = -2; j <= 2; ++j)
        control.points.push_back(triple(p + Real(std::abs(j)) * directions[j > 0]));
    for (int i = 0; i + 1 < n; ++i) {
      for (int j = 0; j < 4; ++j) {
        const int v = 5 * i + j;
        control.faces.push_back({v, v + 5, v + 6, v + 1});
        for (const int corner : control.faces.back())
          if (!normals.empty())
            control.normals[{int(control.faces.size()) - 1, corner}] =
              triple(normals[std::size_t(corner / 5)][j < 2 ? 0 : 1].normalized());
      }
      control.sharp_edges[undirected(5 * i + 2, 5 * i + 7)] = infinity;
    }
  }

  Control control;
};

// how far the points are from those of the linear scheme
template <class Scheme>
std::vector<Vector> offsets(const Control& control, const Scheme& scheme, int rounds)
{
  std::vector<Vector> result = slots(control, scheme, rounds).points;
  const std::vector<Vector> of_linear = slots(control, linear(scheme), rounds).points;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= of_linear[i];
  return result;
}

// the greatest change of such an offset while the parameter changes by 1
template <class Control_of, class Scheme>
Real greatest_slope(Real from, Real to, int steps, const Control_of& control_of,
                    const Scheme& scheme)
{
  Real greatest = 0;
  std::vector<Vector> before;
  for (int k = 0; k <= steps; ++k) {
    const std::vector<Vector> now =
      offsets(control_of(from + (to - from) * Real(k) / Real(steps)), scheme, 2);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Real slope = (now[i] - before[i]).norm() * Real(steps) / (to - from);
      if (!(slope <= greatest)) greatest = slope;
    }
    before = now;
  }
  return greatest;
}

// A jump of 0.02 and more would exceed the bar.
template <class Control_of>
void expect_slope(Real from, Real to, Real bar, const Control_of& control_of)
{
  const int steps = int(std::ceil((to - from) * bar / Real(0.02)));
  const Real cc = greatest_slope(from, to, steps, control_of, CatmullClark_scheme());
  const Real loop = greatest_slope(
    from, to, steps, [&](Real x) { return triangulated(control_of(x)); }, Loop_scheme());
  EXPECT_LE(cc, bar);
  EXPECT_LE(loop, bar);
}

const int columns = 7;

// sheets at the angle pi - 2 slope on a wavy curve; the normals are turned from theirs along the crease
Control roof(Real slope, bool with_normals, Real turn = 0)
{
  const std::array<Vector, 2> sides{Vector(0, -std::cos(slope), -std::sin(slope)),
                                    Vector(0, std::cos(slope), -std::sin(slope))};
  std::vector<Vector> curve;
  std::vector<std::array<Vector, 2>> normals;
  for (int i = 0; i < columns; ++i) {
    const Real x = Real(i);
    curve.push_back({x, Real(0.3) * std::sin(x), Real(0.2) * std::cos(Real(1.3) * x)});
    const Vector t =
      Vector(1, Real(0.3) * std::cos(x), -Real(0.26) * std::sin(Real(1.3) * x)).normalized();
    normals.push_back({sides[0].cross(t).normalized(), t.cross(sides[1]).normalized()});
    for (Vector& n : normals.back()) n = std::cos(turn) * n + std::sin(turn) * t;
  }
  return Sheets(curve, sides, with_normals ? normals : decltype(normals)()).control;
}

// sheets on a plane curve that turns by the angle at all its vertices, or at the one in its middle
Control bent(Real angle, bool at_all_vertices)
{
  std::vector<Vector> curve(columns, Vector(0, 0, 0));
  std::vector<std::array<Vector, 2>> normals(columns);
  const int middle = columns / 2;
  for (int i = 0; i <= middle; ++i)
    for (const int sign : {-1, 1}) {
      const auto at = std::size_t(middle + sign * i);
      const Real turns = Real(sign) * Real(at_all_vertices ? i : std::min(i, 1));
      const Real direction = angle * (turns - Real(sign) / 2);
      const Real tangent = angle * (at_all_vertices ? turns : i == 0 ? 0 : turns - Real(sign) / 2);
      if (i > 0)
        curve[at] = curve[std::size_t(middle + sign * (i - 1))] +
                    Real(sign) * Vector(std::cos(direction), std::sin(direction), 0);
      for (const int side : {0, 1})
        normals[at][std::size_t(side)] = {std::sin(tangent), -std::cos(tangent),
                                          side == 0 ? Real(-0.1) : Real(0.2)};
    }
  const std::array<Vector, 2> sides{Vector(0, Real(0.1), Real(-0.8)), Vector(0, Real(0.1), 1)};
  return Sheets(curve, sides, normals).control;
}

TEST(Crease_scans, Angle_between_the_sheets)
{
  expect_slope(0, pi / 2, Real(0.6), [](Real slope) { return roof(slope, true); });
  expect_slope(0, pi / 2, Real(0.1), [](Real slope) { return roof(slope, false); });
  // of the normals alone, up to opposite ones
  expect_slope(0, pi / 2, Real(0.6), [](Real slope) {
    Control c = roof(Real(0.6), false);
    c.normals = roof(slope, true).normals;
    return c;
  });
}

// Near 180 degrees neighboring normals are nearly opposite.
TEST(Crease_scans, Bends)
{
  const auto arc = [](Real angle) { return bent(angle, true); };
  expect_slope(0, Real(2.8), Real(1.2), arc);
  expect_slope(Real(2.8), 3, 11, arc);
}

TEST(Crease_scans, Kinks)
{
  expect_slope(0, pi, 4, [](Real angle) { return bent(angle, false); });
}

// Beyond 85 degrees neighboring normals of a wedge become opposite: their mean is not continuous.
TEST(Crease_scans, Normals_along_the_crease)
{
  expect_slope(0, pi * 85 / 180, 18, [](Real turn) { return roof(Real(0.6), true, turn); });
}

TEST(Crease_scans, Sharpness)
{
  for (const bool with_normals : {true, false})
    expect_slope(Real(1e-6), Real(3.1), Real(0.3), [&](Real s) {
      Control c = roof(Real(0.6), with_normals);
      for (auto& e : c.sharp_edges) e.second = double(s);
      return c;
    });
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
