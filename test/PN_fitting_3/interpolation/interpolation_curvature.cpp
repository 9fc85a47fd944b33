// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Prescribed curvatures of limit surfaces.

#include "Messages.h"
#include "Prescription_cases.h"
#include "support/Options.h"

#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

#include <Eigen/Dense>

namespace {

using namespace interpolation_cases;
using test_meshes::Cells;

const PN::CatmullClark_scheme plain_quads;
const PN::CatmullClark_scheme::Tuned quads;
const PN::Loop_scheme::Tuned triangles;

Kernel::Vector_3 to_kernel(const Eigen::Vector3d& v)
{
  return {v[0], v[1], v[2]};
}
Eigen::Vector3d to_double(const Kernel::Vector_3& v)
{
  return {v.x(), v.y(), v.z()};
}

Control_mesh graph(Cells cells = Cells::quads)
{
  return sampled_surfaces::patch(8, 8, 0, cells, 1, sampled_surfaces::on_waves);
}

template <class Scheme>
Limits limits_and_curvatures(Surface_mesh& mesh, const Scheme& scheme)
{
  test_options::Limit_options options = limit_cases::close(1e-13, 0);
  options.max_depth = 12;
  options.curvatures = true;
  return limits(mesh, scheme, options);
}

// the curvature at a vertex times a factor
template <class Scheme>
Curvature scaled(Surface_mesh& mesh, const Scheme& scheme, unsigned v, double factor)
{
  const auto [form, normal] = Curvature_runs<Scheme>::form(mesh, scheme, v);
  Eigen::Matrix<double, 3, 2> plane;
  plane.col(0) = normal.unitOrthogonal();
  plane.col(1) = normal.cross(plane.col(0));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> s(plane.transpose() * form * plane);
  return {-factor * s.eigenvalues()[0], -factor * s.eigenvalues()[1],
          to_kernel(plane * s.eigenvectors().col(0))};
}

// That limit_points(), which evaluates curvature by itself, tells of the scaled curvatures; the limit point
// and the normal stay.
template <class Scheme>
void expect_scaled(const Control_mesh& control, const Scheme& scheme, unsigned v, double bar)
{
  for (const double factor : {1.5, 0., -1.}) {
    Prescription p(control);
    const auto before = limits_and_curvatures(p.mesh, scheme).at[v];
    ASSERT_TRUE(before.has_curvature);
    p.curvatures[Index(v)] = scaled(p.mesh, scheme, v, factor);
    p.options.curvature_tolerance = 0;
    const Report report = Curvature_runs<Scheme>::solve(p, scheme);
    EXPECT_LE(report.curvature_residual, bar) << factor;
    EXPECT_LE(report.curvature_steps, 12u);
    EXPECT_GT(report.curvature_steps, 1u);
    const auto after = limits_and_curvatures(p.mesh, scheme).at[v];
    EXPECT_NEAR(after.mean, factor * before.mean, 2 * bar) << factor;
    EXPECT_NEAR(after.gaussian, factor * factor * before.gaussian, 8 * bar) << factor;
    EXPECT_LE(std::sqrt(CGAL::squared_distance(after.point, before.point)), 1e-11);
    EXPECT_LE(angle(after.surface_normal, before.surface_normal), 1e-6); // 12 rounds of evaluation
    EXPECT_LE(report.normal_residual, 1e-11);
  }
}

TEST(Prescribed_curvature, IsMetOnAGraph)
{
  expect_scaled(graph(), plain_quads, 40, 1e-5);
}

TEST(Prescribed_curvature, IsMetOnEllipsoids)
{
  expect_scaled(ellipsoid_quads(8), quads, 0, 1e-4); // valence 3
  expect_scaled(ellipsoid_quads(8), quads, 40, 1e-4);
  expect_scaled(ellipsoid_triangles(2), triangles, 0, 1e-4); // valence 5
  expect_scaled(ellipsoid_triangles(2), triangles, 12, 1e-4);
}

// On fine nets three steps are enough: the form that is added is the one that lacks.
TEST(Prescribed_curvature, ComesCloseInThreeSteps)
{
  Prescription p(graph());
  p.curvatures[Index(40)] = scaled(p.mesh, plain_quads, 40, 1.5);
  p.options.max_curvature_steps = 3;
  p.options.curvature_tolerance = 0;
  EXPECT_LE(Curvature_runs<PN::CatmullClark_scheme>::solve(p, plain_quads).curvature_residual,
            1e-7);
}

// Independently of all evaluation of limits: a quadratic fitted to ever closer points of the surface.
TEST(Prescribed_curvature, FitsComeCloser)
{
  Prescription p(graph());
  const Index v(40);
  const auto before = limits_and_curvatures(p.mesh, plain_quads).at[40];
  const Eigen::Vector3d n = to_double(before.surface_normal);
  const Eigen::Vector3d d = n.cross(Eigen::Vector3d(0.3, 1, 0)).normalized(), e = n.cross(d);
  p.curvatures[v] = Curvature{0.8, -0.5, to_kernel(3 * d + 2 * n)};
  Curvature_runs<PN::CatmullClark_scheme>::solve(p, plain_quads);
  double last = 1;
  for (int round = 0; round < 4; ++round) {
    const Limits all = Limit_runs<PN::CatmullClark_scheme>::refined(p.mesh, plain_quads, 1);
    std::set<Index> near{v};
    for (int ring = 0; ring < 2; ++ring)
      for (const Index w : std::set<Index>(near))
        for (auto x : p.mesh.vertices_around_target(p.mesh.halfedge(w))) near.insert(x);
    Eigen::MatrixXd a(Eigen::Index(near.size()), 6);
    Eigen::VectorXd z(a.rows());
    Eigen::Index row = 0;
    for (const Index w : near) {
      const Eigen::Vector3d q = to_double(all.at[w].point - before.point);
      const double x = d.dot(q), y = e.dot(q);
      a.row(row) << 1, x, y, x * x / 2, x * y, y * y / 2;
      z[row++] = n.dot(q);
    }
    const Eigen::VectorXd c = a.colPivHouseholderQr().solve(z);
    // positive is away from the normal
    const double off = std::max({std::abs(-c[3] - 0.8), std::abs(-c[5] + 0.5), std::abs(c[4])});
    EXPECT_LT(off, 0.75 * last) << round;
    last = off;
  }
  EXPECT_LT(last, 0.02);
}

TEST(Prescribed_curvature, WithPointAndNormal)
{
  const auto expect_met = [](const Control_mesh& control, const auto& scheme, unsigned v) {
    using Runs = Curvature_runs<std::decay_t<decltype(scheme)>>;
    Prescription p(control);
    const auto before = limits_and_curvatures(p.mesh, scheme).at[v];
    const Eigen::Vector3d old = to_double(before.surface_normal);
    const Eigen::Vector3d across = old.unitOrthogonal();
    const Eigen::Vector3d n = std::cos(0.3) * old + std::sin(0.3) * across;
    const Eigen::Vector3d d = n.cross(old).normalized();
    p.points[Index(v)] = before.point + 0.02 * before.surface_normal;
    p.normals[Index(v)] = 2 * to_kernel(n);
    p.curvatures[Index(v)] = Curvature{1, 0.4, to_kernel(d)};
    const Report report = Runs::solve(p, scheme);
    EXPECT_TRUE(report.is_within_tolerance());
    EXPECT_LE(report.normal_residual, 1e-11);
    EXPECT_LE(report.curvature_residual, 1e-4);
    const auto after = limits_and_curvatures(p.mesh, scheme).at[v];
    EXPECT_LE(std::sqrt(CGAL::squared_distance(after.point, *p.points[Index(v)])), 1e-11);
    EXPECT_NEAR(after.mean, 0.7, 2e-4);
    EXPECT_NEAR(after.gaussian, 0.4, 2e-4);
    const auto [form, normal] = Runs::form(p.mesh, scheme, v);
    EXPECT_NEAR(normal.dot(n), 1, 1e-9);
    EXPECT_NEAR(d.dot(form * d), -1, 1e-4);
    EXPECT_NEAR(d.dot(form * n.cross(d)), 0, 1e-4);
  };
  expect_met(graph(), plain_quads, 40);
  expect_met(ellipsoid_quads(8), quads, 0);
}

// The form that is added is right where the surface is tilted against its limit control normal, too.
TEST(Prescribed_curvature, ComesCloseWhereTilted)
{
  Prescription p(graph());
  const auto before = limits_and_curvatures(p.mesh, plain_quads).at[40];
  const Eigen::Vector3d old = to_double(before.surface_normal), across = old.unitOrthogonal();
  const Eigen::Vector3d n = std::cos(0.5) * old + std::sin(0.5) * across;
  p.normals[Index(40)] = to_kernel(n);
  p.curvatures[Index(40)] = Curvature{1, -1, to_kernel(across)};
  p.options.max_curvature_steps = 3;
  EXPECT_LE(Curvature_runs<PN::CatmullClark_scheme>::solve(p, plain_quads).curvature_residual,
            1e-3);
}

// Several at once, each as if it were alone; equal curvatures need no direction.
TEST(Prescribed_curvature, AtSeveralVertices)
{
  Prescription p(graph());
  for (const unsigned v : {20u, 24u, 60u}) p.curvatures[Index(v)] = Curvature{0.5, 0.5, {0, 0, 0}};
  const Report report = Curvature_runs<PN::CatmullClark_scheme>::solve(p, plain_quads);
  EXPECT_LE(report.curvature_residual, 1e-5);
  const Limits all = limits_and_curvatures(p.mesh, plain_quads);
  for (const unsigned v : {20u, 24u, 60u}) {
    EXPECT_NEAR(all.at[v].mean, 0.5, 1e-5);
    EXPECT_NEAR(all.at[v].gaussian, 0.25, 1e-5);
  }
}

TEST(Prescribed_curvature, NoneLeavesAllAsItIs)
{
  Prescription p(graph());
  const Surface_mesh before = p.mesh;
  EXPECT_EQ(Curvature_runs<PN::CatmullClark_scheme>::solve(p, plain_quads).steps, 0u);
  p.curvatures[Index(40)] = scaled(p.mesh, plain_quads, 40, 1.5);
  p.options.max_curvature_steps = 0;
  const Report report = Curvature_runs<PN::CatmullClark_scheme>::solve(p, plain_quads);
  EXPECT_EQ(report.curvature_steps, 0u);
  EXPECT_NEAR(report.curvature_residual, p.curvatures[Index(40)]->along / 3, 0.1);
  EXPECT_GT(report.curvature_residual, 0.03);
  for (auto v : before.vertices()) EXPECT_EQ(before.point(v), p.mesh.point(v));
}

TEST(Prescribed_curvature, WhatCannotBeIsRefusedByName)
{
  const auto expect_refused = [](Prescription& p, const auto& scheme, const std::string& part) {
    const Surface_mesh before = p.mesh;
    const std::vector<Kernel::Vector_3> normals(normal_map(p.mesh).begin(),
                                                normal_map(p.mesh).end());
    messages::expect_refused(
      [&] { Curvature_runs<std::decay_t<decltype(scheme)>>::solve(p, scheme); }, {part, "vertex"});
    for (auto v : before.vertices()) {
      EXPECT_EQ(before.point(v), p.mesh.point(v));
      EXPECT_EQ(normals[v], normal_map(p.mesh)[v]);
    }
  };
  const Curvature one{1, 1, {0, 0, 0}};
  {
    Prescription p(graph());
    p.curvatures[Index(4)] = one;
    expect_refused(p, plain_quads, "take an interior vertex"); // on the border
    p.curvatures[Index(4)].reset();
    p.curvatures[Index(40)] = one;
    p.curvatures[Index(42)] = one;
    expect_refused(p, plain_quads, "its faces share vertex");
    p.curvatures[Index(42)].reset();
    p.curvatures[Index(40)] = Curvature{1, 2, {0, 0, 0}};
    expect_refused(p, plain_quads, "its direction is zero");
    p.curvatures[Index(40)] = Curvature{1, HUGE_VAL, {1, 0, 0}};
    expect_refused(p, plain_quads, "is not finite");
    p.curvatures[Index(40)] = one;
    normal_map(p.mesh)[Index(31)] = CGAL::NULL_VECTOR;
    expect_refused(p, plain_quads, "control normals are zero or more than 60 degrees");
  }
  Prescription p(ellipsoid_quads(4));
  p.curvatures[Index(0)] = one; // valence 3
  expect_refused(p, plain_quads, "a modified scheme if it is irregular");
  p.curvatures[Index(0)].reset();
  p.curvatures[Index(1)] = one; // next to it
  expect_refused(p, quads, "whose neighbors are irregular");
}

} // namespace
