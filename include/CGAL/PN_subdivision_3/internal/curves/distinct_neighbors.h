// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_DISTINCT_NEIGHBORS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_DISTINCT_NEIGHBORS_H

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// the points of a polygon without those that repeat their predecessor, and for each point of the
// polygon its position among them
template <class Point>
std::pair<std::vector<Point>, std::vector<std::size_t>>
distinct_neighbors(const std::vector<Point>& points, bool closed)
{
  std::vector<Point> distinct;
  std::vector<std::size_t> position;
  for (const Point& p : points) {
    if (distinct.empty() || p != distinct.back()) distinct.push_back(p);
    position.push_back(distinct.size() - 1);
  }
  if (closed && distinct.size() > 1 && distinct.front() == distinct.back()) {
    distinct.pop_back();
    for (std::size_t& i : position) i %= distinct.size();
  }
  return {std::move(distinct), std::move(position)};
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVES_DISTINCT_NEIGHBORS_H
