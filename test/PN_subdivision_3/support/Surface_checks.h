// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What holds of every limit surface: its derivatives are the differences of its points, a ray through one of its points
// meets it there or before, and no point of it is closer than the closest one.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SURFACE_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_TEST_SURFACE_CHECKS_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace surface_checks {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;

inline double length(const Vector& v)
{
  return std::sqrt(v.squared_length());
}

template <class Hit>
void expect_point(const Hit& hit, const Point& expected, double distance, double tolerance = 2e-6)
{
  EXPECT_LE(length(hit.point - expected), tolerance) << hit.point << " not " << expected;
  EXPECT_NEAR(hit.distance, distance, tolerance);
}

// so many steps along each side of each piece of a face
template <class Surface>
std::vector<typename Surface::Location> grid_places(const Surface& surface,
                                                    typename Surface::Face f, int steps)
{
  std::vector<typename Surface::Location> result;
  for (std::size_t piece = 0; piece < surface.number_of_pieces(f); ++piece)
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= (surface.is_triangular() ? steps - i : steps); ++j)
        result.push_back({f, 2 * double(piece) + double(i) / steps, double(j) / steps});
  return result;
}
// of all faces; the steps are a function of the face
template <class Surface, class Steps>
std::vector<typename Surface::Location> grid_places(const Surface& surface, const Steps& steps)
{
  std::vector<typename Surface::Location> result;
  for (auto f : surface.faces())
    for (const auto& place : grid_places(surface, f, steps(f))) result.push_back(place);
  return result;
}

// \name Derivatives

// weights of the values at x + k h, where there is room
using Weights = std::vector<std::pair<int, double>>;
struct Differences
{
  Weights first, second; // derivatives, with errors of second order

  Differences(double x, double h)
  {
    const bool is_low = x<h, is_high = x> 1 - h;
    const double a = (is_high ? -1 : 1) / h, b = 1 / (h * h);
    const int k = is_high ? -1 : 1;
    if (is_low || is_high) {
      first = {{0, -1.5 * a}, {k, 2 * a}, {2 * k, -0.5 * a}};
      second = {{0, 2 * b}, {k, -5 * b}, {2 * k, 4 * b}, {3 * k, -b}};
    } else {
      first = {{-1, -0.5 * a}, {1, 0.5 * a}};
      second = {{-1, b}, {0, -2 * b}, {1, b}};
    }
  }
};

struct Derivative_bounds
{
  unsigned order;       // up to which there are some
  double first, second; // in parts of 1 and of the length
};

// Every so many of the places in a piece, from some on.
struct Some_places
{
  std::size_t every = 1, next = 0;
};

// inside, on sides, beside them and beside corners
inline std::vector<std::array<double, 2>> places(bool is_triangular, Some_places& some)
{
  std::vector<std::array<double, 2>> all = {{0.37, 0.41}, {0.61, 0.17}, {0.05, 0.03},
                                            {0.31, 0},    {0, 0.57},    {0.02, 0.93}};
  if (!is_triangular) all.insert(all.end(), {{0.97, 0.96}, {1, 0.3}, {0.6, 1}});
  std::vector<std::array<double, 2>> result;
  for (const auto& place : all)
    if (some.next++ % some.every == 0) result.push_back(place);
  return result;
}

template <class Surface>
void expect_derivatives(const Surface& surface, typename Surface::Face f, std::size_t piece,
                        const Derivative_bounds& bounds, Some_places& some)
{
  constexpr double h = 1e-3;
  using Key = std::array<int, 3>; // number of the place, steps
  std::map<Key, std::size_t> at;
  std::vector<typename Surface::Location> locations;
  const auto all = places(surface.is_triangular(), some);
  const auto need = [&](int n, int i, int j) {
    if (!at.emplace(Key{n, i, j}, locations.size()).second) return;
    locations.push_back({f, 2. * double(piece) + all[n][0] + i * h, all[n][1] + j * h});
  };
  for (int n = 0; n < int(all.size()); ++n) {
    const Differences u(all[n][0], h), v(all[n][1], h);
    need(n, 0, 0);
    for (const auto& [i, a] : u.first)
      for (const auto& [j, b] : v.first) need(n, i, j);
    for (const auto* of : {&u.first, &u.second})
      for (const auto& [i, a] : *of) need(n, i, 0);
    for (const auto* of : {&v.first, &v.second})
      for (const auto& [j, b] : *of) need(n, 0, j);
  }
  const auto points = surface.evaluate(locations);
  for (int n = 0; n < int(all.size()); ++n) {
    const Differences u(all[n][0], h), v(all[n][1], h);
    const auto sum = [&](const Weights& of_u, const Weights& of_v) {
      Vector s = CGAL::NULL_VECTOR;
      for (const auto& [i, a] : of_u)
        for (const auto& [j, b] : of_v)
          s += a * b * (points[at.at({n, i, j})].point - CGAL::ORIGIN);
      return s;
    };
    const auto& s = points[at.at({n, 0, 0})];
    const auto expect = [&](const char* name, const Vector& given, const Vector& expected,
                            double bound) {
      EXPECT_LE(length(given - expected), bound * (1 + length(expected)))
        << name << " at (" << all[n][0] << ", " << all[n][1] << ") of piece " << piece << " of "
        << f << ": " << given << ", not " << expected << ", after " << s.rounds << " rounds";
    };
    const Weights here = {{0, 1.}};
    EXPECT_EQ(s.derivatives, bounds.order);
    if (s.derivatives < 1) continue;
    const double first = bounds.first + 2 * s.error / h; // the points have errors, too
    expect("du", s.du, sum(u.first, here), first);
    expect("dv", s.dv, sum(here, v.first), first);
    if (s.derivatives < 2) continue;
    expect("duu", s.duu, sum(u.second, here), bounds.second);
    expect("duv", s.duv, sum(u.first, v.first), bounds.second);
    expect("dvv", s.dvv, sum(here, v.second), bounds.second);
  }
}

// of two pieces of the first face of every kind, and of the last face; bounds(f) are those of a face
template <class Surface, class Degree, class Bounds>
void expect_derivatives(const Surface& surface, const Degree& degree, const Bounds& bounds,
                        Some_places some = {})
{
  std::map<std::size_t, int> seen;
  for (const auto f : surface.faces())
    if (seen[degree(f)]++ == 0 || f == surface.faces().back())
      for (std::size_t piece = 0; piece < (std::min<std::size_t>)(2, surface.number_of_pieces(f));
           ++piece)
        expect_derivatives(surface, f, piece, bounds(f), some);
}

template <class Surface, class Degree>
void expect_derivatives(const Surface& surface, const Degree& degree,
                        const Derivative_bounds& bounds)
{
  expect_derivatives(surface, degree, [&](const auto&) { return bounds; });
}

// \name Rays and closest points

struct Fine_triangles
{
  std::vector<Point> points;
  double error = 0; // of the points
  std::vector<std::array<Point, 3>> triangles;
  CGAL::Bbox_3 box;

  // points of all pieces, n to a side, and the triangles between them
  template <class Surface>
  Fine_triangles(const Surface& surface, int n)
  {
    for (const auto f : surface.faces())
      for (std::size_t piece = 0; piece < surface.number_of_pieces(f); ++piece) {
        std::map<std::array<int, 2>, std::size_t> at;
        std::vector<typename Surface::Location> locations;
        for (int i = 0; i <= n; ++i)
          for (int j = 0; j <= (surface.is_triangular() ? n - i : n); ++j) {
            at[{i, j}] = points.size() + locations.size();
            locations.push_back({f, 2. * double(piece) + double(i) / n, double(j) / n});
          }
        for (const auto& s : surface.evaluate(locations)) points.push_back(s.point);
        const auto add = [&](std::array<int, 2> a, std::array<int, 2> b, std::array<int, 2> c) {
          if (at.count(a) && at.count(b) && at.count(c))
            triangles.push_back({points[at[a]], points[at[b]], points[at[c]]});
        };
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            add({i, j}, {i + 1, j}, {i, j + 1});
            add({i + 1, j}, {i + 1, j + 1}, {i, j + 1});
          }
      }
    for (const Point& p : points) box += p.bbox();
  }

  // of a mesh with limit points
  template <class Mesh>
  Fine_triangles(const Mesh& mesh, double error_of_points)
    : points(mesh.points().begin(), mesh.points().end())
    , error(error_of_points)
  {
    for (const auto f : mesh.faces()) {
      const auto first = mesh.halfedge(f);
      for (auto h = mesh.next(first); mesh.next(h) != first; h = mesh.next(h))
        triangles.push_back({mesh.point(mesh.target(first)), mesh.point(mesh.target(h)),
                             mesh.point(mesh.target(mesh.next(h)))});
    }
    for (const Point& p : points) box += p.bbox();
  }

  double size() const
  {
    return (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  }

  // where the first triangle is that a ray meets well inside and steeply, not so near its source that the surface may be behind it
  double first(const Point& o, const Vector& d) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : triangles) {
      const Vector u = b - a, v = c - a, n = CGAL::cross_product(u, v);
      const double nd = n * d, nn = n * n, z = (n * (a - o)) / nd;
      if (!(std::abs(nd) > 0.3 * std::sqrt(nn)) || z < 0.1 * size() || z > least) continue;
      const Vector q = o + z * d - a;
      const double y = (CGAL::cross_product(u, q) * n) / nn,
                   x = (CGAL::cross_product(q, v) * n) / nn;
      if (x > 0.05 && y > 0.05 && x + y < 0.95) least = z;
    }
    return least;
  }
};

// rays from outside and inside to places of all kinds, beside sides and corners of pieces too; `from` is the first one's number
template <class Surface, class Queries>
void expect_rays(const Surface& surface, const Queries& queries, const Fine_triangles& fine,
                 int number, int from = 0)
{
  std::mt19937 random(7U + unsigned(from));
  const auto any = [&] { return double(random()) / 4294967296.; };
  const auto any_vector = [&] { return Vector{any() - 0.5, any() - 0.5, any() - 0.5}; };
  const double size = fine.size(), off = 4 * surface.tolerance() + 1e-13 * size;
  const Point middle((fine.box.xmin() + fine.box.xmax()) / 2,
                     (fine.box.ymin() + fine.box.ymax()) / 2,
                     (fine.box.zmin() + fine.box.zmax()) / 2);
  const auto& faces = surface.faces();
  for (int k = from; k < from + number; ++k) {
    const auto f = faces[random() % faces.size()];
    const auto piece = double(random() % surface.number_of_pieces(f));
    const double x = k % 3 == 0 ? any() : std::pow(10., -4 * any()), y = any();
    const bool is_far = k % 2 == 0;
    const double u = is_far ? 1 - x : x, v = surface.is_triangular() ? y * (1 - u) : y;
    SCOPED_TRACE(testing::Message() << "ray " << k << " to (" << u << ", " << v << ") of piece "
                                    << piece << " of " << f);
    const auto target = surface.evaluate(f, 2 * piece + u, v);
    const Point o = middle + (k % 4 == 3 ? 0.1 : 3) * size * any_vector();
    const double distance = length(target.point - o);
    const Vector d = (target.point - o) / distance;
    if (std::abs(target.normal * d) < 0.05) continue;
    const auto hit = queries.first_intersection(o, d);
    EXPECT_TRUE(hit);
    if (!hit) continue;
    const auto there = surface.evaluate(hit->location.face, hit->location.u, hit->location.v);
    EXPECT_LE(length(CGAL::cross_product(hit->point - o, d)), (std::max)(off, 2 * there.error));
    EXPECT_LE(length(there.point - hit->point), 1e-13 * size);
    EXPECT_NEAR(hit->distance, (hit->point - o) * d, 1e-13 * size);
    EXPECT_LE(hit->distance, distance + 20 * (off + 2 * target.error));
    EXPECT_LE(hit->distance, fine.first(o, d) + 0.1 * size);
  }
}

template <class Surface, class Queries>
void expect_closest_points(const Surface& surface, const Queries& queries,
                           const Fine_triangles& fine, int number, int from = 0)
{
  std::mt19937 random(8U + unsigned(from));
  const auto any = [&] { return double(random()) / 4294967296. - 0.5; };
  const double off = 4 * surface.tolerance() + 1e-13 * fine.size() + fine.error;
  for (int k = from; k < from + number; ++k) {
    const double away = k % 4 == 0 ? 0 : fine.size() * std::pow(10., 1 - k % 4);
    const Point p = fine.points[random() % fine.points.size()] + away * Vector{any(), any(), any()};
    double least = std::numeric_limits<double>::infinity();
    for (const Point& other : fine.points) least = (std::min)(least, length(other - p));
    const auto c = queries.closest_point(p);
    const auto there = surface.evaluate(c.location.face, c.location.u, c.location.v);
    EXPECT_LE(c.distance, least + off + there.error) << p;
    EXPECT_NEAR(length(c.point - p), c.distance, 1e-13 * fine.size());
    EXPECT_LE(length(there.point - c.point), 1e-13 * fine.size());
  }
}

} // namespace surface_checks

#endif // CGAL_PN_SUBDIVISION_3_TEST_SURFACE_CHECKS_H
