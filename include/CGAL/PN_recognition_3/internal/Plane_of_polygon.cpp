// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/recognition_interface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::PN_subdivision_3::internal::recognition {

CGAL_PN_RECOGNITION_3_INLINE void Plane_of_polygon::set(std::vector<Vec3> p, bool is_in_space,
                                                        bool closed, double tolerance)
{
  std::vector<double> coordinates;
  for (const Vec3& q : p) {
    coordinates.insert(coordinates.end(), {q[0], q[1]});
    if (is_in_space) coordinates.push_back(q[2]);
  }
  scale(p);
  tolerance_ = tolerance > 0 ? tolerance / scale_ : 2 * file_rounding(coordinates) / scale_ + 1e-8;
  if (is_in_space) find_plane(p, closed);
  for (const Vec3& q : p) points_.push_back({dot(u_, q), dot(v_, q)});
}

CGAL_PN_RECOGNITION_3_INLINE std::array<double, 3> Plane_of_polygon::in_space(const Point& p) const
{
  return origin_ + scale_ * (p[0] * u_ + p[1] * v_ + height_ * cross(u_, v_));
}

CGAL_PN_RECOGNITION_3_INLINE Plane_of_polygon::Point
Plane_of_polygon::in_plane(const std::array<double, 3>& p) const
{
  const Vec3 d = (1 / scale_) * (Vec3(p) - origin_);
  return {dot(u_, d), dot(v_, d)};
}

CGAL_PN_RECOGNITION_3_INLINE std::array<double, 3>
Plane_of_polygon::direction_in_space(const Point& d) const
{
  return d[0] * u_ + d[1] * v_;
}

inline void Plane_of_polygon::scale(std::vector<Vec3>& p)
{
  if (p.empty()) return;
  Vec3 low = p[0], high = p[0];
  for (const Vec3& q : p) {
    low = {(std::min)(low[0], q[0]), (std::min)(low[1], q[1]), (std::min)(low[2], q[2])};
    high = {(std::max)(high[0], q[0]), (std::max)(high[1], q[1]), (std::max)(high[2], q[2])};
  }
  origin_ = 0.5 * low + 0.5 * high;
  const Vec3 d = 0.5 * high - 0.5 * low;
  const double size = std::hypot(d[0], d[1], d[2]);
  if (size > 0) scale_ = 2 * size;
  for (Vec3& q : p)
    q = {(q[0] - origin_[0]) / scale_, (q[1] - origin_[1]) / scale_, (q[2] - origin_[2]) / scale_};
}

inline int turns(const std::vector<Vec3>& p, const Vec3& normal, bool closed)
{
  int sum = 0;
  const std::size_t n = p.size();
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
    const Vec3 a = p[i] - p[(i + n - 1) % n], b = p[(i + 1) % n] - p[i];
    const double t = dot(normal, cross(a, b));
    if (std::abs(t) > 1e-6 * norm(a) * norm(b)) sum += t > 0 ? 1 : -1;
  }
  return sum;
}

inline void Plane_of_polygon::find_plane(const std::vector<Vec3>& p, bool closed)
{
  if (p.empty()) return;
  Vec3 mean;
  for (const Vec3& q : p) mean += (1 / double(p.size())) * q;
  Covariance covariance;
  for (const Vec3& q : p) covariance.add(q - mean);
  Vec3 normal = covariance.least_direction();
  height_ = dot(normal, mean);
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!(std::abs(dot(normal, p[i]) - height_) <= 2 * tolerance_))
      throw std::invalid_argument(
        "PN_subdivision_3: point " + std::to_string(i) +
        " is not in the plane of the polygon: lines and arcs are those of plane curves");
  if (turns(p, normal, closed) < 0) {
    normal = -normal;
    height_ = -height_;
  }
  const Cross_section across(normal);
  u_ = across.u;
  v_ = dot(cross(across.u, across.v), normal) > 0 ? across.v : -across.v;
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
