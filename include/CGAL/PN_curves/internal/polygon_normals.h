// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_INTERNAL_POLYGON_NORMALS_H
#define CGAL_PN_CURVES_INTERNAL_POLYGON_NORMALS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

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

// The smallest rotation of v that takes the unit vector a to b; v itself if a or b is zero or they
// are opposite.
inline Coordinates<double, 3> rotated(const Coordinates<double, 3>& v,
                                      const Coordinates<double, 3>& a,
                                      const Coordinates<double, 3>& b)
{
  const double d = 1 + dot(a, b);
  if (is_zero(a) || is_zero(b) || !(d > 0x1p-40)) return v;
  const auto axis = cross(a, b);
  const auto once = cross(axis, v), twice = cross(axis, once);
  auto r = v;
  add_multiple<double, 3>(r, 1, once);
  add_multiple<double, 3>(r, 1 / d, twice);
  return r;
}

// Normals of a polygon in space without repeated neighbors. A vertex turns if the circle through it
// and its neighbors has a radius below 10^6 edges; it gets the normal of this circle, away from its
// center or, past an inflection, towards it. In between, and at open ends, normals are carried along
// the tangents.
template <class FT>
class Space_polygon_normals
{
public:
  using Vector = Coordinates<double, 3>;

  Space_polygon_normals(std::vector<Coordinates<FT, 3>> points, bool closed)
    : points_(std::move(points))
    , closed_(closed)
    , carried_(points_.size(), Vector{0, 0, 0})
    , sign_(points_.size(), 0)
  {
    measure();
    if (turning_.empty()) return;
    choose_signs();
    carry();
  }

  // zero where the tangent is not defined and on straight polygons
  Coordinates<FT, 3> operator()(std::size_t i) const
  {
    Coordinates<FT, 3> n{FT(carried_[i][0]), FT(carried_[i][1]), FT(carried_[i][2])};
    if (sign_[i] != 0) n = outward(i);
    for (FT& x : n) x = sign_[i] < 0 ? FT(FT(0) - x) : FT(FT(0) + x); // not -0
    normalize_control_normal<FT, 3>(n);
    return n;
  }

private:
  std::size_t size() const { return points_.size(); }
  std::size_t after(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }
  std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : size() - 1; }
  bool has_neighbors(std::size_t i) const
  {
    return size() > 2 && (closed_ || (i > 0 && i + 1 < size()));
  }

  // The vector from the center of the circle through a vertex and its neighbors, of any length. The
  // shorter edge is scaled to a size of about 1, so that nothing overflows.
  Coordinates<FT, 3> outward(std::size_t i) const
  {
    auto a = difference(points_[before(i)], points_[i]),
         b = difference(points_[after(i)], points_[i]);
    const int e = std::ilogb((std::min)(length_[before(i)], length_[i]));
    const FT scale(std::ldexp(1., -e / 2)), rest(std::ldexp(1., -e + e / 2));
    for (FT& x : a) x = x * scale * rest;
    for (FT& x : b) x = x * scale * rest;
    const FT aa = dot(a, a), bb = dot(b, b);
    Coordinates<FT, 3> c;
    for (int k = 0; k < 3; ++k) c[k] = bb * a[k] - aa * b[k];
    return cross(c, cross(a, b));
  }

  // edges, tangents, and which vertices turn
  void measure()
  {
    edge_.resize(size());
    length_.resize(size());
    tangent_.assign(size(), Vector{0, 0, 0});
    for (std::size_t i = 0; i < size(); ++i) {
      edge_[i] = to_double_3<FT>(difference(points_[after(i)], points_[i]));
      length_[i] = length(edge_[i]);
      if (length_[i] > 0) edge_[i] = quotient(edge_[i], length_[i]);
    }
    for (std::size_t i = 0; i < size(); ++i)
      if (has_neighbors(i)) measure_vertex(i);
    if (closed_ || size() < 2) return;
    tangent_.front() = mirrored(tangent_[1], edge_[0]);
    tangent_.back() = mirrored(tangent_[size() - 2], edge_[size() - 2]);
  }

  void measure_vertex(std::size_t i)
  {
    constexpr double straight = 2e6;
    const Vector &a = edge_[before(i)], &b = edge_[i];
    const double w = 1 / (1 + length_[i] / length_[before(i)]);
    Vector t = multiple(1 - w, a);
    add_multiple<double, 3>(t, w, b);
    const double t_length = length(t);
    if (!(t_length > vanishing_tolerance<FT>())) return;
    tangent_[i] = quotient(t, t_length);
    // radius = |p_{i+1} - p_{i-1}| / (2 sin)
    const double longer = (std::max)(length_[before(i)], length_[i]);
    Vector chord = multiple(length_[before(i)] / longer, a);
    add_multiple<double, 3>(chord, length_[i] / longer, b);
    if (length(chord) < straight * length(cross(a, b))) turning_.push_back(i);
  }

  // the tangent at the other end of a circular arc over an edge
  static Vector mirrored(const Vector& t, const Vector& edge)
  {
    Vector r = multiple(-1, t);
    add_multiple<double, 3>(r, 2 * dot(t, edge), edge);
    return r;
  }

  // a normal of a vertex at the one at the other end of an edge
  Vector carried(const Vector& n, std::size_t from, std::size_t edge, std::size_t to) const
  {
    return rotated(rotated(n, tangent_[from], edge_[edge]), edge_[edge], tangent_[to]);
  }
  Vector carried_on(const Vector& n, std::size_t i) const { return carried(n, i, i, after(i)); }

  Vector unit_outward(std::size_t i) const
  {
    const Vector n = to_double_3<FT>(outward(i));
    const double n_length = length(n);
    return n_length > 0 ? quotient(n, n_length) : n;
  }

  // Signs that change as little as possible from each turning vertex to the next one. Round a closed
  // polygon this may be impossible; then the signs change where the normals differ most from equal or
  // opposite ones. Most of the turns have their normals outside.
  void choose_signs()
  {
    const std::size_t m = turning_.size();
    std::vector<double> agreement(m); // with the next one
    for (std::size_t k = 0; k < m; ++k) {
      const std::size_t next = turning_[k + 1 < m ? k + 1 : 0];
      if (!closed_ && k + 1 == m) break;
      Vector n = unit_outward(turning_[k]);
      std::size_t i = turning_[k];
      do {
        n = carried_on(n, i);
        i = after(i);
      } while (i != next);
      agreement[k] = dot(n, unit_outward(next));
    }
    std::size_t first = 0;
    if (closed_) {
      const auto weaker = [](double a, double b) { return std::abs(a) < std::abs(b); };
      first = static_cast<std::size_t>(
        std::min_element(agreement.begin(), agreement.end(), weaker) - agreement.begin());
      first = first + 1 < m ? first + 1 : 0;
    }
    double outside = 0, all = 0;
    int sign = 1;
    for (std::size_t step = 0; step < m; ++step) {
      const std::size_t k = (first + step) % m, i = turning_[k];
      sign_[i] = sign;
      const double turn = length(cross(edge_[before(i)], edge_[i]));
      outside += sign * turn;
      all += turn;
      if (agreement[k] < 0) sign = -sign;
    }
    const bool is_tie = std::abs(outside) <= 1e-9 * all;
    if (is_tie ? sign_[turning_.front()] > 0 : outside > 0) return;
    for (int& s : sign_) s = -s;
  }

  void carry()
  {
    const std::size_t m = turning_.size();
    for (std::size_t i : turning_) carried_[i] = multiple(sign_[i], unit_outward(i));
    for (std::size_t k = 0; k < m; ++k)
      if (closed_ || k + 1 < m) carry_between(turning_[k], turning_[k + 1 < m ? k + 1 : 0]);
    if (closed_) return;
    for (std::size_t i = turning_.front(); i > 0; --i)
      carried_[i - 1] = across_tangent(carried(carried_[i], i, i - 1, i - 1), i - 1);
    for (std::size_t i = turning_.back(); i + 1 < size(); ++i)
      carried_[i + 1] = across_tangent(carried_on(carried_[i], i), i + 1);
  }

  // The vertices between two turning ones: the first normal is carried along and turned about the
  // tangent, in proportion to the length of the polygon, until it meets the second one.
  void carry_between(std::size_t first, std::size_t last)
  {
    if (after(first) == last) return;
    Vector n = carried_[first];
    double total = 0;
    std::size_t i = first;
    do {
      n = carried_on(n, i);
      total += length_[i];
      i = after(i);
    } while (i != last);
    const Vector& end = carried_[last];
    const double angle = std::atan2(dot(cross(n, end), tangent_[last]), dot(n, end));
    n = carried_[first];
    double s = 0;
    for (i = first; after(i) != last; i = after(i)) {
      n = carried_on(n, i);
      s += length_[i];
      const std::size_t j = after(i);
      Vector turned = multiple(std::cos(angle * s / total), n);
      add_multiple<double, 3>(turned, std::sin(angle * s / total), cross(tangent_[j], n));
      carried_[j] = across_tangent(turned, j);
    }
  }

  // zero where there is no tangent
  Vector across_tangent(Vector n, std::size_t i) const
  {
    if (is_zero(tangent_[i])) return {0, 0, 0};
    add_multiple<double, 3>(n, -dot(n, tangent_[i]), tangent_[i]);
    return n;
  }

  std::vector<Coordinates<FT, 3>> points_;
  bool closed_;
  std::vector<Vector> edge_, tangent_; // edge i goes from vertex i to the next one
  std::vector<double> length_;
  std::vector<std::size_t> turning_;
  std::vector<Vector> carried_; // the normals, in double
  std::vector<int> sign_;       // of a turning vertex: 1 outside, -1 inside; else 0
};

// Normals of a polygon in the plane without repeated neighbors: of the circles through three points, to the right of their
// tangents.
template <class FT>
class Planar_polygon_normals
{
public:
  using Vector = Coordinates<FT, 2>;

  Planar_polygon_normals(std::vector<Vector> points, bool closed)
    : points_(std::move(points))
    , closed_(closed)
  {}

  // zero where there is none
  Vector operator()(std::size_t i) const
  {
    const Vector t = tangent(i);
    return {t[1], FT(0) - t[0]}; // not -0
  }

private:
  struct Edge
  {
    Vector direction;
    FT length;
  };

  Vector tangent(std::size_t i) const
  {
    const std::size_t n = points_.size();
    if (n == 1) return zero_vector<FT, 2>();
    if (closed_) return at(edge((i + n - 1) % n), edge(i));
    if (i > 0 && i + 1 < n) return at(edge(i - 1), edge(i));
    const Edge end = i == 0 ? edge(0) : edge(n - 2);
    if (n == 2) return end.direction;
    return reflected(at(i == 0 ? end : edge(n - 3), i == 0 ? edge(1) : end), end.direction);
  }

  Edge edge(std::size_t i) const
  {
    const Vector e = difference(points_[(i + 1) % points_.size()], points_[i]);
    Vector u = e;
    normalize_control_normal<FT, 2>(u);
    return {u, dot(u, e)};
  }

  static Vector at(const Edge& before, const Edge& after)
  {
    const FT w = FT(1) / (FT(1) + after.length / before.length);
    Vector t = zero_vector<FT, 2>();
    add_multiple<FT, 2>(t, FT(1) - w, before.direction);
    add_multiple<FT, 2>(t, w, after.direction);
    const FT tolerance = Unit_normal_traits<FT>::vanishing_tolerance();
    if (dot(t, t) <= tolerance * tolerance) return zero_vector<FT, 2>();
    normalize_control_normal<FT, 2>(t);
    return t;
  }

  // A circle has the mirror image of its tangent at the other end of a chord; without a circle the
  // edge itself is taken.
  static Vector reflected(const Vector& t, const Vector& edge)
  {
    if (t == zero_vector<FT, 2>()) return edge;
    Vector r = {-t[0], -t[1]};
    add_multiple<FT, 2>(r, FT(2) * dot(t, edge), edge);
    return r;
  }

  std::vector<Vector> points_;
  bool closed_;
};

// the normals of all points of a polygon
template <class FT, int dimension>
std::vector<Coordinates<FT, dimension>>
polygon_normals(const std::vector<Coordinates<FT, dimension>>& points, bool closed)
{
  auto [distinct, position] = distinct_neighbors(points, closed);
  const std::conditional_t<dimension == 2, Planar_polygon_normals<FT>, Space_polygon_normals<FT>>
    normal(std::move(distinct), closed);
  std::vector<Coordinates<FT, dimension>> normals;
  for (std::size_t i : position) normals.push_back(normal(i));
  return normals;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_CURVES_INTERNAL_POLYGON_NORMALS_H
