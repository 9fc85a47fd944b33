// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Joints of lines and arcs in creases, of planes and fillets beside them: the rims of an extruded rectangle with
// rounded corners.

#include "Sampled_surfaces.h"

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

namespace {

using namespace sampled_surfaces;
namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using PN::Control_normal_estimate;

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr double half_length = 2.3, half_width = 1.3, radius = 0.3;

// corners by arcs of some steps; the rims are sharp
struct Bar
{
  explicit Bar(int steps)
  {
    std::vector<Kernel::Point_3> bottom, top;
    for (int corner = 0; corner < 4; ++corner)
      for (int k = 0; k <= steps; ++k) {
        const double t = double(pi) / 2 * (corner + double(k) / steps);
        const double x = (corner == 0 || corner == 3 ? 1 : -1) * (half_length - radius);
        const double y = (corner < 2 ? 1 : -1) * (half_width - radius);
        bottom.emplace_back(x + radius * std::cos(t), y + radius * std::sin(t), 0);
        top.emplace_back(bottom.back().x(), bottom.back().y(), 1);
      }
    for (const auto& points : {bottom, top})
      for (const auto& p : points) mesh.add_vertex(p);
    const auto n = unsigned(bottom.size());
    const auto v = [](unsigned i) { return CGAL::SM_Vertex_index(i); };
    std::vector<CGAL::SM_Vertex_index> lower, upper;
    for (unsigned i = 0; i < n; ++i) {
      mesh.add_face(v(i), v((i + 1) % n), v(n + (i + 1) % n), v(n + i));
      lower.push_back(v(n - 1 - i));
      upper.push_back(v(n + i));
    }
    mesh.add_face(lower);
    mesh.add_face(upper);
    sharp = mesh.add_property_map<CGAL::SM_Edge_index, bool>("sharp", false).first;
    for (auto e : mesh.edges())
      sharp[e] = mesh.point(mesh.vertex(e, 0)).z() == mesh.point(mesh.vertex(e, 1)).z();
  }

  Mesh mesh;
  Mesh::Property_map<CGAL::SM_Edge_index, bool> sharp;
};

// of a point of the plane from the rounded rectangle; negative inside
double distance_outside(double x, double y)
{
  const double dx = std::abs(x) - (half_length - radius), dy = std::abs(y) - (half_width - radius);
  if (dx > 0 && dy > 0) return std::hypot(dx, dy) - radius;
  return (std::max)(dx, dy) - radius;
}

double farthest_outside(int steps, Control_normal_estimate how)
{
  Bar bar(steps);
  PN::subdivide(bar.mesh, PN::internal::with_normal_estimate(PN::CatmullClark_scheme(), how),
                CGAL::parameters::number_of_iterations(4).edge_is_constrained_map(bar.sharp));
  double largest = 0;
  for (auto v : bar.mesh.vertices())
    largest = (std::max)(largest, distance_outside(bar.mesh.point(v).x(), bar.mesh.point(v).y()));
  return largest;
}

} // namespace

TEST(Creases_joints, LinesStayNearlyStraight)
{
  for (const auto& [steps, bar] : {std::pair(2, 0.042), std::pair(3, 0.028), std::pair(6, 0.015)}) {
    const double now = farthest_outside(steps, Control_normal_estimate::coherent);
    const double before = farthest_outside(steps, Control_normal_estimate::reciprocal);
    std::cout << steps << " steps: " << now << ", by circles " << before << '\n';
    EXPECT_LE(now, bar);
    EXPECT_GE(before, 0.1);
  }
}

// the exact normals: of the lids, and of the planes and the fillets between them
TEST(Creases_joints, WedgesBesidePlanes)
{
  const auto largest_angle = [](int steps, Control_normal_estimate how) {
    Bar bar(steps);
    const auto normals =
      bar.mesh.add_property_map<CGAL::SM_Halfedge_index, Kernel::Vector_3>("n").first;
    PN::estimate_control_normals(
      bar.mesh, normals,
      PN::parameters::control_normal_estimate(how).edge_is_constrained_map(bar.sharp));
    double largest = 0;
    for (auto h : bar.mesh.halfedges()) {
      const bool is_lid = bar.mesh.degree(bar.mesh.face(h)) > 4;
      const auto p = bar.mesh.point(bar.mesh.target(h));
      const double dx = (std::max)(std::abs(p.x()) - (half_length - radius), 0.);
      const double dy = (std::max)(std::abs(p.y()) - (half_width - radius), 0.);
      const Kernel::Vector_3 exact =
        is_lid ? Kernel::Vector_3(0, 0, 2 * p.z() - 1)
               : Kernel::Vector_3(std::copysign(dx, p.x()), std::copysign(dy, p.y()), 0) / radius;
      const double sine = std::sqrt(CGAL::cross_product(normals[h], exact).squared_length());
      if (is_lid) EXPECT_LE(sine, 4 * ulp);
      EXPECT_GT(normals[h] * exact, 0.5);
      largest = (std::max)(largest, sine);
    }
    return largest;
  };
  for (int steps : {2, 3, 6}) {
    const double now = largest_angle(steps, Control_normal_estimate::coherent);
    const double before = largest_angle(steps, Control_normal_estimate::reciprocal);
    std::cout << steps << " steps: " << now << ", by circles " << before << '\n';
    EXPECT_LE(now, before / 3);
  }
}
