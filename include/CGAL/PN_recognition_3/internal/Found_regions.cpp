// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>

#include <numeric>

namespace CGAL::PN_subdivision_3::internal::recognition {

inline Found_regions::Found_regions(const Context& context)
  : c_(context)
  , grower_(context)
  , known_(context.patches.size())
  , has_region_(context.patches.size(), false)
  , is_settled_(context.patches.size(), false)
{}

inline bool Found_regions::is_known(Kind kind, const Seeds& seeds) const
{
  if (std::all_of(seeds.begin(), seeds.end(), [&](Index p) { return is_settled_[p]; })) return true;
  const auto have = [&](const std::pair<Kind, Index>& tried) {
    return tried.first == kind && std::all_of(seeds.begin(), seeds.end(), [&](Index p) {
             return std::find(known_[p].begin(), known_[p].end(), tried) != known_[p].end();
           });
  };
  return std::any_of(known_[seeds[0]].begin(), known_[seeds[0]].end(), have);
}

inline void Found_regions::try_shape(Shape s, const Seeds& seeds, Guess guess)
{
  const double least = c_.tolerance(),
               t = (std::max)(2 * least, (std::min)(50 * least, 0.02 * least_width(seeds)));
  if (is_known(s.kind, seeds)) return;
  if (!are_on(s, seeds, t) && (guess == Guess::exact || !fit_to(seeds, s) || !are_on(s, seeds, t)))
    return;
  if (guess != Guess::whole && !goes_on(s, seeds, t)) return;
  Region r;
  r.shape = s;
  if (!grower_.settle(r, seeds, t)) return;
  const bool holds = has_evidence(c_, grower_, r);
  if (holds || r.patches.size() >= 12) remember(std::move(r), holds);
}

inline double Found_regions::least_width(const Seeds& seeds) const
{
  double width = c_.part.size;
  for (const Index p : seeds) width = (std::min)(width, c_.patches[p].width);
  return width;
}

inline bool Found_regions::are_on(const Shape& s, const Seeds& seeds, double t) const
{
  const int side = grower_.side_of(s, seeds[0]);
  for (const Index p : seeds)
    if (!grower_.is_on(s, p, t, side)) return false;
  return true;
}

// a facet beside these is on the shape or tangent to it
inline bool Found_regions::goes_on(const Shape& s, const Seeds& seeds, double t) const
{
  const int side = grower_.side_of(s, seeds[0]);
  for (const Index p : seeds)
    for (const Index number : c_.patches[p].joints) {
      const Joint& j = c_.patches.joints[number];
      const Index q = j.other(p);
      if (!j.is_smooth || std::find(seeds.begin(), seeds.end(), q) != seeds.end()) continue;
      if (grower_.is_on(s, q, t, side) || is_tangent_along(c_, j, q, s, side, radians(2)))
        return true;
    }
  return false;
}

inline bool Found_regions::fit_to(const Seeds& seeds, Shape& s) const
{
  const std::vector<Vec3> points = c_.points_of(c_.vertices_of(seeds));
  if (!(greatest_distance(s, points) < 0.3 * least_width(seeds))) return false;
  return fit_shape(s, points, 12, 100 * c_.tolerance());
}

inline void Found_regions::remember(Region&& r, bool holds)
{
  const bool is_doubt_excluded = facts_of(r.shape.kind).is_doubly_curved && r.inner_vertices >= 30;
  for (const Index p : r.patches) {
    known_[p].emplace_back(r.shape.kind, number_);
    if (holds) has_region_[p] = true;
    if (holds && is_doubt_excluded) is_settled_[p] = true;
  }
  ++number_;
  if (holds) regions_.push_back(std::move(r));
}

// Of regions that overlap those of most facets, so that a sphere wins over its rows, which are exact cones.
inline std::vector<Region> choose_regions(const Context& c, std::vector<Region> all)
{
  std::vector<Index> order(all.size());
  std::iota(order.begin(), order.end(), Index(0));
  sort_numbers(order, [&](Index i, Index j) {
    const Region &a = all[i], &b = all[j];
    if (a.patches.size() != b.patches.size()) return a.patches.size() > b.patches.size();
    if (a.number_of_tangent_ends() != b.number_of_tangent_ends())
      return a.number_of_tangent_ends() > b.number_of_tangent_ends();
    if (a.shape.kind != b.shape.kind)
      return facts_of(a.shape.kind).rank < facts_of(b.shape.kind).rank;
    return a.patches < b.patches; // patches are numbered in the order of their vertices
  });
  std::vector<bool> is_taken(c.patches.size(), false);
  std::vector<Region> result;
  for (const Index i : order) {
    Region& r = all[i];
    std::vector<Index> rest;
    for (const Index p : r.patches)
      if (!is_taken[p]) rest.push_back(p);
    if (rest.size() < r.patches.size()) {
      if (5 * rest.size() < 3 * r.patches.size()) continue;
      r.patches = rest;
      measure(c, r);
      if (!is_evident(c, r)) continue;
    }
    for (const Index p : r.patches) is_taken[p] = true;
    result.push_back(std::move(r));
  }
  return result;
}

// --- fits to neighborhoods ---

// Least squares over the rings of facets around one that has no region: this finds trimmed faces, whose facets have no
// rulings.
class Fit_neighborhoods
{
public:
  Fit_neighborhoods(const Context& context, Found_regions& found)
    : c_(context)
    , found_(found)
    , ring_(context.patches.size(), 0)
  {}

  void fit_at(Index p)
  {
    for (int rings = 1; rings <= 3 && !found_.has_region(p); ++rings) {
      const Seeds seeds = neighborhood(p, rings);
      if (seeds.size() > 60) return;
      if (seeds.size() < 3) continue;
      points_ = c_.points_of(c_.vertices_of(seeds));
      is_near_ = points_.size() < 10;
      fit_sphere(seeds);
      fit_cylinder(seeds);
      fit_cone(seeds);
      if (!is_near_) return; // nor are more
    }
  }

private:
  using Seeds = Found_regions::Seeds;

  Seeds neighborhood(Index first, int rings)
  {
    ++now_;
    ring_[first] = now_;
    Seeds result{first};
    std::size_t begin = 0;
    for (int k = 0; k < rings && result.size() <= 60; ++k) {
      const std::size_t end = result.size();
      for (; begin < end; ++begin)
        for (const Index number : c_.patches[result[begin]].joints) {
          const Joint& j = c_.patches.joints[number];
          const Index q = j.other(result[begin]);
          if (!j.is_smooth || ring_[q] == now_ ||
              !(c_.patches[q].area < 20 * c_.patches[first].area))
            continue;
          ring_[q] = now_;
          result.push_back(q);
        }
    }
    return result;
  }

  void fit_sphere(const Seeds& seeds)
  {
    Shape s;
    if (points_.size() >= 5 && !is_known(Kind::sphere, seeds) && sphere_through(points_, s) &&
        is_on(s))
      found_.try_shape(s, seeds);
  }

  void fit_cylinder(const Seeds& seeds)
  {
    if (points_.size() < 6 || is_known(Kind::cylinder, seeds)) return;
    Covariance covariance;
    for (const Index p : seeds) covariance.add(c_.patches[p].normal);
    Shape s;
    s.kind = Kind::cylinder;
    s.axis = covariance.least_direction();
    if (circle_through(points_, s.axis, s.center, s.radius)) polish(s, seeds);
  }

  void fit_cone(const Seeds& seeds)
  {
    if (points_.size() < 7 || is_known(Kind::cone, seeds)) return;
    Vec3 mean;
    for (const Index p : seeds) mean += (1 / double(seeds.size())) * c_.patches[p].normal;
    Covariance covariance;
    Least_squares system(3);
    const Vec3& origin = c_.patches[seeds[0]].mean;
    for (const Index p : seeds) {
      const Vec3& n = c_.patches[p].normal;
      covariance.add(n - mean);
      system.add({n[0], n[1], n[2]}, dot(n, c_.patches[p].mean - origin));
    }
    const Least_squares::Row x = system.solve();
    Shape s;
    s.kind = Kind::cone;
    s.axis = covariance.least_direction();
    const Vec3 apex = origin + Vec3{x[0], x[1], x[2]};
    double rho = 0, z = 0;
    for (const Vec3& p : points_) z += dot(p - apex, s.axis) / double(points_.size());
    if (z < 0) {
      s.axis = -s.axis;
      z = -z;
    }
    for (const Vec3& p : points_) rho += cylindrical(p, apex, s.axis).rho / double(points_.size());
    s.set_angle(std::atan2(rho, z));
    s.radius = rho;
    s.center = apex + z * s.axis;
    if (s.angle > radians(0.2) && s.angle < radians(89.7)) polish(s, seeds);
  }

  void polish(Shape& s, const Seeds& seeds)
  {
    fit_shape(s, points_, 12, limit());
    if (is_on(s)) found_.try_shape(s, seeds);
  }
  double limit() const { return 100 * c_.tolerance(); }
  bool is_on(const Shape& s)
  {
    const bool result = greatest_distance(s, points_) < limit();
    is_near_ = is_near_ || result;
    return result;
  }
  bool is_known(Kind kind, const Seeds& seeds)
  {
    const bool result = found_.is_known(kind, seeds);
    is_near_ = is_near_ || result;
    return result;
  }

  const Context& c_;
  Found_regions& found_;
  std::vector<unsigned> ring_;
  unsigned now_ = 0;
  std::vector<Vec3> points_;
  bool is_near_ = false; // one of the shapes to all points
};

// Some facets first, since in the large regions that they are in there is nothing left to guess.
inline std::vector<Region> find_regions(const Context& context)
{
  Found_regions found(context);
  constexpr Index samples = 200;
  Fit_neighborhoods by_fits(context, found);
  for (Index p = 0; p < context.patches.size(); p += context.patches.size() / samples + 1) {
    guess_by_rows(context, found, p);
    by_fits.fit_at(p);
  }
  guess_by_apexes(context, found);
  guess_by_rulings(context, found);
  for (Index p = 0; p < context.patches.size(); ++p) guess_by_rows(context, found, p);
  for (Index p = 0; p < context.patches.size(); ++p) by_fits.fit_at(p);
  return choose_regions(context, found.take_regions());
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
