// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_CORNER_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_CORNER_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/curvature/Curvature_data.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The normals of angle_weighted_normals(), vertex by vertex, but for angles that are good to 3e-8: where
// they only lay the planes of fits, the others take longer than all the rest.
class Corner_normals
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  explicit Corner_normals(const Curvature_data& data)
    : data_(data)
  {}

  // a unit vector; zero if the faces have no area, or their normals cancel
  Vector operator()(Index v) const
  {
    if (data_.level.is_isolated(v)) return {};
    Sum sum = sum_of_faces(v, 1);
    // squares of areas in range, whatever the size of the faces is beside that of the mesh
    if (!(sum.largest > 1e-60)) {
      if (!(sum.largest > 0)) return {};
      sum = sum_of_faces(v, std::ldexp(1., (std::min)(-std::ilogb(sum.largest), 1000)));
    }
    const double length = std::sqrt(dot<double, 3>(sum.normal, sum.normal));
    if (!(length > 4096 * epsilon * sum.angles)) return {};
    return quotient(sum.normal, length);
  }

  // Abramowitz and Stegun, 4.4.46. \pre |x| <= 1
  static double arc_cosine(double x)
  {
    constexpr double pi = 3.14159265358979324;
    const double c = std::abs(x);
    double sum = -0.0012624911;
    for (const double a : {0.0066700901, -0.0170881256, 0.0308918810, -0.0501743046, 0.0889789874,
                           -0.2145988016, 1.5707963050})
      sum = sum * c + a;
    const double angle = std::sqrt(1 - c) * sum;
    return x < 0 ? pi - angle : angle;
  }

private:
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();

  struct Sum
  {
    Vector normal{0, 0, 0};
    double angles = 0;
    double largest = 0; // a squared length of an edge, in the unit
  };

  struct Edge
  {
    Vector offset;
    double square, inverse_length;
  };

  Vector offset(Index v, Index h, double scale) const
  {
    return multiple(scale, data_.offset(v, data_.level.target(h)));
  }

  static Edge edge(const Vector& offset)
  {
    const double square = dot<double, 3>(offset, offset);
    return {offset, square, square > 0 ? 1 / std::sqrt(square) : 0};
  }

  Sum sum_of_faces(Index v, double scale) const
  {
    const Level_connectivity& level = data_.level;
    Sum sum;
    const double coordinate = data_.unit * scale * largest_coordinate(v);
    const Index first = level.halfedge_of_vertex(v);
    Edge before = edge(offset(v, Level_connectivity::opposite(first), scale));
    Index h = first;
    do { // the edge of `before` is that of h
      const Index next = level.next(h);
      const Edge after = edge(offset(v, next, scale));
      sum.largest = (std::max)(sum.largest, after.square);
      if (!level.is_border(h))
        add(sum, before, after, area(v, h, before, after, scale), coordinate);
      before = after;
      h = Level_connectivity::opposite(next);
    } while (h != first);
    return sum;
  }

  // twice the area vector of the face of h
  Vector area(Index v, Index h, const Edge& before, const Edge& after, double scale) const
  {
    Vector sum{0, 0, 0}, last = after.offset;
    for (Index g = data_.level.next(data_.level.next(h)); data_.level.next(g) != h;
         g = data_.level.next(g)) {
      const Vector corner = offset(v, g, scale);
      add_multiple<double, 3>(sum, 1, cross(last, corner));
      last = corner;
    }
    add_multiple<double, 3>(sum, 1, cross(last, before.offset));
    return sum;
  }

  // What the rounding of the coordinates alone can make of a face without area counts as no area.
  static void add(Sum& sum, const Edge& before, const Edge& after, const Vector& area,
                  double coordinate)
  {
    const double square = dot<double, 3>(area, area);
    const double side = (std::max)(before.square, after.square);
    const double rounding = 16 * epsilon * (coordinate + std::sqrt(side));
    if (!(square > rounding * rounding * side)) return;
    const double cosine =
      dot<double, 3>(before.offset, after.offset) * before.inverse_length * after.inverse_length;
    if (before.inverse_length == 0 || after.inverse_length == 0) return;
    const double angle = arc_cosine((std::max)(-1., (std::min)(1., cosine)));
    add_multiple<double, 3>(sum.normal, angle / std::sqrt(square), area);
    sum.angles += angle;
  }

  double largest_coordinate(Index v) const
  {
    const Vector& p = data_.vertices[v].point;
    return (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  }

  const Curvature_data& data_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_CORNER_NORMALS_H
