// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Interpolation of difficult and wrong input.

#include "Extent.h"
#include "Interpolation_cases.h"
#include "Mesh_files.h"
#include "Surface_checks.h"

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/centroid.h>

namespace {

using namespace interpolation_cases;

const PN::CatmullClark_scheme scheme;
const PN::Loop_scheme::Tuned scheme_of_triangles;
using Runs = Interpolation_runs<PN::CatmullClark_scheme>;

void expect_finite(const Surface_mesh& mesh)
{
  for (auto v : mesh.vertices())
    for (int k = 0; k < 3; ++k) ASSERT_TRUE(std::isfinite(mesh.point(v)[k]));
}

double distance_from_data(Surface_mesh& net, const Control_mesh& data)
{
  const Limits all = limits(net, scheme, limit_cases::close(1e-12));
  double largest = 0;
  for (std::size_t v = 0; v < data.points.size(); ++v)
    largest = (std::max)(
      largest, double((limit_cases::to_vector(all.at[v].point) - point_of(data, v)).norm()));
  return largest;
}

TEST(Interpolation_input, IsFiniteAndNoWorseThanTheData)
{
  for (Control_mesh data : meshes_for<CatmullClark_description>()) {
    if (data.points.size() > (tests_are_full ? 30 : 12))
      continue; // all kinds of connectivity are among the small ones
    for (const int kind : {0, 1, 2, 3}) {
      if (kind == 0) test_meshes::set_wild_normals(data, 5);
      if (kind == 1) data.normals.assign(data.points.size(), {0, 0, 0});
      if (kind == 2) data.normals.assign(data.points.size(), {0, 0, 1});
      if (kind == 3) data.points.assign(data.points.size(), {1, 2, 3});
      for (const Options& options : {Options(), strict()}) {
        Interpolated result = interpolated(data, scheme, options);
        expect_finite(result.mesh);
        EXPECT_TRUE(std::isfinite(result.report.residual)) << data.name << kind;
        EXPECT_TRUE(std::isfinite(result.report.slip_of_edge)) << data.name << kind;
        if (options.mode == PN::Limit_interpolation::Mode::slide) continue;
        Surface_mesh before = to_surface_mesh(data);
        EXPECT_LE(distance_from_data(result.mesh, data),
                  distance_from_data(before, data) * (1 + 1e-9) + 1e-12)
          << data.name << kind;
      }
    }
  }
}

// Control normals that are solved for turn by 45 degrees at most: where that is not enough the given
// ones stay, and are counted.
TEST(Interpolation_input, SolvedNormalsStayNearTheGivenOnes)
{
  Options options = strict();
  options.normals = PN::Limit_interpolation::Normals::solved;
  std::size_t left_out = 0;
  for (const unsigned seed : {5u, 6u, 7u}) {
    Control_mesh data = ellipsoid_quads(2);
    test_meshes::set_wild_normals(data, seed);
    Interpolated result = interpolated(data, scheme, options);
    left_out += result.report.left_out;
    const Control_mesh net = control_net(result.mesh, data);
    for (std::size_t v = 0; v < data.points.size(); ++v) {
      const auto &m = data.normals[v], &n = net.normals[v];
      const double length = std::hypot(m[0], m[1], m[2]);
      EXPECT_GE(m[0] * n[0] + m[1] * n[1] + m[2] * n[2], 0.707 * length) << v;
    }
  }
  EXPECT_GT(left_out, 0u);
}

// The matrix of the linear limit points of a cube's connectivity is singular: the vector that alternates.
TEST(Interpolation_input, TheCubeHasASolutionWithNormals)
{
  Surface_mesh cube = mesh_files::read(std::string(PN_DATA_DIR) + "/cube.off");
  const auto normals = normal_map(cube);
  PN::estimate_control_normals(cube, normals);
  for (const Options& options : {Options(), strict()}) {
    Surface_mesh net = cube;
    const Report report = Runs::interpolate(net, scheme, options);
    EXPECT_TRUE(report.is_within_tolerance()) << report.residual;
    expect_finite(net);
  }
  // one that is not on a sphere
  Surface_mesh brick = cube;
  for (auto v : brick.vertices()) {
    const auto& p = brick.point(v);
    brick.point(v) = Kernel::Point_3(p.x(), 1.2 * p.y(), 1.5 * p.z());
  }
  PN::estimate_control_normals(brick, normal_map(brick));
  const Report report = Runs::interpolate(brick, scheme, strict());
  EXPECT_GT(report.steps, 0u);
  EXPECT_TRUE(report.is_within_tolerance()) << report.residual;
  expect_finite(brick);
  // moved by that vector: linear interpolation cannot do it, and says so
  const Kernel::Point_3 middle =
    CGAL::centroid(cube.points().begin(), cube.points().end(), CGAL::Dimension_tag<0>());
  for (auto v : cube.vertices()) {
    const Kernel::Vector_3 d = cube.point(v) - middle;
    const double sign = d.x() * d.y() * d.z() > 0 ? 0.1 : -0.1;
    cube.point(v) = cube.point(v) + sign * Kernel::Vector_3(1, 1, 1);
  }
  const Report impossible =
    Interpolation_runs<PN::Linear_scheme<PN::CatmullClark_scheme>>::interpolate(
      cube, PN::linear(scheme), strict());
  EXPECT_FALSE(impossible.is_within_tolerance());
  expect_finite(cube);
}

// No vertex of `net` is farther from where it was than the longest edge at it.
void expect_within_an_edge(const Surface_mesh& net, const Surface_mesh& before)
{
  for (auto v : before.vertices()) {
    double longest = 0;
    for (auto w : before.vertices_around_target(before.halfedge(v)))
      longest = (std::max)(longest, CGAL::squared_distance(before.point(v), before.point(w)));
    EXPECT_LE(CGAL::squared_distance(net.point(v), before.point(v)), 1.002 * longest) << v;
  }
}

// The limit at the tip of a spike is at 3/8 of its height: the tip would have to move by half as much again as its edges are long.
TEST(Interpolation_input, TheTipOfASpikeStaysWithinAnEdge)
{
  Control_mesh data = test_meshes::star(3, 1, test_meshes::Cells::quads);
  data.points[0] = {0, 0, 3};
  data.normals.assign(data.points.size(), {0, 0, 1});
  const Interpolated result = interpolated(data, scheme, Options());
  expect_within_an_edge(result.mesh, to_surface_mesh(data));
  EXPECT_FALSE(result.report.is_within_tolerance());
}

// Vertices between faces that are turned by up to 180 degrees: there limits are far from control points, and arcs tell little.
TEST(Interpolation_input, SlideStaysWithinAnEdge)
{
  Control_mesh data{"two parts",
                    {{-2.86, -1.398, 1.164},
                     {-3.388, 1.999, -0.042},
                     {-3.882, 1.576, -0.026},
                     {-3.681, 1.388, 0.038},
                     {-3.395, 1.786, 0.107},
                     {-3.368, -1.582, 0.641},
                     {-3.252, -1.071, 0.888},
                     {-3.541, -1.923, 0.84},
                     {-3.667, -1.075, 0.597},
                     {-3.259, -3.418, 1.116},
                     {-3.087, -2.964, 1.088},
                     {-3.085, -2.753, 0.901}},
                    {{1, 2, 4},
                     {1, 4, 3},
                     {1, 3, 2},
                     {3, 4, 2},
                     {0, 6, 7},
                     {7, 6, 5},
                     {8, 5, 6},
                     {7, 9, 10},
                     {7, 10, 0},
                     {9, 7, 11},
                     {11, 7, 5}}};
  data.normals.assign(data.points.size(), {0, 0, 0});
  Surface_mesh mesh = to_surface_mesh(data);
  PN::estimate_control_normals(mesh, normal_map(mesh));
  Surface_mesh net = mesh;
  const Report report = Runs::interpolate(net, scheme, Options());
  expect_within_an_edge(net, mesh);
  double left = 0, before = 0;
  for (auto v : mesh.vertices()) {
    const Vector p = limit_cases::to_vector(mesh.point(v));
    const auto distance = [&](Surface_mesh& m) {
      return Distance_runs<PN::CatmullClark_scheme>::from_limit(m, scheme, p, v.idx());
    };
    left = (std::max)(left, distance(net));
    before = (std::max)(before, distance(mesh));
  }
  EXPECT_NEAR(report.residual, left, 0.03 * left);
  EXPECT_LE(left, 1.01 * before);
  EXPECT_FALSE(report.is_within_tolerance());
}

// The largest distance of some points from the triangles between limits of three rounds more.
double farthest_from_limit(Surface_mesh net, const std::vector<Kernel::Point_3>& points)
{
  const Limits all = Limit_runs<PN::Loop_scheme::Tuned>::refined(net, scheme_of_triangles, 3);
  for (auto v : net.vertices()) net.point(v) = all.at[v].point;
  const surface_checks::Fine_triangles fine(net, 0.);
  double farthest = 0;
  for (const auto& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& q : fine.points) least = (std::min)(least, CGAL::squared_distance(p, q));
    if (least <= farthest) continue;
    for (const auto& [a, b, c] : fine.triangles)
      least = (std::min)(least, CGAL::squared_distance(p, Kernel::Triangle_3(a, b, c)));
    farthest = (std::max)(farthest, least);
  }
  return std::sqrt(farthest);
}

TEST(Interpolation_input, RealMeshes)
{
  for (const char* file : {"/head.obj", "/spoon.obj", "/creature.obj"}) {
    Surface_mesh mesh = mesh_files::read(std::string(PN_DATA_DIR) + file);
    PN::estimate_control_normals(mesh, normal_map(mesh));
    Options options = strict();
    options.tolerance = 1e-9;
    for (const auto mode :
         {PN::Limit_interpolation::Mode::slide, PN::Limit_interpolation::Mode::strict}) {
      options.mode = mode;
      Surface_mesh net = mesh;
      const Report report = Runs::interpolate(net, scheme, options);
      if (mode == PN::Limit_interpolation::Mode::strict) {
        EXPECT_TRUE(report.is_within_tolerance()) << file << " " << report.residual;
      } else
        expect_within_an_edge(net, mesh);
      expect_finite(net);
    }
    // in triangles, too coarse for their normals
    for (auto f : std::vector<Surface_mesh::Face_index>(mesh.faces_begin(), mesh.faces_end())) {
      const auto h = mesh.halfedge(f);
      while (mesh.next(mesh.next(mesh.next(h))) != h)
        CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
    }
    PN::estimate_control_normals(mesh, normal_map(mesh));
    const Surface_mesh before = mesh;
    const std::vector<Kernel::Point_3> points(mesh.points().begin(), mesh.points().end());
    const Report report =
      Interpolation_runs<PN::Loop_scheme::Tuned>::interpolate(mesh, scheme_of_triangles, Options());
    expect_within_an_edge(mesh, before);
    const double farthest = farthest_from_limit(mesh, points);
    EXPECT_NEAR(report.residual, farthest, 0.04 * farthest) << file;
    EXPECT_LE(farthest, 1.01 * farthest_from_limit(before, points)) << file;
    EXPECT_FALSE(report.is_within_tolerance()) << file;
  }
}

TEST(Interpolation_input, ATolerancePastReachGivesTheBest)
{
  Options options = strict();
  options.tolerance = 0;
  const Control_mesh data = ellipsoid_quads(3);
  Interpolated result = interpolated(data, scheme, options);
  EXPECT_GT(result.report.residual, 0);
  EXPECT_LE(result.report.residual, 1e-14);
  EXPECT_FALSE(result.report.is_within_tolerance());
}

TEST(Interpolation_input, WrongOptionsAreRefused)
{
  const Control_mesh data = ellipsoid_quads(2);
  Surface_mesh mesh = to_surface_mesh(data);
  const auto run = [&](const Options& options) { Runs::interpolate(mesh, scheme, options); };
  Options options;
  options.tolerance = -1;
  EXPECT_THROW(run(options), std::invalid_argument);
  options.tolerance = std::nan("");
  EXPECT_THROW(run(options), std::invalid_argument);
  options = Options();
  options.free = PN::Limit_interpolation::Free::smooth;
  EXPECT_THROW(run(options), std::invalid_argument);
  EXPECT_EQ(control_net(mesh, data).points, data.points);
}

TEST(Interpolation_input, EmptyMeshesStayEmpty)
{
  Surface_mesh mesh;
  for (const Options& options : {Options(), strict()}) {
    const Report report = Runs::interpolate(mesh, scheme, options);
    EXPECT_TRUE(report.is_within_tolerance());
    EXPECT_EQ(report.steps, 0u);
  }
}

} // namespace
