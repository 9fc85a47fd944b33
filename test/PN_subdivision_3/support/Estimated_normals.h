// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Estimated control normals of a control mesh, and what the tests ask of them.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_ESTIMATED_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_TEST_ESTIMATED_NORMALS_H

#include "Mesh_cases.h"
#include "Sampled_surfaces.h"
#include "reference/Control_normals.h"

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

namespace estimated_normals {

using CGAL::PN_subdivision_3::Control_normal_estimate;
using sampled_surfaces::Real;
using test_meshes::Control_mesh;
using test_meshes::Triple;

constexpr double ulp = std::numeric_limits<double>::epsilon(); // 2^-52

template <class K>
CGAL::Surface_mesh<typename K::Point_3> to_mesh(const Control_mesh& control)
{
  return mesh_cases::built<CGAL::Surface_mesh<typename K::Point_3>>(control);
}

template <class K = CGAL::Simple_cartesian<double>>
std::vector<typename K::Vector_3>
estimate(const Control_mesh& control,
         Control_normal_estimate how = Control_normal_estimate::reciprocal)
{
  auto mesh = to_mesh<K>(control);
  auto normals =
    mesh.template add_property_map<CGAL::SM_Vertex_index, typename K::Vector_3>("n").first;
  CGAL::PN_subdivision_3::estimate_control_normals(
    mesh, normals, CGAL::PN_subdivision_3::parameters::control_normal_estimate(how));
  std::vector<typename K::Vector_3> result;
  for (auto v : mesh.vertices()) result.push_back(normals[v]);
  return result;
}

inline std::vector<Triple>
estimated(const Control_mesh& control,
          Control_normal_estimate how = Control_normal_estimate::reciprocal)
{
  std::vector<Triple> result;
  for (const auto& n : estimate(control, how)) result.push_back({n.x(), n.y(), n.z()});
  return result;
}

inline double distance(const Triple& a, const Triple& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline double largest_distance(const std::vector<Triple>& a, const std::vector<Triple>& b)
{
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    if (!(distance(a[i], b[i]) <= largest)) largest = distance(a[i], b[i]); // NaN is large
  return largest;
}

// normals, and roundness where it is estimated
struct Estimates
{
  std::vector<Triple> normals;
  std::vector<double> roundness;
};

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    if (!(std::abs(a[i] - b[i]) <= largest)) largest = std::abs(a[i] - b[i]);
  return largest;
}

inline void expect_near(const Estimates& a, const Estimates& b, double bound,
                        const std::string& name)
{
  EXPECT_LE(largest_distance(a.normals, b.normals), bound) << name;
  EXPECT_LE(largest_difference(a.roundness, b.roundness), 32 * bound) << name;
}

inline Control_mesh
moved(Control_mesh mesh,
      const std::function<sampled_surfaces::Vector(const sampled_surfaces::Vector&)>& f)
{
  for (Triple& p : mesh.points) {
    const sampled_surfaces::Vector q = f(sampled_surfaces::Vector(p[0], p[1], p[2]));
    p = {double(q[0]), double(q[1]), double(q[2])};
  }
  return mesh;
}

// powers of two bit for bit
template <class Estimate>
void expect_similarities_commute(const std::vector<Control_mesh>& meshes, const Estimate& estimate,
                                 const std::vector<int>& exponents, double bound)
{
  using sampled_surfaces::Vector;
  const Eigen::AngleAxis<Real> turn(0.7L, Vector(1, 2, -0.5).normalized());
  for (const Control_mesh& mesh : meshes) {
    Estimates expected = estimate(mesh);
    for (int exponent : exponents) {
      const Real factor = std::ldexp(1.L, exponent);
      const Estimates result =
        estimate(moved(mesh, [&](const Vector& p) -> Vector { return factor * p; }));
      EXPECT_EQ(result.normals, expected.normals) << mesh.name << ", 2^" << exponent;
      EXPECT_EQ(result.roundness, expected.roundness) << mesh.name << ", 2^" << exponent;
    }
    const Estimates turned = estimate(
      moved(mesh, [&](const Vector& p) -> Vector { return 3 * (turn * p) + Vector(1, -2, 3); }));
    for (Triple& m : expected.normals) {
      const Vector n = turn * Vector(m[0], m[1], m[2]);
      m = {double(n[0]), double(n[1]), double(n[2])};
    }
    expect_near(turned, expected, bound, mesh.name);
  }
}

template <class Estimate>
void expect_reversed_faces_reverse(const std::vector<Control_mesh>& meshes,
                                   const Estimate& estimate, double bound)
{
  for (Control_mesh mesh : meshes) {
    Estimates expected = estimate(mesh);
    for (Triple& n : expected.normals)
      for (double& x : n) x = -x;
    for (reference::Face& f : mesh.faces) std::reverse(f.begin(), f.end());
    expect_near(estimate(mesh), expected, bound, mesh.name);
  }
}

// angles to the true normals, in degrees
struct Angles
{
  double rms = 0, largest = 0;
};

template <class Predicate>
Angles angles(const Control_mesh& mesh, const std::vector<Triple>& normals, const Predicate& counts)
{
  Angles a;
  int n = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!counts(int(i))) continue;
    const double x = 2 * std::asin((std::min)(1., distance(normals[i], mesh.normals[i]) / 2)) *
                     180 / std::acos(-1.);
    a.rms += x * x;
    a.largest = (std::max)(a.largest, x);
    ++n;
  }
  a.rms = std::sqrt(a.rms / (std::max)(n, 1));
  return a;
}

inline std::vector<reference::Point_3> reference_points(const Control_mesh& mesh)
{
  std::vector<reference::Point_3> points;
  for (const Triple& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

inline std::vector<Triple> triples(const std::vector<reference::Point_3>& points)
{
  std::vector<Triple> result;
  for (const auto& p : points) result.push_back({double(p[0]), double(p[1]), double(p[2])});
  return result;
}

} // namespace estimated_normals

#endif // CGAL_PN_SUBDIVISION_3_TEST_ESTIMATED_NORMALS_H
