// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ROUNDNESS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ROUNDNESS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The windows by which Coherent_estimation decides, each from 0 to 1 and smooth.

inline double smooth_window(double x, double low, double high)
{
  return smoothstep<double>((x - low) / (high - low));
}

// How much the first of two vectors at a vertex, its reciprocal normal or the circle's tangent, counts beside
// the second: by the squared curvatures that the edges would need for each vector to agree with the
// neighbors. On spheres, cylinders and circles the first vector needs none.
struct Curvature_mismatch
{
  // the squares by which the first and the second vector miss along an edge e, and 1/|e|^2
  void add(double square_of_first, double square_of_second, double weight)
  {
    first += square_of_first * weight;
    second += square_of_second * weight;
    weights += weight;
  }

  double share_of_first(double tolerance) const
  {
    const double sum = first + second;
    if (first <= tolerance * tolerance * weights || !std::isfinite(sum)) return 1;
    return smooth_window(second / sum, 0.2, 0.5);
  }

  double first = 0, second = 0, weights = 0;
};

constexpr double cos_36 = 0.80901699437494742410, cos_45 = 0.70710678118654752440;

// Two planes at a right angle turn by 45 degrees from any normal between them, a regular pentagon by
// 36.
inline double share_of_turn(double cosine)
{
  return smooth_window(cosine, cos_45, cos_36);
}

// how well arcs meet, by the largest miss of an arc relative to its length
inline double share_of_arcs(double miss)
{
  return 1 - smooth_window(miss, 0.1, 0.3);
}

// the same beside creases, for arcs with the area normal
inline double share_of_wedge(double miss)
{
  return 1 - smooth_window(miss, 0.05, 0.2);
}

// the same where only exact arcs prove roundness; files have six digits
inline double share_of_exact_arcs(double miss)
{
  return 1 - smooth_window(miss, 1e-4, 1e-3);
}

// the roundness by the corner that is turned most from n; 0 where no corner has an area
template <class FT>
double roundness_of_turn(const Coordinates<double, 3>& n, const Inverted_fan<FT>& fan)
{
  double least = 2;
  for (const auto& corner : fan.corners()) {
    if (!corner.has_area) continue;
    const auto d = dot(n, corner.normal);
    if (d > 0 && d * d >= cos_36 * cos_36 * corner.squared)
      least = (std::min)(least, 1.);
    else
      least = (std::min)(least, d / std::sqrt(corner.squared));
  }
  return least > 1 ? 0 : share_of_turn(least);
}

// whether the roundness of the turn is 1 at n, and at all unit vectors that are close to n
template <class FT>
bool is_narrow(const Coordinates<double, 3>& n, const Inverted_fan<FT>& fan)
{
  constexpr double cosine = 0.8405; // over cos_36 by more than close vectors differ
  bool has_area = false;
  for (const auto& corner : fan.corners()) {
    if (!corner.has_area) continue;
    const auto d = dot(n, corner.normal);
    if (!(d > 0 && d * d >= cosine * cosine * corner.squared)) return false;
    has_area = true;
  }
  return has_area;
}

inline bool is_close(const Coordinates<double, 3>& n, const Coordinates<double, 3>& m)
{
  const auto d = difference(n, m);
  return dot(d, d) <= 0x1p-10;
}

// the length of the shortest edge over the length of the longest edge
template <class FT>
double evenness(const Inverted_fan<FT>& fan)
{
  double least = std::numeric_limits<double>::infinity(), most = 0; // of inverse squares of lengths
  for (const auto& ray : fan.rays()) {
    least = (std::min)(least, ray.squared);
    most = (std::max)(most, ray.squared);
  }
  return most > 0 ? std::sqrt(least / most) : 0;
}

// Wide fans are round, too, if both normals and all arcs agree: a cube is a sphere. What long edges bulge would fold
// edges that are a tenth as long.
inline double regularity(double distance_of_normals, double largest_arc_error, double evenness)
{
  return (1 - smooth_window(distance_of_normals, 0.1, 0.3)) * share_of_arcs(largest_arc_error) *
         smooth_window(evenness, 1. / 12, 1. / 6);
}

// A plane that ends in a short chamfer looks like the cap of a large sphere: its edges dip below the
// tangent plane by several lengths of the shortest edge, and would bulge as much.
struct Dips
{
  // the squared dip of an edge e, and 1/|e|^2
  void add(double squared_dip, double inverse)
  {
    largest = (std::max)(largest, squared_dip);
    of_shortest = (std::max)(of_shortest, inverse);
  }

  // the factor of the roundness
  double share() const
  {
    const double squared_ratio = largest * of_shortest;
    return squared_ratio > 4 ? 1 - smooth_window(std::sqrt(squared_ratio), 2, 4) : 1;
  }

  double largest = 0, of_shortest = 0;
};

// the height over q, along n, of the arc to the point p with the normal m; bounded where m turns by more than 90 degrees
inline double arc_height(const Coordinates<double, 3>& m, const Coordinates<double, 3>& p,
                         const Coordinates<double, 3>& q, const Coordinates<double, 3>& n)
{
  const auto d = difference(p, q);
  const double numerator = dot(m, d) + dot(n, d);
  return numerator / (1 + (std::max)(0., dot(m, n)));
}

// the share where one of the shares a and b is enough
inline double either(double a, double b)
{
  return 1 - (1 - a) * (1 - b);
}

// 0 where the longest edge is at most 6 times the shortest edge, from 7 times on 1; both lengths are squared
inline double share_of_uneven(double longest, double shortest)
{
  return longest > 36 * shortest ? (std::min)(std::sqrt(longest / shortest) - 6, 1.) : 0;
}

// 0 where arcs meet, up to a miss of 1e-6 of the length; 1 from 1e-3 on
inline double share_of_miss(double miss)
{
  return miss > 1e-6 ? smooth_window(std::log10(miss), -6, -3) : 0;
}

// the factor of the roundness of a vertex beside another vertex, by the error of the arc between both
inline double roundness_beside(double neighbor, double arc_error)
{
  return 1 - (1 - neighbor) * smooth_window(arc_error, 0.3, 0.6);
}

// How far a round would lift the new point of a vertex above its tangent plane and all its neighbors,
// or below them all: not at all on spheres, cylinders and whatever bends like them. But where a large
// plane ends in short bevels, the linear point slides far along the plane, the new normal tilts a
// little, by the normals of the bevels, and the point leaves the plane by the tilt times the way: thin
// plates swell. The weights are Loop's at a regular vertex, which are near those of Catmull-Clark.
class Lift_above_neighbors
{
public:
  using Vector = Coordinates<double, 3>;

  static constexpr double least_unevenness = 4; // the longest edge over the shortest one

  void clear() { neighbors_.clear(); }
  // the edge to a neighbor, of positive length, and the neighbor's normal
  void add(const Vector& edge, const Vector& normal) { neighbors_.push_back({edge, normal}); }

  // the factor of the roundness of the vertex
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

  // the excess in lengths of the shortest edge, times the number of these by which the longest edge exceeds four
  double excess(const Vector& normal) const
  {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (const Neighbor& j : neighbors_) {
      const double squared = dot(j.edge, j.edge);
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
      add_multiple(slide, each, j.edge);
      add_multiple(n, each, j.normal);
      const auto height = dot(normal, j.edge);
      lowest = (std::min)(lowest, height);
      highest = (std::max)(highest, height);
    }
    n = quotient(n, quick_length(n)); // at least a quarter
    double lift = own * arc_height(normal, {0, 0, 0}, slide, n);
    for (const Neighbor& j : neighbors_) lift += each * arc_height(j.normal, j.edge, slide, n);
    const double height = dot(normal, slide) + lift * dot(normal, n);
    return (std::max)(height - highest, lowest - height);
  }

  std::vector<Neighbor> neighbors_;
};

// How far the arcs from the corners of a face to the point over its middle miss each other: not at all on spheres and
// cylinders. Over a long and narrow face at the corner of a bevel they miss by more than its width, and
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

  // the edge to a corner, from the corner before, and the corner's normal
  void add(const Vector& edge, const Vector& normal)
  {
    add_multiple(last_, 1., edge);
    corners_.push_back({last_, normal, dot(edge, edge), 0});
    longest_ = (std::max)(longest_, corners_.back().squared_edge);
  }

  // the factor of the roundness of the corners
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
    double squared_edge; // of the edge to this corner
    double height;       // of the arc from this corner, over the middle
  };

  // the squared length of the shortest edge, or of the distance that coinciding points may have
  double squared_width() const
  {
    double shortest = longest_;
    for (const Corner& c : corners_) shortest = (std::min)(shortest, c.squared_edge);
    return (std::max)(shortest, 0x1p-20 * longest_);
  }

  // the mean difference of the arcs' heights from their mean
  double mean_error()
  {
    const double weight = 1. / double(corners_.size());
    Vector q{0, 0, 0}, n{0, 0, 0};
    for (const Corner& c : corners_) {
      add_multiple(q, weight, c.point);
      add_multiple(n, weight, c.normal);
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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_ROUNDNESS_H
