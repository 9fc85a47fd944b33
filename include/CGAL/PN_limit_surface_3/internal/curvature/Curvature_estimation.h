// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATION_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATION_H

#include <CGAL/PN_limit_surface_3/internal/curvature/Curvature_data.h>
#include <CGAL/PN_limit_surface_3/internal/curvature/Curvature_fit.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

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
    const Eigen::Vector3d normal = frame_normal(v);
    if (data_.level.is_isolated(v) || normal.isZero(0)) return {};
    takes_normals_ = data_.fits_normals && !vector(data_.vertices[v].normal).isZero(0);
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

  static Eigen::Vector3d vector(const Coordinates<double, 3>& c) { return {c[0], c[1], c[2]}; }

  Eigen::Vector3d frame_normal(Index v) const
  {
    const Eigen::Vector3d own = vector(data_.vertices[v].normal);
    return own.isZero(0) && data_.fits_normals ? vector(data_.face_normals[v]) : own;
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
    const auto is_before = [&](Index v, Index w) { return data_.is_before(v, w); };
    next_ring_.clear();
    for (Index v : ring_) add_face_neighbors(v);
    std::sort(next_ring_.begin(), next_ring_.end(), is_before);
    next_ring_.erase(std::unique(next_ring_.begin(), next_ring_.end()), next_ring_.end());
    const auto is_known_or_behind = [&](Index v) {
      return v == vertex_ ||
             std::binary_search(neighbors_.begin(), neighbors_.end(), v, is_before) ||
             weight(v, normal) <= (takes_normals_ ? least_weight : 0);
    };
    next_ring_.erase(std::remove_if(next_ring_.begin(), next_ring_.end(), is_known_or_behind),
                     next_ring_.end());
    const auto old_size = static_cast<std::ptrdiff_t>(neighbors_.size());
    neighbors_.insert(neighbors_.end(), next_ring_.begin(), next_ring_.end());
    std::inplace_merge(neighbors_.begin(), neighbors_.begin() + old_size, neighbors_.end(),
                       is_before);
    ring_.swap(next_ring_);
    ++number_of_rings_;
    return !ring_.empty();
  }

  void add_face_neighbors(Index v)
  {
    const Level_connectivity& level = data_.level;
    const Index first = level.halfedge_of_vertex(v);
    Index h = first;
    do {
      if (!level.is_border(h))
        for (Index g = level.next(h); g != h; g = level.next(g))
          next_ring_.push_back(level.target(g));
      h = level.next_around_target(h);
    } while (h != first);
  }

  // The cosine of the angle to the normal; where normals are fitted, which tell also what is steep, the square of that of
  // half the angle.
  double weight(Index v, const Eigen::Vector3d& normal) const
  {
    const Eigen::Vector3d n = vector(data_.vertices[v].normal);
    if (n.isZero(0)) return 1;
    return takes_normals_ ? (1 + n.dot(normal)) / 2 : n.dot(normal);
  }

  // Lengths are divided by the mean distance of the neighbors, which is returned.
  double set_samples(Index v, const Eigen::Vector3d& normal)
  {
    const Eigen::Vector3d center = vector(data_.vertices[v].point);
    double scale = 0;
    samples_.clear();
    for (Index w : neighbors_) {
      const Eigen::Vector3d offset = vector(data_.vertices[w].point) - center;
      samples_.push_back({offset, fitted_normal(w), weight(w, normal)});
      scale += offset.stableNorm() / static_cast<double>(neighbors_.size());
    }
    for (Curvature_sample& s : samples_) s.offset /= scale;
    samples_.push_back({Eigen::Vector3d::Zero(), fitted_normal(v), 1});
    return scale;
  }

  Eigen::Vector3d fitted_normal(Index v) const
  {
    return takes_normals_ ? vector(data_.vertices[v].normal) : Eigen::Vector3d::Zero();
  }

  const Curvature_data& data_;
  Curvature_fit fit_;
  Index vertex_ = 0;
  bool takes_normals_ = false; // it has one itself
  int number_of_rings_ = 0;
  std::vector<Index> neighbors_, ring_, next_ring_; // without the vertex; `neighbors_` is sorted
  std::vector<Curvature_sample> samples_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATION_H
