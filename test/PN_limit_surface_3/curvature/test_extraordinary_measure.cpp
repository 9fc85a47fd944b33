// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Whether the measurement of curvature at extraordinary vertices measures right: on surfaces whose
// curvature is known, at regular vertices, and with the plain schemes, whose curvature diverges.

#include "Extraordinary_checks.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace data = extraordinary_data;
using data::Extraordinary_net;
using data::Index;
using PN::CatmullClark_scheme;
using PN::Extraordinary_vertex_zoom;
using PN::Loop_scheme;
using Zoom_quads = Extraordinary_vertex_zoom<CatmullClark_scheme>;
using Zoom_triangles = Extraordinary_vertex_zoom<Loop_scheme>;

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

TEST(Extraordinary_net, RefusesWhatIsNoNet)
{
  EXPECT_THROW(Extraordinary_net(5, 5, 5), std::invalid_argument);
  EXPECT_THROW(Extraordinary_net(4, 2, 5), std::invalid_argument);
  EXPECT_THROW(Extraordinary_net(3, 5, 0), std::invalid_argument);
  const Zoom_quads zoom(CatmullClark_scheme(), 5);
  EXPECT_THROW(zoom.measure(data::Values(3)), std::invalid_argument);
}

// A regular net in the plane has its shape again after a round, and every vertex its place.
template <class Scheme>
void check_places_are_kept(const Scheme& scheme, Index valence)
{
  const Extraordinary_vertex_zoom<Scheme> zoom(scheme, valence);
  data::Values values(zoom.net().number_of_vertices());
  for (Index v = 0; v < values.size(); ++v) {
    const auto p = data::layout(zoom.net(), v);
    values[v].point = {p[0] + 1, p[1] - 2, 0};
  }
  data::Vector origin{};
  const data::Values half = zoom.refined(values, origin);
  const data::Values quarter = zoom.twice_refined(values);
  EXPECT_NEAR(origin[0], 1, 1e-15);
  EXPECT_NEAR(origin[1], -2, 1e-15);
  const Extraordinary_net larger(zoom.degree, valence, 17);
  for (std::size_t c = 0; c < 2; ++c) {
    for (Index v = 0; v < half.size(); ++v)
      EXPECT_NEAR(half[v].point[c], data::layout(zoom.net(), v)[c] / 2, 1e-14) << v;
    for (Index v = 0; v < quarter.size(); ++v)
      EXPECT_NEAR(quarter[v].point[c], origin[c] + data::layout(larger, v)[c] / 4, 1e-14) << v;
  }
}

TEST(Extraordinary_zoom, KeepsThePlacesOfVertices)
{
  check_places_are_kept(CatmullClark_scheme(), 4);
  check_places_are_kept(Loop_scheme(), 6);
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

TEST(Extraordinary_zoom, StaysOnTheSphere)
{
  for_plain_schemes({3, 5, 12}, [](const auto& s, Index n) {
    extraordinary_checks::check_sphere(s, n);
    extraordinary_checks::check_slope_on_sphere(s, n);
  });
}

// The limit from a single net: on a graph its error falls with the square of the spacing. Here it is
// the one of a regular vertex, whose quadratic parts the prediction does not hold: the slopes alone.
TEST(Extraordinary_zoom, PredictsFromTheSlopes)
{
  const auto twisted = [](double x, double y) -> std::array<double, 2> {
    return {.8 * x + .7 * y, -.1 * x + .2 * y}; // sym = (.8, .3; .3, .2)
  };
  for_plain_schemes({3, 5, 8}, [&](const auto& scheme, Index n) {
    const Extraordinary_vertex_zoom<std::decay_t<decltype(scheme)>> zoom(scheme, n);
    const auto limit = zoom.limit(data::turned(data::with_slopes(zoom.net(), nullptr, twisted)));
    EXPECT_NEAR(limit.gaussian, .8 * .2 - .3 * .3, 1e-2);
    EXPECT_NEAR(limit.mean, -.5, 1e-2);
  });
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

TEST(Extraordinary_zoom, ShowsWhatIsNotANumber)
{
  for_plain_schemes({5}, [](const auto& scheme, Index n) {
    const Extraordinary_vertex_zoom<std::decay_t<decltype(scheme)>> zoom(scheme, n);
    data::Values values = data::sampled(zoom.net(), data::cubic);
    values.back().point[2] = std::numeric_limits<double>::quiet_NaN();
    const auto ring = zoom.ring_curvature(values);
    EXPECT_FALSE(std::isfinite(ring.oscillation()));
    EXPECT_FALSE(std::isfinite(ring.mean_max));
    PN::Extraordinary_curvature<double> curvature{};
    curvature.rings = {ring, ring};
    EXPECT_FALSE(std::isfinite(curvature.rate()));
  });
}

// Without a tangent plane there is no curvature, not even zero. The normals are those of a saddle.
TEST(Extraordinary_zoom, PredictsNoCurvatureWhereTheNetHasCollapsed)
{
  const data::Vector corner{.3, -.7, 1.1}, direction = data::unit({2, 1, -3});
  for_plain_schemes({3, 5, 8, 12}, [&](const auto& scheme, Index n) {
    const Extraordinary_vertex_zoom<std::decay_t<decltype(scheme)>> zoom(scheme, n);
    data::Values values = data::sampled(zoom.net(), data::saddle);
    EXPECT_LT(zoom.limit(values).gaussian, -1); // as long as it has not
    for (const double length : {1., 0.}) {      // of the line that is left
      SCOPED_TRACE(length);
      for (Index v = 0; v < values.size(); ++v)
        for (std::size_t c = 0; c < 3; ++c)
          values[v].point[c] = corner[c] + length * data::layout(zoom.net(), v)[0] * direction[c];
      const auto limit = zoom.limit(values);
      EXPECT_TRUE(std::isnan(limit.gaussian)) << limit.gaussian;
      EXPECT_TRUE(std::isnan(limit.mean)) << limit.mean;
      for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_TRUE(std::isnan(limit.slope[c]));
        for (const double h : limit.derivative_of_slopes[c]) EXPECT_TRUE(std::isnan(h));
      }
      if (length == 0) {
        EXPECT_EQ(limit.point, corner);
      }
    }
  });
}

template <class Zoom>
void expect_no_curvature_at(const Zoom& zoom, data::Values values, const data::Vector& place)
{
  for (data::Value& v : values) v.point = place;
  const auto curvature = zoom.measure(values);
  for (std::size_t m = 0; m < curvature.rings.size(); ++m) {
    const auto& ring = curvature.rings[m];
    for (const double c : {ring.gaussian_min, ring.gaussian_max, ring.mean_min, ring.mean_max})
      EXPECT_TRUE(std::isnan(c)) << "ring " << m << ": " << c;
  }
  EXPECT_TRUE(std::isnan(curvature.limit.gaussian)) << curvature.limit.gaussian;
  EXPECT_TRUE(std::isnan(curvature.rate())) << curvature.rate();
  EXPECT_TRUE(std::isnan(curvature.prediction_error())) << curvature.prediction_error();
}

// On a line, normals may still spread the points of later rounds; at one point, nothing does.
TEST(Extraordinary_zoom, FindsNoCurvatureWhereTheNetHasCollapsedToAPoint)
{
  for_plain_schemes({3, 5, 12}, [&](const auto& scheme, Index n) {
    const Extraordinary_vertex_zoom<std::decay_t<decltype(scheme)>> zoom(scheme, n);
    for (const data::Vector& place : {data::Vector{0, 0, 0}, data::Vector{.3, -.7, 1.1}}) {
      expect_no_curvature_at(zoom, data::sampled(zoom.net(), data::saddle), place);
      expect_no_curvature_at(zoom, data::Values(zoom.net().number_of_vertices()), place);
    }
  });
}

// Measures as a zoom does, but for one data set, whose curvatures are not numbers.
struct Zoom_with_a_hole
{
  Zoom_quads zoom{CatmullClark_scheme(), 5};
  std::size_t hole;
  mutable std::size_t count = 0;

  const Extraordinary_net& net() const { return zoom.net(); }
  data::Curvature measure(data::Values values) const
  {
    if (count++ == hole) values.front().point[2] = std::numeric_limits<double>::quiet_NaN();
    return zoom.measure(std::move(values));
  }
};

TEST(Extraordinary_figures, ShowWhatIsNotANumber)
{
  const std::vector<data::Data_set> sets = data::curved();
  for (std::size_t hole = 0; hole < sets.size(); ++hole) {
    SCOPED_TRACE(sets[hole].name);
    const Zoom_with_a_hole zoom{Zoom_quads{CatmullClark_scheme(), 5}, hole};
    const data::Figures f = data::figures(zoom);
    EXPECT_TRUE(std::isnan(f.oscillation_12));
    EXPECT_TRUE(std::isnan(f.oscillation_16));
    EXPECT_TRUE(std::isnan(f.oscillation_20));
    EXPECT_TRUE(std::isnan(f.rate));
    EXPECT_TRUE(std::isnan(f.prediction_error));
    EXPECT_EQ(std::isnan(f.least_gaussian), sets[hole].has_sampled_normals);
    zoom.count = 0;
    EXPECT_TRUE(std::isnan(data::remaining_mean_curvature(zoom, sets)));
  }
}

TEST(Extraordinary_zoom, FindsOneHalfAtRegularVertices)
{
  const auto check = [](const auto& scheme, Index n) {
    const Extraordinary_vertex_zoom<std::decay_t<decltype(scheme)>> zoom(scheme, n);
    for (const data::Graph& graph : {data::Graph(data::cubic), data::Graph(data::waves)}) {
      const auto c = zoom.measure(data::turned(data::sampled(zoom.net(), graph)));
      EXPECT_NEAR(c.rate(), .5, .01);
      EXPECT_LT(c.rings[20].oscillation(), 1e-5);
    }
  };
  check(CatmullClark_scheme(), 4);
  check(Loop_scheme(), 6);
  check(PN::linear(CatmullClark_scheme()), 4);
  check(PN::linear(Loop_scheme()), 6);
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

TEST(Extraordinary_eigenvalues, NeedStencilsInThe1Ring)
{
  EXPECT_THROW(PN::extraordinary_eigenvalues(PN::Kobbelt_scheme(), 5), std::invalid_argument);
}

// Negative control: the plain schemes' curvature oscillates more from ring to ring.
TEST(Extraordinary_zoom, SeesThatPlainCurvatureDiverges)
{
  const auto check = [](const auto& scheme, Index n) {
    const Extraordinary_vertex_zoom<std::decay_t<decltype(scheme)>> zoom(scheme, n);
    SCOPED_TRACE((zoom.degree == 4 ? "Catmull-Clark, valence " : "Loop, valence ") +
                 std::to_string(n));
    const auto expected = PN::extraordinary_eigenvalues(scheme, n);
    for (const auto& set : data::curved()) {
      if (set.name != "saddle" && set.name != "cubic" && set.name != "rough") continue;
      const double rate = zoom.measure(set.values(zoom.net())).rate();
      EXPECT_GT(rate, 1.05) << set.name;
      EXPECT_NEAR(rate, expected.rate(), .08) << set.name;
    }
  };
  for (const Index n : {5, 6, 7, 8, 10, 12}) check(CatmullClark_scheme(), n);
  for (const Index n : {7, 8, 9, 12}) check(Loop_scheme(), n); // lower ones converge, but for 3
}

TEST(Extraordinary_zoom, SeesThatCurvatureOfPlainLoopDoublesAtValence3)
{
  const Zoom_triangles zoom(Loop_scheme(), 3);
  for (const auto& set : data::curved())
    EXPECT_NEAR(zoom.measure(set.values(zoom.net())).rate(), 2, .01) << set.name;
}

TEST(Extraordinary_zoom, LeavesNormalsOutOfLinearSchemes)
{
  const auto scheme = PN::linear(CatmullClark_scheme());
  const Extraordinary_vertex_zoom<decltype(PN::linear(CatmullClark_scheme()))> zoom(scheme, 5);
  data::Values values = data::turned(data::sampled(zoom.net(), data::cubic));
  const auto with = zoom.measure(values);
  for (auto& v : values) v.normal = {0, 0, 0};
  const auto without = zoom.measure(values);
  const auto pn = Zoom_quads(CatmullClark_scheme(), 5).measure(values); // all normals zero
  for (std::size_t m = 0; m < with.rings.size(); ++m) {
    EXPECT_EQ(with.rings[m].gaussian_min, without.rings[m].gaussian_min);
    EXPECT_EQ(with.rings[m].mean_max, without.rings[m].mean_max);
    EXPECT_EQ(with.rings[m].mean_max, pn.rings[m].mean_max);
  }
  EXPECT_EQ(with.limit.gaussian, 0);
}

} // namespace
