// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Curvatures estimated on samples of surfaces whose curvatures are known, and what holds of them.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_ESTIMATED_CURVATURES_H
#define CGAL_PN_SUBDIVISION_3_TEST_ESTIMATED_CURVATURES_H

#include "Curved_surfaces.h"

#include <CGAL/PN_limit_surface_3/estimate_curvature.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace estimated_curvatures {

using namespace curved_surfaces;
using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Curvature = PN::Vertex_curvature<Kernel>;
using Curvatures = std::vector<Curvature>;

template <class Map, class Any_mesh>
auto all_of(const Any_mesh& mesh, Map map)
{
  std::vector<typename boost::property_traits<Map>::value_type> result;
  for (auto v : vertices(mesh)) result.push_back(get(map, v));
  return result;
}

inline Mesh mesh_of(const Soup& soup)
{
  Mesh mesh;
  build(soup, mesh);
  return mesh;
}

template <class Tag = CGAL::Sequential_tag>
Curvatures from_points(Mesh mesh)
{
  const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
  PN::estimate_curvature<Tag>(mesh, c);
  return all_of(mesh, c);
}

inline Curvatures from_points(const Soup& soup)
{
  return from_points(mesh_of(soup));
}

template <class Tag = CGAL::Sequential_tag>
Curvatures from_normals(const Soup& soup, const std::vector<Triple>& normals)
{
  Mesh mesh = mesh_of(soup);
  const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
  const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
  put_normals(normals, mesh, n);
  PN::estimate_curvature<Tag>(mesh, c, CGAL::parameters::vertex_normal_map(n));
  return all_of(mesh, c);
}

inline std::vector<Triple> normals_of(const Sampled_surface& s)
{
  std::vector<Triple> normals;
  for (const Surface_point& p : s.exact) normals.push_back(p.normal);
  return normals;
}

inline Triple triple(const Kernel::Vector_3& v)
{
  return {v.x(), v.y(), v.z()};
}

inline double dot(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Triple cross(const Triple& a, const Triple& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// What holds of every result, whatever the surface.
inline void expect_consistent(const Curvature& c)
{
  ASSERT_TRUE(c.is_estimated);
  const double size = std::abs(c.minimal) + std::abs(c.maximal);
  EXPECT_LE(c.minimal, c.maximal);
  EXPECT_NEAR(c.mean, (c.minimal + c.maximal) / 2, 1e-14 * size);
  EXPECT_NEAR(c.gaussian, c.minimal * c.maximal, 1e-13 * size * size);
  EXPECT_NEAR(c.minimal_direction.squared_length(), 1, 1e-14);
  EXPECT_NEAR(c.maximal_direction.squared_length(), 1, 1e-14);
  EXPECT_NEAR(c.minimal_direction * c.maximal_direction, 0, 1e-14);
}

// The largest error of Gaussian and mean curvature, the latter times 2.
inline double error(const Curvatures& c, const Sampled_surface& s)
{
  double largest = 0;
  for (std::size_t v = 0; v < c.size(); ++v) {
    expect_consistent(c[v]);
    const double e = (std::max)(std::abs(c[v].gaussian - s.exact[v].gaussian),
                                2 * std::abs(c[v].mean - s.exact[v].mean));
    largest = (std::max)(largest, e);
  }
  return largest;
}

} // namespace estimated_curvatures

#endif // CGAL_PN_SUBDIVISION_3_TEST_ESTIMATED_CURVATURES_H
