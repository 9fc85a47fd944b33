// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Interpolation of points by limit surfaces: against brute force, on shapes, and how close it comes to
// the surfaces that were sampled.

#include "Extent.h"
#include "Interpolation_cases.h"
#include "Messages.h"
#include "Schemes.h"
#include "support/Options.h"

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace interpolation_cases;
using test_meshes::Cells;

const PN::CatmullClark_scheme::Tuned quad_scheme;
const PN::Loop_scheme::Tuned triangle_scheme;

Control_mesh graph_of_waves()
{
  return sampled_surfaces::patch(8, 8, 0, Cells::quads, 1, sampled_surfaces::on_waves);
}

// Limit masks of Catmull-Clark have eigenvalues in [1/9, 1] on the regular grid, so that a step halves what is missing.
constexpr unsigned most_steps = 44; // 2^-44 < 1e-13

// The limits of the control net, by the reference rules round by round, are the points.
template <class Description>
void expect_limits(const Control_mesh& data, double tolerance)
{
  Interpolated result = interpolated(data, Description::scheme(), strict());
  EXPECT_TRUE(result.report.is_within_tolerance()) << data.name << " " << result.report.residual;
  EXPECT_LE(result.report.steps, most_steps);
  const Control_mesh net = control_net(result.mesh, data);
  const std::size_t step = data.points.size() / 5 + 1;
  for (std::size_t v = 0; v < data.points.size(); v += step) {
    const reference::Limit limit = limit_cases::brute_force<Description>(net, int(v), false);
    EXPECT_LE(double((limit.point - point_of(data, v)).norm()), tolerance)
      << data.name << ", vertex " << v;
  }
}

TEST(Interpolation, StrictLimitsAreThePoints)
{
  expect_limits<Modified_CatmullClark_description>(ellipsoid_quads(3), 1e-11);
  expect_limits<Modified_Loop_description>(ellipsoid_triangles(1), 1e-11);
  // a border, polygons, irregular vertices next to each other
  Control_mesh mixed =
    sampled_surfaces::patch(4, 4, 0.2, Cells::mixed, 5, sampled_surfaces::on_waves);
  expect_limits<CatmullClark_description>(mixed, 1e-11);
  expect_limits<Modified_CatmullClark_description>(mixed, 1e-11);
}

TEST(Interpolation, StrictLimitsAreThePointsOnAll)
{
  Control_mesh noise = ellipsoid_quads(4);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> shift(-0.01, 0.01);
  for (auto& p : noise.points)
    for (double& x : p) x += shift(generator);
  const PN::CatmullClark_scheme::Tuned later(0.5, 2); // plain in the first round
  const auto expect_met = [](const Control_mesh& data, const auto& scheme) {
    Interpolated result = interpolated(data, scheme, strict());
    EXPECT_TRUE(result.report.is_within_tolerance()) << data.name << " " << result.report.residual;
    EXPECT_LE(result.report.steps, most_steps) << data.name;
    const Limits all = limits(result.mesh, scheme, limit_cases::close(1e-14));
    for (std::size_t v = 0; v < data.points.size(); ++v)
      EXPECT_LE(double((limit_cases::to_vector(all.at[v].point) - point_of(data, v)).norm()), 1e-11)
        << data.name << ", vertex " << v;
  };
  for (const Control_mesh& data : {ellipsoid_quads(4), torus(8), graph_of_waves(), noise}) {
    expect_met(data, quad_scheme);
    expect_met(data, later);
  }
  expect_met(ellipsoid_triangles(1), triangle_scheme);
  expect_met(ellipsoid_triangles(1), PN::Loop_scheme::Tuned(0.5, 2));
}

TEST(Interpolation, AFirstRoundPastReachIsRefused)
{
  messages::expect_refused(
    [] { interpolated(ellipsoid_quads(2), PN::CatmullClark_scheme::Tuned(0.5, 10)); },
    {"the first round of the rules of the scheme is 10"});
}

TEST(Interpolation, SpheresAndCylindersAreTheirOwnNets)
{
  const auto expect_no_solve = [](const Control_mesh& data, const auto& scheme) {
    Options options;
    options.tolerance = 1e-14;
    Interpolated result = interpolated(data, scheme, options);
    EXPECT_EQ(result.report.steps, 0u) << result.report.residual;
    const Control_mesh net = control_net(result.mesh, data);
    EXPECT_EQ(net.points, data.points);
    EXPECT_EQ(net.normals, data.normals);
    return result;
  };
  Interpolated sphere = expect_no_solve(
    sampled_surfaces::scattered(1, 0.1, 3, sampled_surfaces::on_sphere), triangle_scheme);
  for (const auto& limit : limits(sphere.mesh, triangle_scheme, limit_cases::close(1e-14)).at)
    EXPECT_NEAR(double(limit_cases::to_vector(limit.point).norm()), 1, 16 * 2.3e-16);
  std::mt19937 generator(4);
  const auto u = sampled_surfaces::uneven(9, 0.3L, generator);
  expect_no_solve(sampled_surfaces::cylinder(u, u, 3, Cells::quads), quad_scheme);
  expect_no_solve(sampled_surfaces::patch(4, 4, 0.2, Cells::mixed, 5, sampled_surfaces::cap(0.5L)),
                  quad_scheme);
}

TEST(Interpolation, SolvedNormalsKeepSpheres)
{
  const Control_mesh data = sampled_surfaces::scattered(1, 0.1, 3, sampled_surfaces::on_sphere);
  Options options = strict();
  options.normals = PN::Limit_interpolation::Normals::solved;
  Interpolated result = interpolated(data, triangle_scheme, options);
  EXPECT_EQ(result.report.left_out, 0u);
  EXPECT_LE(result.report.steps, 2 * most_steps); // of the normals, and of the points
  const Control_mesh net = control_net(result.mesh, data);
  for (std::size_t v = 0; v < net.points.size(); ++v)
    EXPECT_NEAR(double(point_of(net, v).norm()), 1, 1e-11);
  const Limits all = limits(result.mesh, triangle_scheme, limit_cases::close(1e-13));
  for (std::size_t v = 0; v < net.points.size(); ++v)
    EXPECT_LE(double((limit_cases::to_vector(all.at[v].point) - point_of(data, v)).norm()), 1e-11);
}

// rms error of linear interpolation over that of mode slide, with normals of the surface
template <class Scheme>
void expect_gains(const Control_mesh& data, const Scheme& scheme, const Distance& distance,
                  double over_strict_linear, double over_linear_slide, double over_unfairness = 0)
{
  const Interpolated slide = interpolated(data, scheme);
  if (over_linear_slide > 0) { // on smooth borders corners are rounded
    EXPECT_LE(slide.report.residual, 1e-4);
  }
  EXPECT_LE(slide.report.slip_of_edge, 0.25);
  const Interpolated linear = interpolated(data, PN::linear(scheme), strict());
  const Interpolated linear_slide = interpolated(data, PN::linear(scheme));
  const double error = rms_error(slide.mesh, scheme, distance);
  EXPECT_GE(rms_error(linear.mesh, PN::linear(scheme), distance) / error, over_strict_linear);
  if (over_linear_slide > 0) {
    EXPECT_GE(rms_error(linear_slide.mesh, PN::linear(scheme), distance) / error,
              over_linear_slide);
  }
  if (over_unfairness > 0) {
    const double fair = unfairness(slide.mesh, scheme);
    EXPECT_GE(unfairness(linear.mesh, PN::linear(scheme)) / fair, over_unfairness);
    EXPECT_NEAR(fair, 9.445, 0.5); // by quadrature of H in closed form on the ellipsoid
  }
}

TEST(Interpolation, SlideIsCloserThanLinearInterpolation)
{
  expect_gains(ellipsoid_quads(8), quad_scheme, to_ellipsoid, 12, 3, 5);
  expect_gains(ellipsoid_triangles(2), triangle_scheme, to_ellipsoid, 20, 6, 5);
  expect_gains(torus(16), quad_scheme, to_torus, 15, 12);
  expect_gains(graph_of_waves(), quad_scheme, to_waves, 12, 0);
}

// Orders of convergence: the error falls by 2^4 where the edges are halved.
TEST(Interpolation, SlideIsOfFourthOrder)
{
  const double coarse =
    rms_error(interpolated(ellipsoid_quads(4), quad_scheme).mesh, quad_scheme, to_ellipsoid);
  const double fine =
    rms_error(interpolated(ellipsoid_quads(8), quad_scheme).mesh, quad_scheme, to_ellipsoid);
  EXPECT_GE(coarse / fine, 13);
}

// Points over the limits of the vertices of some rounds, each sought about the vertex whose limit is next to it, or the next but one: then
// it may be at the far corner of a face there.
template <class Scheme>
void expect_distances(const Control_mesh& data, const Scheme& scheme, unsigned rounds = 2,
                      std::size_t order = 0)
{
  Surface_mesh mesh = to_surface_mesh(data), fine = mesh;
  const Limits all = Limit_runs<Scheme>::refined(fine, scheme, rounds),
               of_vertices = limits(mesh, scheme, limit_cases::close(1e-12));
  for (std::size_t w = 0; w < all.at.size(); w += 23) {
    const double height = (w % 2 == 0 ? 1e-4 : -3e-3) * double(1 + w % 3);
    const Vector p = limit_cases::to_vector(all.at[w].point) +
                     height * limit_cases::to_vector(all.at[w].surface_normal);
    std::vector<std::pair<double, std::size_t>> next;
    for (std::size_t v = 0; v < of_vertices.at.size(); ++v)
      next.emplace_back((limit_cases::to_vector(of_vertices.at[v].point) - p).norm(), v);
    std::sort(next.begin(), next.end());
    const double found = Distance_runs<Scheme>::from_limit(mesh, scheme, p, next[order].second);
    EXPECT_NEAR(found, std::abs(height), 0.02 * std::abs(height)) << data.name << ", vertex " << w;
  }
}

TEST(Interpolation, DistancesFromTheLimit)
{
  expect_distances(sampled_surfaces::patch(3, 3, 0.2, Cells::mixed, 5, sampled_surfaces::on_waves),
                   PN::CatmullClark_scheme());
  expect_distances(ellipsoid_quads(2), quad_scheme);
  expect_distances(ellipsoid_triangles(1), triangle_scheme);
  expect_distances(
    sampled_surfaces::patch(3, 3, 0.2, Cells::triangles, 5, sampled_surfaces::on_waves),
    triangle_scheme);
  expect_distances(ellipsoid_quads(2), quad_scheme, 3, 1);
  expect_distances(ellipsoid_triangles(1), triangle_scheme, 3, 1);
}

// The report has the distance of the points from the surface, which is that of the arcs no more.
template <class Scheme>
void expect_true_residual(const Control_mesh& data, const Scheme& scheme)
{
  Interpolated result = interpolated(data, scheme);
  double farthest = 0;
  for (std::size_t v = 0; v < data.points.size(); ++v)
    farthest = (std::max)(
      farthest, Distance_runs<Scheme>::from_limit(result.mesh, scheme, point_of(data, v), v));
  EXPECT_NEAR(result.report.residual, farthest, 0.03 * farthest);
  EXPECT_GT(result.report.residual, 1e-9);
  EXPECT_FALSE(result.report.is_within_tolerance());
}

TEST(Interpolation, SlideTellsTheDistanceFromTheSurface)
{
  expect_true_residual(ellipsoid_quads(2), quad_scheme);
  expect_true_residual(ellipsoid_triangles(0), triangle_scheme);
}

// A point is on the surface wherever that passes through it: those of a tetrahedron, which is too coarse for its normals, on a sphere.
TEST(Interpolation, TheSurfaceMayBeNearerElsewhere)
{
  Control_mesh both{"tetrahedron", {}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}, {}};
  for (const Vector& p : {Vector(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}})
    sampled_surfaces::add(both, {p, Vector(0.2L, 0.1L, 1)});
  EXPECT_GT(interpolated(both, triangle_scheme).report.residual, 1e-2);
  const Control_mesh sphere = sampled_surfaces::scattered(1, 0.1, 3, sampled_surfaces::on_sphere);
  for (auto face : sphere.faces) {
    for (int& v : face) v += 4;
    both.faces.push_back(face);
  }
  both.points.insert(both.points.end(), sphere.points.begin(), sphere.points.end());
  both.normals.insert(both.normals.end(), sphere.normals.begin(), sphere.normals.end());
  EXPECT_LE(interpolated(both, triangle_scheme).report.residual, 1e-12);
}

// A part is interpolated as if it were alone, whatever is next to it.
TEST(Interpolation, ComponentsSlideOnTheirOwn)
{
  const Control_mesh alone = ellipsoid_quads(2);
  Control_mesh both = alone;
  const int n = int(alone.points.size());
  for (const auto& p : {Vector(0, 0, 0), {.5L, 0, 0}, {.4L, .4L, 0}, {0, .4L, .3L}, {.1L, 0, .4L}})
    sampled_surfaces::add(both, {p, Vector(1, 1 - 3 * p[0], 1 - 5 * p[1])});
  both.faces.push_back({n, n + 1, n + 2, n + 3});
  both.faces.push_back({n + 1, n, n + 4});
  const Interpolated a = interpolated(alone, quad_scheme), b = interpolated(both, quad_scheme);
  EXPECT_GT(b.report.residual, a.report.residual);
  for (auto v : a.mesh.vertices()) EXPECT_EQ(a.mesh.point(v), b.mesh.point(v)) << v;
}

double rms_angle(const Control_mesh& data, Normal_map normals)
{
  double sum = 0;
  for (std::size_t v = 0; v < data.points.size(); ++v) {
    const auto& n = data.normals[v];
    const Kernel::Vector_3 exact(n[0], n[1], n[2]);
    const auto& found = normals[Surface_mesh::Vertex_index(unsigned(v))];
    const double angle =
      std::atan2(std::sqrt(CGAL::cross_product(exact, found).squared_length()), exact * found);
    sum += angle * angle;
  }
  return std::sqrt(sum / double(data.points.size())) * 57.29577951308232;
}

TEST(Interpolation, NaturalNormalsAreThoseOfTheSurface)
{
  for (const auto& [n, bar, before] : {std::tuple(4, 0.2, 1.), {8, 0.04, 0.3}}) {
    if (n > 4 && !tests_are_full) continue;
    const Control_mesh data = ellipsoid_quads(n);
    Surface_mesh mesh = to_surface_mesh(data);
    const auto normals = normal_map(mesh);
    Further_interpolation_runs<PN::CatmullClark_scheme::Tuned>::natural_normals(mesh, quad_scheme);
    EXPECT_LE(rms_angle(data, normals), bar);
    mesh = to_surface_mesh(data);
    const auto estimated = normal_map(mesh);
    PN::estimate_control_normals(mesh, estimated); // where it began
    EXPECT_GE(rms_angle(data, estimated), before);
  }
}

TEST(Interpolation, NaturalNormalsStayOnBorders)
{
  const Control_mesh data = graph_of_waves();
  Surface_mesh mesh = to_surface_mesh(data), estimate = mesh;
  Further_interpolation_runs<PN::CatmullClark_scheme::Tuned>::natural_normals(mesh, quad_scheme);
  PN::estimate_control_normals(estimate, normal_map(estimate));
  std::size_t changed = 0;
  for (auto v : mesh.vertices()) {
    const bool is_same = (normal_map(mesh)[v] - normal_map(estimate)[v]).squared_length() < 1e-28;
    if (mesh.is_border(v)) {
      EXPECT_TRUE(is_same) << v;
    } else
      changed += is_same ? 0 : 1;
  }
  EXPECT_GT(changed, 40u);
}

TEST(Interpolation, NaturalNormalsOfSpheresAreTheEstimate)
{
  const Control_mesh data = sampled_surfaces::scattered(1, 0.1, 3, sampled_surfaces::on_sphere);
  Surface_mesh mesh = to_surface_mesh(data);
  const auto normals = normal_map(mesh);
  Further_interpolation_runs<PN::Loop_scheme::Tuned>::natural_normals(mesh, triangle_scheme);
  EXPECT_LE(rms_angle(data, normals), 1e-11);
}

TEST(Interpolation, MovesWithTheData)
{
  const Control_mesh data = graph_of_waves();
  const Interpolated before = interpolated(data, quad_scheme);
  for (const Real scale : {1e-3L, 1e4L}) {
    Control_mesh other = data;
    for (std::size_t v = 0; v < data.points.size(); ++v) {
      const auto& n = data.normals[v];
      const Vector p = moved(point_of(data, v), scale);
      const Vector m = (moved({n[0], n[1], n[2]}, 1) - moved(Vector(Vector::Zero()), 1));
      other.points[v] = {double(p[0]), double(p[1]), double(p[2])};
      other.normals[v] = {double(m[0]), double(m[1]), double(m[2])};
    }
    const Interpolated after = interpolated(other, quad_scheme);
    for (auto v : before.mesh.vertices())
      EXPECT_LE(double((moved(limit_cases::to_vector(before.mesh.point(v)), scale) -
                        limit_cases::to_vector(after.mesh.point(v)))
                         .norm()),
                2e-10 * double(scale));
  }
}

TEST(Interpolation, SomeVertices)
{
  const Control_mesh data = ellipsoid_quads(4);
  test_options::Limit_interpolation_options<Chosen> options;
  Surface_mesh mesh = to_surface_mesh(data);
  options.vertices =
    mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:chosen", false).first;
  for (auto v : mesh.vertices()) options.vertices[v] = v.idx() % 3 == 0;
  for (const bool smooth : {false, true}) {
    for (const auto mode :
         {PN::Limit_interpolation::Mode::slide, PN::Limit_interpolation::Mode::strict}) {
      if (smooth && mode == PN::Limit_interpolation::Mode::slide) continue;
      options.mode = mode;
      options.free =
        smooth ? PN::Limit_interpolation::Free::smooth : PN::Limit_interpolation::Free::fixed;
      Surface_mesh net = mesh;
      options.vertices =
        PN::internal::find_property_map<Surface_mesh::Vertex_index, bool>(net, "v:chosen").value();
      const Report report =
        Further_interpolation_runs<PN::CatmullClark_scheme::Tuned>::some(net, quad_scheme, options);
      EXPECT_LE(report.residual,
                mode == PN::Limit_interpolation::Mode::slide ? 1e-2 : report.tolerance);
      std::size_t moved_others = 0;
      const Limits all = limits(net, quad_scheme, limit_cases::close(1e-13));
      for (auto v : mesh.vertices())
        if (options.vertices[v]) {
          if (mode == PN::Limit_interpolation::Mode::strict) {
            EXPECT_LE(CGAL::squared_distance(all.at[v].point, mesh.point(v)), 1e-22);
          }
        } else if (net.point(v) != mesh.point(v))
          ++moved_others;
      EXPECT_EQ(moved_others != 0, smooth);
    }
  }
}

TEST(Interpolation, InterpolatorySchemesReturnTheNet)
{
  const Control_mesh data = ellipsoid_triangles(1);
  for (const Options& options : {Options(), strict()}) {
    Interpolated result = interpolated(data, PN::Butterfly_scheme(), options);
    EXPECT_EQ(result.report.steps, 0u);
    EXPECT_EQ(result.report.residual, 0);
    EXPECT_EQ(control_net(result.mesh, data).points, data.points);
  }
}

TEST(Interpolation, IsTheSameWithThreads)
{
  long_test([](auto) {
    const Control_mesh data = torus(46); // more than one chunk
    Options options = strict();
    options.tolerance = 1e-5;
    Surface_mesh one = to_surface_mesh(data), many = one;
    Interpolation_runs<PN::CatmullClark_scheme::Tuned>::interpolate(one, quad_scheme, options);
    Further_interpolation_runs<PN::CatmullClark_scheme::Tuned>::in_parallel(many, quad_scheme,
                                                                            options);
    for (auto v : one.vertices()) EXPECT_EQ(one.point(v), many.point(v));
  });
}

} // namespace
