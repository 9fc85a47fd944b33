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

#include <CGAL/PN_subdivision_3.h>
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
  PN::subdivide(bar.mesh, PN::with_normal_estimate(PN::CatmullClark_scheme(), how),
                CGAL::parameters::number_of_iterations(4).edge_is_constrained_map(bar.sharp));
  double largest = 0;
  for (auto v : bar.mesh.vertices())
    largest = (std::max)(largest, distance_outside(bar.mesh.point(v).x(), bar.mesh.point(v).y()));
  return largest;
}

// A sharp rim of radius 1 around a wall, from which a plane or a cone leads to a fillet. The corner normals at the
// rim of the part beyond, and the exact tangents of the rim.
struct Rim
{
  Rim(double slope, Control_normal_estimate how)
  {
    constexpr unsigned n = 11, rows = 7;
    std::mt19937 generator(3);
    const Numbers turns = uneven(n + 1, 0.4, generator);
    std::vector<std::pair<double, double>> profile{{1, 0}, {1, 1}};
    for (int k = 0; k <= 3; ++k) {
      const double t = std::atan(slope) + (double(pi) / 2 - std::atan(slope)) * k / 3;
      profile.emplace_back(1.5 + 0.3 * std::sin(t), 0.7 + 0.5 * slope + 0.3 * std::cos(t));
    }
    profile.emplace_back(1.8, 0.2);
    Mesh mesh;
    for (const auto& [r, z] : profile)
      for (unsigned i = 0; i < n; ++i) {
        const double angle = double(2 * pi * turns[i]);
        mesh.add_vertex(Kernel::Point_3(r * std::cos(angle), r * std::sin(angle), z));
      }
    const auto v = [](unsigned row, unsigned i) { return CGAL::SM_Vertex_index(row * n + i % n); };
    for (unsigned row = 0; row + 1 < rows; ++row)
      for (unsigned i = 0; i < n; ++i)
        mesh.add_face(v(row, i), v(row + 1, i), v(row + 1, i + 1), v(row, i + 1));
    auto sharp = mesh.add_property_map<CGAL::SM_Edge_index, bool>("sharp", false).first;
    for (unsigned i = 0; i < n; ++i) sharp[mesh.edge(mesh.halfedge(v(1, i), v(1, i + 1)))] = true;
    const auto all = mesh.add_property_map<CGAL::SM_Halfedge_index, Kernel::Vector_3>("n").first;
    PN::estimate_corner_normals(mesh, sharp, all, CGAL::parameters::default_values(), how);
    for (unsigned i = 0; i < n; ++i) {
      const auto h = mesh.halfedge(v(2, i), v(1, i)), other = mesh.opposite(h);
      EXPECT_FALSE(mesh.is_border(h) || mesh.is_border(other));
      normals.push_back(all[h]);
      const auto p = mesh.point(v(1, i));
      tangents.emplace_back(-p.y(), p.x(), 0);
    }
  }

  std::vector<Kernel::Vector_3> normals, tangents;
};

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
    PN::estimate_corner_normals(bar.mesh, bar.sharp, normals, CGAL::parameters::default_values(),
                                how);
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

// The reciprocal normals at the end of the plane lean towards the fillet, and by arcs those at its rim would, too.
TEST(Creases_joints, PlanesBetweenRimAndFillet)
{
  for (const auto& n : Rim(0, Control_normal_estimate::coherent).normals)
    EXPECT_LE((n - Kernel::Vector_3(0, 0, 1)).squared_length(), 256 * ulp * ulp);
  for (const auto& n : Rim(0, Control_normal_estimate::reciprocal).normals)
    EXPECT_GE((n - Kernel::Vector_3(0, 0, 1)).squared_length(), 0.01);
}

TEST(Creases_joints, NormalsAreOrthogonalToTheRim)
{
  const Rim rim(0.3, Control_normal_estimate::coherent);
  for (std::size_t i = 0; i < rim.normals.size(); ++i)
    EXPECT_LE(std::abs(rim.normals[i] * rim.tangents[i]), 64 * ulp);
}
