// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_SHAPE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_SHAPE_H

#include <CGAL/PN_subdivision_3/Recognized_surface.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Vec3.h>

#include <cmath>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

using Kind = Recognized_surface::Kind;

// where a point is about an axis
struct Cylindrical
{
  double rho, z;
  Vec3 outward; // unit, zero on the axis
};
inline Cylindrical cylindrical(const Vec3& p, const Vec3& center, const Vec3& axis)
{
  const Vec3 q = p - center;
  const double z = dot(q, axis);
  const Vec3 w = q - z * axis;
  const double rho = norm(w);
  return {rho, z, rho > 0 ? (1 / rho) * w : Vec3()};
}

// A surface in the frame of the part. The cone is (rho - radius) cos(angle) = z sin(angle), with its center on the axis
// among the vertices and not in its apex, which may be far away.
struct Shape
{
  Kind kind = Kind::unknown;
  Vec3 center, axis;
  double radius = 0, tube = 0, angle = 0;

  bool has_axis() const { return kind != Kind::sphere && kind != Kind::unknown; }
  Cylindrical local(const Vec3& p) const { return cylindrical(p, center, axis); }
  Vec3 apex() const { return center - (radius / std::tan(angle)) * axis; }

  double distance(const Vec3& p) const
  {
    if (kind == Kind::plane) return dot(p - center, axis);
    if (kind == Kind::sphere) return norm(p - center) - radius;
    const Cylindrical q = local(p);
    if (kind == Kind::cone) return (q.rho - radius) * std::cos(angle) - q.z * std::sin(angle);
    return kind == Kind::torus ? std::hypot(q.rho - radius, q.z) - tube : q.rho - radius;
  }
  // the gradient of the distance; zero where there is none
  Vec3 normal(const Vec3& p) const
  {
    if (kind == Kind::plane) return axis;
    if (kind == Kind::sphere) return unit(p - center);
    const Cylindrical q = local(p);
    if (kind == Kind::cylinder) return q.outward;
    if (kind == Kind::torus) return unit((q.rho - radius) * q.outward + q.z * axis);
    if (q.rho == 0) return {};
    return std::cos(angle) * q.outward - std::sin(angle) * axis;
  }
  // of the torus, where the point is on the circle of the tube
  double meridian_angle(const Vec3& p) const
  {
    const Cylindrical q = local(p);
    return std::atan2(q.z, q.rho - radius);
  }
};

// the same in another frame, x -> scale x + shift, in terms that have a meaning for users
inline Recognized_surface as_surface(const Shape& s, double scale, const Vec3& shift)
{
  Recognized_surface result;
  result.kind = s.kind;
  if (s.kind == Kind::unknown) return result;
  const Vec3 point = s.kind == Kind::cone ? s.apex() : s.center;
  result.point = as_array(scale * point + shift);
  if (s.kind != Kind::sphere) result.direction = as_array(s.axis);
  if (s.kind == Kind::cone)
    result.half_angle = s.angle;
  else if (s.kind != Kind::plane)
    result.radius = scale * s.radius;
  if (s.kind == Kind::torus) result.tube_radius = scale * s.tube;
  return result;
}

// and back
inline Shape as_shape(const Recognized_surface& surface, double scale, const Vec3& shift)
{
  Shape s;
  s.kind = surface.kind;
  s.center = (1 / scale) * (as_vec3(surface.point) - shift);
  s.axis = as_vec3(surface.direction);
  s.radius = surface.kind == Kind::cone ? 0 : surface.radius / scale;
  s.tube = surface.tube_radius / scale;
  s.angle = surface.half_angle;
  return s;
}

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_SHAPE_H
