// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SURFACE_REFINER_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_SURFACE_REFINER_CASES_H

#include "Mesh_cases.h"

#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace surface_refiner_cases {

using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

// n x n unit quads over the plane, wavy
inline Mesh grid(std::size_t n)
{
  Soup soup;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      soup.points.push_back(
        {double(i), double(j), 0.3 * std::sin(1.3 * double(i)) * std::cos(double(j))});
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t v = j * (n + 1) + i;
      soup.faces.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  Mesh mesh;
  build(soup, mesh, mesh.points());
  return mesh;
}

inline Soup united(Soup a, const Soup& b)
{
  const std::size_t n = a.points.size();
  for (const Triple& p : b.points) a.points.push_back({p[0] + 9, p[1], p[2]});
  for (Polygon f : b.faces) {
    for (std::size_t& v : f) v += n;
    a.faces.push_back(f);
  }
  return a;
}

// a component with a border, a closed one, and a vertex without edges
inline Soup quads_and_others()
{
  Soup soup = united(mixed_with_border(), cube());
  soup.points.push_back({0, 0, 20});
  return soup;
}
inline Soup triangles()
{
  Soup soup = united(triangles_with_border(), tetrahedron());
  soup.points.push_back({0, 0, 20});
  return soup;
}

// uneven ones, one of them missing
inline auto add_normals(Mesh& mesh)
{
  auto normals = mesh.add_property_map<Vertex, Vector>("n").first;
  for (Vertex v : mesh.vertices())
    normals[v] = v.idx() == 5 ? Vector(0, 0, 0)
                              : Vector(0.3 * std::sin(double(v.idx())), 0.1 * (v.idx() % 3), 1);
  return normals;
}

// Moves points and turns normals at random, one, several and all, and compares points and normals
// with those of subdivide(), bit by bit.
template <class Scheme>
void expect_as_subdivide(const Soup& soup, const Scheme& scheme, unsigned rounds)
{
  Mesh control;
  build(soup, control, control.points());
  auto normals = add_normals(control);
  PN::Surface_refiner refiner(control, scheme,
                              params::number_of_iterations(rounds).vertex_normal_map(normals));
  std::mt19937 generator(1);
  std::uniform_real_distribution<> number(-0.3, 0.3);
  const std::size_t n = control.number_of_vertices();
  for (const std::size_t changes : {std::size_t(0), std::size_t(1), std::size_t(2), n}) {
    std::vector<Point> old_points = refiner.points();
    for (std::size_t i = 0; i < changes; ++i) {
      const Vertex v(static_cast<unsigned>(changes == n ? i : generator() % n));
      control.point(v) += Vector(number(generator), number(generator), number(generator));
      refiner.set_point(v, control.point(v));
      if (i % 2 == 1) continue;
      normals[v] = Vector(number(generator), 0.2, 1 + number(generator));
      refiner.set_normal(v, normals[v]);
    }
    const auto changed = refiner.update();
    Mesh refined = control;
    auto refined_normals = refined.property_map<Vertex, Vector>("n").first;
    PN::subdivide(refined, scheme,
                  params::number_of_iterations(rounds).vertex_normal_map(refined_normals));
    ASSERT_EQ(refiner.number_of_vertices(), refined.number_of_vertices());
    EXPECT_EQ(refiner.number_of_faces(), refined.number_of_faces());
    std::vector<bool> is_changed(refined.number_of_vertices(), false);
    for (auto v : changed) is_changed[v] = true;
    for (Vertex v : refined.vertices()) {
      EXPECT_EQ(refiner.points()[v], refined.point(v)) << v << " after " << changes;
      EXPECT_EQ(refiner.normals()[v], refined_normals[v]) << v << " after " << changes;
      if (is_changed[v]) continue;
      EXPECT_EQ(refiner.points()[v], old_points[v]) << v << " after " << changes;
    }
  }
}

} // namespace surface_refiner_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_SURFACE_REFINER_CASES_H
