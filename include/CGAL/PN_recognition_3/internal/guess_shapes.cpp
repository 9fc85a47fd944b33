// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>

namespace CGAL::PN_subdivision_3::internal::recognition {

inline void guess_by_apexes(const Context& c, Found_regions& found)
{
  for (Index v = 0; v < c.part.points.size(); ++v) {
    std::vector<Index> seeds;
    std::vector<Vec3> directions;
    double length = 0;
    for (const Index f : c.part.faces_around[v]) {
      const Index p = c.patches.patch_of_face[f];
      if (p == null || c.patches[p].vertices.size() > 4) continue;
      seeds.push_back(p);
      const Lists::Range corners = c.part.corners[f];
      for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] != v) continue;
        const Vec3 d = c.point(corners[(i + 1) % corners.size()]) - c.point(v);
        directions.push_back(unit(d));
        length += norm(d);
      }
    }
    std::sort(seeds.begin(), seeds.end());
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
    if (seeds.size() < 5) continue;
    const auto n = double(directions.size());
    Vec3 mean;
    for (const Vec3& d : directions) mean += (1 / n) * d;
    Covariance covariance;
    for (const Vec3& d : directions) covariance.add(d - mean);
    Shape s;
    s.kind = Kind::cone;
    s.axis = covariance.least_direction();
    if (dot(mean, s.axis) < 0) s.axis = -s.axis;
    s.set_angle(std::acos((std::min)(1., dot(mean, s.axis))));
    if (!(s.angle > radians(0.5) && s.angle < radians(89.5))) continue;
    const double height = s.cosine * length / n;
    s.center = c.point(v) + height * s.axis;
    s.radius = height * std::tan(s.angle);
    found.try_shape(s, seeds, Found_regions::Guess::whole);
  }
}

// the vertex of a facet that is furthest from a line
inline Index furthest_from_line(const Context& c, Index patch, const Vec3& p, const Vec3& direction)
{
  const auto distance = [&](Index v) { return norm(cross(c.point(v) - p, direction)); };
  const std::vector<Index>& vertices = c.patches[patch].vertices;
  return *std::max_element(vertices.begin(), vertices.end(),
                           [&](Index v, Index w) { return distance(v) < distance(w); });
}

inline void guess_by_rulings(const Context& c, Found_regions& found)
{
  for (const Joint& j : c.patches.joints) {
    if (!j.is_smooth || found.is_known(Kind::cylinder, {j.p, j.q})) continue;
    Shape s;
    s.kind = Kind::cylinder;
    s.axis = unit(c.direction(j));
    const Vec3 middle = 0.5 * (c.point(j.v) + c.point(j.w));
    const std::vector<Vec3> points{middle, c.point(furthest_from_line(c, j.p, middle, s.axis)),
                                   c.point(furthest_from_line(c, j.q, middle, s.axis))};
    if (circle_through(points, s.axis, s.center, s.radius)) found.try_shape(s, {j.p, j.q});
  }
}

// --- shapes of revolution by three facets in a row, whose normals make one angle with the axis ---

struct Meridian_point
{
  double rho, z;
};

inline bool axis_of(const Context& c, Index k, Index l, Index m, Vec3& axis, Vec3& center)
{
  const Vec3 &a = c.patches[k].normal, &b = c.patches[l].normal, &d = c.patches[m].normal;
  const Vec3 product = cross(a - b, d - a);
  if (!(norm(product) > 1e-3 * norm(a - b) * norm(d - a))) return false;
  axis = unit(product);
  const Cross_section across(axis);
  Least_squares system(2);
  const Vec3& origin = c.patches[k].mean;
  for (const Index p : {k, l, m}) {
    const Vec3& n = c.patches[p].normal;
    double x = dot(n, across.u), y = dot(n, across.v);
    const double length = std::hypot(x, y);
    if (!(length > 1e-3)) return false;
    x /= length;
    y /= length;
    const Vec3 q = c.patches[p].mean - origin;
    system.add({y, -x}, y * dot(q, across.u) - x * dot(q, across.v));
  }
  const Least_squares::Row x = system.solve();
  center = origin + x[0] * across.u + x[1] * across.v;
  return true;
}

inline Meridian_point meridian_point(const Context& c, Index v, const Vec3& axis,
                                     const Vec3& center)
{
  const Cylindrical q = cylindrical(c.point(v), center, axis);
  return {q.rho, q.z};
}

// the ends of the facet's own line, means of vertices
inline bool meridian_of(const Context& c, Index k, const Vec3& axis, const Vec3& center,
                        Meridian_point& low, Meridian_point& high)
{
  const Patches::Patch& patch = c.patches[k];
  const Vec3 d = unit(axis - dot(axis, patch.normal) * patch.normal);
  double least = 0, most = 0;
  for (const Index v : patch.vertices) {
    const double x = dot(c.point(v) - patch.mean, d);
    least = (std::min)(least, x);
    most = (std::max)(most, x);
  }
  if (!(most > least)) return false;
  low = high = {0, 0};
  double lows = 0, highs = 0;
  for (const Index v : patch.vertices) {
    const double x = (dot(c.point(v) - patch.mean, d) - least) / (most - least);
    const Meridian_point p = meridian_point(c, v, axis, center);
    if (x < 0.1) {
      low = {low.rho + p.rho, low.z + p.z};
      ++lows;
    } else if (x > 0.9) {
      high = {high.rho + p.rho, high.z + p.z};
      ++highs;
    }
  }
  low = {low.rho / lows, low.z / lows};
  high = {high.rho / highs, high.z / highs};
  return true;
}

inline void guess_ruled(Found_regions& found, const Found_regions::Seeds& row, const Vec3& axis,
                        const Vec3& center, const Meridian_point& low, const Meridian_point& high)
{
  const double rho = high.rho - low.rho, z = high.z - low.z;
  Shape s;
  s.axis = axis;
  s.center = center + (low.z + z / 2) * axis;
  s.radius = low.rho + rho / 2;
  if (std::abs(rho) > 2e-3 * std::abs(z)) {
    s.kind = Kind::cone;
    s.set_angle(std::atan2(std::abs(rho), std::abs(z)));
    if ((rho < 0) != (z < 0)) s.axis = -axis;
    found.try_shape(s, row, Found_regions::Guess::may_be_fitted);
  }
  if (std::abs(rho) < 5e-2 * std::abs(z)) {
    s.kind = Kind::cylinder;
    s.axis = axis;
    found.try_shape(s, row, Found_regions::Guess::may_be_fitted);
  }
}

inline void guess_round(const Context& c, Found_regions& found, const Found_regions::Seeds& seeds,
                        const Vec3& axis, const Vec3& center, const Meridian_point& low,
                        const Meridian_point& high)
{
  const Vec3 a{low.rho, low.z, 0}, b{high.rho, high.z, 0};
  const Vec3 along = unit(b - a);
  Vec3 third;
  double furthest = -1;
  for (const Index v : c.patches[seeds.back()].vertices) {
    const Meridian_point p = meridian_point(c, v, axis, center);
    const Vec3 q{p.rho, p.z, 0};
    const double d = std::abs(dot(q - 0.5 * (a + b), along));
    if (!(d > furthest)) continue;
    furthest = d;
    third = q;
  }
  Vec3 middle;
  Shape s;
  s.axis = axis;
  if (!circle_through({a, b, third}, {0, 0, 1}, middle, s.radius)) return;
  const double r = s.radius;
  s.center = center + middle[1] * axis;
  if (std::abs(middle[0]) < 0.05 * r) {
    s.kind = Kind::sphere;
    found.try_shape(s, seeds, Found_regions::Guess::may_be_fitted);
  }
  if (middle[0] > 0.02 * r) {
    s.kind = Kind::torus;
    s.radius = middle[0];
    s.tube = r;
    found.try_shape(s, seeds, Found_regions::Guess::may_be_fitted);
  }
}

inline void guess_by_row(const Context& c, Found_regions& found, Index k, const Joint& j,
                         const Joint& i, const std::vector<Index>& smooth)
{
  if (j.v == i.v || j.v == i.w || j.w == i.v || j.w == i.w) return;
  if (j.angle > 5 * i.angle || i.angle > 5 * j.angle) return;
  const Index l = j.other(k), m = i.other(k);
  if (l == m) return;
  const Found_regions::Seeds row{k, l, m};
  const bool knows_ruled = found.is_known(Kind::cylinder, row) || found.is_known(Kind::cone, row);
  const bool knows_round = found.is_known(Kind::torus, row) || found.is_known(Kind::sphere, row);
  if (knows_ruled && knows_round) return;
  Vec3 axis, center;
  if (!axis_of(c, k, l, m, axis, center)) return;
  Meridian_point low, high;
  if (!meridian_of(c, k, axis, center, low, high)) return;
  if (!knows_ruled) guess_ruled(found, row, axis, center, low, high);
  if (knows_round || c.patches[k].vertices.size() > 4) return;
  for (const Index number : smooth) {
    const Index q = c.patches.joints[number].other(k);
    if (q != l && q != m) guess_round(c, found, {k, l, m, q}, axis, center, low, high);
  }
}

inline void guess_by_rows(const Context& c, Found_regions& found, Index k)
{
  if (found.is_settled(k)) return;
  std::vector<Index> smooth;
  for (const Index j : c.patches[k].joints)
    if (c.patches.joints[j].is_smooth) smooth.push_back(j);
  if (smooth.size() > 8) return;
  for (std::size_t i = 0; i < smooth.size(); ++i)
    for (std::size_t l = 0; l < i; ++l)
      guess_by_row(c, found, k, c.patches.joints[smooth[l]], c.patches.joints[smooth[i]], smooth);
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
