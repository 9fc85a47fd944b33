// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Normals and roundness from points, as the manual defines them: vertex by vertex and face by face, in long double,
// with no guards but against division by zero. Includes nothing of the package.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_COHERENT_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_COHERENT_NORMALS_H

#include "Control_normals.h"

namespace reference {

class Coherent_normals
{
public:
  std::vector<Point_3> normals;
  std::vector<Real> roundness;

  Coherent_normals(const Face_list& mesh, const std::vector<Point_3>& points)
    : normals(points.size(), Point_3::Zero())
    , mesh_(mesh)
    , p_(points)
    , reciprocal_(Control_normals(mesh, points).reciprocal())
  {
    const int n = int(points.size());
    for (int v = 0; v < n; ++v) {
      area_.push_back(area_normal(v));
      if (mesh.is_border(v)) continue;
      Point_3& r = reciprocal_[std::size_t(v)];
      r = fan_normal(v);
      if (r.isZero()) r = area_.back();
    }
    std::vector<Real> regular, dips, misses, alone;
    for (int v = 0; v < n; ++v) regular.push_back(make_normal(v));
    for (int v = 0; v < n; ++v) {
      const auto i = std::size_t(v);
      dips.push_back(1 - window(dip_in_shortest_edges(v, normals[i]), 2, 4));
      misses.push_back(share_of_misses(v));
      alone.push_back(regular[i] * (1 - misses[i] * (1 - dips[i])));
    }
    for (int v = 0; v < n; ++v) {
      const auto i = std::size_t(v);
      Real beside = 1;
      for (int j : mesh.ring(v)) {
        const Real other = alone[std::size_t(j)];
        beside = std::min(beside, 1 - (1 - other) * window(error_beside(v, j), 0.3L, 0.6L));
      }
      Real spread = 0;
      for (const Face& f : mesh.faces())
        if (std::find(f.begin(), f.end(), v) != f.end()) spread = std::max(spread, spread_over(f));
      const Real lifted = window(lift(v), 0.5L, 1), spreads = window(spread, 0.2L, 0.4L);
      const Real share = dips[i] * beside * (1 - lifted) * (1 - spreads);
      roundness.push_back(regular[i] * (1 - misses[i] * (1 - share)));
    }
  }

private:
  const Point_3& at(int v) const { return p_[std::size_t(v)]; }

  static Real window(Real x, Real low, Real high)
  {
    if (x <= low) return 0;
    if (x >= high) return 1;
    const Real y = (x - low) / (high - low);
    return y * y * (3 - 2 * y);
  }

  static Point_3 unit(const Point_3& x)
  {
    return x.norm() > 0 ? Point_3(x / x.norm()) : Point_3(Point_3::Zero());
  }

  Point_3 area_normal(int v) const
  {
    Point_3 sum = Point_3::Zero();
    for (const Face& f : mesh_.faces())
      for (int corner : f) {
        if (corner != v) continue;
        for (std::size_t i = 0; i < f.size(); ++i)
          sum += (at(f[i]) - at(f[0])).cross(at(f[(i + 1) % f.size()]) - at(f[0]));
      }
    return unit(sum);
  }

  // corners of the fan as pairs of vectors, counterclockwise
  std::vector<std::pair<Point_3, Point_3>> corners(int v) const
  {
    std::vector<std::pair<Point_3, Point_3>> result;
    for (const Face& f : mesh_.faces())
      for (std::size_t i = 0; i < f.size(); ++i)
        if (f[i] == v)
          result.emplace_back(at(f[(i + 1) % f.size()]) - at(v),
                              at(f[(i + f.size() - 1) % f.size()]) - at(v));
    return result;
  }

  Point_3 fan_normal(int v) const
  {
    Point_3 sum = Point_3::Zero();
    for (const auto& [a, b] : corners(v)) sum += (a / a.squaredNorm()).cross(b / b.squaredNorm());
    return unit(sum);
  }

  Real turn_share(int v, const Point_3& n) const
  {
    const Real degree = std::acos(Real(-1)) / 180;
    Real least = 1;
    for (const auto& [a, b] : corners(v)) {
      const Point_3 c = a.cross(b);
      if (c.norm() > 1e-14L * std::max(a.squaredNorm(), b.squaredNorm()))
        least = std::min(least, n.dot(c) / c.norm());
    }
    return window(least, std::cos(45 * degree), std::cos(36 * degree));
  }

  Real arc_error(int v, int j, const std::vector<Point_3>& n) const
  {
    const Point_3 e = at(j) - at(v);
    return std::abs((n[std::size_t(v)] + n[std::size_t(j)]).dot(e)) / e.norm();
  }

  // from 0 where all arcs meet to 1e-6 to 1 where one misses by 1e-3
  Real share_of_misses(int v) const
  {
    Real miss = 1e-9L;
    for (int j : mesh_.ring(v))
      miss =
        std::max(miss, at(j) != at(v) ? arc_error(v, j, normals)
                                      : (normals[std::size_t(v)] - normals[std::size_t(j)]).norm());
    return window(std::log10(miss), -6, -3);
  }

  // from 0 where the longest edge is 6 times the shortest one to 1 where it is 7 times that
  static Real uneven(Real longest, Real shortest)
  {
    return longest > 6 * shortest ? std::min(Real(1), longest / shortest - 6) : 0;
  }

  // of the arc from v to j relative to the edge; to the shortest one of j where these are uneven
  Real error_beside(int v, int j) const
  {
    const Point_3 e = at(j) - at(v);
    if (!(e.norm() > 0)) return 1;
    Real s = HUGE_VALL, l = 0;
    for (int k : mesh_.ring(j)) {
      const Real length = (at(k) - at(j)).norm();
      if (length > 0) s = std::min(s, length);
      l = std::max(l, length);
    }
    const Real u = uneven(l, s);
    return arc_error(v, j, normals) * (1 - u + u * e.norm() / s);
  }

  // How much the heights of arcs from the corners of a face over their mean differ from their own mean, on average, in
  // widths of the face.
  Real spread_over(const Face& f) const
  {
    const Real m = Real(f.size());
    Point_3 q = Point_3::Zero(), sum = Point_3::Zero();
    Real s = HUGE_VALL, l = 0, mean = 0, spread = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      const Real length = (at(f[i]) - at(f[i == 0 ? f.size() - 1 : i - 1])).norm();
      s = std::min(s, length);
      l = std::max(l, length);
      q += at(f[i]) / m;
      sum += normals[std::size_t(f[i])];
    }
    if (!(l > 6 * s) || sum.isZero()) return 0;
    const Point_3 n = unit(sum);
    std::vector<Real> heights;
    for (int v : f) {
      const Point_3& n_v = normals[std::size_t(v)];
      heights.push_back((n_v + n).dot(at(v) - q) / std::max(Real(1), (n_v + n).dot(n)));
      mean += heights.back() / m;
    }
    for (Real h : heights) spread += std::abs(h - mean) / m;
    return uneven(l, s) * spread / std::max(s, l / 1024);
  }

  // the length of the shortest edge over that of the longest
  Real evenness(int v) const
  {
    Real least = HUGE_VALL, most = 0;
    for (int j : mesh_.ring(v)) {
      const Real length = (at(j) - at(v)).norm();
      if (length > 0) least = std::min(least, length);
      most = std::max(most, length);
    }
    return least / most;
  }

  // how far edges dip below the tangent plane, in lengths of the shortest edge
  Real dip_in_shortest_edges(int v, const Point_3& n) const
  {
    Real least = HUGE_VALL, dip = 0;
    for (int j : mesh_.ring(v)) {
      const Point_3 e = at(j) - at(v);
      if (e.norm() > 0) least = std::min(least, e.norm());
      dip = std::max(dip, std::abs(n.dot(e)));
    }
    return dip > 0 ? dip / least : 0;
  }

  // How far the point-normal rule with the weights 5/8 of an interior vertex and 3/8 of its neighbors takes that
  // above its tangent plane and all neighbors, or below; by the shortest edge s and the longest one l it is (l - 4s)/s^2
  // of that.
  Real lift(int v) const
  {
    if (mesh_.is_border(v)) return 0;
    const Point_3& n = normals[std::size_t(v)];
    std::vector<std::pair<Point_3, Point_3>> entries; // points beside that of v, and normals
    Real s = HUGE_VALL, l = 0;
    for (int j : mesh_.ring(v)) {
      const Point_3 e = at(j) - at(v);
      if (!(e.norm() > 0)) continue;
      entries.emplace_back(e, normals[std::size_t(j)]);
      s = std::min(s, e.norm());
      l = std::max(l, e.norm());
    }
    if (!(l > 4 * s)) return 0;
    std::vector<Real> heights{0};
    std::vector<Real> weights(entries.size(), Real(3) / Real(8 * entries.size()));
    for (const auto& [e, m] : entries) heights.push_back(n.dot(e));
    entries.emplace_back(Point_3::Zero(), n);
    weights.push_back(Real(5) / 8);
    Point_3 q = Point_3::Zero(), sum = Point_3::Zero();
    for (std::size_t i = 0; i < entries.size(); ++i) {
      q += weights[i] * entries[i].first;
      sum += weights[i] * entries[i].second;
    }
    const Point_3 u = unit(sum);
    Point_3 p = q;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const auto& [e, m] = entries[i];
      p += weights[i] * (m + u).dot(e - q) / std::max(Real(1), (m + u).dot(u)) * u;
    }
    const auto range = std::minmax_element(heights.begin(), heights.end());
    return std::max(n.dot(p) - *range.second, *range.first - n.dot(p)) * (l - 4 * s) / (s * s);
  }

  Real mismatch(int v, const Point_3& n) const
  {
    Real sum = 0;
    for (int j : mesh_.ring(v)) {
      const Point_3 e = at(j) - at(v);
      const Real x = (n + reciprocal_[std::size_t(j)]).dot(e) / e.squaredNorm();
      sum += x * x;
    }
    return sum;
  }

  // returns its roundness if all arcs meet
  Real make_normal(int v)
  {
    const Point_3 &r = reciprocal_[std::size_t(v)], &a = area_[std::size_t(v)];
    Point_3& n = normals[std::size_t(v)];
    if (mesh_.ring(v).empty()) return 1;
    Real g = 0;
    for (int j : mesh_.ring(v)) g = std::max(g, arc_error(v, j, reciprocal_));
    const Real rho = (1 - window((r - a).norm(), 0.1L, 0.3L)) * (1 - window(g, 0.1L, 0.3L)) *
                     window(evenness(v), 1 / 12.L, 1 / 6.L);
    n = r;
    if (!mesh_.is_border(v)) {
      const Real er = mismatch(v, r), ea = mismatch(v, a);
      const Real t = er + ea > 0 ? window(ea / (er + ea), 0.2L, 0.5L) : 1;
      const Real f = turn_share(v, r), s = t * (f + (1 - f) * rho);
      n = unit(s * r + (1 - s) * a);
    }
    if (n.isZero()) return 0;
    const Real f = turn_share(v, n);
    return f + (1 - f) * rho;
  }

  const Face_list& mesh_;
  const std::vector<Point_3>& p_;
  std::vector<Point_3> reciprocal_, area_;
};

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_COHERENT_NORMALS_H
