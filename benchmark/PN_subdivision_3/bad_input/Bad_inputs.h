// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Thirty inputs that go wrong somewhere, each with what it should lead to.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_PEERS_BAD_INPUTS_H
#define CGAL_PN_SUBDIVISION_3_TEST_PEERS_BAD_INPUTS_H

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace peers {

using Triple = std::array<double, 3>;
using Polygon = std::vector<int>;

enum class Expected {
  result,  // the scheme's
  refusal, // there is no right result
  either   // no oriented 2-manifold, but a scheme may have a rule for it
};

struct Input
{
  std::string name;
  std::vector<Triple> points;
  std::vector<Polygon> faces;
  Expected expected = Expected::refusal;
  bool loop = false; // otherwise Catmull-Clark

  // vertices and faces after a round of a scheme that keeps vertices without edges
  std::pair<std::size_t, std::size_t> refined() const
  {
    std::set<std::pair<int, int>> edges;
    std::size_t corners = 0;
    for (const Polygon& f : faces) {
      corners += f.size();
      for (std::size_t i = 0; i < f.size(); ++i) {
        const int a = f[i], b = f[(i + 1) % f.size()];
        edges.insert({(std::min)(a, b), (std::max)(a, b)});
      }
    }
    if (loop) return {points.size() + edges.size(), 4 * faces.size()};
    return {points.size() + edges.size() + faces.size(), corners};
  }
};

inline Triple on_circle(int i, int n, double z = 0)
{
  const double angle = 2 * 3.141592653589793 * i / n;
  return {std::cos(angle), std::sin(angle), z};
}

inline Input cube(const std::string& name, Expected expected)
{
  Input in{name, {}, {}, expected};
  for (int i = 0; i < 8; ++i)
    in.points.push_back({i & 1 ? 1. : -1., i & 2 ? 1. : -1., i & 4 ? 1. : -1.});
  in.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return in;
}
inline Input tetrahedron(const std::string& name, Expected expected)
{
  return {name,
          {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
          expected,
          true};
}

inline std::vector<Input> bad_inputs()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Triple> five = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}, {-1, 0.5, 0.2}};
  std::vector<Input> all;
  const auto add = [&all](Input in) -> Input& {
    all.push_back(std::move(in));
    return all.back();
  };
  // elements
  add({"no vertices and no faces", {}, {}, Expected::result});
  add({"vertices without faces", five, {}, Expected::result});
  add(cube("a vertex without edges, Catmull-Clark", Expected::result)).points.push_back({5, 5, 5});
  add(tetrahedron("a vertex without edges, Loop", Expected::result)).points.push_back({5, 5, 5});
  add(cube("a coordinate that is not a number", Expected::refusal)).points[3][1] = NAN;
  add(cube("an infinite coordinate", Expected::refusal)).points[3][1] = infinity;
  for (Triple& p : add(cube("coordinates whose sums overflow", Expected::either)).points)
    for (double& x : p) x *= 1.7e308;
  for (Triple& p : add(cube("coordinates below the normal range", Expected::result)).points)
    for (double& x : p) x *= 5e-324;
  add(cube("an index beyond the vertices", Expected::refusal)).faces[2][1] = 99;
  add(cube("a negative index", Expected::refusal)).faces[2][1] = -1;
  add(cube("a face with two vertices", Expected::refusal)).faces.push_back({0, 1});
  add(cube("a face with one vertex", Expected::refusal)).faces.push_back({0});
  add(cube("a face that visits a vertex twice", Expected::refusal)).faces[0] = {0, 2, 0, 3, 1};
  // no manifolds
  add({"the same face twice",
       {five[0], five[1], five[2], five[3]},
       {{0, 1, 2, 3}, {0, 1, 2, 3}},
       Expected::either});
  add({"an edge with three faces", five, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, Expected::either});
  add(
    {"faces with opposite orientation", five, {{0, 1, 2}, {0, 2, 4}, {0, 3, 2}}, Expected::either});
  Input& moebius = add({"a Möbius strip", {}, {}, Expected::either});
  for (int i = 0; i < 5; ++i) {
    moebius.points.push_back(on_circle(i, 5, -0.3));
    moebius.points.push_back(on_circle(i, 5, 0.3));
    if (i < 4) moebius.faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  }
  moebius.faces.push_back({8, 1, 0, 9});
  add({"two triangles that share a vertex", five, {{0, 1, 2}, {0, 3, 4}}, Expected::either});
  Input& pinched = add(tetrahedron("two tetrahedra that share a vertex", Expected::either));
  pinched.points.insert(pinched.points.end(), {{4, 1, 1}, {4, 3, 1}, {4, 1, 3}});
  pinched.faces.insert(pinched.faces.end(), {{0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}});
  // faces that a scheme does not take
  add(cube("quadrilaterals for Loop", Expected::refusal)).loop = true;
  add({"a triangle and a pentagon for Loop",
       {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {0.5, -1, 0}},
       {{0, 1, 2, 3, 4}, {1, 0, 5}},
       Expected::refusal,
       true});
  // unusual, but right
  add({"a face on a line",
       {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}},
       {{0, 1, 2}, {0, 2, 3}},
       Expected::result});
  for (Triple& p : add(cube("all points are equal", Expected::result)).points) p = {1, 2, 3};
  Input& crack =
    add({"equal points along an edge", five, {{0, 1, 2, 3}, {5, 6, 4}}, Expected::result});
  crack.points.insert(crack.points.end(), {five[0], five[3]});
  add({"two faces back to back",
       {five[0], five[1], five[2], five[3]},
       {{0, 1, 2, 3}, {3, 2, 1, 0}},
       Expected::result});
  add({"an interior vertex of valence 2", five, {{0, 1, 2, 3}, {2, 1, 0, 4}}, Expected::result});
  add({"a quadrilateral that crosses itself",
       {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
       {{0, 1, 2, 3}},
       Expected::result});
  add({"one triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, Expected::result, true});
  Input& pole = add({"a vertex of valence 5000", {}, {}, Expected::result, true});
  Input rim = {"a face of 5000 vertices", {}, {{}}, Expected::result};
  constexpr int n = 5000;
  for (int i = 0; i < n; ++i) {
    pole.points.push_back(on_circle(i, n));
    pole.faces.push_back({i, (i + 1) % n, n});
    rim.points.push_back(on_circle(i, n));
    rim.faces[0].push_back(i);
  }
  pole.points.push_back({0, 0, 1});
  add(rim);
  return all;
}

} // namespace peers

#endif // CGAL_PN_SUBDIVISION_3_TEST_PEERS_BAD_INPUTS_H
