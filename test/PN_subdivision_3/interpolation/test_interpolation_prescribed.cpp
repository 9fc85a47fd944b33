// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Prescribed limit points and surface normals.

#include "Interpolation_cases.h"

#include <CGAL/PN_subdivision_3/prescribe_limit_data.h>

#include <gtest/gtest.h>

#include <optional>

namespace {

using namespace interpolation_cases;
using test_meshes::Cells;
using Index = Surface_mesh::Vertex_index;
using Points = Surface_mesh::Property_map<Index, std::optional<Kernel::Point_3>>;
using Normals = Surface_mesh::Property_map<Index, std::optional<Kernel::Vector_3>>;

constexpr double degree = 0.017453292519943295;

// Where rounding and truncation of the surface normals balance, in double.
template <class Scheme>
Limits limits_and_normals(Surface_mesh& mesh, const Scheme& scheme)
{
  PN::Limit_options options = limit_cases::close(1e-13, 0);
  options.max_depth = 15;
  return limit_cases::limits(mesh, scheme, options);
}

double angle(const Kernel::Vector_3& a, const Kernel::Vector_3& b)
{
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
}

Kernel::Vector_3 turned(const Kernel::Vector_3& n, double degrees)
{
  Kernel::Vector_3 t = CGAL::cross_product(n, Kernel::Vector_3(0.3, 0.2, 1));
  t = t / std::sqrt(t.squared_length());
  return std::cos(degrees * degree) * n + std::sin(degrees * degree) * t;
}

struct Prescription
{
  Surface_mesh mesh;
  Points points;
  Normals normals;

  explicit Prescription(const Control_mesh& control)
    : mesh(to_surface_mesh(control))
    , points(mesh.add_property_map<Index, std::optional<Kernel::Point_3>>("v:p").first)
    , normals(mesh.add_property_map<Index, std::optional<Kernel::Vector_3>>("v:n").first)
  {}

  template <class Scheme>
  Report solve(const Scheme& scheme, unsigned rings = 2)
  {
    PN::Limit_prescription_options options;
    options.rings = rings;
    return PN::prescribe_limit_data(mesh, scheme, points, normals, options,
                                    CGAL::parameters::vertex_normal_map(normal_map(mesh)));
  }

  // as prescribed, by the evaluation of limit points, which is another one
  template <class Scheme>
  void expect_met(const Scheme& scheme, double normal_bar = 1e-8)
  {
    const Limits all = limits_and_normals(mesh, scheme);
    for (auto v : mesh.vertices()) {
      if (points[v]) {
        EXPECT_LE(std::sqrt(CGAL::squared_distance(all.at[v].point, *points[v])), 1e-12) << v;
      }
      if (normals[v]) {
        EXPECT_TRUE(all.at[v].has_surface_normal) << v;
        EXPECT_LE(angle(all.at[v].surface_normal, *normals[v]) / degree, normal_bar) << v;
      }
    }
  }
};

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
    const Report report = p.solve(scheme);
    EXPECT_LE(report.normal_residual, 1e-10 * degree);
    EXPECT_TRUE(report.is_within_tolerance());
    p.expect_met(scheme);
    std::size_t moved = 0;
    for (auto v : old.vertices()) moved += old.point(v) == p.mesh.point(v) ? 0 : 1;
    EXPECT_LT(moved, old.number_of_vertices());
    EXPECT_GT(moved, 4u);
  }
}

TEST(Prescribed_limit_data, NormalsAreTurned)
{
  expect_turned(ellipsoid_quads(6), PN::modified_CatmullClark_scheme(), {0, 40});
  expect_turned(ellipsoid_triangles(2), PN::modified_Loop_scheme(), {0, 100}); // valence 5 and 6
  Control_mesh mixed =
    sampled_surfaces::patch(8, 8, 0.1, Cells::mixed, 5, sampled_surfaces::on_waves);
  expect_turned(mixed, PN::CatmullClark_scheme(), {40});
}

TEST(Prescribed_limit_data, LinearSchemesToo)
{
  const auto scheme = PN::linear(PN::CatmullClark_scheme());
  Prescription p(ellipsoid_quads(4));
  const Limits before = limits_and_normals(p.mesh, scheme);
  p.normals[Index(40)] = turned(before.at[40].surface_normal, 20);
  p.points[Index(40)] = before.at[40].point;
  p.solve(scheme);
  p.expect_met(scheme);
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
      const Report report = p.solve(scheme);
      EXPECT_LE(report.normal_residual, 1e-10 * degree);
      p.expect_met(scheme, 2e-5); // 15 rounds of evaluation, in which the error halves on borders
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
  const PN::modified_CatmullClark_scheme scheme;
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
  const Report coarse = p.solve(scheme, 1000);
  EXPECT_GT(coarse.residual + coarse.normal_residual, 1e-6);
  Prescription fine(data);
  PN::interpolate_limit_points(fine.mesh, scheme, strict(),
                               CGAL::parameters::vertex_normal_map(normal_map(fine.mesh)));
  const double error = rms_error(fine.mesh, scheme, to_ellipsoid);
  PN::subdivide(fine.mesh, scheme, CGAL::parameters::vertex_normal_map(normal_map(fine.mesh)));
  prescribe_all(fine);
  const Report report = fine.solve(scheme, 1000);
  EXPECT_LE(report.normal_residual, 1e-9 * degree);
  fine.expect_met(scheme, 1e-7);
  EXPECT_LT(rms_error(fine.mesh, scheme, to_ellipsoid), error);
}

// Independently of all evaluation of limits: the area normal of ever smaller faces.
TEST(Prescribed_limit_data, FacesTurnTowardsThePrescribedNormal)
{
  const PN::CatmullClark_scheme scheme;
  Prescription p(ellipsoid_quads(4));
  const Index v(40);
  p.normals[v] = turned(limits_and_normals(p.mesh, scheme).at[40].surface_normal, 20);
  p.solve(scheme);
  double last = 1;
  for (int round = 0; round < 4; ++round) {
    PN::subdivide(p.mesh, scheme, CGAL::parameters::vertex_normal_map(normal_map(p.mesh)));
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
    try {
      p.solve(PN::CatmullClark_scheme());
      ADD_FAILURE() << part;
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find("vertex"), std::string::npos) << e.what();
    }
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
  EXPECT_EQ(p.solve(PN::CatmullClark_scheme()).steps, 0u);
  for (auto v : before.vertices()) EXPECT_EQ(before.point(v), p.mesh.point(v));
}

} // namespace
