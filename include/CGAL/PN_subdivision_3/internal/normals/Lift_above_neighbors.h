// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_LIFT_ABOVE_NEIGHBORS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_LIFT_ABOVE_NEIGHBORS_H

#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/roundness.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// How far a round would lift the new point of a vertex above its tangent plane and all its neighbors,
// or below them all: not at all on spheres, cylinders and whatever bends like them. But where a large
// plane ends in short bevels, the linear point slides far along the plane, the new normal tilts a
// little, by the normals of the bevels, and the point leaves the plane by the tilt times the way: thin
// plates swell. The weights are those of a regular vertex of Loop's scheme, near those of Catmull-Clark.
class Lift_above_neighbors
{
public:
  using Vector = Coordinates<double, 3>;

  static constexpr double least_unevenness = 4; // the longest edge over the shortest one

  void clear() { neighbors_.clear(); }
  // the edge to a neighbor, of positive length, and the neighbor's normal
  void add(const Vector& edge, const Vector& normal) { neighbors_.push_back({edge, normal}); }

  // what is left of the roundness of the vertex
  double share(const Vector& normal) const
  {
    const double x = excess(normal);
    return x > 0 ? 1 - smooth_window(x, 0.5, 1) : 1;
  }

private:
  struct Neighbor
  {
    Vector edge, normal;
  };

  static constexpr double weight_of_neighbors = 3 / 8.;

  // in lengths of the shortest edge, times what the longest one is longer than four of that
  double excess(const Vector& normal) const
  {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (const Neighbor& j : neighbors_) {
      const double squared = dot<double, 3>(j.edge, j.edge);
      shortest = (std::min)(shortest, squared);
      longest = (std::max)(longest, squared);
    }
    shortest = std::sqrt(shortest);
    const double unevenness = std::sqrt(longest) / shortest - least_unevenness;
    return unevenness > 0 ? excess_in_length(normal) / shortest * unevenness : 0;
  }

  double excess_in_length(const Vector& normal) const
  {
    const double own = 1 - weight_of_neighbors,
                 each = weight_of_neighbors / double(neighbors_.size());
    Vector slide{0, 0, 0}, n = multiple(own, normal);
    double lowest = 0, highest = 0;
    for (const Neighbor& j : neighbors_) {
      add_multiple<double, 3>(slide, each, j.edge);
      add_multiple<double, 3>(n, each, j.normal);
      const auto height = dot<double, 3>(normal, j.edge);
      lowest = (std::min)(lowest, height);
      highest = (std::max)(highest, height);
    }
    n = quotient(n, quick_length(n)); // at least a quarter
    double lift = own * arc_height(normal, {0, 0, 0}, slide, n);
    for (const Neighbor& j : neighbors_) lift += each * arc_height(j.normal, j.edge, slide, n);
    const double height = dot<double, 3>(normal, slide) + lift * dot<double, 3>(normal, n);
    return (std::max)(height - highest, lowest - height);
  }

  std::vector<Neighbor> neighbors_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_LIFT_ABOVE_NEIGHBORS_H
