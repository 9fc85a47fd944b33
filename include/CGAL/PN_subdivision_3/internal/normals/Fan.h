// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FAN_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FAN_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The half-edges with the same target v, one after the other clockwise. A closed fan has all these
// half-edges, an open fan the half-edges from `first` to `last`. The faces of a fan are the faces of its
// half-edges, but for `last` in an open fan. An open fan may have the same first and
// last half-edge: then it goes once round v.
struct Fan
{
  using Index = Level_connectivity::Index;

  Index first, last;
  bool closed;
};

// all half-edges at v. \pre v is not isolated
inline Fan fan_of_vertex(const Level_connectivity& level, Level_connectivity::Index v)
{
  const Level_connectivity::Index h = level.halfedge_of_vertex(v);
  if (!level.is_border(h)) return {h, h, true};
  return {level.next_around_target(h), h, false};
}

// calls f(h) for the half-edges of a fan
template <class Function>
void for_each_halfedge(const Level_connectivity& level, const Fan& fan, const Function& f)
{
  Level_connectivity::Index h = fan.first;
  do {
    f(h);
    h = level.next_around_target(h);
  } while (h != (fan.closed ? fan.first : fan.last));
  if (!fan.closed) f(h);
}

// calls function(half-edge) for the half-edges to a vertex, clockwise. \pre v is not isolated
template <class Function>
void for_each_halfedge_to(const Level_connectivity& level, Level_connectivity::Index v,
                          const Function& function)
{
  for (const auto h : halfedges_around_target(level, level.halfedge_of_vertex(v))) function(h);
}

// calls function(half-edge) for the half-edges of a face
template <class Function>
void for_each_halfedge_of_face(const Level_connectivity& level, Level_connectivity::Index f,
                               const Function& function)
{
  for (const auto h : halfedges_around_face(level, level.halfedge_of_face(f))) function(h);
}

// The edges e of a fan inverted at its vertex, W = e/|e|^2, and the cross products of neighboring
// ones: the corner normals, each of the length |sin| / (|e||e'|). In double. Edges of length zero are
// left out. The fan is scaled by a power of two where squares would leave the range of double.
template <class FT>
class Inverted_fan
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  struct Ray
  {
    Index halfedge; // towards the vertex
    Vector inverted;
    double squared; // |W|^2
  };

  struct Corner
  {
    Vector normal; // outwards, for faces that are counterclockwise seen from there
    double squared;
    bool has_area; // more than the rounding of the points can make
  };

  template <class Point_of>
  void assign(const Level_connectivity& level, const Fan& fan, const Point_of& point)
  {
    collect(level, fan, point);
    invert();
    make_corners(fan.closed);
  }

  const std::vector<Ray>& rays() const { return rays_; }
  const std::vector<Corner>& corners() const { return corners_; }
  // whether neither the first nor the last edge of an open fan has length zero
  bool has_ends() const { return has_ends_; }

private:
  using T = At_least_double<FT>;

  template <class Point_of>
  void collect(const Level_connectivity& level, const Fan& fan, const Point_of& point)
  {
    rays_.clear();
    shortest_ = std::numeric_limits<double>::infinity();
    longest_ = 0;
    const auto& p = point(level.target(fan.first));
    bool last_is_zero = false;
    has_ends_ = true;
    for_each_halfedge(level, fan, [&](Index h) {
      const auto& q = point(level.source(h));
      const Vector e = to_double_3<T>({T(q[0]) - T(p[0]), T(q[1]) - T(p[1]), T(q[2]) - T(p[2])});
      const double size = largest_coordinate(e);
      last_is_zero = size == 0;
      if (last_is_zero && rays_.empty()) has_ends_ = false;
      if (last_is_zero) return;
      shortest_ = (std::min)(shortest_, size);
      longest_ = (std::max)(longest_, size);
      rays_.push_back({h, e, 0});
    });
    if (last_is_zero) has_ends_ = false;
    if (!std::isfinite(longest_)) rays_.clear();
    if constexpr (!is_exact_v<FT>)
      point_error_ = epsilon() * (largest_coordinate(to_double_3<FT>(p)) + longest_);
  }

  // Inversions of edges that are too long for their squares are too short to count.
  void invert()
  {
    constexpr double largest = 0x1p100;
    int exponent = 0;
    if (!rays_.empty() && (shortest_ < 1 / largest || longest_ > largest))
      exponent = std::ilogb(shortest_);
    if (exponent != 0) point_error_ = std::ldexp(point_error_, -exponent);
    for (Ray& ray : rays_) {
      Vector& e = ray.inverted;
      bool counts = true;
      if (exponent != 0) {
        for (double& x : e) x = std::ldexp(x, -exponent);
        counts = largest_coordinate(e) <= largest;
      }
      ray.squared = counts ? 1 / dot(e, e) : 0;
      for (double& x : e) x = counts ? x * ray.squared : 0;
    }
  }

  void make_corners(bool closed)
  {
    const std::size_t n = rays_.size();
    const std::size_t count = closed ? n : n - (std::min)(n, std::size_t(1));
    const double squared_error = point_error_ * point_error_;
    corners_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Ray &a = rays_[i], &b = rays_[i + 1 < n ? i + 1 : 0];
      const Vector c = cross(b.inverted, a.inverted);
      const auto squared = dot(c, c);
      const double nearer = (std::max)(a.squared, b.squared);
      const double rounding = 256 * (squared_error * nearer + conversion_error * conversion_error);
      corners_[i] = {c, squared, squared > rounding * a.squared * b.squared};
    }
  }

  static double epsilon() { return static_cast<double>(CGAL::to_double(machine_epsilon<FT>())); }

  static constexpr double conversion_error =
    std::is_same_v<T, double> ? 0 : std::numeric_limits<double>::epsilon();

  std::vector<Ray> rays_;
  std::vector<Corner> corners_;
  double shortest_ = 0, longest_ = 0;
  double point_error_ = 0; // of a coordinate, in the scale of the fan
  bool has_ends_ = true;
};

// Normals are estimated sector by sector. A sector is a vertex with one of its fans; here a whole
// vertex. at_target(h) and at_source(h) are the sectors of the corners of face(h). Wedges are
// sectors at creases; own_normal(s) is a normal of the wedge in which the neighbors have no part.
class Vertex_sectors
{
public:
  using Index = Level_connectivity::Index;

  explicit Vertex_sectors(const Level_connectivity& level)
    : level_(level)
  {}

  Index number_of_sectors() const { return level_.number_of_vertices(); }
  bool is_empty(Index s) const { return level_.is_isolated(s); }
  Fan fan(Index s) const { return fan_of_vertex(level_, s); }
  Index at_target(Index h) const { return level_.target(h); }
  Index at_source(Index h) const { return level_.source(h); }
  static constexpr bool is_at_crease(Index) { return false; }
  static constexpr Coordinates<double, 3> own_normal(Index) { return {0, 0, 0}; }

private:
  const Level_connectivity& level_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FAN_H
