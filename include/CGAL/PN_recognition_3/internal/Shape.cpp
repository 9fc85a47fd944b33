// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>

namespace CGAL::PN_subdivision_3::internal::recognition {

CGAL_PN_RECOGNITION_3_INLINE Cylindrical cylindrical(const Vec3& p, const Vec3& center,
                                                     const Vec3& axis)
{
  const Vec3 q = p - center;
  const double z = dot(q, axis);
  const Vec3 w = q - z * axis;
  const double rho = norm(w);
  return {rho, z, rho > 0 ? (1 / rho) * w : Vec3()};
}

CGAL_PN_RECOGNITION_3_INLINE void Shape::set_angle(double x)
{
  angle = x;
  cosine = std::cos(x);
  sine = std::sin(x);
}

CGAL_PN_RECOGNITION_3_INLINE double Shape::distance(const Vec3& p, Cylindrical& q) const
{
  if (facts_of(kind).turns_about_axis) q = local(p);
  switch (kind) {
  case Kind::unknown:
    break;
  case Kind::plane:
    return dot(p - center, axis);
  case Kind::cylinder:
    return q.rho - radius;
  case Kind::cone:
    return (q.rho - radius) * cosine - q.z * sine;
  case Kind::sphere:
    return norm(p - center) - radius;
  case Kind::torus:
    return std::hypot(q.rho - radius, q.z) - tube;
  }
  return 0;
}

CGAL_PN_RECOGNITION_3_INLINE Vec3 Shape::normal(const Vec3& p, const Cylindrical& q) const
{
  switch (kind) {
  case Kind::unknown:
    break;
  case Kind::plane:
    return axis;
  case Kind::cylinder:
    return q.outward;
  case Kind::cone:
    return q.rho == 0 ? Vec3() : cosine * q.outward - sine * axis;
  case Kind::sphere:
    return unit(p - center);
  case Kind::torus:
    return unit((q.rho - radius) * q.outward + q.z * axis);
  }
  return {};
}

CGAL_PN_RECOGNITION_3_INLINE double Shape::meridian_angle(const Vec3& p) const
{
  const Cylindrical q = local(p);
  return std::atan2(q.z, q.rho - radius);
}

CGAL_PN_RECOGNITION_3_INLINE Recognized_surface as_surface(const Shape& s, double scale,
                                                           const Vec3& shift)
{
  Recognized_surface result;
  result.kind = s.kind;
  switch (s.kind) {
  case Kind::unknown:
    return result;
  case Kind::plane:
    break;
  case Kind::cone:
    result.half_angle = s.angle;
    break;
  case Kind::torus:
    result.tube_radius = scale * s.tube;
    [[fallthrough]];
  case Kind::cylinder:
  case Kind::sphere:
    result.radius = scale * s.radius;
    break;
  }
  result.point = scale * (s.kind == Kind::cone ? s.apex() : s.center) + shift;
  if (s.kind != Kind::sphere) result.direction = s.axis;
  return result;
}

CGAL_PN_RECOGNITION_3_INLINE Shape as_shape(const Recognized_surface& surface, double scale,
                                            const Vec3& shift)
{
  Shape s;
  s.kind = surface.kind;
  s.center = (1 / scale) * (Vec3(surface.point) - shift);
  s.axis = surface.direction;
  s.radius = s.kind == Kind::cone ? 0 : surface.radius / scale; // the center is the apex
  s.tube = surface.tube_radius / scale;
  s.set_angle(surface.half_angle);
  return s;
}

inline double greatest_distance(const Shape& s, const std::vector<Vec3>& points)
{
  double largest = 0;
  for (const Vec3& p : points) largest = (std::max)(largest, std::abs(s.distance(p)));
  return largest;
}

// the center among the points, so that turns are about what is there
inline void recenter(const std::vector<Vec3>& points, Shape& s)
{
  if (!facts_of(s.kind).is_ruled) return;
  double z = 0;
  for (const Vec3& p : points) z += dot(p - s.center, s.axis);
  z /= double(points.size());
  s.center += z * s.axis;
  if (s.kind == Kind::cone) s.radius += z * std::tan(s.angle);
}

inline bool step_of_sphere(const std::vector<Vec3>& points, Shape& s)
{
  Least_squares system(facts_of(s.kind).unknowns);
  for (const Vec3& p : points) {
    const Vec3 n = s.normal(p);
    system.add({-n[0], -n[1], -n[2], -1}, -s.distance(p));
  }
  const Least_squares::Row x = system.solve();
  s.center += Vec3{x[0], x[1], x[2]};
  s.radius += x[3];
  return s.radius > 0;
}

inline void add_row(const Shape& s, const Cross_section& across, const Cylindrical& q,
                    Least_squares& system)
{
  const double eu = dot(q.outward, across.u), ev = dot(q.outward, across.v);
  double along_rho = 1, along_z = 0, f = q.rho - s.radius;
  Least_squares::Row row{};
  switch (s.kind) {
  case Kind::unknown:
  case Kind::plane:
  case Kind::sphere:
    return; // turn about no axis
  case Kind::cylinder:
    break;
  case Kind::cone:
    along_rho = s.cosine;
    along_z = -s.sine;
    row[5] = -f * s.sine - q.z * s.cosine;
    f = f * s.cosine - q.z * s.sine;
    break;
  case Kind::torus: {
    const double d = std::hypot(f, q.z);
    if (d == 0) return;
    along_rho = f / d;
    along_z = q.z / d;
    row[5] = -1;
    row[6] = -along_z;
    f = d - s.tube;
    break;
  }
  }
  row[4] = -along_rho;
  const double turn = along_z * q.rho - along_rho * q.z;
  row[0] = -along_rho * eu;
  row[1] = -along_rho * ev;
  row[2] = turn * eu;
  row[3] = turn * ev;
  system.add(row, -f);
}

// the point is the apex: three rows
inline void add_apex(const Shape& s, const Cross_section& across, const Vec3& p,
                     Least_squares& system)
{
  const Vec3 q = p - s.apex();
  const double tangent = std::tan(s.angle), t = s.radius / tangent;
  system.add({-1, 0, t, 0}, -dot(q, across.u));
  system.add({0, -1, 0, t}, -dot(q, across.v));
  system.add({0, 0, 0, 0, 1 / tangent, -s.radius / (s.sine * s.sine)}, -dot(q, s.axis));
}

// 0, 1: shift across; 2, 3: turn; then radius; tube and shift along, or angle
inline bool step_of_revolution(const std::vector<Vec3>& points, Shape& s)
{
  const Cross_section across(s.axis);
  Least_squares system(facts_of(s.kind).unknowns);
  double largest_rho = 0;
  for (const Vec3& p : points) largest_rho = (std::max)(largest_rho, s.local(p).rho);
  for (const Vec3& p : points) {
    const Cylindrical q = s.local(p);
    if (q.rho > 1e-3 * largest_rho)
      add_row(s, across, q, system);
    else if (s.kind == Kind::cone)
      add_apex(s, across, p, system);
  }
  const Least_squares::Row x = system.solve();
  const Vec3 axis = s.axis;
  s.center += x[0] * across.u + x[1] * across.v;
  s.radius += x[4];
  s.axis = unit(axis + x[2] * across.u + x[3] * across.v);
  switch (s.kind) {
  case Kind::unknown:
  case Kind::plane:
  case Kind::cylinder:
  case Kind::sphere:
    break;
  case Kind::cone: {
    const double angle = s.angle + x[5];
    if (angle < 0) s.axis = -s.axis;
    s.set_angle(std::abs(angle));
    if (!(s.angle < radians(89.9) && s.angle > 1e-6)) return false;
    break;
  }
  case Kind::torus:
    s.tube += x[5];
    s.center += x[6] * axis;
    if (!(s.tube > 0)) return false;
    break;
  }
  return s.radius > 0;
}

inline bool step(const std::vector<Vec3>& points, Shape& s)
{
  recenter(points, s);
  switch (s.kind) {
  case Kind::unknown:
  case Kind::plane:
    break;
  case Kind::sphere:
    return step_of_sphere(points, s);
  case Kind::cylinder:
  case Kind::cone:
  case Kind::torus:
    return step_of_revolution(points, s);
  }
  return false;
}

// Least squares by the method of Gauss and Newton for the distances of points from a shape. The unknowns are a shift of
// the center (along the axis only where this changes the shape), a turn of the axis and the shape's own numbers. Stops as
// soon as the distances do not get less.
inline bool fit_shape(Shape& s, const std::vector<Vec3>& points, std::size_t steps, double hopeless)
{
  double before = greatest_distance(s, points);
  bool is_better = false;
  for (std::size_t k = 0; k < steps && before > 1e-15; ++k) {
    Shape next = s;
    if (!step(points, next)) break;
    const double after = greatest_distance(next, points);
    if (!(after < before)) break;
    const bool settles = after > 0.9 * before && k > 0;
    s = next;
    is_better = true;
    if (hopeless > 0 && after > hopeless && after > before / 4) return false;
    before = after;
    if (settles) break;
  }
  return is_better;
}

inline bool sphere_through(const std::vector<Vec3>& points, Shape& s)
{
  Vec3 mean;
  for (const Vec3& p : points) mean += (1 / double(points.size())) * p;
  Least_squares system(4);
  for (const Vec3& p : points) {
    const Vec3 q = p - mean;
    system.add({2 * q[0], 2 * q[1], 2 * q[2], 1}, dot(q, q));
  }
  const Least_squares::Row x = system.solve();
  const Vec3 c{x[0], x[1], x[2]};
  const double square = x[3] + dot(c, c);
  if (!(square > 0)) return false;
  s = Shape();
  s.kind = Kind::sphere;
  s.center = mean + c;
  s.radius = std::sqrt(square);
  return true;
}

inline bool circle_through(const std::vector<Vec3>& points, const Vec3& axis, Vec3& center,
                           double& radius)
{
  const Cross_section across(axis);
  Vec3 mean;
  for (const Vec3& p : points) mean += (1 / double(points.size())) * p;
  Least_squares system(3);
  for (const Vec3& p : points) {
    const double x = dot(p - mean, across.u), y = dot(p - mean, across.v);
    system.add({2 * x, 2 * y, 1}, x * x + y * y);
  }
  const Least_squares::Row c = system.solve();
  const double square = c[2] + c[0] * c[0] + c[1] * c[1];
  if (!(square > 0)) return false;
  center = mean + c[0] * across.u + c[1] * across.v;
  radius = std::sqrt(square);
  return true;
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
