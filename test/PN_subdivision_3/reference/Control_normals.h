// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control normals from points, written from the formulas on a list of faces, vertex by vertex, in
// long double and with angles where the package has none. Meshes without degenerate fans only.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CONTROL_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CONTROL_NORMALS_H

#include "Face_list.h"

#include <Eigen/Geometry>

#include <optional>

namespace reference {

using Point_3 = Eigen::Matrix<Real, 3, 1>;

class Control_normals
{
public:
  Control_normals(const Face_list& mesh, const std::vector<Point_3>& points)
    : mesh_(mesh)
    , p_(points)
  {}

  std::vector<Point_3> angle_weighted() const
  {
    std::vector<Point_3> sums(p_.size(), Point_3::Zero());
    for (const Face& f : mesh_.faces()) {
      for (std::size_t i = 0; i < f.size(); ++i) {
        const Point_3 a = at(f[(i + f.size() - 1) % f.size()]) - at(f[i]);
        const Point_3 b = at(f[(i + 1) % f.size()]) - at(f[i]);
        sums[std::size_t(f[i])] += angle(a, b) * area(f).normalized();
      }
    }
    for (Point_3& n : sums)
      if (!n.isZero()) n.normalize();
    return sums;
  }

  std::vector<Point_3> reciprocal() const
  {
    const std::size_t count = p_.size();
    std::vector<Point_3> unblended(count, Point_3::Zero());
    std::vector<int> sweep(count, 0); // in which an arc may have found it; interior vertices: 1
    for (int v = 0; v < int(count); ++v) {
      unblended[std::size_t(v)] = fan_normal(v);
      if (!mesh_.ring(v).empty() && !mesh_.is_border(v)) sweep[std::size_t(v)] = 1;
    }
    constexpr int failed = -1;
    for (int now : {2, 3}) {
      const std::vector<Point_3> known = unblended;
      const std::vector<int> before = sweep;
      for (int v = 0; v < int(count); ++v) {
        if (mesh_.ring(v).empty() || before[std::size_t(v)] != 0) continue;
        if (!has_known_neighbor(v, before)) continue;
        const auto n = by_arcs(v, known, before);
        sweep[std::size_t(v)] = n ? now : failed;
        if (n) unblended[std::size_t(v)] = *n;
      }
    }
    std::vector<Point_3> result = angle_weighted();
    for (int v = 0; v < int(count); ++v) {
      if (mesh_.ring(v).empty()) continue;
      const Real w = weight(v, unblended[std::size_t(v)]);
      Point_3& n = result[std::size_t(v)];
      n = (w * unblended[std::size_t(v)] + (1 - w) * n).normalized();
    }
    return result;
  }

private:
  const Point_3& at(int v) const { return p_[std::size_t(v)]; }

  static Real angle(const Point_3& a, const Point_3& b)
  {
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }
  Point_3 area(const Face& f) const
  {
    Point_3 sum = Point_3::Zero();
    for (std::size_t i = 0; i < f.size(); ++i) sum += at(f[i]).cross(at(f[(i + 1) % f.size()]));
    return sum;
  }
  static Point_3 inverted(const Point_3& e) { return e / e.squaredNorm(); }

  // f(edge, next edge) counterclockwise
  template <class Function>
  void for_each_corner(int v, const Function& f) const
  {
    const std::vector<int> ring = mesh_.ring(v);
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (i + 1 == n && mesh_.is_border(v)) return;
      f(at(ring[i]) - at(v), at(ring[(i + 1) % n]) - at(v));
    }
  }

  Point_3 fan_normal(int v) const
  {
    Point_3 sum = Point_3::Zero();
    for_each_corner(
      v, [&](const Point_3& a, const Point_3& b) { sum += inverted(a).cross(inverted(b)); });
    return sum.isZero() ? sum : sum.normalized();
  }

  bool has_known_neighbor(int v, const std::vector<int>& sweep) const
  {
    const std::vector<int> ring = mesh_.ring(v);
    return std::any_of(ring.begin(), ring.end(), [&](int j) { return sweep[std::size_t(j)] > 0; });
  }

  // the border normal from the neighbors that an earlier sweep has found
  std::optional<Point_3> by_arcs(int v, const std::vector<Point_3>& known,
                                 const std::vector<int>& sweep) const
  {
    const std::vector<int> ring = mesh_.ring(v);
    const Point_3 open = fan_normal(v);
    const Point_3 t =
      (inverted(at(ring.front()) - at(v)) - inverted(at(ring.back()) - at(v))).normalized();
    const Point_3 a = (open - open.dot(t) * t).normalized();
    const auto normal = [&](Real x) -> Point_3 {
      return Eigen::AngleAxis<Real>(x, -t) * a; // cos(x) a + sin(x) a x t
    };
    const auto slope = [&](Real x) {
      Real sum = 0;
      const Point_3 n = normal(x);
      for (int j : ring) {
        if (sweep[std::size_t(j)] <= 0) continue;
        const Point_3 u = (at(j) - at(v)).normalized();
        sum += (n + known[std::size_t(j)]).dot(u) * n.cross(t).dot(u);
      }
      return sum;
    };
    // downhill in small steps as far as that goes
    const Real direction = slope(0) > 0 ? -1 : 1;
    Real low = 0, high = 0;
    while (std::abs(high) < 4 && slope(high) * direction < 0) {
      low = high;
      high += direction / 128;
    }
    for (int halving = 0; halving < 70; ++halving) {
      const Real middle = (low + high) / 2;
      (slope(middle) * direction < 0 ? low : high) = middle;
    }
    const Real phi = low;
    if (normal(phi).dot(open) <= Real(0.3)) return std::nullopt;
    return normal(phi);
  }

  // the least cosine of the turns of the corners, with what faces of more than three corners add
  Real least_cosine(int v, const Point_3& n) const
  {
    Real least = 1;
    const std::vector<int> ring = mesh_.ring(v);
    std::size_t i = 0;
    for_each_corner(v, [&](const Point_3& a, const Point_3& b) {
      Real c = std::cos(angle(n, a.cross(b)));
      const Face& f = mesh_.faces()[std::size_t(mesh_.face(v, ring[i++]))];
      const Real fade = std::clamp(2 * c, Real(0), Real(1));
      if (f.size() > 3)
        c += fade * fade * (3 - 2 * fade) * std::max(Real(0), std::cos(angle(n, area(f))) - c);
      least = std::min(least, c);
    });
    return least;
  }

  Real weight(int v, const Point_3& n) const
  {
    const Real degree = std::acos(Real(-1)) / 180;
    const Real x = (least_cosine(v, n) - std::cos(60 * degree)) /
                   (std::cos(40 * degree) - std::cos(60 * degree));
    const Real c = std::clamp(x, Real(0), Real(1));
    return c * c * (3 - 2 * c);
  }

  const Face_list& mesh_;
  const std::vector<Point_3>& p_;
};

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CONTROL_NORMALS_H
