// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Whether the measurement of curvature at extraordinary vertices measures right: on surfaces whose
// curvature is known, and by published eigenvalues.

#include "Extraordinary_checks.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <functional>
#include <set>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace data = extraordinary_data;
using data::Extraordinary_net;
using data::Index;
using PN::CatmullClark_scheme;
using PN::Extraordinary_vertex_zoom;
using PN::Loop_scheme;

template <class Function>
void for_plain_schemes(const std::vector<Index>& valences, const Function& f)
{
  for (const Index n : valences) {
    {
      SCOPED_TRACE("Catmull-Clark, valence " + std::to_string(n));
      f(CatmullClark_scheme(), n);
    }
    SCOPED_TRACE("Loop, valence " + std::to_string(n));
    f(Loop_scheme(), n);
  }
}

// --- the net ---

void check_net(const Extraordinary_net& net)
{
  std::set<std::array<Index, 3>> places;
  for (Index v = 0; v < net.number_of_vertices(); ++v) {
    const auto& [s, i, j] = net.place(v);
    EXPECT_EQ(net.vertex(s, i, j), v);
    EXPECT_LE(net.norm(v), net.rings());
    places.insert({s, i, j});
  }
  EXPECT_EQ(places.size(), net.number_of_vertices());
  const PN::Level_connectivity level = net.level();
  const Index regular = net.degree() == 4 ? 4 : 6;
  for (Index v = 0; v < net.number_of_vertices(); ++v) {
    EXPECT_EQ(level.target(level.halfedge_of_vertex(v)), v);
    EXPECT_EQ(level.is_border_vertex(v), net.norm(v) == net.rings());
    if (net.norm(v) == net.rings()) continue;
    EXPECT_EQ(level.valence(v), v == 0 ? net.valence() : regular);
  }
  for (Index f = 0; f < level.number_of_faces(); ++f)
    EXPECT_EQ(level.degree(level.halfedge_of_face(f)), net.degree());
}

TEST(Extraordinary_net, HasOneVertexOfItsValence)
{
  for (const Index degree : {3u, 4u})
    for (const Index valence : {3u, 5u, 6u})
      for (const Index rings : {1u, 2u, 5u}) check_net(Extraordinary_net(degree, valence, rings));
}

// --- known curvatures ---

struct Extent
{
  double min = std::numeric_limits<double>::infinity(), max = -min;
  void add(double x)
  {
    min = (std::min)(min, x);
    max = (std::max)(max, x);
  }
};

// From control points on the graph of a cubic polynomial q over a regular net of spacing h the linear
// schemes make the graph of q + h^2/6 Laplace(q) (quads) or q + h^2/8 Laplace(q) (triangles).
struct Cubic
{
  data::Graph graph;
  std::array<double, 2> laplacian;                             // its derivatives
  std::function<std::array<double, 3>(double, double)> second; // xx, xy, yy

  void add_curvature(double x, double y, double c, Extent& gaussian, Extent& mean) const
  {
    const data::Height h = graph(x, y);
    const double a = h.x + c * laplacian[0], b = h.y + c * laplacian[1], s = 1 + a * a + b * b;
    const auto [xx, xy, yy] = second(x, y);
    gaussian.add((xx * yy - xy * xy) / (s * s));
    // positive where the graph bends away from the normal, which points up
    mean.add(-((1 + b * b) * xx - 2 * a * b * xy + (1 + a * a) * yy) / (2 * s * std::sqrt(s)));
  }
};

template <class Scheme>
void check_cubic(const Scheme& scheme, Index valence, const Cubic& cubic)
{
  const Extraordinary_vertex_zoom<decltype(PN::linear(scheme))> zoom(PN::linear(scheme), valence);
  const auto ring = zoom.ring_curvature(data::turned(data::sampled(zoom.net(), cubic.graph)));
  const Extraordinary_net fine(zoom.degree, valence, 16);
  const double c = data::spacing * data::spacing / (zoom.degree == 4 ? 6 : 8);
  Extent gaussian, mean;
  for (Index v = 0; v < fine.number_of_vertices(); ++v) {
    const auto p = data::layout(fine, v);
    if (fine.norm(v) >= 8) cubic.add_curvature(p[0] / 4, p[1] / 4, c, gaussian, mean);
  }
  EXPECT_NEAR(ring.gaussian_min, gaussian.min, 1e-11);
  EXPECT_NEAR(ring.gaussian_max, gaussian.max, 1e-11);
  EXPECT_NEAR(ring.mean_min, mean.min, 1e-11);
  EXPECT_NEAR(ring.mean_max, mean.max, 1e-11);
}

TEST(Extraordinary_zoom, FindsTheCurvatureOfCubicGraphs)
{
  using Second = std::array<double, 3>;
  const Cubic saddle{data::saddle, {0, 0}, [](double, double) { return Second{0, 2, 0}; }};
  const Cubic cubic{data::cubic, {1.5, .3}, [](double x, double y) {
                      return Second{1 + 1.5 * x - .3 * y, -.3 - .3 * x, .4 + .6 * y};
                    }};
  for (const Cubic& c : {saddle, cubic}) {
    check_cubic(CatmullClark_scheme(), 4, c);
    check_cubic(Loop_scheme(), 6, c);
  }
}

// PN schemes keep spheres and cylinders at any valence and depth. The jets do not hold them exactly:
// what is left falls with the square of the size of the net.
template <class Scheme>
void check_sphere_and_cylinder(const Scheme& scheme, Index valence)
{
  const Extraordinary_vertex_zoom<Scheme> zoom(scheme, valence);
  const double r = data::sphere_radius;
  const data::Graph cylinder = [r](double x, double) -> data::Height {
    const double z = std::sqrt(r * r - x * x);
    return {z, -x / z, 0};
  };
  const auto on_sphere = zoom.measure(data::turned(data::sampled(zoom.net(), data::sphere)));
  const auto on_cylinder = zoom.measure(data::turned(data::sampled(zoom.net(), cylinder)));
  const double lambda = PN::extraordinary_eigenvalues(scheme, valence).subdominant;
  const double fall = (std::max)(lambda * lambda, 1. / 8);
  for (std::size_t m = 0; m < on_sphere.rings.size(); ++m) {
    const auto& s = on_sphere.rings[m];
    const auto& c = on_cylinder.rings[m];
    const double tolerance = 2e-3 * std::pow(fall, static_cast<double>(m)) + s.noise;
    for (const double h : {s.mean_min, s.mean_max}) EXPECT_NEAR(h, 1 / r, tolerance) << m;
    for (const double k : {s.gaussian_min, s.gaussian_max})
      EXPECT_NEAR(k, 1 / (r * r), 2 * tolerance) << m;
    for (const double h : {c.mean_min, c.mean_max}) EXPECT_NEAR(h, .5 / r, tolerance) << m;
    for (const double k : {c.gaussian_min, c.gaussian_max}) EXPECT_NEAR(k, 0, tolerance) << m;
  }
  const double noise = on_sphere.rings.back().noise;
  EXPECT_NEAR(on_sphere.limit.gaussian, 1 / (r * r), noise);
  EXPECT_NEAR(on_sphere.limit.mean, 1 / r, noise);
  EXPECT_NEAR(on_cylinder.limit.gaussian, 0, noise);
  EXPECT_NEAR(on_cylinder.limit.mean, .5 / r, noise);
}

TEST(Extraordinary_zoom, FindsTheCurvatureOfSpheresAndCylinders)
{
  for_plain_schemes({3, 4, 5, 6, 8, 12},
                    [](const auto& s, Index n) { check_sphere_and_cylinder(s, n); });
}

// Points of a plane that is not perpendicular to the control normal: the curvatures are those of the graph of
// x + y/2 + (x, y) sym (x, y) / 2 at the origin.
TEST(Extraordinary_zoom, PredictsAcrossSlopes)
{
  const auto twisted = [](double x, double y) -> std::array<double, 2> {
    return {.8 * x + .7 * y, -.1 * x + .2 * y}; // sym = (.8, .3; .3, .2)
  };
  const data::Graph slope = [](double x, double y) -> data::Height { return {x + y / 2, 1, .5}; };
  for_plain_schemes({3, 5, 8}, [&](const auto& scheme, Index n) {
    const Extraordinary_vertex_zoom<std::decay_t<decltype(scheme)>> zoom(scheme, n);
    const auto limit = zoom.limit(data::turned(data::with_slopes(zoom.net(), slope, twisted)));
    const double s = 1 + 1 + .25;
    EXPECT_NEAR(limit.gaussian, (.8 * .2 - .3 * .3) / (s * s), 3e-3);
    EXPECT_NEAR(limit.mean, -(1.25 * .8 - 2 * .5 * .3 + 2 * .2) / (2 * s * std::sqrt(s)), 1e-2);
  });
}

TEST(Extraordinary_zoom, HasLeftEigenvectors)
{
  for_plain_schemes({3, 4, 5, 6, 7, 12}, [](const auto& s, Index n) {
    extraordinary_checks::check_left_eigenvectors(s, n);
  });
}

// --- rates ---

TEST(Extraordinary_zoom, FitsTheRate)
{
  PN::Extraordinary_curvature<double> curvature{};
  for (int m = 0; m <= 20; ++m)
    curvature.rings.push_back({0, 0, 1, 1 + (m < 15 ? 1 : 3 * std::pow(.6, m)), 1e-12});
  EXPECT_NEAR(curvature.rate(), .6, 1e-9);
  for (auto& ring : curvature.rings)
    ring.noise = .08 * 3 * std::pow(.6, 17); // three rings are left
  EXPECT_NEAR(curvature.rate(), .6, 1e-9);
  for (auto& ring : curvature.rings) ring.noise = 1;
  EXPECT_EQ(curvature.rate(), 0);
}

// Published eigenvalues: Catmull-Clark at valence n has those of formulas with cos(2 pi / n).
TEST(Extraordinary_eigenvalues, AreThoseOfThePlainSchemes)
{
  for (Index n = 3; n <= 20; ++n) {
    const auto cosine = [n](int k) { return std::cos(2 * data::pi() * k / n); };
    const auto dominant = [&](int k) {
      const double c = cosine(k);
      return (5 + c + std::sqrt((c + 1) * (c + 9))) / 16;
    };
    const double m = n;
    const double axial = (3 * m - 7 + std::sqrt(5 * m * m - 30 * m + 49)) / (8 * m);
    const double second =
      n == 3 ? (5 + cosine(1) - std::sqrt((cosine(1) + 1) * (cosine(1) + 9))) / 16 : dominant(2);
    const auto quads = PN::extraordinary_eigenvalues(CatmullClark_scheme(), n);
    EXPECT_NEAR(quads.subdominant, dominant(1), 1e-14) << n;
    EXPECT_NEAR(quads.largest_other, (std::max)(axial, second), 1e-14) << n;
    const auto triangles = PN::extraordinary_eigenvalues(Loop_scheme(), n);
    const double lambda = .375 + .25 * cosine(1);
    EXPECT_NEAR(triangles.subdominant, lambda, 1e-14) << n;
    const double frequency_2 = n == 3 ? 0 : .375 + .25 * cosine(2);
    EXPECT_NEAR(triangles.largest_other, (std::max)(lambda * lambda, frequency_2), 1e-14) << n;
  }
}

} // namespace
