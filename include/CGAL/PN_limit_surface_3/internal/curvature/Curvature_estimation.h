// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATION_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATION_H

#include <CGAL/PN_limit_surface_3/internal/curvature/Curvature_fit.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// What is known of the vertices of a mesh. A normal is a unit vector or zero.
struct Curvature_data
{
  using Index = Level_connectivity::Index;

  struct Vertex
  {
    Eigen::Vector3d point, normal;
  };

  // the normal of the plane of the fit
  const Eigen::Vector3d& frame_normal(Index v) const
  {
    return fits_normals && vertices[v].normal.isZero(0) ? face_normals[v] : vertices[v].normal;
  }

  Level_connectivity level;
  std::vector<Vertex> vertices;
  bool fits_normals =
    false; // otherwise normals come from the faces, and only tell the sides of the surface apart
  std::vector<Eigen::Vector3d> face_normals; // where normals are fitted
};

// The vertices in an order in which near ones follow each other: in a refined mesh those of old vertices, edges and faces
// have numbers far apart, and what looks at one after the other waits for memory most of the time.
inline std::vector<Level_connectivity::Index> order_by_faces(const Level_connectivity& level)
{
  using Index = Level_connectivity::Index;
  std::vector<Index> order;
  std::vector<char> is_listed(level.number_of_vertices(), 0);
  const auto add = [&](Index v) {
    if (is_listed[v] == 0) order.push_back(v);
    is_listed[v] = 1;
  };
  for (Index f = 0; f < level.number_of_faces(); ++f)
    for_each_halfedge_of_face(level, f, [&](Index h) { add(level.target(h)); });
  for (Index v = 0; v < level.number_of_vertices(); ++v) add(v);
  return order;
}

// The curvatures at one vertex after the other. The neighborhood of a vertex grows by rings, each
// the vertices that share a face with the ring before, until a cubic is determined; where none is,
// a quadric is taken.
class Curvature_estimation
{
public:
  using Index = Level_connectivity::Index;

  explicit Curvature_estimation(const Curvature_data& data)
    : data_(data)
  {}

  Principal_curvatures operator()(Index v)
  {
    const Eigen::Vector3d& normal = data_.frame_normal(v);
    if (data_.level.is_isolated(v) || normal.isZero(0)) return {};
    takes_normals_ = data_.fits_normals && !data_.vertices[v].normal.isZero(0);
    for (int degree : {3, 2}) {
      start(v);
      while (number_of_rings_ < max_rings && grow(normal)) {
        if (neighbors_.size() < least_number_of_neighbors(degree)) continue;
        const double scale = set_samples(v, normal);
        if (scale > 0 && (takes_normals_ ? fit_.fit_normals(samples_, normal, degree)
                                         : fit_.fit(samples_, normal, degree)))
          return fit_.curvatures(scale);
      }
    }
    return {};
  }

private:
  static constexpr int max_rings = 4;
  static constexpr double least_weight = 1. / 16; // 151 degrees

  // Without normals somewhat more equations than unknowns; with them there are three a neighbor.
  std::size_t least_number_of_neighbors(int degree) const
  {
    if (takes_normals_) return degree == 3 ? 3 : 2;
    return degree == 3 ? 12 : 6;
  }

  void start(Index v)
  {
    vertex_ = v;
    neighbors_.clear();
    ring_.assign(1, v);
    number_of_rings_ = 0;
  }

  // Adds a ring; false if it is empty. What faces the other way belongs to another part of the
  // surface and is not entered.
  bool grow(const Eigen::Vector3d& normal)
  {
    next_ring_.clear();
    for (Index v : ring_) add_face_neighbors(v);
    std::sort(next_ring_.begin(), next_ring_.end());
    next_ring_.erase(std::unique(next_ring_.begin(), next_ring_.end()), next_ring_.end());
    const auto is_known_or_behind = [&](Index v) {
      return v == vertex_ || std::binary_search(neighbors_.begin(), neighbors_.end(), v) ||
             weight(v, normal) <= (takes_normals_ ? least_weight : 0);
    };
    next_ring_.erase(std::remove_if(next_ring_.begin(), next_ring_.end(), is_known_or_behind),
                     next_ring_.end());
    const auto old_size = static_cast<std::ptrdiff_t>(neighbors_.size());
    neighbors_.insert(neighbors_.end(), next_ring_.begin(), next_ring_.end());
    std::inplace_merge(neighbors_.begin(), neighbors_.begin() + old_size, neighbors_.end());
    ring_.swap(next_ring_);
    ++number_of_rings_;
    return !ring_.empty();
  }

  void add_face_neighbors(Index v)
  {
    const Level_connectivity& level = data_.level;
    for_each_halfedge_to(level, v, [&](Index h) { // the one after h has the edge of the next one
      next_ring_.push_back(level.source(h));
      if (!level.is_border(h))
        for (Index g = level.next(level.next(h)); level.next(g) != h; g = level.next(g))
          next_ring_.push_back(level.target(g));
    });
  }

  // The cosine of the angle to the normal; where normals are fitted, which tell also what is steep, the square of that of
  // half the angle.
  double weight(Index v, const Eigen::Vector3d& normal) const
  {
    const Eigen::Vector3d& n = data_.vertices[v].normal;
    if (n.isZero(0)) return 1;
    return takes_normals_ ? (1 + n.dot(normal)) / 2 : n.dot(normal);
  }

  // Lengths are divided by the largest coordinate, which is returned.
  double set_samples(Index v, const Eigen::Vector3d& normal)
  {
    double scale = 0;
    samples_.clear();
    for (Index w : neighbors_) {
      const Eigen::Vector3d offset = data_.vertices[w].point - data_.vertices[v].point;
      samples_.push_back({offset, fitted_normal(w), weight(w, normal)});
      scale = (std::max)(scale, offset.lpNorm<Eigen::Infinity>());
    }
    for (Curvature_sample& s : samples_) s.offset *= 1 / scale;
    samples_.push_back({Eigen::Vector3d::Zero(), fitted_normal(v), 1});
    return scale;
  }

  Eigen::Vector3d fitted_normal(Index v) const
  {
    return takes_normals_ ? data_.vertices[v].normal : Eigen::Vector3d::Zero();
  }

  const Curvature_data& data_;
  Curvature_fit fit_;
  Index vertex_ = 0;
  bool takes_normals_ = false; // the vertex has a normal, which is fitted, too
  int number_of_rings_ = 0;
  std::vector<Index> neighbors_, ring_, next_ring_; // without the vertex; `neighbors_` is sorted
  std::vector<Curvature_sample> samples_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATION_H
