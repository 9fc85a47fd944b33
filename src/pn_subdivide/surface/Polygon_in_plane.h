// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_POLYGON_IN_PLANE_H
#define PN_SUBDIVIDE_POLYGON_IN_PLANE_H

#include "surface/Surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pn_subdivide {

// Vectors of which the largest component is between 1/2 and 1, by a power of two.
inline void scale_to_one(std::vector<Vector_3>& vectors)
{
  double largest = 0;
  for (const Vector_3& v : vectors)
    for (int i = 0; i < 3; ++i) largest = (std::max)(largest, std::abs(v[i]));
  int exponent;
  std::frexp(largest, &exponent);
  for (Vector_3& v : vectors)
    v = {std::ldexp(v.x(), -exponent), std::ldexp(v.y(), -exponent), std::ldexp(v.z(), -exponent)};
}

// A polygon seen against its area vector: turns are decided exactly, on two of the three coordinates; lengths,
// areas and the coordinates in the plane are numbers of its own scale.
class Polygon_in_plane
{
public:
  using Coordinates = std::array<double, 2>;

  explicit Polygon_in_plane(const std::vector<Point_3>& points)
  {
    for (const Point_3& p : points) at_.push_back(p - CGAL::ORIGIN);
    scale_to_one(at_);
    const std::vector<Vector_3> given = at_;
    for (Vector_3& v : at_) v -= given[0];
    scale_to_one(at_);
    project(given, normal());
  }

  std::size_t size() const { return at_.size(); }

  // positive if the corners turn left
  int turn(std::size_t i, std::size_t j, std::size_t k) const
  {
    return int(CGAL::orientation(exact_[i], exact_[j], exact_[k]));
  }
  // the coordinates of the exact turns, and those in the plane
  double x(std::size_t i) const { return exact_[i].x(); }
  double y(std::size_t i) const { return exact_[i].y(); }
  const Coordinates& in_plane(std::size_t i) const { return plane_[i]; }

  double squared_distance(std::size_t i, std::size_t j) const
  {
    return (at_[j] - at_[i]).squared_length();
  }
  double area(std::size_t i, std::size_t j, std::size_t k) const
  {
    return std::sqrt(CGAL::cross_product(at_[j] - at_[i], at_[k] - at_[i]).squared_length()) / 2;
  }

private:
  using Exact_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

  // The first point is the origin.
  Vector_3 normal() const
  {
    Vector_3 sum = CGAL::NULL_VECTOR, far = CGAL::NULL_VECTOR, widest = CGAL::NULL_VECTOR;
    for (std::size_t i = 1; i < at_.size(); ++i) {
      if (i + 1 < at_.size()) sum += CGAL::cross_product(at_[i], at_[i + 1]);
      if (at_[i].squared_length() > far.squared_length()) far = at_[i];
    }
    const double noise = std::ldexp(far.squared_length(), -44);
    if (sum.squared_length() > noise * noise) return sum;
    for (const Vector_3& v : at_) { // no area, or as much to the left as to the right
      const Vector_3 c = CGAL::cross_product(far, v);
      if (c.squared_length() > widest.squared_length()) widest = c;
    }
    return widest * sum < 0 ? -widest : widest;
  }

  void project(std::vector<Vector_3> given, const Vector_3& normal)
  {
    int axis = 2;
    for (int i = 0; i < 2; ++i)
      if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(x, y);
    for (Vector_3& v : given) v = {v[x], v[y], 0};
    scale_to_one(given);
    for (const Vector_3& v : given) exact_.emplace_back(v.x(), v.y());

    std::array<double, 3> along = {0, 0, 0};
    along[std::size_t(x)] = 1;
    Vector_3 u = CGAL::cross_product(
      CGAL::cross_product(normal, Vector_3(along[0], along[1], along[2])), normal);
    Vector_3 v = CGAL::cross_product(normal, u);
    if (u != CGAL::NULL_VECTOR) u /= std::sqrt(u.squared_length());
    if (v != CGAL::NULL_VECTOR) v /= std::sqrt(v.squared_length());
    for (const Vector_3& w : at_) plane_.push_back({w * u, w * v});
  }

  std::vector<Vector_3> at_;
  std::vector<Exact_point> exact_;
  std::vector<Coordinates> plane_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_POLYGON_IN_PLANE_H
