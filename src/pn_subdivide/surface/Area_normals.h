// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_AREA_NORMALS_H
#define PN_SUBDIVIDE_AREA_NORMALS_H

#include "io/corner_normals.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pn_subdivide {

// The unit sums of the area vectors of the faces at vertices, or at wedges of vertices. They depend on the order
// in which faces are added, in their last bits.
class Area_normals
{
public:
  // scale: a power of 2, so that no product overflows or vanishes
  Area_normals(std::size_t number, double scale)
    : sums_(number, Triple{0, 0, 0})
    , scale_(scale)
  {}

  // The points of n corners, and the vertices or wedges at them: point(i), place(i).
  template <class Point, class Place>
  void add_face(std::size_t n, const Point& point, const Place& place)
  {
    const Triple area = twice_the_area(n, point);
    for (std::size_t i = 0; i < n; ++i) {
      Triple& sum = sums_[place(i)];
      for (std::size_t k = 0; k < 3; ++k) sum[k] += area[k];
    }
  }

  // zero where there is no area
  std::vector<Triple> take()
  {
    for (Triple& n : sums_) n = normalized(n);
    return std::move(sums_);
  }

private:
  template <class Point>
  Triple twice_the_area(std::size_t n, const Point& point) const
  {
    const auto from_to = [&](std::size_t i, std::size_t j) {
      Triple d = difference(point(j), point(i));
      for (double& x : d) x *= scale_;
      return d;
    };
    if (n == 4) return cross_product(from_to(0, 2), from_to(1, 3));
    Triple before = from_to(0, 2), area = cross_product(from_to(0, 1), before);
    for (std::size_t i = 3; i < n; ++i) {
      const Triple now = from_to(0, i), part = cross_product(before, now);
      for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
      before = now;
    }
    return area;
  }

  std::vector<Triple> sums_;
  double scale_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_AREA_NORMALS_H
