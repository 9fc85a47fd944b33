// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_FIT_NEIGHBORHOODS_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_FIT_NEIGHBORHOODS_H

#include <CGAL/PN_recognition_3/internal/Found_regions.h>
#include <CGAL/PN_recognition_3/internal/Region.h>
#include <CGAL/PN_recognition_3/internal/Shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

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

  void operator()()
  {
    for (Index p = 0; p < c_.patches.size(); ++p) fit_at(p);
  }
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
      system.add({n.x, n.y, n.z}, dot(n, c_.patches[p].mean - origin));
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
    Shape_fit(points_, 12)(s, limit());
    if (is_on(s)) found_.try_shape(s, seeds);
  }
  double limit() const { return 100 * c_.tolerance(); }
  bool is_on(const Shape& s)
  {
    const bool result = Shape_fit::residual(s, points_) < limit();
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

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_FIT_NEIGHBORHOODS_H
