// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_MEASURED_LIMITS_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_MEASURED_LIMITS_H

#include "../../examples/PN_certificates_3/Closed_samples.h"

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// A surface as a set of points with its normals and mean curvatures there, and how far it is off the closed cubic
// surface of the examples: for the benchmarks that compare the linear scheme and other methods.
namespace measured {

using closed_samples::Kernel;
using closed_samples::Mesh;
using closed_samples::Normals;
using closed_samples::Point;
using closed_samples::Vector;

struct Sample
{
  Point point;
  Vector normal;
  double mean = 0, gaussian = 0;
  bool has_curvature = false;
};
using Samples = std::vector<Sample>;

inline double degrees(double radians)
{
  return radians * 180 / std::acos(-1.);
}

inline double angle(const Vector& a, const Vector& b)
{
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
}

// Turns normals by an angle that has the root mean square `noise` in degrees, in directions at random.
inline void disturb(Mesh& mesh, double noise)
{
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  order_samples::Random random;
  const double size = std::tan(noise * std::acos(-1.) / 180) * std::sqrt(1.5);
  for (const auto v : mesh.vertices()) {
    const Vector r{random(), random(), random()}, n = normals[v];
    normals[v] = order_samples::unit(n + size * (r - (r * n) * n));
  }
}

// the limit surface at the vertices of the second round; without normals, that of the linear twin
template <class Scheme>
Samples limits(Mesh mesh, const Scheme& scheme, bool is_linear, double roundness = 1)
{
  namespace PN = CGAL::PN_subdivision_3;
  constexpr unsigned rounds = 2;
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  if (is_linear)
    for (const auto v : mesh.vertices()) normals[v] = CGAL::NULL_VECTOR;
  PN::subdivide(
    mesh, scheme,
    PN::parameters::roundness(roundness).number_of_iterations(rounds).vertex_normal_map(normals));
  const auto found =
    mesh.add_property_map<Mesh::Vertex_index, PN::Limit_point<Kernel>>("v:limit").first;
  PN::limit_points(mesh, scheme, found,
                   PN::parameters::normal_tolerance(1e-5)
                     .surface_normals(true)
                     .curvatures(true)
                     .rounds_done(rounds)
                     .roundness(roundness)
                     .vertex_normal_map(normals));
  Samples samples;
  for (const auto v : mesh.vertices()) {
    const PN::Limit_point<Kernel>& l = found[v];
    samples.push_back({l.point, l.surface_normal, l.mean, l.gaussian, l.has_curvature});
  }
  return samples;
}

// the mean curvature of the closed surface at the foot of p, half the divergence of its normals
inline double mean_curvature(const Point& p)
{
  constexpr double step = 1e-4;
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const Vector e(k == 0 ? step : 0, k == 1 ? step : 0, k == 2 ? step : 0);
    Vector before, after;
    before = order_samples::unit(closed_samples::gradient(p - e - CGAL::ORIGIN));
    after = order_samples::unit(closed_samples::gradient(p + e - CGAL::ORIGIN));
    sum += (after - before)[k] / (2 * step);
  }
  return sum / 2;
}

// how far a surface is off the closed one: root mean squares, and the largest
struct Errors
{
  double distance = 0, largest_distance = 0, angle = 0, largest_angle = 0, curvature = 0;
};

inline Errors errors(const Samples& samples)
{
  Errors all;
  double h = 0, with_curvature = 0;
  for (const Sample& s : samples) {
    Vector n;
    const double d = closed_samples::distance(s.point, &n), a = degrees(angle(s.normal, n));
    all.distance += d * d;
    all.angle += a * a;
    all.largest_distance = (std::max)(all.largest_distance, std::abs(d));
    all.largest_angle = (std::max)(all.largest_angle, a);
    if (!s.has_curvature) continue;
    const double wanted = mean_curvature(s.point);
    all.curvature += (s.mean - wanted) * (s.mean - wanted);
    h += wanted * wanted;
    ++with_curvature;
  }
  all.distance = std::sqrt(all.distance / double(samples.size()));
  all.angle = std::sqrt(all.angle / double(samples.size()));
  if (with_curvature > 0) all.curvature = std::sqrt(all.curvature / h);
  return all;
}

} // namespace measured

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_MEASURED_LIMITS_H
