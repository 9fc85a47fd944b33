// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_FLATNESS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_FLATNESS_H

#include <CGAL/PN_subdivision_3/internal/average/vectors.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::PN_subdivision_3::internal {

// the factors of estimates
constexpr double tessellation_safety = 1.1, safety_at_curves = 1.25;
// the weight of the length of a diagonal where the heights over both diagonals are about equal
constexpr double weight_of_length = 1. / 1024;

// How far a surface is from triangles between its points, told from the normals at these.
namespace flatness {

using Vector = Coordinates<double, 3>;

// zero if there is none
inline Vector unit(const Vector& v)
{
  const double l = quick_length(v);
  return l > 0 ? quotient(v, l) : Vector{};
}
inline Vector between(const Vector& a, const Vector& b, double t)
{
  Vector c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = a[i] + t * (b[i] - a[i]);
  return c;
}

// The distance from a line; from its first point if it has no direction.
inline double distance_from_line(const Vector& p, const Vector& a, const Vector& b)
{
  const Vector d = difference(b, a), r = difference(p, a);
  const double square = dot(d, d);
  if (!(square > 0)) return quick_length(r);
  const double t = dot(r, d) / square;
  return quick_length(difference(r, {t * d[0], t * d[1], t * d[2]}));
}

// s a + t b next to r, and its distance; no numbers if a and b have one direction
struct Combination
{
  Combination(Vector r, const Vector& a, const Vector& b)
  {
    const double square = dot(a, a);
    Vector across = b;
    add_multiple<double, 3>(across, -dot(a, b) / square, a);
    t = dot(r, across) / dot(across, across);
    add_multiple<double, 3>(r, -t, b);
    s = dot(r, a) / square;
    add_multiple<double, 3>(r, -s, a);
    distance = quick_length(r);
  }

  double s, t, distance;
};

inline double distance_from_segment(const Vector& p, const Vector& a, const Vector& b)
{
  const double t =
    dot(difference(p, a), difference(b, a)) / dot(difference(b, a), difference(b, a));
  return quick_length(difference(p, between(a, b, t > 0 ? (std::min)(t, 1.) : 0)));
}

inline double distance_from_triangle(const Vector& p, const Vector& a, const Vector& b,
                                     const Vector& c)
{
  const Combination inside(difference(p, a), difference(b, a), difference(c, a));
  if (inside.s >= 0 && inside.t >= 0 && inside.s + inside.t <= 1) return inside.distance;
  return (std::min)({distance_from_segment(p, a, b), distance_from_segment(p, b, c),
                     distance_from_segment(p, c, a)});
}

// A corner of a triangle: a point of the surface and its unit normal there, zero if none is known.
struct Corner
{
  Vector point, normal;
};

inline double distance(const Corner& a, const Corner& b)
{
  return quick_length(difference(a.point, b.point));
}

// The section of a surface over the chord of two corners: a cubic over the chord, whose height in the middle is that
// of the point-normal average, hence exact on spheres and cylinders, and in general of fourth order.
class Section
{
public:
  // If one of the normals is not known, the section is an arc. Where normals are opposite the section has no plane, which
  // rounding would decide.
  Section(const Corner& a, const Corner& b)
    : a_(a.point)
    , chord_(difference(b.point, a.point))
  {
    const Vector of_a = a.normal == Vector{} ? mirrored(b.normal) : a.normal;
    const Vector of_b = b.normal == Vector{} ? mirrored(a.normal) : b.normal;
    normal_ = between(of_a, of_b);
    start_ = -slope(of_a);
    end_ = slope(of_b);
  }

  const Vector& normal() const { return normal_; }

  double height(double t) const { return 2 * t * (1 - t) * (start_ * (1 - t) + end_ * t); }
  // the height in the middle
  double sagitta() const { return height(0.5); }
  // the largest height
  double bulge() const
  {
    return (std::max)({std::abs(height(0.25)), std::abs(height(0.5)), std::abs(height(0.75))});
  }

  // how high a point is over the chord, and how much more than the section
  double height_of(const Vector& p) const
  {
    return dot(normal_, difference(p, a_)) - along(p) * slope_of_chord();
  }
  double excess_of(const Vector& p) const { return height_of(p) - height(along(p)); }

private:
  // zero if they are opposite
  static Vector between(const Vector& m, const Vector& n)
  {
    const Vector sum = {m[0] + n[0], m[1] + n[1], m[2] + n[2]};
    return dot(sum, sum) > 0x1p-40 ? unit(sum) : Vector{};
  }
  // a normal mirrored in the plane between the ends
  Vector mirrored(Vector n) const
  {
    const double square = dot(chord_, chord_);
    if (square > 0) add_multiple<double, 3>(n, -2 * dot(n, chord_) / square, chord_);
    return n;
  }
  double slope_of_chord() const { return dot(normal_, chord_); }
  double along(const Vector& p) const
  {
    const double square = dot(chord_, chord_);
    if (!(square > 0)) return 0.5;
    return (std::min)(1., (std::max)(0., dot(difference(p, a_), chord_) / square));
  }
  // the slope of the stereographic image of a normal, along the chord; steep where the normal is opposite
  double slope(const Vector& n) const
  {
    constexpr double least = 1. / 64;
    const double d = (std::max)(least, 1 + dot(n, normal_));
    return (dot(n, chord_) + dot(normal_, chord_)) / d - dot(normal_, chord_);
  }

  Vector a_, chord_, normal_;
  double start_, end_;
};

// The largest distance of a quadratic surface from a triangle, from its heights over the middles of the sides.
inline double over_triangle(double a, double b, double c)
{
  const double over_side = (std::max)({a, b, c});
  const double x = a * (b + c - a), y = b * (a + c - b), z = c * (a + b - c);
  if (!(x > 0) || !(y > 0) || !(z > 0)) return over_side;
  return (std::max)(over_side, 4 * a * b * c / (x + y + z));
}

// How high a surface is over a chord: in the middle, and where it is highest.
struct Height
{
  double middle, largest;
};
inline Height height(const Section& section)
{
  return {std::abs(section.sagitta()), section.bulge()};
}

inline double over_triangle(const Height& a, const Height& b, const Height& c)
{
  return (std::max)({over_triangle(a.middle, b.middle, c.middle), a.largest, b.largest, c.largest});
}
inline double over_triangle(const Corner& a, const Corner& b, const Corner& c)
{
  return over_triangle(height(Section(a, b)), height(Section(b, c)), height(Section(c, a)));
}

// the heights over both triangles, with the diagonal from a to c, and with the diagonal from b to d
inline std::array<double, 2> over_quadrilateral(const Corner& a, const Corner& b, const Corner& c,
                                                const Corner& d)
{
  const Height ab = height(Section(a, b)), bc = height(Section(b, c)), cd = height(Section(c, d)),
               da = height(Section(d, a)), ac = height(Section(a, c)), bd = height(Section(b, d));
  return {(std::max)(over_triangle(ab, bc, ac), over_triangle(cd, da, ac)),
          (std::max)(over_triangle(bc, cd, bd), over_triangle(da, ab, bd))};
}

// Whether the triangle is turned over, as its corners see it, or its area less than a part of the square of the longest
// side.
inline bool is_turned_or_thin(const Corner& a, const Corner& b, const Corner& c, double part)
{
  const Vector ab = difference(b.point, a.point), ac = difference(c.point, a.point),
               bc = difference(c.point, b.point), area = cross(ab, ac);
  if (dot(area, a.normal) + dot(area, b.normal) + dot(area, c.normal) < 0) return true;
  const double longest = (std::max)({dot(ab, ab), dot(ac, ac), dot(bc, bc)});
  return !(quick_length(area) > part * longest);
}

} // namespace flatness

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_FLATNESS_H
