// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The smoothest change of control points that meets conditions, against a dense matrix of what it is defined by, at
// vertices of small and of large valence; a part of the program of test_interpolation.cpp.

#include <CGAL/PN_fitting_3/internal/Prescription.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace {

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

} // namespace

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
