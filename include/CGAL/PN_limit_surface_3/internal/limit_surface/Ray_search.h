// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_RAY_SEARCH_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_RAY_SEARCH_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Surface_places.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL::PN_subdivision_3::internal {

// Where a ray meets a surface first. Seen along the ray, the surface has two coordinates, which both vanish there:
// Newton's method finds the place. It may fail, or find one of two; then the triangle is split, and parts that the ray does
// not come near drop out.
template <class Surface>
class Ray_search
{
public:
  using Places = Surface_places<Surface>;
  using Place = typename Places::Place;
  using Triangle = typename Places::Triangle;
  using Kernel = Simple_cartesian<double>;
  using Vector = Kernel::Vector_3;

  // direction: a unit vector
  Ray_search(const Places& places, const Kernel::Point_3& source, const Vector& direction)
    : places_(places)
    , source_(source)
    , along_(direction)
    , right_(perpendicular(direction))
    , up_(CGAL::cross_product(direction, right_))
  {}

  // no point of the surface over the triangle is nearer to the source along the ray
  double least_distance(const Triangle& t) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Query_corner& c : t.corners) least = (std::min)(least, seen(c.point - source_)[2]);
    return least - t.distance;
  }

  void add(const Triangle& t, unsigned splits = 0)
  {
    constexpr unsigned most_splits = 16, enough = 6;
    if (first_ && least_distance(t) > first_->distance) return;
    const Passing passing = this->passing(t);
    if (!(passing.gap <= t.distance)) return;
    const bool crosses_once = is_seen_from_one_side(t);
    if (crosses_once && first_ && Places::is_about(*first_, t, 0.5)) return;
    const Place place = approach(places_.start(t, passing.weights));
    if (is_hit(place)) {
      if (place.distance >= 0 && (!first_ || place.distance < first_->distance)) first_ = place;
      if (crosses_once && Places::is_about(place, t, 0.5)) return;
    }
    const bool is_known = t.distance <= (std::max)(4 * places_.surface().tolerance(), 2 * t.error);
    if (splits == most_splits || (is_known && splits >= enough)) return;
    for (const Triangle& part : places_.parts(t)) add(part, splits + 1);
  }

  const std::optional<Place>& first() const { return first_; }

private:
  using Seen = std::array<double, 3>; // to the right, up, and along the ray

  // how far the line of the ray passes a triangle, and the weights of its corners there
  struct Passing
  {
    double gap;
    std::array<double, 3> weights;
  };

  static Vector perpendicular(const Vector& d)
  {
    const Vector n = Kernel::Plane_3(CGAL::ORIGIN, d).base1();
    return n / std::sqrt(n.squared_length());
  }

  Seen seen(const Vector& v) const { return {v * right_, v * up_, v * along_}; }

  Passing passing(const Triangle& t) const
  {
    std::array<Seen, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = seen(t.corners[k].point - source_);
    std::array<double, 3> area;
    for (std::size_t k = 0; k < 3; ++k) {
      const Seen &a = c[(k + 1) % 3], &b = c[(k + 2) % 3];
      area[k] = a[0] * b[1] - a[1] * b[0];
    }
    const double sum = area[0] + area[1] + area[2];
    const auto [least, greatest] = std::minmax({area[0], area[1], area[2]});
    if (sum != 0 && (least >= 0 || greatest <= 0))
      return {0, {area[0] / sum, area[1] / sum, area[2] / sum}};
    Passing nearest{std::numeric_limits<double>::infinity(), {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const double x = c[next][0] - c[k][0], y = c[next][1] - c[k][1], square = x * x + y * y;
      const double s =
        square > 0 ? (std::min)(1., (std::max)(0., -(c[k][0] * x + c[k][1] * y) / square)) : 0.;
      const double gap = std::hypot(c[k][0] + s * x, c[k][1] + s * y);
      if (!(gap < nearest.gap)) continue;
      nearest = {gap, {}};
      nearest.weights[k] = 1 - s;
      nearest.weights[next] = s;
    }
    return nearest;
  }

  // by more than half of what normals differ in
  bool is_seen_from_one_side(const Triangle& t) const
  {
    const auto side = [&](std::size_t k) { return t.corners[k].normal * along_; };
    const auto [a, b] = std::minmax({side(0), side(1), side(2)});
    return (std::max)(a, -b) > (b - a) / 2;
  }

  double tolerance(const Place& p) const
  {
    return (std::max)(4 * places_.surface().tolerance(), 1e-14 * std::abs(p.distance));
  }
  bool is_hit(const Place& p) const { return p.gap <= (std::max)(tolerance(p), 2 * p.at.error); }

  Seen look(Place& place) const
  {
    place.at = places_.evaluate(place);
    const Seen s = seen(Places::in_double(place.at.point) - source_);
    place.gap = std::hypot(s[0], s[1]);
    place.distance = s[2];
    return s;
  }

  Place approach(Place place) const
  {
    constexpr int most_steps = 30;
    Seen at = look(place);
    for (int i = 0; i < most_steps && place.gap > tolerance(place) && place.at.derivatives > 0;
         ++i) {
      const Seen u = seen(Places::vector_in_double(place.at.du)),
                 v = seen(Places::vector_in_double(place.at.dv));
      const double det = u[0] * v[1] - u[1] * v[0];
      if (det == 0) break;
      Place next = place;
      places_.move(next, (v[0] * at[1] - v[1] * at[0]) / det, (u[1] * at[0] - u[0] * at[1]) / det);
      at = look(next);
      if (!(next.gap < place.gap / 2)) break;
      place = next;
    }
    return place;
  }

  const Places& places_;
  const Kernel::Point_3 source_;
  const Vector along_, right_, up_;
  std::optional<Place> first_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_RAY_SEARCH_H
