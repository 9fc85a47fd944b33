// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control nets of meshes and polygons of any scale are those at scale 1, bit for bit, and so are the reports.

#include "Extent.h"
#include "support/Options.h"

#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_fitting_3/internal/Prescription.h>
#include <CGAL/PN_fitting_3/interpolate_curve.h>
#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;
using Options = test_options::Limit_interpolation_options<>;

template <class FT>
struct Net
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;

  // an octahedron, dented and uneven
  explicit Net(int exponent)
  {
    normals = mesh.template add_property_map<Vertex, Vector>("v:normal", CGAL::NULL_VECTOR).first;
    const double at[6][3] = {{1, 0, 0.125}, {0, 1.5, 0}, {-1, 0.25, 0},
                             {0, -1.25, 0}, {0, 0, 1},   {0.25, 0, -2}};
    for (const auto& p : at)
      mesh.add_vertex(Point(FT(std::ldexp(p[0], exponent)), FT(std::ldexp(p[1], exponent)),
                            FT(std::ldexp(p[2], exponent))));
    for (unsigned i = 0; i < 4; ++i) {
      mesh.add_face(Vertex(i), Vertex((i + 1) % 4), Vertex(4));
      mesh.add_face(Vertex((i + 1) % 4), Vertex(i), Vertex(5));
    }
    PN::estimate_control_normals(mesh, normals);
  }

  Mesh mesh;
  typename Mesh::template Property_map<Vertex, Vector> normals;
  PN::Limit_interpolation report;
};

template <class FT>
Net<FT> interpolated(int exponent, const Options& options)
{
  Net<FT> net(exponent);
  net.report = PN::interpolate_limit_points(
    net.mesh, PN::Loop_scheme(),
    PN::parameters::join(options.pack(), np::vertex_normal_map(net.normals)));
  return net;
}

void expect_scaled(const PN::Limit_interpolation& a, const PN::Limit_interpolation& b, int e)
{
  EXPECT_EQ(b.residual, std::ldexp(a.residual, e));
  EXPECT_EQ(b.error, std::ldexp(a.error, e));
  EXPECT_EQ(b.tolerance, std::ldexp(a.tolerance, e));
  EXPECT_EQ(b.slip, std::ldexp(a.slip, e));
  EXPECT_EQ(b.slip_of_edge, a.slip_of_edge);
  EXPECT_EQ(b.normal_angle, a.normal_angle);
  EXPECT_EQ(b.steps, a.steps);
}

template <class FT>
void expect_scaled_nets(const std::vector<int>& exponents)
{
  for (const auto mode :
       {PN::Limit_interpolation::Mode::slide, PN::Limit_interpolation::Mode::strict})
    for (const auto normals :
         {PN::Limit_interpolation::Normals::given, PN::Limit_interpolation::Normals::solved}) {
      Options options;
      options.mode = mode;
      options.normals = normals;
      const Net<FT> one = interpolated<FT>(0, options);
      EXPECT_GT(one.report.steps, 0u);
      for (const int e : exponents) {
        SCOPED_TRACE(e);
        const Net<FT> net = interpolated<FT>(e, options);
        expect_scaled(one.report, net.report, e);
        for (const auto v : net.mesh.vertices()) {
          for (int k = 0; k < 3; ++k)
            ASSERT_EQ(net.mesh.point(v)[k], std::ldexp(one.mesh.point(v)[k], e)) << v;
          ASSERT_EQ(net.normals[v], one.normals[v]) << v;
        }
      }
    }
}

TEST(Interpolation_at_any_scale, OfMeshesInDouble)
{
  expect_scaled_nets<double>({-600, -300, -260, -100, -1, 100, 280, 300, 600, 1000});
}

TEST(Interpolation_at_any_scale, OfMeshesInFloat)
{
  long_test([](auto) { expect_scaled_nets<float>({-80, -30, 30, 80}); });
}

TEST(Interpolation_at_any_scale, NaturalNormals)
{
  const auto find = [](Net<double>& net) {
    PN::interpolate_limit_points(
      net.mesh, PN::Loop_scheme(),
      PN::parameters::interpolation_normals(PN::Limit_interpolation::Normals::natural)
        .vertex_normal_map(net.normals));
  };
  Net<double> one(0);
  find(one);
  for (const int e : {-600, -300, -100, 100, 300, 600}) {
    Net<double> net(e);
    find(net);
    for (const auto v : net.mesh.vertices()) ASSERT_EQ(net.normals[v], one.normals[v]) << e;
  }
}

TEST(Interpolation_at_any_scale, OfPolygons)
{
  using Plane_kernel = CGAL::Simple_cartesian<double>;
  using Polygon = std::vector<std::pair<Plane_kernel::Point_2, Plane_kernel::Vector_2>>;
  const auto polygon = [](int e) {
    Polygon result;
    for (int i = 0; i < 7; ++i)
      result.emplace_back(Plane_kernel::Point_2(std::ldexp(3 * std::cos(0.8 * i), e),
                                                std::ldexp(std::sin(0.8 * i) + 0.25 * (i % 2), e)),
                          CGAL::NULL_VECTOR);
    return result;
  };
  for (const auto mode :
       {PN::Limit_interpolation::Mode::slide, PN::Limit_interpolation::Mode::strict}) {
    Options options;
    options.mode = mode;
    const auto [one, report] = PN::interpolate_curve(polygon(0), PN::B_spline_mask(3),
                                                     PN::Curve_end::closed, options.pack());
    for (const int e : {-600, -300, -100, 100, 300, 600}) {
      const auto [scaled, of_scaled] = PN::interpolate_curve(polygon(e), PN::B_spline_mask(3),
                                                             PN::Curve_end::closed, options.pack());
      expect_scaled(report, of_scaled, e);
      for (std::size_t i = 0; i < one.size(); ++i) {
        for (int k = 0; k < 2; ++k)
          ASSERT_EQ(scaled[i].first[k], std::ldexp(one[i].first[k], e)) << e << ' ' << i;
        ASSERT_EQ(scaled[i].second, one[i].second) << e << ' ' << i;
      }
    }
  }
}

TEST(Interpolation_at_any_scale, WhatIsOutOfRangeIsRefused)
{
  using Vectors = PN::internal::Vectors<3>;
  Vectors points = {{1, 2, 3}, {-1, 0, 3}};
  EXPECT_NO_THROW((PN::internal::multiply_by_size<double, 3>(1022, points)));
  EXPECT_EQ(points[1][2], 3 * 0x1p1022);
  points = {{1, 2, 3}, {-1, 0, 3}};
  EXPECT_THROW((PN::internal::multiply_by_size<double, 3>(1023, points)), std::overflow_error);
  points = {{1, 2, 3}, {-1, 0, 3}};
  EXPECT_THROW((PN::internal::multiply_by_size<float, 3>(127, points)), std::overflow_error);
}

// --- the smoothest change of control points that meets conditions, against a dense matrix of what it is defined by ---

namespace in = CGAL::PN_subdivision_3::internal;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Correction = in::Smooth_correction<3>;
using Number = Correction::Index;
using Conditions = std::vector<Correction::Condition>;

// a vertex of valence n, number 0, and two rings of n vertices about it
constexpr std::size_t rings = 2;
Mesh disk(std::size_t n)
{
  using Vertex = Mesh::Vertex_index;
  Mesh mesh;
  for (std::size_t i = 0; i <= rings * n; ++i) mesh.add_vertex({double(i % 7), double(i % 5), 0});
  const auto at = [n](std::size_t ring, std::size_t i) { return Vertex(1 + ring * n + i % n); };
  for (std::size_t i = 0; i < n; ++i) {
    mesh.add_face(Vertex(0), at(0, i), at(0, i + 1));
    mesh.add_face(at(0, i), at(1, i), at(0, i + 1));
    mesh.add_face(at(0, i + 1), at(1, i), at(1, i + 1));
  }
  return mesh;
}

// the mean of the middle and its neighbors, and differences of some others, in directions of all kinds
Conditions conditions_on(std::size_t n)
{
  Conditions conditions;
  for (int k = 0; k < 3; ++k) {
    Correction::Condition mean;
    mean.emplace_back(Number(0), 0.5 * Correction::Vector::Unit(k));
    for (Number i = 1; i <= n; ++i)
      mean.emplace_back(i, 0.5 / double(n) * Correction::Vector::Unit(k));
    conditions.push_back(mean);
  }
  conditions.push_back({{Number(1), {0.3, 0.2, 0.9}}, {Number(2), {-0.3, 0.1, -0.9}}});
  conditions.push_back({{Number(n), {0.1, 1, 0.2}}, {Number(n + 1), {0, 0.2, 0.1}}});
  return conditions;
}

// The least of |U d|^2 + 1e-6 |d|^2 under the conditions, by Lagrange's multipliers.
Eigen::VectorXd expected_change(const Mesh& mesh, const Conditions& conditions,
                                const std::vector<double>& values)
{
  const auto n = Eigen::Index(3 * mesh.number_of_vertices()), m = Eigen::Index(values.size());
  Eigen::MatrixXd umbrella = Eigen::MatrixXd::Zero(n, n);
  for (const auto v : mesh.vertices())
    for (int k = 0; k < 3; ++k) {
      umbrella(3 * Eigen::Index(v) + k, 3 * Eigen::Index(v) + k) = 1;
      for (const auto w : mesh.vertices_around_target(mesh.halfedge(v)))
        umbrella(3 * Eigen::Index(v) + k, 3 * Eigen::Index(w) + k) = -1. / mesh.degree(v);
    }
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m, n + m);
  system.topLeftCorner(n, n) =
    umbrella.transpose() * umbrella + 1e-6 * Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(n + m);
  for (Eigen::Index i = 0; i < m; ++i) {
    right_side[n + i] = values[std::size_t(i)];
    for (const auto& [v, c] : conditions[std::size_t(i)]) {
      system.block<1, 3>(n + i, 3 * Eigen::Index(v)) += c.transpose();
      system.block<3, 1>(3 * Eigen::Index(v), n + i) += c;
    }
  }
  return system.partialPivLu().solve(right_side).head(n);
}

TEST(Smooth_correction, IsTheSmoothestChange)
{
  const std::vector<double> values = {1, 0.2, -0.4, 0.7, -0.5};
  for (const std::size_t n : {5u, 12u, 63u, 64u, 65u, 90u}) {
    SCOPED_TRACE(n);
    const Mesh mesh = disk(n);
    CGAL::PN_subdivision_3::Level_connectivity level;
    in::with_mesh_access(mesh, [&](const auto& access) { level = in::checked_level(access); });
    const Conditions conditions = conditions_on(n);
    Correction correction(level, {0, 1, 2, Number(n)}, 4); // all vertices
    ASSERT_TRUE(correction.set_conditions(conditions));
    in::Vectors<3> points(level.number_of_vertices(), Correction::Vector::Zero());
    ASSERT_TRUE(correction.add_to(points, values));
    const Eigen::VectorXd expected = expected_change(mesh, conditions, values);
    for (std::size_t v = 0; v < points.size(); ++v)
      EXPECT_LT((points[v] - expected.segment<3>(3 * Eigen::Index(v))).norm(),
                1e-9 * expected.norm());
  }
}

} // namespace
