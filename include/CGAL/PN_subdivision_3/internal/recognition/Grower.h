// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_GROWER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_GROWER_H

#include <CGAL/PN_subdivision_3/internal/recognition/Region.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Shape.h>
#include <CGAL/PN_subdivision_3/internal/recognition/fit_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

// Collects the facets that are on a shape.
class Grower
{
public:
  explicit Grower(const Context& context)
    : c_(context)
    , cosine_(std::cos(context.greatest_smooth_angle / 2 + radians(1.1)))
    , stamp_(context.patches.size(), 0)
  {}

  // all vertices of a facet within t of the shape, its normal near that of the shape at each
  bool is_on(const Shape& s, Index p, double t, int side) const
  {
    const Patches::Patch& patch = c_.patches[p];
    if ((s.kind == Kind::sphere || s.kind == Kind::torus) && patch.vertices.size() > 4)
      return false;
    for (const Index v : patch.vertices) {
      const Vec3& x = c_.point(v);
      if (!(std::abs(s.distance(x)) <= t)) return false;
      const Vec3 n = s.normal(x);
      const bool is_apex = s.kind == Kind::cone && norm(x - s.apex()) <= 10 * t;
      if (!is_apex && !(side * dot(n, patch.normal) >= cosine_)) return false;
    }
    return true;
  }
  // on which side a facet is
  int side_of(const Shape& s, Index p) const
  {
    const Patches::Patch& patch = c_.patches[p];
    return dot(s.normal(patch.mean), patch.normal) < 0 ? -1 : 1;
  }

  std::vector<Index> grow(const Shape& s, const std::vector<Index>& seeds, double t, int side)
  {
    begin();
    std::vector<Index> result;
    for (const Index p : seeds)
      if (stamp_[p] != now_ && is_on(s, p, t, side)) take(p, result);
    for (std::size_t i = 0; i < result.size(); ++i)
      for (const Index number : c_.patches[result[i]].joints) {
        const Joint& j = c_.patches.joints[number];
        if (!j.is_smooth) continue;
        const Index q = j.other(result[i]);
        if (stamp_[q] == now_) continue;
        if (is_on(s, q, t, side))
          take(q, result);
        else
          stamp_[q] = now_;
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Grows and fits by turns until nothing changes; whether there is a region. What was taken on a generous tolerance may
  // have been too much, so that the fit leaves the seeds: then less of it.
  bool settle(Region& r, const std::vector<Index>& seeds, double t)
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

  // what must not be taken, for flats
  void ban(Index p) { banned_.push_back(p); }
  void lift_bans() { banned_.clear(); }

  void refit(Region& r) const
  {
    const std::vector<Vec3> points = c_.points_of(c_.vertices_of(r.patches));
    const Kind k = r.shape.kind;
    const std::size_t least = k == Kind::sphere     ? 5
                              : k == Kind::cylinder ? 6
                              : k == Kind::cone     ? 7
                                                    : 9;
    if (points.size() < least) return;
    Shape next = r.shape;
    Shape_fit(points, 3)(next);
    if (Shape_fit::residual(next, points) <= 1.5 * Shape_fit::residual(r.shape, points))
      r.shape = next;
  }

private:
  bool settle_from(Region& r, const std::vector<Index>& seeds, double t, std::size_t& first_size)
  {
    std::vector<Index> before;
    for (int k = 0; k < 8; ++k) {
      r.patches = grow(r.shape, seeds, t, r.side);
      if (k == 0) first_size = r.patches.size();
      if (r.patches.empty()) return false;
      if (t <= c_.tolerance() && r.patches == before) break;
      before = r.patches;
      refit(r);
      t = (std::max)(t / 10, c_.tolerance());
    }
    return true;
  }

  void begin()
  {
    ++now_;
    for (const Index p : banned_) stamp_[p] = now_;
  }
  void take(Index p, std::vector<Index>& result)
  {
    stamp_[p] = now_;
    result.push_back(p);
  }

  const Context& c_;
  double cosine_;
  std::vector<unsigned> stamp_;
  std::vector<Index> banned_;
  unsigned now_ = 0;
};

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_GROWER_H
