// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_PRINCIPAL_CURVATURES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_PRINCIPAL_CURVATURES_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The derivatives of the unit normal in an orthonormal basis of eigenvectors.
struct Principal_curvatures
{
  double minimal = 0, maximal = 0, gaussian = 0, mean = 0;
  Eigen::Vector3d minimal_direction{0, 0, 0}, maximal_direction{0, 0, 0};
  bool is_estimated = false;
};

// What is known of a graph z = f(u) at u = 0; z is along the last column of the frame.
struct Graph_derivatives
{
  Eigen::Matrix3d frame;
  Eigen::Vector2d gradient;
  Eigen::Matrix2d hessian;
};

// The unit vector at half the angle of (x, y), which has the given length.
inline Eigen::Vector2d half_angle(double x, double y, double length)
{
  if (!(length > 0)) return {1, 0};
  const double larger = std::sqrt((1 + std::abs(x) / length) / 2);
  const double smaller = std::abs(y) / (2 * length * larger);
  return x < 0 ? Eigen::Vector2d(smaller, std::copysign(larger, y))
               : Eigen::Vector2d(larger, std::copysign(smaller, y));
}

// The curvatures of the graph, whose lengths have been divided by `scale`. The shape operator is that of
// the derivative of the normal (-grad f, 1)/W, so that a sphere with outward normals has positive curvatures.
inline Principal_curvatures principal_curvatures(const Graph_derivatives& f, double scale)
{
  const double a = f.gradient[0], b = f.gradient[1], w = std::sqrt(1 + a * a + b * b);
  // the columns of `basis` are the projections of an orthonormal basis of the tangent plane
  const double l = std::sqrt(1 + a * a);
  Eigen::Matrix2d basis;
  basis << 1 / l, -a * b / (l * w), 0, l / w;
  const Eigen::Matrix2d shape = -basis.transpose() * f.hessian * basis / w;

  Principal_curvatures c;
  const double difference = (shape(0, 0) - shape(1, 1)) / 2;
  const double size = (std::max)(std::abs(difference), std::abs(shape(0, 1)));
  const double x = size > 0 ? difference / size : 0, y = size > 0 ? shape(0, 1) / size : 0;
  const double length = std::sqrt(x * x + y * y), radius = size * length / scale;
  c.mean = (shape(0, 0) + shape(1, 1)) / 2 / scale;
  c.minimal = c.mean - radius;
  c.maximal = c.mean + radius;
  c.gaussian =
    shape(0, 0) / scale * (shape(1, 1) / scale) - shape(0, 1) / scale * (shape(0, 1) / scale);
  const Eigen::Vector2d along = half_angle(x, y, length), across(along[1], -along[0]);
  const auto in_space = [&](const Eigen::Vector2d& t) -> Eigen::Vector3d {
    const Eigen::Vector2d u = basis * t;
    return (f.frame * Eigen::Vector3d(u[0], u[1], f.gradient.dot(u))).normalized();
  };
  c.minimal_direction = in_space(across);
  c.maximal_direction = in_space(along);
  c.is_estimated = std::isfinite(c.gaussian) && std::isfinite(c.mean) && std::isfinite(radius);
  return c.is_estimated ? c : Principal_curvatures();
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_PRINCIPAL_CURVATURES_H
