// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Interpolation of points by limit surfaces: against brute force, on shapes, and how close it comes to
// the surfaces that were sampled.

#include "Interpolation_cases.h"

#include <gtest/gtest.h>

namespace {

using namespace interpolation_cases;
using test_meshes::Cells;

const PN::modified_CatmullClark_scheme quad_scheme;
const PN::modified_Loop_scheme triangle_scheme;

Control_mesh graph()
{
  return sampled_surfaces::patch(8, 8, 0, Cells::quads, 1, sampled_surfaces::on_waves);
}

// The limits of the control net, by the reference rules round by round, are the points.
template <class Description>
void expect_limits(const Control_mesh& data, double tolerance)
{
  Interpolated result = interpolated(data, Description::scheme(), strict());
  EXPECT_TRUE(result.report.is_within_tolerance()) << data.name << " " << result.report.residual;
  EXPECT_LE(result.report.steps, 15u);
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

// One evaluation at depth 0 would be off: solved with it, the true limits are not the points.
TEST(Interpolation, OneAverageIsNotTheLimit)
{
  const Control_mesh data = ellipsoid_quads(3);
  Surface_mesh mesh = to_surface_mesh(data);
  const Limits coarse = limit_cases::limits(mesh, quad_scheme, limit_cases::close(HUGE_VAL));
  const Limits fine = limit_cases::limits(mesh, quad_scheme, limit_cases::close(1e-13));
  double largest = 0;
  for (std::size_t v = 0; v < fine.at.size(); ++v)
    largest =
      (std::max)(largest, std::sqrt(CGAL::squared_distance(coarse.at[v].point, fine.at[v].point)));
  EXPECT_GT(largest, 1e-5);
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
  };
  expect_no_solve(sampled_surfaces::scattered(1, 0.1, 3, sampled_surfaces::on_sphere),
                  triangle_scheme);
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
  options.normals = PN::Limit_interpolation_normals::solved;
  Interpolated result = interpolated(data, triangle_scheme, options);
  EXPECT_EQ(result.report.left_out, 0u);
  const Control_mesh net = control_net(result.mesh, data);
  for (std::size_t v = 0; v < net.points.size(); ++v)
    EXPECT_NEAR(double(point_of(net, v).norm()), 1, 1e-11);
  const Limits all = limit_cases::limits(result.mesh, triangle_scheme, limit_cases::close(1e-13));
  for (std::size_t v = 0; v < net.points.size(); ++v)
    EXPECT_LE(double((limit_cases::to_vector(all.at[v].point) - point_of(data, v)).norm()), 1e-11);
}

// rms error of linear interpolation over that of mode slide, with normals of the surface
template <class Scheme>
void expect_gains(const Control_mesh& data, const Scheme& scheme, const Distance& distance,
                  double over_strict_linear, double over_linear_slide)
{
  const Interpolated slide = interpolated(data, scheme);
  EXPECT_FALSE(slide.report.fallback);
  EXPECT_TRUE(slide.report.is_within_tolerance());
  EXPECT_LE(slide.report.slip_of_edge, 0.25);
  const Interpolated linear = interpolated(data, PN::linear(scheme), strict());
  const Interpolated linear_slide = interpolated(data, PN::linear(scheme));
  const double error = rms_error(slide.mesh, scheme, distance);
  EXPECT_GE(rms_error(linear.mesh, PN::linear(scheme), distance) / error, over_strict_linear);
  EXPECT_GE(rms_error(linear_slide.mesh, PN::linear(scheme), distance) / error, over_linear_slide);
}

TEST(Interpolation, SlideIsCloserThanLinearInterpolation)
{
  expect_gains(ellipsoid_quads(8), quad_scheme, to_ellipsoid, 12, 3);
  expect_gains(ellipsoid_triangles(2), triangle_scheme, to_ellipsoid, 20, 6);
  expect_gains(torus(16), quad_scheme, to_torus, 15, 12);
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

// Without the surface's own normal the points are not on the surface, see the fallback: every vertex
// taken as one of the border.
TEST(Interpolation, SlideNeedsTheSurfaceNormal)
{
  const Control_mesh data = torus(16);
  const Interpolated right = interpolated(data, quad_scheme);
  Surface_mesh mesh = to_surface_mesh(data);
  PN::internal::with_mesh_access(mesh, [&](auto& access) {
    const auto level = PN::internal::checked_level(access);
    auto control = PN::internal::read_points_and_normals<double>(access, quad_scheme, level,
                                                                 mesh.points(), normal_map(mesh));
    PN::internal::set_surroundings(level, control);
    control.is_at_border.assign(control.points.size(), 1);
    control.tolerance = 1e-12;
    for (unsigned v = 0; v < control.points.size(); ++v) control.vertices.push_back(v);
    PN::internal::Mesh_limit_functionals<PN::modified_CatmullClark_scheme> source(
      quad_scheme, level, PN::internal::For_chunks());
    const auto result = PN::internal::Slide_interpolation<3, 2>(control, source)();
    for (auto v : mesh.vertices()) {
      const auto& p = result.points[v];
      mesh.point(v) = Kernel::Point_3(p[0], p[1], p[2]);
    }
  });
  EXPECT_GE(rms_error(mesh, quad_scheme, to_torus),
            50 * rms_error(right.mesh, quad_scheme, to_torus));
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
  const Control_mesh data = ellipsoid_quads(4);
  Surface_mesh mesh = to_surface_mesh(data);
  const auto normals = normal_map(mesh);
  PN::natural_normals(mesh, quad_scheme, normals);
  EXPECT_LE(rms_angle(data, normals), 0.2);
  PN::estimate_control_normals(mesh, normals); // where it began
  EXPECT_GE(rms_angle(data, normals), 1);
}

TEST(Interpolation, NaturalNormalsOfSpheresAreTheEstimate)
{
  const Control_mesh data = sampled_surfaces::scattered(1, 0.1, 3, sampled_surfaces::on_sphere);
  Surface_mesh mesh = to_surface_mesh(data);
  const auto normals = normal_map(mesh);
  PN::natural_normals(mesh, triangle_scheme, normals);
  EXPECT_LE(rms_angle(data, normals), 1e-11);
}

TEST(Interpolation, MovesWithTheData)
{
  const Control_mesh data = graph();
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
  PN::Limit_interpolation_options<Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool>>
    options;
  Surface_mesh mesh = to_surface_mesh(data);
  options.vertices =
    mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:chosen", false).first;
  for (auto v : mesh.vertices()) options.vertices[v] = v.idx() % 3 == 0;
  for (const bool smooth : {false, true}) {
    for (const auto mode :
         {PN::Limit_interpolation_mode::slide, PN::Limit_interpolation_mode::limit_points}) {
      if (smooth && mode == PN::Limit_interpolation_mode::slide) continue;
      options.mode = mode;
      options.free =
        smooth ? PN::Limit_interpolation_free::smooth : PN::Limit_interpolation_free::fixed;
      Surface_mesh net = mesh;
      options.vertices = net.property_map<Surface_mesh::Vertex_index, bool>("v:chosen").first;
      const Report report = PN::interpolate_limit_points(
        net, quad_scheme, options, CGAL::parameters::vertex_normal_map(normal_map(net)));
      EXPECT_TRUE(report.is_within_tolerance()) << report.residual;
      std::size_t moved_others = 0;
      const Limits all = limit_cases::limits(net, quad_scheme, limit_cases::close(1e-13));
      for (auto v : mesh.vertices())
        if (options.vertices[v]) {
          if (mode == PN::Limit_interpolation_mode::limit_points) {
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
  const Control_mesh data = torus(46); // more than one chunk
  Options options = strict();
  options.tolerance = 1e-5;
  Surface_mesh one = to_surface_mesh(data), many = one;
  PN::interpolate_limit_points(one, quad_scheme, options,
                               CGAL::parameters::vertex_normal_map(normal_map(one)));
  PN::interpolate_limit_points<CGAL::Parallel_if_available_tag>(
    many, quad_scheme, options, CGAL::parameters::vertex_normal_map(normal_map(many)));
  for (auto v : one.vertices()) EXPECT_EQ(one.point(v), many.point(v));
}

} // namespace
