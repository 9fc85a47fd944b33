// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_INTERNAL_LEVEL_SHAPE_H
#define CGAL_PN_CERTIFICATES_3_INTERNAL_LEVEL_SHAPE_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Points in double that are compared: relative to a point of the control mesh, divided by a power of two that is
// about its size, so that neither far places nor large or small numbers cost digits.
template <class FT>
class Unit_frame
{
  using Wide = Wide_number<FT>;
  using Wide_point = Coordinates<Wide, 3>;

public:
  using Points = std::vector<Coordinates<double, 3>>;

  explicit Unit_frame(const std::vector<Coordinates<FT, 3>>& control)
    : origin_(control.empty() ? zero_vector<Wide, 3>() : wide(control.front()))
  {
    double size = 0;
    for (const Coordinates<double, 3>& p : (*this)(control))
      for (const double x : p) size = (std::max)(size, std::abs(x));
    if (size > 0 && std::isfinite(size)) exponent_ = std::ilogb(size) + 1;
    double farthest = 0;
    for (const Wide& x : origin_) farthest = (std::max)(farthest, std::abs(close_double(x)));
    const double epsilon = (std::max)(close_double(machine_epsilon<FT>()), 0x1p-53);
    if (is_exact_v<FT>) farthest = 0; // only what is relative to the origin is rounded
    rounding_ = epsilon * (1 + std::ldexp(farthest, -exponent_));
  }

  Points operator()(const std::vector<Coordinates<FT, 3>>& points) const
  {
    Points result;
    result.reserve(points.size());
    for (const Coordinates<FT, 3>& p : points) {
      result.push_back(to_double_3(difference<Wide, 3>(wide(p), origin_)));
      for (double& x : result.back()) x = std::ldexp(x, -exponent_);
    }
    return result;
  }

  // of coordinates here
  double rounding() const { return rounding_; }
  // the power of two that coordinates are divided by
  int exponent() const { return exponent_; }

private:
  static Wide_point wide(const Coordinates<FT, 3>& p)
  {
    return {Wide(p[0]), Wide(p[1]), Wide(p[2])};
  }

  Wide_point origin_;
  int exponent_ = 0;
  double rounding_ = 0;
};

// What is measured of a level whose points are in a Unit_frame. A polygon is taken as triangles round its mean.
class Level_shape
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  // is_sharp: of edges, or empty
  Level_shape(Level_connectivity level, std::vector<Vector> points, std::vector<bool> is_sharp,
              double rounding)
    : level_(std::move(level))
    , points_(std::move(points))
    , is_sharp_(std::move(is_sharp))
    , rounding_(rounding)
  {
    areas_.reserve(level_.number_of_faces());
    for (Index f = 0; f < level_.number_of_faces(); ++f) add_face(f);
  }

  const Level_connectivity& level() const { return level_; }
  const std::vector<Vector>& points() const { return points_; }
  bool is_closed() const { return level_.number_of_faces() > 0 && !level_.has_border(); }
  // of a closed level; 0 if it is no more than rounding
  double volume() const
  {
    return std::abs(volume_) <= 1e-13 * volume_terms_ + rounding_ * area_ ? 0 : volume_;
  }

  // Edges that are not sharp, at which two faces with an area meet at an angle greater than this, which has a cosine, by more
  // than what rounding makes of rectangular ones.
  std::size_t edges_beyond(double cosine) const { return folds_beyond(cosine).edges; }
  struct Folds
  {
    std::size_t edges = 0;
    double length = 0; // in all
  };
  Folds folds_beyond(double cosine) const
  {
    constexpr double margin = 1e-10;
    Folds folds;
    for (Index e = 0; e < level_.number_of_edges(); ++e) {
      if (level_.is_border_edge(e) || (!is_sharp_.empty() && is_sharp_[e])) continue;
      const Vector &m = areas_[level_.face(2 * e)], &n = areas_[level_.face(2 * e + 1)];
      if (!(dot<double, 3>(m, n) < (cosine - margin) * quick_length(m) * quick_length(n))) continue;
      ++folds.edges;
      folds.length += quick_length(
        difference<double, 3>(points_[level_.source(2 * e)], points_[level_.target(2 * e)]));
    }
    return folds;
  }

  // of each vertex the mean length of its edges, 0 without edges
  std::vector<double> edge_lengths() const
  {
    std::vector<double> sum(points_.size(), 0.);
    std::vector<std::size_t> valence(points_.size(), 0);
    for (Index h = 0; h < level_.number_of_halfedges(); ++h) {
      const Index v = level_.target(h);
      sum[v] += quick_length(difference<double, 3>(points_[level_.source(h)], points_[v]));
      ++valence[v];
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
      if (valence[v] > 0) sum[v] /= double(valence[v]);
    return sum;
  }

private:
  void add_face(Index f)
  {
    const Index first = level_.halfedge_of_face(f);
    Vector mean{0, 0, 0};
    double degree = 0;
    Index h = first;
    do {
      add_multiple<double, 3>(mean, 1., points_[level_.target(h)]);
      ++degree;
      h = level_.next(h);
    } while (h != first);
    mean = quotient(mean, degree);
    Vector area{0, 0, 0}, before = difference<double, 3>(points_[level_.target(first)], mean);
    double noise = 0;
    do {
      h = level_.next(h);
      const Vector corner = difference<double, 3>(points_[level_.target(h)], mean);
      add_multiple<double, 3>(area, 0.5, cross(before, corner));
      const double r = quick_length(corner);
      noise += r * (0x1p-46 * r + 2 * rounding_);
      before = corner;
    } while (h != first);
    const double size = quick_length(area);
    volume_ += dot<double, 3>(mean, area) / 3;
    volume_terms_ += quick_length(mean) * size;
    area_ += size;
    areas_.push_back(size <= noise ? Vector{0, 0, 0} : quotient(area, size));
  }

  Level_connectivity level_;
  std::vector<Vector> points_;
  std::vector<bool> is_sharp_;
  double rounding_;
  std::vector<Vector> areas_; // their directions, 0 of faces without area
  double volume_ = 0, volume_terms_ = 0, area_ = 0;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CERTIFICATES_3_INTERNAL_LEVEL_SHAPE_H
