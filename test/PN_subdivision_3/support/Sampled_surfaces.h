// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Uneven samples of spheres, caps, cylinders, cones, tori, ellipsoids and a wavy graph with their
// true normals; they come as points with nothing else to what is tested.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SAMPLED_SURFACES_H
#define CGAL_PN_SUBDIVISION_3_TEST_SAMPLED_SURFACES_H

#include "Test_meshes.h"

#include <Eigen/Geometry>

#include <functional>

namespace sampled_surfaces {

using reference::Face;
using reference::Real;
using test_meshes::Cells;
using test_meshes::Control_mesh;
using test_meshes::Triple;
using Vector = Eigen::Matrix<Real, 3, 1>;

constexpr Real pi = 3.14159265358979323846264338327950288L;

// a point and its normal, of any length
struct Sample
{
  Vector point, normal;
};

inline void add(Control_mesh& mesh, const Sample& s)
{
  const Vector n = s.normal.normalized();
  mesh.points.push_back({double(s.point[0]), double(s.point[1]), double(s.point[2])});
  mesh.normals.push_back({double(n[0]), double(n[1]), double(n[2])});
}

inline Sample on_sphere(const Vector& direction)
{
  const Vector n = direction.normalized();
  return {n, n};
}

inline Sample on_ellipsoid(const Vector& direction)
{
  const Vector axes(1.5, 1, 0.7);
  const Vector p = axes.cwiseProduct(direction.normalized());
  return {p, p.cwiseQuotient(axes).cwiseQuotient(axes)};
}

using Numbers = std::vector<Real>;

// n values from 0 to 1 with uneven steps, both ends included
inline Numbers uneven(int n, Real unevenness, std::mt19937& generator)
{
  std::uniform_real_distribution<double> step(1 - double(unevenness), 1 + double(unevenness));
  Numbers x{0};
  for (int i = 1; i < n; ++i) x.push_back(x.back() + step(generator));
  for (Real& y : x) y /= x.back();
  return x;
}

// The crossings of parallels, at the angles 2 pi u, and meridians, at the heights v. The surface is
// closed along the parallels, and also along the meridians if told so. `v` then has its first value
// again as its last one.
template <class Surface>
Control_mesh revolution(const Numbers& u, const Numbers& v, bool closed_v, Cells cells,
                        const Surface& surface)
{
  const int nu = int(u.size()) - 1, nv = int(v.size()) - 1, rows = closed_v ? nv : nv + 1;
  Control_mesh mesh{"revolution", {}, {}, {}};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < nu; ++i) add(mesh, surface(2 * pi * u[std::size_t(i)], v[std::size_t(j)]));
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const int right = (i + 1) % nu, up = (j + 1) % rows;
      test_meshes::add_cell({nu * j + i, nu * j + right, nu * up + right, nu * up + i},
                            std::size_t(j * nu + i * i + j * j), cells, mesh.faces);
    }
  return mesh;
}

inline Control_mesh cylinder(const Numbers& u, const Numbers& v, Real height, Cells cells)
{
  return revolution(u, v, false, cells, [&](Real s, Real t) {
    const Vector n(std::cos(s), std::sin(s), 0);
    return Sample{n + Vector(0, 0, height * t), n};
  });
}

inline Control_mesh cone(const Numbers& u, const Numbers& v, Cells cells)
{
  return revolution(u, v, false, cells, [&](Real s, Real t) {
    const Vector n(std::cos(s), std::sin(s), 0.5);
    return Sample{(2 - t) * Vector(n[0], n[1], 0) + Vector(0, 0, 2 * t), n};
  });
}

inline Control_mesh torus(const Numbers& u, const Numbers& v, Cells cells)
{
  return revolution(u, v, true, cells, [&](Real s, Real t) {
    const Vector out(std::cos(s), std::sin(s), 0);
    const Vector n = std::cos(2 * pi * t) * out + std::sin(2 * pi * t) * Vector(0, 0, 1);
    return Sample{2.5L * out + n, n};
  });
}

// An icosahedron cut in four `rounds` times, each direction moved by up to `shift` edges.
inline Control_mesh scattered(int rounds, double shift, unsigned seed,
                              const std::function<Sample(const Vector&)>& surface)
{
  const double g = (1 + std::sqrt(5.)) / 2;
  std::vector<Vector> d;
  for (int a : {-1, 1})
    for (double b : {-g, g})
      for (int k = 0; k < 3; ++k) {
        Vector x = Vector::Zero();
        x[(k + 1) % 3] = a;
        x[(k + 2) % 3] = b;
        d.push_back(x);
      }
  std::vector<Face> faces;
  for (int i = 0; i < 12; ++i) // its edges have the length 2
    for (int j = i + 1; j < 12; ++j)
      for (int k = j + 1; k < 12; ++k) {
        const auto near = [&](int a, int b) {
          return (d[std::size_t(a)] - d[std::size_t(b)]).norm() < 2.1L;
        };
        if (!near(i, j) || !near(j, k) || !near(k, i)) continue;
        const bool outwards = d[std::size_t(i)].dot(d[std::size_t(j)].cross(d[std::size_t(k)])) > 0;
        faces.push_back(outwards ? Face{i, j, k} : Face{i, k, j});
      }
  for (int r = 0; r < rounds; ++r) {
    std::map<std::pair<int, int>, int> middle;
    std::vector<Face> smaller;
    const auto between = [&](int a, int b) {
      const auto [it, is_new] = middle.insert({std::minmax(a, b), int(d.size())});
      if (is_new)
        d.push_back((d[std::size_t(a)].normalized() + d[std::size_t(b)].normalized()) / 2);
      return it->second;
    };
    for (const Face& f : faces) {
      const int a = between(f[0], f[1]), b = between(f[1], f[2]), c = between(f[2], f[0]);
      for (const Face& t : {Face{f[0], a, c}, Face{f[1], b, a}, Face{f[2], c, b}, Face{a, b, c}})
        smaller.push_back(t);
    }
    faces = smaller;
  }
  std::mt19937 generator(seed);
  const double edge = 1.05 / std::pow(2., rounds);
  std::uniform_real_distribution<double> noise(-shift * edge, shift * edge);
  Control_mesh mesh{"scattered", {}, {}, {}};
  for (const Vector& x : d) {
    // one by one: compilers evaluate arguments in orders of their own
    const double dz = noise(generator), dy = noise(generator), dx = noise(generator);
    add(mesh, surface(x.normalized() + Vector(dx, dy, dz)));
  }
  mesh.faces = faces;
  return mesh;
}

// A grid of nx times ny cells about the middle of [-1, 1]^2, its inner and border vertices moved by
// up to `shift` cells (along the border where they are on it), laid on a surface over the plane.
inline Control_mesh patch(int nx, int ny, double shift, Cells cells, unsigned seed,
                          const std::function<Sample(Real, Real)>& surface)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> noise(-shift, shift);
  Control_mesh mesh{"patch", {}, {}, {}};
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const double dx = noise(generator), dy = noise(generator);
      const double x = i + (i % nx == 0 ? 0 : dx), y = j + (j % ny == 0 ? 0 : dy);
      add(mesh, surface(2 * x / nx - 1, 2 * y / ny - 1));
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = (nx + 1) * j + i, b = a + nx + 1;
      test_meshes::add_cell({a, a + 1, b + 1, b}, std::size_t(i * i + 3 * j + i * j), cells,
                            mesh.faces);
    }
  return mesh;
}

// the part of the unit sphere above the square [-side, side]^2
inline std::function<Sample(Real, Real)> cap(Real side)
{
  return [side](Real x, Real y) {
    return on_sphere(Vector(side * x, side * y, std::sqrt(1 - side * side * (x * x + y * y) / 2)));
  };
}

inline Sample on_waves(Real x, Real y)
{
  const Real a = 1.5 * x + 0.4, b = 1.3 * y - 0.2;
  return {Vector(x, y, 0.3 * std::sin(a) * std::cos(b)),
          Vector(-0.45 * std::cos(a) * std::cos(b), 0.39 * std::sin(a) * std::sin(b), 1)};
}

} // namespace sampled_surfaces

#endif // CGAL_PN_SUBDIVISION_3_TEST_SAMPLED_SURFACES_H
