// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Creases of surfaces that are none of the simple ones: how smooth and how near to the true ones they are.

#include "Crease_shapes.h"
#include "Random_creases.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace crease_shapes;
using namespace CGAL::PN_subdivision_3;

// \name Perturbed data

// every point goes by 0.05 of the edges at it, every wedge's normal turns by 0.2
Control perturbed(const Part& part, unsigned seed)
{
  std::mt19937 random(seed);
  const auto direction = [&] {
    const auto x = [&] { return Real(random_creases::random_between(random, -1, 1)); };
    const Real a = x(), b = x(), c = x();
    return Vector(a, b, c).normalized();
  };
  Control c = part.control();
  std::vector<Real> length(c.points.size(), 0), count = length;
  for (const Face& f : c.faces)
    for (std::size_t i = 0; i < f.size(); ++i) {
      const auto v = std::size_t(f[i]), w = std::size_t(f[(i + 1) % f.size()]);
      const Real edge = (part.points[v] - part.points[w]).norm();
      for (const std::size_t end : {v, w}) {
        length[end] += edge;
        count[end] += 1;
      }
    }
  for (std::size_t v = 0; v < c.points.size(); ++v)
    c.points[v] = triple(part.points[v] + Real(0.05) * length[v] / count[v] * direction());
  std::map<std::pair<std::size_t, int>, Triple> turned; // by the group and the vertex
  for (auto& [corner, n] : c.normals) {
    const auto key = std::make_pair(part.group[std::size_t(corner.first)], corner.second);
    if (turned.count(key) == 0) {
      const Vector m = vector(n), axis = m.cross(direction()).normalized();
      turned[key] = triple(std::cos(Real(0.2)) * m + std::sin(Real(0.2)) * axis);
    }
    n = turned[key];
  }
  return c;
}

// the greatest angle between neighboring faces of one side at vertices on creases
template <class Run>
Real greatest_angle_at_creases(const Run& run)
{
  const Level_connectivity& level = run.level();
  std::set<Index> edges, vertices;
  for (const auto& e : run.creases().edges) edges.insert(e.edge);
  for (const auto& star : run.creases().stars)
    if (star.number_of_ends == 2 && star.sharpness == 0) vertices.insert(star.vertex);
  const auto area = [&](Index h) {
    Vector sum = Vector::Zero();
    const Vector origin = vector(run.point(level.target(h)));
    for (Index g = level.next(h); level.next(g) != h; g = level.next(g))
      sum += (vector(run.point(level.target(g))) - origin)
               .cross(vector(run.point(level.target(level.next(g)))) - origin);
    return sum;
  };
  Real greatest = 0;
  for (Index e = 0; e < level.number_of_edges(); ++e) {
    if (level.is_border_edge(e) || edges.count(e) != 0 ||
        (vertices.count(level.source(2 * e)) == 0 && vertices.count(level.target(2 * e)) == 0))
      continue;
    const Vector m = area(2 * e), n = area(2 * e + 1);
    const Real angle = std::atan2(m.cross(n).norm(), m.dot(n));
    if (!(angle <= greatest)) greatest = angle;
  }
  return greatest;
}

// the control mesh with a vertex in the middle of all polygons but triangles and quads, all split
Control split_about_centers(const Control& control)
{
  Control c = control;
  c.faces.clear();
  c.normals.clear();
  for (std::size_t f = 0; f < control.faces.size(); ++f) {
    const Face& face = control.faces[f];
    const auto corner = [&](int v) { return control.normals.at({int(f), v}); };
    const auto add = [&](const Face& t, const std::vector<Triple>& normals) {
      for (std::size_t i = 0; i < t.size(); ++i)
        c.normals[{int(c.faces.size()), t[i]}] = normals[i];
      c.faces.push_back(t);
    };
    if (face.size() <= 4) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i)
        add({face[0], face[i], face[i + 1]},
            {corner(face[0]), corner(face[i]), corner(face[i + 1])});
      continue;
    }
    Vector middle = Vector::Zero(), normal = middle;
    for (const int v : face) {
      middle += vector(control.points[std::size_t(v)]) / Real(face.size());
      normal += vector(corner(v));
    }
    const auto center = int(c.points.size());
    c.points.push_back(triple(middle));
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int v = face[i], w = face[(i + 1) % face.size()];
      add({v, w, center}, {corner(v), corner(w), triple(normal.normalized())});
    }
  }
  return c;
}

template <class Scheme>
void expect_smooth_sides(const Control& control, const Scheme& scheme, int first_round)
{
  Crease_run<double, Scheme> run(control, scheme);
  Real angle = 0;
  for (int k = 1; k <= 5; ++k) {
    run.refine();
    const Real next = greatest_angle_at_creases(run);
    EXPECT_LE(next, 1) << "round " << k; // no face is turned
    if (k > first_round) {
      EXPECT_LE(next, 0.6 * angle) << "round " << k;
    }
    angle = next;
  }
}

// Where the sides are tangent, turned normals give tangents far from those of the points: their angles
// halve later. For Loop, polygons are split about their centers: a single triangle between two creases has
// the osculating plane of the crease for its tangent plane, whatever the normals.
TEST(Perturbed_creases, Sides_are_smooth)
{
  for (unsigned seed = 1; seed <= 3; ++seed) {
    for (const Part& part : {capped_cylinder(uneven(7)), half_ball(), lens(), countersink()}) {
      const Control c = perturbed(part, seed);
      expect_smooth_sides(c, CatmullClark_scheme(), 2);
      expect_smooth_sides(split_about_centers(c), Loop_scheme(), 2);
    }
    const Control tangent = perturbed(bullet(), seed);
    expect_smooth_sides(tangent, CatmullClark_scheme(), 3);
    expect_smooth_sides(split_about_centers(tangent), Loop_scheme(), 3);
  }
}

TEST(Perturbed_creases, Stay_near)
{
  const auto expect_near = [](const Slots& a, const Slots& b, Real bar) {
    Real greatest = 0;
    for (std::size_t i = 0; i < a.points.size(); ++i)
      if (!((a.points[i] - b.points[i]).norm() <= greatest))
        greatest = (a.points[i] - b.points[i]).norm();
    EXPECT_LE(greatest, bar);
  };
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const Part& part : {washer(), bolt(), d_section(), rounded_box(), plate_with_hole(),
                             ball_cap(), octant(), crease_shapes::cube()}) {
      const Control exact = part.control(), c = perturbed(part, seed);
      const Real bar = Real(0.2) * part.scale();
      expect_near(slots(c, CatmullClark_scheme(), 3), slots(exact, CatmullClark_scheme(), 3), bar);
      expect_near(slots(triangulated(c), Loop_scheme(), 3),
                  slots(triangulated(exact), Loop_scheme(), 3), bar);
    }
}

// \name A cylinder's end, cut off by another surface

// z = saddle (x^2 - y^2) + slope x, between that surface and the cylinder of radius 1
struct Cut
{
  Real saddle, slope;

  Real height(Real x, Real y) const { return saddle * (x * x - y * y) + slope * x; }
  Vector normal(bool is_top, const Vector& p) const
  {
    return (is_top ? Vector(-2 * saddle * p[0] - slope, 2 * saddle * p[1], 1)
                   : Vector(p[0], p[1], 0))
      .normalized();
  }
  Real distance(bool is_top, const Vector& p) const
  {
    if (!is_top) return std::abs(std::hypot(p[0], p[1]) - 1);
    return std::abs((p[2] - height(p[0], p[1])) * normal(true, p)[2]); // to first order
  }

  // n quads on either side of the crease
  Control control(int n) const
  {
    Control c;
    const auto add_ring = [&](Real radius, Real lowered) {
      Ring r;
      for (int i = 0; i < n; ++i) {
        const Real a = 2 * pi * (Real(i) + Real(0.3)) / Real(n), x = radius * std::cos(a),
                   y = radius * std::sin(a);
        r.push_back(int(c.points.size()));
        c.points.push_back(triple({x, y, height(x, y) - lowered}));
      }
      return r;
    };
    const Ring rim = add_ring(1, 0), inner = add_ring(Real(0.6), 0), low = add_ring(1, 2);
    const auto add = [&](const Face& f, bool is_top) {
      for (const int v : f)
        c.normals[{int(c.faces.size()), v}] =
          triple(normal(is_top, vector(c.points[std::size_t(v)])));
      c.faces.push_back(f);
    };
    for (std::size_t i = 0; i < std::size_t(n); ++i) {
      const std::size_t j = (i + 1) % std::size_t(n);
      add({rim[i], rim[j], inner[j], inner[i]}, true);
      add({low[i], low[j], rim[j], rim[i]}, false);
      c.sharp_edges[undirected(rim[i], rim[j])] = infinity;
    }
    add(inner, true);
    return c;
  }

  // of the crease from both surfaces
  template <class Scheme>
  Real distance(int n, const Scheme& scheme) const
  {
    Crease_run<double, Scheme> run(control(n), scheme);
    run.refine(3);
    Real greatest = 0;
    for (const auto& star : run.creases().stars)
      for (const bool is_top : {true, false})
        greatest = (std::max)(greatest, distance(is_top, vector(run.point(star.vertex))));
    return greatest;
  }
};

// no such crease is kept exactly: linear rules approach it as the square, these as the fourth power
TEST(Wavy_crease, Follows_the_surfaces_beside_it)
{
  for (const Cut& cut : {Cut{Real(0.3), 0}, Cut{0, 1}}) {
    Real coarse = cut.distance(8, CatmullClark_scheme());
    EXPECT_LE(coarse, 0.016);
    EXPECT_GE(cut.distance(8, linear(CatmullClark_scheme())), 0.06);
    for (const int n : {16, 32}) {
      const Real fine = cut.distance(n, CatmullClark_scheme());
      EXPECT_LE(fine, coarse / 8) << n;
      EXPECT_GE(cut.distance(n, linear(CatmullClark_scheme())), 15 * fine);
      coarse = fine;
    }
  }
}

} // namespace
