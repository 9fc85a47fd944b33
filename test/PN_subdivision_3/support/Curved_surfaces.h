// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Surfaces over the plane with their normals and curvatures in closed form, and plane meshes to be
// laid on them. A curvature is positive where the surface bends away from its normal.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_CURVED_SURFACES_H
#define CGAL_PN_SUBDIVISION_3_TEST_CURVED_SURFACES_H

#include "Mesh_cases.h"

#include <functional>
#include <random>
#include <utility>

namespace curved_surfaces {

using mesh_cases::Polygon;
using mesh_cases::Soup;
using mesh_cases::Triple;

constexpr double pi = 3.14159265358979323846;

struct Surface_point
{
  Triple point, normal;
  double gaussian, mean;
  Triple minimal_direction; // zero where it is not known in closed form
};

using Surface = std::function<Surface_point(double, double)>;

// --- surfaces ---

// the graph of z, from its derivatives: p = z_x, q = z_y, r = z_xx, s = z_xy, t = z_yy
inline Surface_point graph(double x, double y, double z, double p, double q, double r, double s,
                           double t)
{
  const double w2 = 1 + p * p + q * q, w = std::sqrt(w2);
  return {{x, y, z},
          {-p / w, -q / w, 1 / w},
          (r * t - s * s) / (w2 * w2),
          -((1 + q * q) * r - 2 * p * q * s + (1 + p * p) * t) / (2 * w2 * w),
          {}};
}

inline Surface_point saddle(double x, double y)
{
  return graph(x, y, 2 * x * y, 2 * y, 2 * x, 0, 2, 0);
}

inline Surface_point waves(double x, double y)
{
  const double a = 1.5 * x + 0.4, b = 1.3 * y - 0.2;
  const double sa = std::sin(a), ca = std::cos(a), sb = std::sin(b), cb = std::cos(b);
  return graph(x, y, 0.3 * sa * cb, 0.45 * ca * cb, -0.39 * sa * sb, -0.675 * sa * cb,
               -0.585 * ca * sb, -0.507 * sa * cb);
}

inline Surface_point plane(double x, double y)
{
  return graph(x, y, 0.3 * x - 0.7 * y + 2, 0.3, -0.7, 0, 0, 0);
}

// radius 2, outward normals
inline Surface_point sphere(double x, double y)
{
  const double l = std::sqrt(x * x + y * y + 1);
  const Triple n{x / l, y / l, 1 / l};
  return {{2 * n[0], 2 * n[1], 2 * n[2]}, n, 0.25, 0.5, {}};
}

// radius 2 about the x-axis, outward normals
inline Surface_point cylinder(double x, double y)
{
  const double s = std::sin(y / 2), c = std::cos(y / 2);
  return {{x, 2 * s, 2 * c}, {0, s, c}, 0, 0.25, {1, 0, 0}};
}

// radii 3 and 1 about the z-axis, outward normals; x and y are the angles about and in the tube
inline Surface_point torus(double x, double y)
{
  const double rho = 3 + std::cos(y), across = std::cos(y) / rho;
  return {{rho * std::cos(x), rho * std::sin(x), std::sin(y)},
          {std::cos(y) * std::cos(x), std::cos(y) * std::sin(x), std::sin(y)},
          across,
          (1 + across) / 2,
          {-std::sin(x), std::cos(x), 0}};
}

// --- plane meshes ---

enum class Faces { quads, triangles, mixed };

inline void add_quad(Soup& soup, const Polygon& q, Faces kind, std::size_t index)
{
  if (kind == Faces::quads || (kind == Faces::mixed && index % 3 != 0)) {
    soup.faces.push_back(q);
  } else {
    soup.faces.push_back({q[0], q[1], q[2]});
    soup.faces.push_back({q[0], q[2], q[3]});
  }
}

// (n+1)^2 vertices in the unit square about (0.2, 0.3), displaced at random by up to `jitter`
// edge lengths
inline Soup square(std::size_t n, Faces kind, double jitter)
{
  Soup soup;
  std::mt19937 generator(7);
  std::uniform_real_distribution<> random(-jitter, jitter);
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j) {
      const double x = double(i) + random(generator), y = double(j) + random(generator);
      soup.points.push_back({x / double(n) - 0.3, y / double(n) - 0.2, 0});
    }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = i * (n + 1) + j, b = a + n + 1;
      add_quad(soup, {a, b, b + 1, a + 1}, kind, i + 2 * j);
    }
  return soup;
}

// A vertex of valence n, the first one, in the middle of five rings of edge length h. Sector s has
// the vertices h (i D_s + j D_{s+1}) with unit vectors D.
inline Soup star(int n, Faces kind, double h)
{
  constexpr int rings = 5;
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> index;
  const auto vertex = [&](int s, int i, int j) {
    if (i == 0 && j == 0) s = 0;
    if (i == 0 && j > 0) {
      s = s + 1;
      std::swap(i, j);
    }
    s %= n;
    const auto [it, is_new] = index.try_emplace({s, i, j}, index.size());
    if (is_new) {
      const double a = 2 * pi * s / n, b = 2 * pi * (s + 1) / n;
      soup.points.push_back({h * (i * std::cos(a) + j * std::cos(b)) + 0.2,
                             h * (i * std::sin(a) + j * std::sin(b)) + 0.1, 0});
    }
    return it->second;
  };
  vertex(0, 0, 0);
  for (int s = 0; s < n; ++s)
    for (int i = 0; i < rings; ++i)
      for (int j = 0; j < rings; ++j) {
        const auto corner = [&](int k, int l) { return vertex(s, i + k, j + l); };
        if (kind == Faces::quads)
          soup.faces.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
        else if (i + j < rings) {
          soup.faces.push_back({corner(0, 0), corner(1, 0), corner(0, 1)});
          if (i + j + 1 < rings) soup.faces.push_back({corner(1, 0), corner(1, 1), corner(0, 1)});
        }
      }
  return soup;
}

// the grid of n times 2n cells of a closed torus, in its angles
inline Soup torus_grid(std::size_t n, Faces kind)
{
  Soup soup;
  const std::size_t m = 2 * n;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      soup.points.push_back({2 * pi * double(i) / double(m), 2 * pi * double(j) / double(n), 0});
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const auto v = [&](std::size_t k, std::size_t l) { return (k % m) * n + l % n; };
      add_quad(soup, {v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1)}, kind, i + 2 * j);
    }
  return soup;
}

// --- a plane mesh on a surface ---

struct Sampled_surface
{
  Soup soup;
  std::vector<Surface_point> exact; // of the vertices
};

inline Sampled_surface lay(const Soup& plane_mesh, const Surface& surface)
{
  Sampled_surface result{plane_mesh, {}};
  for (Triple& p : result.soup.points) {
    result.exact.push_back(surface(p[0], p[1]));
    p = result.exact.back().point;
  }
  return result;
}

} // namespace curved_surfaces

#endif // CGAL_PN_SUBDIVISION_3_TEST_CURVED_SURFACES_H
