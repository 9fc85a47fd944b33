// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SPLIT_POLYGON_H
#define PN_SUBDIVIDE_SPLIT_POLYGON_H

#include "surface/Surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace pn_subdivide {

// the numbers of three corners of a polygon, ascending
using Corner_triangle = std::array<std::uint32_t, 3>;
// whether two corners of the polygon are joined by an edge elsewhere
using Is_edge = std::function<bool(std::uint32_t, std::uint32_t)>;

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

// Turns diagonals of a polygon's triangles without folds until all are as Delaunay has them, in its plane. The sum
// of the angles' cotangents falls with each, so it ends; quadratic at worst, which the number of turns bounds.
class Polygon_flips
{
public:
  Polygon_flips(const Polygon_in_plane& polygon, const Is_edge& is_edge,
                const std::vector<Corner_triangle>& triangles)
    : polygon_(polygon)
    , is_edge_(is_edge)
  {
    for (const Corner_triangle& t : triangles) triangles_.push_back({t, {none, none, none}});
    join();
  }

  std::vector<Corner_triangle> triangles()
  {
    std::vector<Side> open;
    for (Index t = 0; t < triangles_.size(); ++t)
      for (Index i = 0; i < 3; ++i)
        if (triangles_[t].across[i] > t && triangles_[t].across[i] != none) open.push_back({t, i});
    for (std::size_t turns = 64 * triangles_.size(); turns > 0 && !open.empty();) {
      const Side side = open.back();
      open.pop_back();
      if (triangles_[side.triangle].across[side.corner] == none || !turn(side)) continue;
      --turns;
      const Index s = triangles_[side.triangle].across[1];
      open.insert(open.end(), {{side.triangle, 0}, {side.triangle, 2}, {s, 0}, {s, 1}});
    }
    std::vector<Corner_triangle> result;
    for (const Triangle& t : triangles_) {
      result.push_back(t.corners);
      std::sort(result.back().begin(), result.back().end());
    }
    return result;
  }

private:
  static constexpr Index none = std::numeric_limits<Index>::max();

  struct Triangle
  {
    Corner_triangle corners;     // turning left
    std::array<Index, 3> across; // the triangle beyond the side opposite to each
  };
  struct Side
  {
    Index triangle, corner; // opposite to it
  };

  void join()
  {
    using Diagonal = std::pair<Index, Index>;
    std::vector<std::pair<Diagonal, Side>> sides;
    for (Index t = 0; t < triangles_.size(); ++t)
      for (Index i = 0; i < 3; ++i) {
        const Corner_triangle& c = triangles_[t].corners;
        sides.push_back({std::minmax(c[(i + 1) % 3], c[(i + 2) % 3]), {t, i}});
      }
    std::sort(sides.begin(), sides.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
      if (sides[k].first != sides[k + 1].first) continue;
      const Side a = sides[k].second, b = sides[k + 1].second;
      triangles_[a.triangle].across[a.corner] = b.triangle;
      triangles_[b.triangle].across[b.corner] = a.triangle;
    }
  }

  // Whether the circle through a, b, d holds c, by more than rounding.
  bool is_better(Index a, Index b, Index c, Index d) const
  {
    const Angle at_a = angle(b, a, d), at_c = angle(d, c, b);
    return at_a.cosine * at_c.sine + at_a.sine * at_c.cosine < -std::ldexp(1., -40);
  }
  struct Angle
  {
    double cosine, sine;
  };
  Angle angle(Index from, Index at, Index to) const
  {
    const auto &f = polygon_.in_plane(from), &o = polygon_.in_plane(at), &t = polygon_.in_plane(to);
    const double ux = f[0] - o[0], uy = f[1] - o[1], vx = t[0] - o[0], vy = t[1] - o[1];
    const double lengths = std::hypot(ux, uy) * std::hypot(vx, vy);
    if (!(lengths > 0)) return {1, 0};
    return {(ux * vx + uy * vy) / lengths, (ux * vy - uy * vx) / lengths};
  }

  // The corners a, b, c, d of the two triangles beside the side b d; it becomes a c.
  bool turn(const Side& side)
  {
    Triangle& t = triangles_[side.triangle];
    const Index i = side.corner, other = t.across[i];
    Triangle& s = triangles_[other];
    const Index j =
      Index(std::find(s.across.begin(), s.across.end(), side.triangle) - s.across.begin());
    const Index a = t.corners[i], b = t.corners[(i + 1) % 3], c = s.corners[j],
                d = t.corners[(i + 2) % 3];
    if (!is_better(a, b, c, d) || polygon_.turn(a, b, c) <= 0 || polygon_.turn(a, c, d) <= 0 ||
        is_edge_(a, c))
      return false;
    const Index bc = s.across[(j + 1) % 3], cd = s.across[(j + 2) % 3], da = t.across[(i + 1) % 3],
                ab = t.across[(i + 2) % 3];
    t = {{a, b, c}, {bc, other, ab}};
    s = {{a, c, d}, {cd, da, side.triangle}};
    if (bc != none) replace(bc, other, side.triangle);
    if (da != none) replace(da, side.triangle, other);
    return true;
  }
  void replace(Index in, Index from, Index to)
  {
    std::array<Index, 3>& across = triangles_[in].across;
    *std::find(across.begin(), across.end(), from) = to;
  }

  const Polygon_in_plane& polygon_;
  const Is_edge& is_edge_;
  std::vector<Triangle> triangles_;
};

// Cuts off corners, of those that can be cut off the one with the shortest diagonal first. In a polygon that
// touches or crosses itself there may be none: then the one that does least harm. Corners that turn right, the only
// ones that can lie in an ear, are found by their x: near-linear where ears are small, never more than quadratic.
class Ear_clipping
{
public:
  Ear_clipping(const Polygon_in_plane& polygon, const Is_edge& is_edge)
    : polygon_(polygon)
    , is_edge_(is_edge)
    , size_(Index(polygon.size()))
    , before_(size_)
    , after_(size_)
    , by_x_(size_)
    , turns_right_(size_)
    , version_(size_, 0)
  {
    for (Index i = 0; i < size_; ++i) {
      before_[i] = i == 0 ? size_ - 1 : i - 1;
      after_[i] = i + 1 == size_ ? 0 : i + 1;
    }
    std::iota(by_x_.begin(), by_x_.end(), Index(0));
    std::sort(by_x_.begin(), by_x_.end(),
              [&](Index i, Index j) { return polygon_.x(i) < polygon_.x(j); });
    for (Index i = 0; i < size_; ++i) set_turn(i);
    for (Index i = 0; i < size_; ++i) enter(i);
  }

  std::vector<Corner_triangle> triangles()
  {
    std::vector<Corner_triangle> result;
    while (result.size() + 2 < size_) {
      const Candidate c = queue_.top();
      queue_.pop();
      if (c.version != version_[c.corner]) continue;
      Corner_triangle t = {before_[c.corner], c.corner, after_[c.corner]};
      cut_off(c.corner);
      std::sort(t.begin(), t.end());
      result.push_back(t);
    }
    return result;
  }

private:
  enum Harm { none, is_blocked, has_no_area, is_reversed, doubles_an_edge };

  struct Candidate
  {
    int harm;
    double length;
    Index corner, version;

    bool operator>(const Candidate& c) const
    {
      return std::tie(harm, length, corner) > std::tie(c.harm, c.length, c.corner);
    }
  };

  int turn(Index i) const { return polygon_.turn(before_[i], i, after_[i]); }
  void set_turn(Index i) { turns_right_[i] = turn(i) < 0; }

  void enter(Index i)
  {
    const Index a = before_[i], c = after_[i];
    queue_.push({harm(i), polygon_.squared_distance(a, c), i, ++version_[i]});
  }

  void cut_off(Index i)
  {
    const Index a = before_[i], c = after_[i];
    ++version_[i];
    turns_right_[i] = false;
    after_[a] = c;
    before_[c] = a;
    set_turn(a);
    set_turn(c);
    enter(a);
    enter(c);
  }

  int harm(Index i) const
  {
    const Index a = before_[i], c = after_[i];
    if (after_[c] != a && is_edge_(a, c)) return doubles_an_edge;
    const int t = turn(i);
    if (t < 0) return is_reversed;
    if (t == 0) return has_no_area;
    return is_empty(a, i, c) ? none : is_blocked;
  }

  bool is_empty(Index a, Index b, Index c) const
  {
    const auto [left, right] = std::minmax({polygon_.x(a), polygon_.x(b), polygon_.x(c)});
    const auto [low, high] = std::minmax({polygon_.y(a), polygon_.y(b), polygon_.y(c)});
    auto i = std::lower_bound(by_x_.begin(), by_x_.end(), left,
                              [&](Index j, double x) { return polygon_.x(j) < x; });
    for (; i != by_x_.end() && polygon_.x(*i) <= right; ++i) {
      if (!turns_right_[*i] || *i == a || *i == b || *i == c) continue;
      if (polygon_.y(*i) >= low && polygon_.y(*i) <= high && blocks(*i, {a, b, c})) return false;
    }
    return true;
  }

  // A corner at the same point as one of the ear, as of a bridge to a hole, does so if one of its sides goes in.
  bool blocks(Index i, const std::array<Index, 3>& ear) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (polygon_.turn(ear[k], ear[(k + 1) % 3], i) < 0) return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (is_at(i, ear[k])) return goes_in(before_[i], ear, k) || goes_in(after_[i], ear, k);
    return true;
  }
  bool is_at(Index i, Index j) const
  {
    return polygon_.x(i) == polygon_.x(j) && polygon_.y(i) == polygon_.y(j);
  }
  bool goes_in(Index i, const std::array<Index, 3>& ear, std::size_t k) const
  {
    return polygon_.turn(ear[k], ear[(k + 1) % 3], i) > 0 &&
           polygon_.turn(ear[k], ear[(k + 2) % 3], i) < 0;
  }

  const Polygon_in_plane& polygon_;
  const Is_edge& is_edge_;
  Index size_;
  std::vector<Index> before_, after_, by_x_;
  std::vector<char> turns_right_;
  std::vector<Index> version_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

// Splits a polygon of n >= 3 corners at finite points into n - 2 triangles, whatever the points are: in a line,
// equal, in no plane, of a polygon that crosses itself. Where its projection to the plane of its area vector can be
// split without a fold, the triangles have no fold, and are those of Delaunay's condition. Diagonals are no edges
// elsewhere, if that is possible. Each triangle cuts off its middle corner from what those before it have left.
std::vector<Corner_triangle> split_polygon(const std::vector<Point_3>& points,
                                           const Is_edge& is_edge);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SPLIT_POLYGON_H
