// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_SPREAD_OF_ARCS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_SPREAD_OF_ARCS_H

#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/roundness.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// How far the arcs from the corners of a face to the point over its middle miss each other: not at all on spheres and
// cylinders. Over a long and narrow face at the corner of a bevel they do by more than the face is wide, and
// the new point would fold it.
class Spread_of_arcs
{
public:
  using Vector = Coordinates<double, 3>;

  void clear()
  {
    corners_.clear();
    last_ = Vector{0, 0, 0};
    longest_ = 0;
  }

  // the edge to a corner, from the one before, and the corner's normal
  void add(const Vector& edge, const Vector& normal)
  {
    add_multiple<double, 3>(last_, 1., edge);
    corners_.push_back({last_, normal, dot<double, 3>(edge, edge), 0});
    longest_ = (std::max)(longest_, corners_.back().squared_edge);
  }

  // what is left of the roundness of the corners
  double share()
  {
    const double shortest = squared_width(), uneven = share_of_uneven(longest_, shortest);
    return uneven > 0 ? 1 - smooth_window(uneven * mean_error() / std::sqrt(shortest), 0.2, 0.4)
                      : 1;
  }

private:
  struct Corner
  {
    Vector point, normal;
    double squared_edge; // to here
    double height;       // of the arc from here over the middle
  };

  // that of the shortest edge, or of what points that coincide may miss each other by
  double squared_width() const
  {
    double shortest = longest_;
    for (const Corner& c : corners_) shortest = (std::min)(shortest, c.squared_edge);
    return (std::max)(shortest, 0x1p-20 * longest_);
  }

  // of the heights
  double mean_error()
  {
    const double weight = 1. / double(corners_.size());
    Vector q{0, 0, 0}, n{0, 0, 0};
    for (const Corner& c : corners_) {
      add_multiple<double, 3>(q, weight, c.point);
      add_multiple<double, 3>(n, weight, c.normal);
    }
    const double n_length = quick_length(n);
    if (!(n_length > 0)) return 0; // the new point is the linear one
    n = quotient(n, n_length);
    double mean = 0, error = 0;
    for (Corner& c : corners_) {
      c.height = arc_height(c.normal, c.point, q, n);
      mean += weight * c.height;
    }
    for (const Corner& c : corners_) error += weight * std::abs(c.height - mean);
    return error;
  }

  std::vector<Corner> corners_;
  Vector last_{0, 0, 0};
  double longest_ = 0; // squared
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_SPREAD_OF_ARCS_H
