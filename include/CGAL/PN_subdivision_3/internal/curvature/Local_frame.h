// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_LOCAL_FRAME_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_LOCAL_FRAME_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/curvature/Curvature_data.h>
#include <CGAL/PN_subdivision_3/internal/normals/angle_weighted_normals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class FT>
using Pair = std::array<FT, 2>;

// divides a vector by its length; zero stays zero
template <class FT>
void normalize(Coordinates<FT, 3>& v)
{
  const FT length = square_root_of<FT>(dot<FT, 3>(v, v));
  if (length > FT(0))
    for (FT& x : v) x /= length;
}

// A point with a unit normal and two unit vectors perpendicular to it, right-handed. In the frame a
// point is (u, z), and a normal (-g, 1) but for its length.
template <class FT>
class Local_frame
{
public:
  using Vector = Coordinates<FT, 3>;

  Local_frame(const Vector& origin, const Vector& normal)
    : origin_(origin)
    , normal_(normal)
  {
    const auto smaller = [](const FT& a, const FT& b) {
      return absolute_value(a) < absolute_value(b);
    };
    const auto smallest = std::min_element(normal.begin(), normal.end(), smaller);
    Vector axis{};
    axis[static_cast<std::size_t>(smallest - normal.begin())] = FT(1);
    e1_ = cross<FT>(axis, normal);
    normalize(e1_);
    e2_ = cross<FT>(normal, e1_);
  }

  const Vector& origin() const { return origin_; }
  const Vector& normal() const { return normal_; }
  const Vector& e1() const { return e1_; }
  const Vector& e2() const { return e2_; }

  Pair<FT> u(const Vector& p) const
  {
    const Vector d = difference(p);
    return {dot<FT, 3>(d, e1_), dot<FT, 3>(d, e2_)};
  }
  FT z(const Vector& p) const { return dot<FT, 3>(difference(p), normal_); }

  // The slope of the plane perpendicular to n, bounded for normals that are not on the side of the
  // frame's; zero for no normal.
  Pair<FT> slope(const Vector& n) const
  {
    const FT c = -1 / (std::max)(dot<FT, 3>(n, normal_), FT(1) / FT(1024));
    return {c * dot<FT, 3>(n, e1_), c * dot<FT, 3>(n, e2_)};
  }

private:
  Vector difference(const Vector& p) const
  {
    return {p[0] - origin_[0], p[1] - origin_[1], p[2] - origin_[2]};
  }

  Vector origin_, normal_, e1_, e2_;
};

// the x with m x = b; NaN if m is singular but for rounding
template <class FT>
Pair<FT> solve(const std::array<Pair<FT>, 2>& m, const Pair<FT>& b)
{
  const FT det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const FT size = m[0][0] * m[0][0] + m[0][1] * m[0][1] + m[1][0] * m[1][0] + m[1][1] * m[1][1];
  if (!(absolute_value(det) > 64 * machine_epsilon<FT>() * size)) {
    const FT nan(std::numeric_limits<double>::quiet_NaN());
    return {nan, nan};
  }
  return {(b[0] * m[1][1] - b[1] * m[0][1]) / det, (m[0][0] * b[1] - m[1][0] * b[0]) / det};
}

// The normals of Angle_weighted_normals, vertex by vertex, but for angles that are good to 3e-8: where
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

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_LOCAL_FRAME_H
