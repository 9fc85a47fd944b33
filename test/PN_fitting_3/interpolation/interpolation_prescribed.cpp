// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Prescribed limit points and surface normals.

#include "Messages.h"
#include "Prescription_cases.h"
#include "support/Options.h"

#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

#include <Eigen/Dense>

namespace {

using namespace interpolation_cases;
using test_meshes::Cells;

// Where rounding and truncation of the surface normals balance, in double.
template <class Scheme>
Limits limits_and_normals(Surface_mesh& mesh, const Scheme& scheme)
{
  test_options::Limit_options options = limit_cases::close(1e-13, 0);
  options.max_depth = 15;
  return limits(mesh, scheme, options);
}

Kernel::Vector_3 turned(const Kernel::Vector_3& n, double degrees)
{
  Kernel::Vector_3 t = CGAL::cross_product(n, Kernel::Vector_3(0.3, 0.2, 1));
  t = t / std::sqrt(t.squared_length());
  return std::cos(degrees * degree) * n + std::sin(degrees * degree) * t;
}

// On borders the error of a surface normal halves with every round of evaluation only: what it tends to.
template <class Scheme>
std::vector<Kernel::Vector_3> extrapolated_normals(Surface_mesh& mesh, const Scheme& scheme)
{
  std::vector<std::vector<Kernel::Vector_3>> table;
  for (unsigned depth = 9; depth < 14; ++depth) {
    test_options::Limit_options options = limit_cases::close(0, 0);
    options.max_depth = depth;
    table.emplace_back();
    for (const auto& limit : limits(mesh, scheme, options).at)
      table.back().push_back(limit.surface_normal);
  }
  for (double factor = 2; table.size() > 1; factor *= 2) {
    for (std::size_t k = 0; k + 1 < table.size(); ++k)
      for (std::size_t v = 0; v < table[k].size(); ++v)
        table[k][v] = (factor * table[k + 1][v] - table[k][v]) / (factor - 1);
    table.pop_back();
  }
  return table[0];
}

template <class Scheme>
Report solve(Prescription& p, const Scheme& scheme, unsigned rings = 2)
{
  p.options.rings = rings;
  return Prescription_runs<Scheme>::solve(p, scheme);
}

// as prescribed, by the evaluation of limit points, which is another one
template <class Scheme>
void expect_met(Prescription& p, const Scheme& scheme, double normal_bar = 1e-8)
{
  const Limits all = limits_and_normals(p.mesh, scheme);
  const auto at_borders = extrapolated_normals(p.mesh, scheme);
  for (auto v : p.mesh.vertices()) {
    if (p.points[v]) {
      EXPECT_LE(std::sqrt(CGAL::squared_distance(all.at[v].point, *p.points[v])), 1e-12) << v;
    }
    if (p.normals[v]) {
      EXPECT_TRUE(all.at[v].has_surface_normal) << v;
      const bool is_at_border = p.mesh.is_border(v);
      EXPECT_LE(angle(is_at_border ? at_borders[v] : all.at[v].surface_normal, *p.normals[v]),
                normal_bar * degree)
        << v;
    }
  }
}

template <class Scheme>
void expect_turned(const Control_mesh& control, const Scheme& scheme,
                   const std::vector<unsigned>& chosen)
{
  for (const double degrees : {20., 45.}) {
    Prescription p(control);
    const Limits before = limits_and_normals(p.mesh, scheme);
    for (const unsigned v : chosen) {
      p.points[Index(v)] = before.at[v].point;
      p.normals[Index(v)] = turned(before.at[v].surface_normal, degrees);
    }
    const Surface_mesh old = p.mesh;
    const Report report = solve(p, scheme);
    EXPECT_LE(report.normal_residual, 1e-10 * degree);
    EXPECT_TRUE(report.is_within_tolerance());
    expect_met(p, scheme);
    std::size_t moved = 0;
    for (auto v : old.vertices()) moved += old.point(v) == p.mesh.point(v) ? 0 : 1;
    EXPECT_LT(moved, old.number_of_vertices());
    EXPECT_GT(moved, 4u);
  }
}

TEST(Prescribed_limit_data, NormalsAreTurned)
{
  expect_turned(ellipsoid_quads(6), PN::CatmullClark_scheme::Tuned(), {0, 40});
  expect_turned(ellipsoid_triangles(2), PN::Loop_scheme::Tuned(), {0, 100}); // valence 5 and 6
  Control_mesh mixed =
    sampled_surfaces::patch(8, 8, 0.1, Cells::mixed, 5, sampled_surfaces::on_waves);
  expect_turned(mixed, PN::CatmullClark_scheme(), {40});
}

// The smoothest change, as dense matrices have it: a point of the linear scheme, in two rings of faces.
TEST(Prescribed_limit_data, ChangesAreTheSmoothestOnes)
{
  const auto scheme = PN::linear(PN::CatmullClark_scheme());
  constexpr int n = 9, chosen = 40;
  Prescription p(sampled_surfaces::patch(8, 8, 0, Cells::quads, 1, sampled_surfaces::on_waves));
  const Surface_mesh before = p.mesh;
  const Kernel::Vector_3 shift(0.03, -0.02, 0.05);
  p.points[Index(chosen)] = limits_and_normals(p.mesh, scheme).at[chosen].point + shift;
  solve(p, scheme);
  std::vector<int> free;
  Eigen::VectorXd limit = Eigen::VectorXd::Zero(25);
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i) {
      const double weights[] = {4. / 6, 1. / 6, 0};
      limit[Eigen::Index(free.size())] = weights[std::abs(i)] * weights[std::abs(j)];
      free.push_back(chosen + n * j + i);
    }
  Eigen::MatrixXd umbrella = Eigen::MatrixXd::Zero(n * n, 25);
  for (int k = 0; k < 25; ++k) {
    const Index v(static_cast<unsigned>(free[std::size_t(k)]));
    umbrella(int(v), k) += 1;
    for (auto w : before.vertices_around_target(before.halfedge(v)))
      umbrella(int(w), k) -= 1. / double(before.degree(w));
  }
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(26, 26);
  system.topLeftCorner(25, 25) =
    umbrella.transpose() * umbrella + 1e-6 * Eigen::MatrixXd::Identity(25, 25);
  system.topRightCorner(25, 1) = limit;
  system.bottomLeftCorner(1, 25) = limit.transpose();
  const Eigen::VectorXd change = system.fullPivLu().solve(Eigen::VectorXd::Unit(26, 25));
  for (auto v : before.vertices()) {
    const auto found = std::find(free.begin(), free.end(), int(v));
    const double c = found == free.end() ? 0 : change[found - free.begin()];
    EXPECT_LE(std::sqrt((p.mesh.point(v) - before.point(v) - c * shift).squared_length()), 1e-9)
      << v;
  }
}

TEST(Prescribed_limit_data, LinearSchemesToo)
{
  const auto scheme = PN::linear(PN::CatmullClark_scheme());
  Prescription p(ellipsoid_quads(4));
  const Limits before = limits_and_normals(p.mesh, scheme);
  p.normals[Index(40)] = turned(before.at[40].surface_normal, 20);
  p.points[Index(40)] = before.at[40].point;
  solve(p, scheme);
  expect_met(p, scheme);
}

// Along the border of a patch: tangent planes by which another patch can go on.
TEST(Prescribed_limit_data, PlanesAlongABorder)
{
  for (const Cells cells : {Cells::quads, Cells::triangles}) {
    const auto run = [](const Control_mesh& control, const auto& scheme) {
      Prescription p(control);
      const Limits before = limits_and_normals(p.mesh, scheme);
      std::size_t chosen = 0;
      for (auto v : p.mesh.vertices()) {
        const Kernel::Point_3& q = p.mesh.point(v);
        // one side, without its ends
        if (q.y() > -1 + 1e-9 || std::abs(q.x()) > 1 - 1e-9) continue;
        ASSERT_TRUE(before.at[v].has_surface_normal);
        // the border curve stays, hence the plane turns about its tangent
        const double h = 1e-3;
        const auto at = [&](double x) -> Vector {
          return limit_cases::to_vector(Kernel::Point_3(x, -1, 0)) +
                 Vector(0, 0, sampled_surfaces::on_waves(Real(x), -1).point[2]);
        };
        const Vector t = (at(q.x() + h) - at(q.x() - h)).normalized();
        const Kernel::Vector_3 tangent{double(t[0]), double(t[1]), double(t[2])};
        const Kernel::Vector_3 n = before.at[v].surface_normal;
        const Kernel::Vector_3 across = CGAL::cross_product(tangent, n);
        const double a = 25 * degree;
        p.normals[v] = std::cos(a) * n + std::sin(a) * across;
        ++chosen;
      }
      EXPECT_EQ(chosen, 7u);
      const Report report = solve(p, scheme);
      EXPECT_LE(report.normal_residual, 1e-10 * degree);
      expect_met(p, scheme);
    };
    const Control_mesh control =
      sampled_surfaces::patch(8, 8, 0, cells, 5, sampled_surfaces::on_waves);
    if (cells == Cells::quads)
      run(control, PN::CatmullClark_scheme());
    else
      run(control, PN::Loop_scheme());
  }
}

// More conditions than unknowns: least squares. After a round at the old vertices all can be met.
TEST(Prescribed_limit_data, AllPointsAndNormalsAfterOneRound)
{
  const PN::CatmullClark_scheme::Tuned scheme;
  const Control_mesh data = ellipsoid_quads(4);
  const auto prescribe_all = [&](Prescription& p) {
    for (unsigned v = 0; v < data.points.size(); ++v) {
      const auto &q = data.points[v], &n = data.normals[v];
      p.points[Index(v)] = Kernel::Point_3(q[0], q[1], q[2]);
      p.normals[Index(v)] = Kernel::Vector_3(n[0], n[1], n[2]);
    }
  };
  Prescription p(data);
  prescribe_all(p);
  const Report coarse = solve(p, scheme, 1000);
  EXPECT_GT(coarse.residual + coarse.normal_residual, 1e-6);
  Prescription fine(data);
  Interpolation_runs<PN::CatmullClark_scheme::Tuned>::interpolate(fine.mesh, scheme, strict());
  const double error = rms_error(fine.mesh, scheme, to_ellipsoid);
  Limit_runs<PN::CatmullClark_scheme::Tuned>::refined(fine.mesh, scheme, 1);
  prescribe_all(fine);
  const Report report = solve(fine, scheme, 1000);
  EXPECT_LE(report.normal_residual, 1e-9 * degree);
  expect_met(fine, scheme, 1e-7);
  EXPECT_LT(rms_error(fine.mesh, scheme, to_ellipsoid), error);
}

// Independently of all evaluation of limits: the area normal of ever smaller faces.
TEST(Prescribed_limit_data, FacesTurnTowardsThePrescribedNormal)
{
  const PN::CatmullClark_scheme scheme;
  Prescription p(ellipsoid_quads(4));
  const Index v(40);
  p.normals[v] = turned(limits_and_normals(p.mesh, scheme).at[40].surface_normal, 20);
  solve(p, scheme);
  double last = 1;
  for (int round = 0; round < 4; ++round) {
    Limit_runs<PN::CatmullClark_scheme>::refined(p.mesh, scheme, 1);
    std::vector<Kernel::Point_3> ring;
    for (auto w : p.mesh.vertices_around_target(p.mesh.halfedge(v)))
      ring.push_back(p.mesh.point(w));
    Kernel::Vector_3 n = CGAL::NULL_VECTOR;
    for (std::size_t i = 0; i < ring.size(); ++i)
      n = n + CGAL::cross_product(ring[(i + 1) % ring.size()] - ring[0], ring[i] - ring[0]);
    const double off = angle(n, *p.normals[v]);
    EXPECT_LT(off, 0.45 * last) << round;
    last = off;
  }
  EXPECT_LT(last, 0.2 * degree);
}

TEST(Prescribed_limit_data, WhatCannotBeIsRefusedByName)
{
  Prescription p(sampled_surfaces::patch(3, 3, 0, Cells::quads, 5, sampled_surfaces::on_waves));
  const Surface_mesh before = p.mesh;
  const auto refused = [&](const std::string& part) {
    messages::expect_refused([&] { solve(p, PN::CatmullClark_scheme()); }, {part, "vertex"});
    for (auto v : before.vertices()) EXPECT_EQ(before.point(v), p.mesh.point(v));
  };
  p.normals[Index(0)] = Kernel::Vector_3(0, 0, 1); // a corner
  refused("no tangent plane");
  p.normals[Index(0)].reset();
  p.normals[Index(5)] = CGAL::NULL_VECTOR;
  refused("no direction");
  p.normals[Index(5)].reset();
  p.points[Index(5)] = Kernel::Point_3(HUGE_VAL, 0, 0);
  refused("not finite");
}

TEST(Prescribed_limit_data, NothingPrescribedChangesNothing)
{
  Prescription p(ellipsoid_quads(2));
  const Surface_mesh before = p.mesh;
  EXPECT_EQ(solve(p, PN::CatmullClark_scheme()).steps, 0u);
  for (auto v : before.vertices()) EXPECT_EQ(before.point(v), p.mesh.point(v));
}

} // namespace
