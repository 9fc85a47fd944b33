// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_INTERNAL_PLANAR_POLYGON_NORMALS_H
#define CGAL_PN_CURVES_INTERNAL_PLANAR_POLYGON_NORMALS_H

#include <CGAL/PN_curves/internal/Curve_points.h>
#include <CGAL/PN_curves/internal/space_polygon_normals.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Tangents of the circles through three points of a polygon without repeated neighbors.
template <class FT>
class Planar_polygon_tangents
{
public:
  using Vector = Coordinates<FT, 2>;

  Planar_polygon_tangents(std::vector<Vector> points, bool closed)
    : points_(std::move(points))
    , closed_(closed)
  {}

  // zero where there is none
  Vector operator()(std::size_t i) const
  {
    const std::size_t n = points_.size();
    if (n == 1) return zero();
    if (closed_) return at(edge((i + n - 1) % n), edge(i));
    if (i > 0 && i + 1 < n) return at(edge(i - 1), edge(i));
    const Edge end = i == 0 ? edge(0) : edge(n - 2);
    if (n == 2) return end.direction;
    return reflected(at(i == 0 ? end : edge(n - 3), i == 0 ? edge(1) : end), end.direction);
  }

private:
  struct Edge
  {
    Vector direction;
    FT length;
  };

  static Vector zero() { return {FT(0), FT(0)}; }

  Edge edge(std::size_t i) const
  {
    const Vector e = difference_of(points_[(i + 1) % points_.size()], points_[i]);
    Vector u = e;
    normalize_control_normal<FT, 2>(u);
    return {u, dot<FT, 2>(u, e)};
  }

  static Vector at(const Edge& before, const Edge& after)
  {
    const FT w = FT(1) / (FT(1) + after.length / before.length);
    Vector t = zero();
    add_multiple<FT, 2>(t, FT(1) - w, before.direction);
    add_multiple<FT, 2>(t, w, after.direction);
    const FT tolerance = Unit_normal_traits<FT>::vanishing_tolerance();
    if (dot<FT, 2>(t, t) <= tolerance * tolerance) return zero();
    normalize_control_normal<FT, 2>(t);
    return t;
  }

  // A circle has the mirror image of its tangent at the other end of a chord; without a circle the
  // edge itself is taken.
  static Vector reflected(const Vector& t, const Vector& edge)
  {
    if (t == zero()) return edge;
    Vector r = {-t[0], -t[1]};
    add_multiple<FT, 2>(r, FT(2) * dot<FT, 2>(t, edge), edge);
    return r;
  }

  std::vector<Vector> points_;
  bool closed_;
};

template <class FT>
std::vector<Coordinates<FT, 2>>
planar_polygon_normals(const std::vector<Coordinates<FT, 2>>& points, bool closed)
{
  auto [distinct, position] = distinct_neighbors(points, closed);
  const Planar_polygon_tangents<FT> tangent(std::move(distinct), closed);
  std::vector<Coordinates<FT, 2>> normals;
  for (std::size_t i : position) {
    const Coordinates<FT, 2> t = tangent(i);
    normals.push_back({t[1], FT(0) - t[0]}); // not -0
  }
  return normals;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CURVES_INTERNAL_PLANAR_POLYGON_NORMALS_H
