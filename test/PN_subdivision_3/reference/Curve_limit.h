// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The limit of a curve by many rounds of the reference rules on a window of points that moves and shrinks
// with the vertex, or with the edge of a dual scheme.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CURVE_LIMIT_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CURVE_LIMIT_H

#include "Curve.h"
#include "PN_rule.h"

namespace reference {

struct Curve_limit
{
  Vector point, control_normal, tangent;
  Real curvature = 0; // not negative
};

class Curve_limit_by_rounds
{
public:
  // The normals' scheme may be another one. Both are primal or both dual.
  Curve_limit_by_rounds(const Curve_scheme& scheme, const Curve_scheme& normal_scheme, bool linear,
                        Real roundness = 1)
    : scheme_(scheme)
    , normal_scheme_(normal_scheme)
    , linear_(linear)
    , roundness_(roundness)
  {}

  // of vertex v, or of the edge behind it
  Curve_limit operator()(const Values& polygon, long v, End end)
  {
    start(polygon, v, end);
    Vector offset = Vector::Zero();
    Curve_limit limit;
    for (int k = 0; k < 40; ++k) {
      const Vector center = window_.points[std::size_t(center_)];
      offset += center;
      for (Vector& p : window_.points) p -= center;
      if (k == 16) limit.curvature = curvature();
      if (k == 28) limit.tangent = tangent();
      refine();
    }
    const std::size_t c = std::size_t(center_);
    limit.point = offset + window_.points[c];
    limit.control_normal = window_.normals[c];
    if (!scheme_.primal()) {
      limit.point = offset + (window_.points[c] + window_.points[c + 1]) / 2;
      limit.control_normal = window_.normals[c] + window_.normals[c + 1];
    }
    if (limit.control_normal.norm() > 0) limit.control_normal.normalize();
    return limit;
  }

private:
  long before() const { return scheme_.primal() ? 8 : 7; }

  void start(const Values& polygon, long v, End end)
  {
    const long n = long(polygon.points.size());
    window_ = Values();
    center_ = 0;
    for (long j = v - before(); j <= v + 8; ++j) {
      if (end != End::closed && (j < 0 || j >= n)) continue;
      if (j < v) ++center_;
      window_.points.push_back(polygon.points[std::size_t(((j % n) + n) % n)]);
      window_.normals.push_back(polygon.normals[std::size_t(((j % n) + n) % n)]);
    }
  }

  // What comes of the window's own ends is cut off, unless the curve ends there.
  void refine()
  {
    const long n = long(window_.points.size());
    const auto& [points, normals] = matrices(n);
    Values next;
    const long first = std::max(0L, 2 * center_ - before());
    const long last = std::min(long(points.rows()) - 1, 2 * center_ + 8);
    for (long i = first; i <= last; ++i) {
      Vector p = Vector::Zero();
      for (long j = 0; j < n; ++j) p += points(i, j) * window_.points[std::size_t(j)];
      if (linear_) {
        next.points.push_back(p);
        next.normals.push_back(Vector::Zero());
      } else {
        const Point_normal value = pn_rule(points.row(i), normals.row(i), window_);
        next.points.push_back(p + roundness_ * (value.point - p));
        next.normals.push_back(value.normal);
      }
    }
    center_ = 2 * center_ - first;
    window_ = next;
  }

  const std::pair<Matrix, Matrix>& matrices(long n)
  {
    auto& m = matrices_[n];
    if (m.first.size() == 0)
      m = {curve_matrix(scheme_, n, End::reflect), curve_matrix(normal_scheme_, n, End::reflect)};
    return m;
  }

  Vector tangent() const
  {
    const long last = long(window_.points.size()) - 1;
    const long i = scheme_.primal() ? std::max(0L, center_ - 1) : center_;
    const long j = std::min(last, center_ + 1);
    return (window_.points[std::size_t(j)] - window_.points[std::size_t(i)]).normalized();
  }

  // of the circle through three points
  Real curvature() const
  {
    const long last = long(window_.points.size()) - 1;
    const std::size_t m = std::size_t(std::min(last - 1, std::max(1L, center_)));
    const Vector a = window_.points[m] - window_.points[m - 1];
    const Vector b = window_.points[m + 1] - window_.points[m];
    return 2 * a.cross(b).norm() / (a.norm() * b.norm() * (a + b).norm());
  }

  Curve_scheme scheme_, normal_scheme_;
  bool linear_;
  Real roundness_;
  std::map<long, std::pair<Matrix, Matrix>> matrices_;
  Values window_;
  long center_ = 0;
};

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CURVE_LIMIT_H
