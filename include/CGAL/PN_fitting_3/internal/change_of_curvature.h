// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_CHANGE_OF_CURVATURE_H
#define CGAL_PN_FITTING_3_INTERNAL_CHANGE_OF_CURVATURE_H

#include <CGAL/PN_fitting_3/internal/Ring_limit_functionals.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The mean of |grad H| over triangles, but for those at vertices that do not count: H by cotangents (Meyer, Desbrun,
// Schroeder and Barr), with a third of the area of each triangle.
inline double mean_change_of_curvature(const Vectors<3>& points,
                                       const std::vector<std::array<std::size_t, 3>>& triangles,
                                       std::vector<bool> counts)
{
  using Vector = Eigen_vector<3>;
  Vectors<3> flow(points.size(), Vector::Zero()), normal = flow;
  std::vector<double> area(points.size(), 0), mean(points.size(), 0);
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      const Vector u = points[a] - points[c], v = points[b] - points[c], n = u.cross(v);
      if (!(n.norm() > 0)) continue;
      const Vector f = u.dot(v) / n.norm() / 2 * (points[a] - points[b]);
      flow[a] += f;
      flow[b] -= f;
      area[c] += n.norm() / 6;
      normal[c] += n;
    }
  for (std::size_t v = 0; v < points.size(); ++v) {
    mean[v] = flow[v].dot(normal[v].normalized()) / area[v] / 2;
    if (!std::isfinite(mean[v])) counts[v] = false;
  }
  double sum = 0, all = 0;
  for (const auto& t : triangles) {
    if (!counts[t[0]] || !counts[t[1]] || !counts[t[2]]) continue;
    const Vector u = points[t[1]] - points[t[0]], v = points[t[2]] - points[t[0]];
    sum += ((mean[t[2]] - mean[t[0]]) * u - (mean[t[1]] - mean[t[0]]) * v).norm();
    all += u.cross(v).norm();
  }
  return all > 0 ? sum / all : std::numeric_limits<double>::infinity();
}

// The mean angle between faces that share an edge, in radians.
inline double mean_turn(const Level_connectivity& level, const Vectors<3>& points)
{
  using Index = Level_connectivity::Index;
  Vectors<3> areas;
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    areas.push_back(Eigen_vector<3>::Zero());
    for_each_halfedge_of_face(level, f, [&](Index h) {
      const auto& origin = points[level.target(level.halfedge_of_face(f))];
      areas[f] += (points[level.source(h)] - origin).cross(points[level.target(h)] - origin);
    });
    areas[f].normalize();
  }
  double sum = 0, number = 0;
  for (Index e = 0; e < level.number_of_edges(); ++e)
    if (!level.is_border_edge(e)) {
      const auto &a = areas[level.face(2 * e)], &b = areas[level.face(2 * e + 1)];
      sum += std::atan2(a.cross(b).norm(), a.dot(b));
      ++number;
    }
  return number > 0 ? sum / number : 0;
}

struct Fairness
{
  double change_of_curvature, mean_turn;
};

// Of the surface after two rounds. Of each quad both pairs of triangles count.
template <class Scheme_>
Fairness fairness(const Scheme_& rules, const Level_connectivity& control, const Vectors<3>& points,
                  const Vectors<3>& normals, double roundness)
{
  using Index = Level_connectivity::Index;
  using Scheme = With_roundness<Scheme_, double>;
  using Refiner = Level_refiner<Scheme, Average_of_scheme<Scheme, double>>;
  using Value = Point_normal<double, 3>;
  const Scheme scheme{{rules}};
  typename Refiner::Values values;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const auto &p = points[v], &n = normals[v];
    Value value;
    value.point = {p[0], p[1], p[2]};
    value.normal = {n[0], n[1], n[2]};
    value.roundness = roundness;
    values.push_back(value);
  }
  Refiner refiner(scheme, Level_connectivity(control), std::move(values));
  for (int k = 0; k < 2; ++k) refiner.refine();
  const Level_connectivity& level = refiner.level();
  Vectors<3> refined;
  std::vector<bool> counts;
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    const Value value = refiner.values()[v];
    refined.emplace_back(value.point[0], value.point[1], value.point[2]);
    counts.push_back(!level.is_isolated(v) && !level.is_border_vertex(v));
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    std::array<Index, 4> c;
    Index h = level.halfedge_of_face(f);
    for (Index& v : c) {
      v = level.target(h);
      h = level.next(h);
    }
    const std::size_t number = c[3] == c[0] ? 1 : 4;
    for (std::size_t i = 0; i < number; ++i)
      triangles.push_back({c[i], c[(i + 1) % 4], c[(i + 2) % 4]});
  }
  return {mean_change_of_curvature(refined, triangles, std::move(counts)),
          mean_turn(level, refined)};
}

// by Loop or Catmull-Clark subdivision
inline Fairness fairness(const Level_connectivity& level, const Vectors<3>& points,
                         const Vectors<3>& normals, double roundness = 1)
{
  bool triangles = true;
  for (Level_connectivity::Index f = 0; f < level.number_of_faces() && triangles; ++f)
    triangles = level.has_degree(level.halfedge_of_face(f), 3);
  return triangles ? fairness(Loop_scheme(), level, points, normals, roundness)
                   : fairness(CatmullClark_scheme(), level, points, normals, roundness);
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_CHANGE_OF_CURVATURE_H
