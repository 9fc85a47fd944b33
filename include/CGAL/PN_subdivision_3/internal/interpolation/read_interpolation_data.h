// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_READ_INTERPOLATION_DATA_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_READ_INTERPOLATION_DATA_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Interpolation_data.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/refuse_creases.h>
#include <CGAL/PN_subdivision_3/schemes/normal_estimate.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Refuses what is sharp in a mesh, by its name.
template <class Scheme, class Access, class Edge_map, class Vertex_map>
void refuse_interpolated_creases(const Scheme& scheme, const Access& access,
                                 const Level_connectivity& level, Edge_map edge_map,
                                 Vertex_map vertex_map)
{
  refuse_sharp_elements(scheme, access, level, edge_map, vertex_map,
                        [](const std::string& element) {
                          throw std::invalid_argument(
                            "PN_subdivision_3: " + element +
                            " is sharp, but interpolation is for surfaces without creases: make "
                            "all edges and vertices smooth");
                        });
}

// Points and normals of a mesh in double. Without a map the normals are estimated.
template <class FT, class Scheme, class Access, class Point_map, class Normal_map>
Interpolation_data<3> read_points_and_normals(const Access& access, const Scheme& scheme,
                                              const Level_connectivity& level, Point_map points,
                                              Normal_map normals)
{
  const auto values =
    read_values<PN_average<FT, 3>>(access, level, points, normals, normal_estimate(scheme));
  Interpolation_data<3> data;
  for (const auto& value : values) {
    data.points.push_back(to_eigen<3>(to_double_3(value.point)));
    data.normals.push_back(to_eigen<3>(to_double_3(value.normal)));
  }
  divide_by_size(data);
  return data;
}

// estimates the normals that are zero
inline void estimate_missing_normals(const Level_connectivity& level,
                                     Control_normal_estimate estimate, Interpolation_data<3>& data)
{
  const auto is_missing = [](const Eigen_vector<3>& n) { return n.isZero(0); };
  if (std::none_of(data.normals.begin(), data.normals.end(), is_missing)) return;
  auto values = to_values<3>(data.points, data.normals, true);
  estimate_normals<double>(level, estimate, Point_of_value<double>{values.data()},
                           Set_normal_of_value<double>{values.data()});
  for (std::size_t v = 0; v < values.size(); ++v)
    if (is_missing(data.normals[v])) data.normals[v] = to_eigen<3>(values[v].normal);
}

// where the border is, and how long the edges are
inline void set_surroundings(const Level_connectivity& level, Interpolation_data<3>& data)
{
  using Index = Level_connectivity::Index;
  const Index n = level.number_of_vertices();
  data.is_at_border.assign(n, 0);
  data.edge_length.assign(n, 0.);
  for (Index v = 0; v < n; ++v) {
    if (level.is_isolated(v)) continue;
    data.is_at_border[v] = level.is_border_vertex(v) ? 1 : 0;
    unsigned edges = 0;
    level.for_each_neighbor(level.halfedge_of_vertex(v), [&](Index w) {
      data.edge_length[v] += (data.points[w] - data.points[v]).norm();
      ++edges;
    });
    data.edge_length[v] /= edges;
  }
}

// the largest angle between the normals of neighbors, in degrees
inline double largest_normal_angle(const Level_connectivity& level, const Vectors<3>& normals)
{
  using Index = Level_connectivity::Index;
  double least = 1;
  for (Index e = 0; e < level.number_of_edges(); ++e) {
    const Eigen_vector<3>& a = normals[level.target(2 * e)];
    const Eigen_vector<3>& b = normals[level.target(2 * e + 1)];
    if (!a.isZero(0) && !b.isZero(0)) least = (std::min)(least, a.dot(b));
  }
  return std::acos((std::max)(-1., least)) * 57.29577951308232;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_READ_INTERPOLATION_DATA_H
