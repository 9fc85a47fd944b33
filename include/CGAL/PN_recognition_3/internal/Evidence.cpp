// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>

namespace CGAL::PN_subdivision_3::internal::recognition {

// --- growing ---

inline bool Grower::is_on(const Shape& s, Index p, double t, int side) const
{
  const Patches::Patch& patch = c_.patches[p];
  if (facts_of(s.kind).is_doubly_curved && patch.vertices.size() > 4) return false;
  Cylindrical q;
  for (const Index v : patch.vertices) {
    const Vec3& x = c_.point(v);
    if (!(std::abs(s.distance(x, q)) <= t)) return false;
    const bool is_along = side * dot(s.normal(x, q), patch.normal) >= cosine_;
    if (!is_along && !(s.kind == Kind::cone && norm(x - s.apex()) <= 10 * t)) return false;
  }
  return true;
}

inline int Grower::side_of(const Shape& s, Index p) const
{
  const Patches::Patch& patch = c_.patches[p];
  return dot(s.normal(patch.mean), patch.normal) < 0 ? -1 : 1;
}

inline std::vector<Index> Grower::grow(const Shape& s, const std::vector<Index>& seeds, double t,
                                       int side)
{
  ++now_;
  for (const Index p : banned_) stamp_[p] = now_;
  std::vector<Index> result;
  const auto try_patch = [&](Index p) {
    if (std::exchange(stamp_[p], now_) != now_ && is_on(s, p, t, side)) result.push_back(p);
  };
  for (const Index p : seeds) try_patch(p);
  for (std::size_t i = 0; i < result.size(); ++i)
    for (const Index number : c_.patches[result[i]].joints) {
      const Joint& j = c_.patches.joints[number];
      if (j.is_smooth) try_patch(j.other(result[i]));
    }
  std::sort(result.begin(), result.end());
  return result;
}

inline bool Grower::settle_from(Region& r, const std::vector<Index>& seeds, double t,
                                std::size_t& first_size)
{
  std::vector<Index> before;
  for (int k = 0; k < 8; ++k) {
    r.patches = grow(r.shape, seeds, t, r.side);
    if (k == 0) first_size = r.patches.size();
    if (r.patches.empty()) return false;
    if (t <= c_.tolerance() && r.patches == before) break;
    before = r.patches;
    const std::vector<Vec3> points = c_.points_of(c_.vertices_of(r.patches));
    if (points.size() >= facts_of(r.shape.kind).least_points) fit_shape(r.shape, points, 3);
    t = (std::max)(t / 10, c_.tolerance());
  }
  return true;
}

inline bool Grower::settle(Region& r, const std::vector<Index>& seeds, double t)
{
  if (seeds.empty()) return false;
  const Shape guess = r.shape;
  r.side = side_of(guess, seeds[0]);
  for (; t >= c_.tolerance(); t /= 8) {
    r.shape = guess;
    std::size_t first_size = 0;
    if (settle_from(r, seeds, t, first_size)) return true;
    if (first_size < 5) return false;
  }
  return false;
}

// --- evidence ---

inline bool has_sensible_size(const Context& c, const Region& r)
{
  const Shape& s = r.shape;
  switch (s.kind) {
  case Kind::unknown:
  case Kind::plane:
    break;
  case Kind::cylinder:
  case Kind::sphere:
    return s.radius <= 50 * c.part.size;
  case Kind::cone:
    return s.angle > radians(0.5) && s.angle < radians(89.5);
  case Kind::torus:
    return s.radius <= 20 * c.part.size;
  }
  return false;
}

inline bool is_bend_visible(const Context& c, const Region& r, double sagitta,
                            std::size_t positions)
{
  const double tolerance = c.tolerance();
  return !(r.residual > sagitta / 10 && sagitta < 10 * tolerance) &&
         sagitta * double(positions) >= 4 * tolerance;
}

inline bool bends(const Context& c, const Region& r)
{
  const Shape& s = r.shape;
  const auto sagitta = [](double radius, double step) { return radius * (1 - std::cos(step / 2)); };
  const Kind_facts facts = facts_of(s.kind);
  if (!facts.turns_about_axis)
    return is_bend_visible(c, r, sagitta(s.radius, r.widest_angle), r.vertices.size());
  const double factor = s.kind == Kind::cone ? s.cosine : 1;
  if (!is_bend_visible(c, r, factor * sagitta(r.greatest_rho, r.turn.widest),
                       r.turn.positions.size()))
    return false;
  return !facts.has_tube ||
         is_bend_visible(c, r, sagitta(s.tube, r.meridian.widest), r.meridian.positions.size());
}

// a facet alone may have its vertices at many angles
inline std::size_t number_of_positions(const Region& r)
{
  return (std::min)(r.turn.positions.size(), r.patches.size() + 1);
}

inline bool is_cylinder(const Region& r)
{
  const std::size_t n = number_of_positions(r);
  const int ends = r.number_of_tangent_ends();
  if (n >= 5) return true;
  if (n == 4)
    return ends > 0 || (r.turn.widest <= 1.02 * r.turn.least && r.turn.widest <= radians(31));
  return n == 3 && ends == 2;
}

inline bool are_others_in_a_plane(const Context& c, const Region& r, Index hub)
{
  Vec3 mean;
  for (const Index v : r.vertices)
    if (v != hub) mean += (1 / double(r.vertices.size() - 1)) * c.point(v);
  Covariance covariance;
  for (const Index v : r.vertices)
    if (v != hub) covariance.add(c.point(v) - mean);
  const Vec3 normal = covariance.least_direction();
  for (const Index v : r.vertices)
    if (v != hub && std::abs(dot(normal, c.point(v) - mean)) > 4 * c.tolerance()) return false;
  return true;
}

// a circle and a point are on a sphere anyway
inline bool is_fan(const Context& c, const Region& r)
{
  const std::vector<Index>& first = c.patches[r.patches[0]].vertices;
  return std::any_of(first.begin(), first.end(), [&](Index v) {
    return c.have_vertex(r.patches, v) && are_others_in_a_plane(c, r, v);
  });
}

inline bool is_cone(const Region& r)
{
  return number_of_positions(r) >= 4 && r.vertices.size() >= (r.turn.is_full ? 7u : 8u);
}

inline bool has_even_gaps(const Turn& turn)
{
  double least = 0, most = 0;
  for (std::size_t i = 0; i + 1 < turn.positions.size(); ++i) {
    const double gap = turn.positions[i + 1] - turn.positions[i];
    least = i == 0 ? gap : (std::min)(least, gap);
    most = (std::max)(most, gap);
  }
  return most <= 1.75 * least;
}

inline bool is_torus(const Region& r)
{
  const std::size_t n = r.turn.positions.size(), m = r.meridian.positions.size();
  return r.inner_vertices >= 2 && n >= 4 && m >= (r.has_tangent_end ? 3u : 4u) &&
         (n > 4 || has_even_gaps(r.turn)) && (m > 4 || has_even_gaps(r.meridian)) &&
         (r.has_tangent_end || r.patches.size() >= 10);
}

inline bool is_evident(const Context& c, const Region& r)
{
  if (!has_sensible_size(c, r) || !bends(c, r)) return false;
  if (r.turn.widest > c.greatest_smooth_angle || r.meridian.widest > c.greatest_smooth_angle)
    return false;
  switch (r.shape.kind) {
  case Kind::cylinder:
    return is_cylinder(r);
  case Kind::cone:
    return is_cone(r);
  case Kind::sphere:
    return r.vertices.size() >= 7 && r.inner_vertices >= 1 && !is_fan(c, r);
  case Kind::torus:
    return is_torus(r);
  case Kind::unknown:
  case Kind::plane:
    break;
  }
  return false;
}

// again from the rest
inline bool grow_rest(const Context& c, Grower& grower, Region& r, const std::vector<Index>& rest)
{
  for (const Index p : rest) {
    Region next = r;
    if (!grower.settle(next, {p}, c.tolerance())) continue;
    r = next;
    measure(c, r);
    return true;
  }
  return false;
}

// Few facets that are much wider than all others are no part of the round: tessellators halve steps, they do not
// double them.
inline bool take_flats_out(const Context& c, Grower& grower, Region& r)
{
  for (int k = 0; k < 4; ++k) {
    std::vector<Index> flats, rest;
    double next = 0;
    for (std::size_t i = 0; i < r.patches.size(); ++i)
      if (r.turn.spans[i] >= 0.9 * r.turn.widest)
        flats.push_back(r.patches[i]);
      else {
        next = (std::max)(next, r.turn.spans[i]);
        rest.push_back(r.patches[i]);
      }
    const bool are_few = flats.size() <= 2 || 10 * flats.size() <= r.patches.size();
    if (rest.empty() || !are_few || !(r.turn.widest > 1.75 * next)) break;
    for (const Index p : flats) grower.ban(p);
    if (!grow_rest(c, grower, r, rest)) return false;
  }
  return true;
}

inline bool has_evidence(const Context& c, Grower& grower, Region& r)
{
  measure(c, r);
  const bool has_round = take_flats_out(c, grower, r);
  grower.lift_bans();
  return has_round && is_evident(c, r);
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
