// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Rational points with rational unit normals on spheres, cylinders and circles, meshes of them, and the exact test
// whether a point with its normal is on one.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_RATIONAL_SHAPES_H
#define CGAL_PN_SUBDIVISION_3_TEST_RATIONAL_SHAPES_H

#include "Mesh_cases.h"

#include <CGAL/Gmpq.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <type_traits>

namespace rational_shapes {

using Rational = CGAL::Gmpq;
template <class FT>
using Vector = std::array<FT, 3>;

template <class FT>
FT dot(const Vector<FT>& a, const Vector<FT>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// a + f b
template <class FT>
Vector<FT> sum(const Vector<FT>& a, const FT& f, const Vector<FT>& b)
{
  return {a[0] + f * b[0], a[1] + f * b[1], a[2] + f * b[2]};
}

// the nearest multiple of 1/32
inline Rational rounded(double x)
{
  return Rational(static_cast<int>(std::lround(32 * x)), 32);
}

// (cos, sin) of nearly the direction (x, y), by the tangent of half the angle
inline std::array<Rational, 2> unit_2(double x, double y)
{
  const bool back = x < 0;
  const Rational t = rounded(y / (std::hypot(x, y) + std::abs(x))), s = 1 + t * t;
  return {(back ? t * t - 1 : 1 - t * t) / s, 2 * t / s};
}

// nearly the direction of (x, y, z), by stereographic projection from the farther pole
inline Vector<Rational> unit_3(double x, double y, double z)
{
  const double length = std::hypot(x, y, z) + std::abs(z);
  const Rational u = rounded(x / length), v = rounded(y / length), s = 1 + u * u + v * v;
  const Rational w = (1 - u * u - v * v) / s;
  return {2 * u / s, 2 * v / s, z < 0 ? -w : w};
}

struct Sample
{
  Vector<Rational> point, normal;
};

// A sphere or, with an axis (a unit vector), a cylinder.
struct Shape
{
  Vector<Rational> center;
  Rational radius;
  Vector<Rational> axis{0, 0, 0};

  bool is_sphere() const { return axis == Vector<Rational>{0, 0, 0}; }

  // near the direction of d from the center; cylinders: d is (along the axis, two across)
  Sample sample(const std::array<double, 3>& d) const
  {
    Vector<Rational> n = unit_3(d[0], d[1], d[2]), p = center;
    if (!is_sphere()) {
      // an orthonormal frame with the axis (1, 2, 2)/3
      const Vector<Rational> u{Rational(2, 3), Rational(1, 3), Rational(-2, 3)},
        v{Rational(2, 3), Rational(-2, 3), Rational(1, 3)};
      const std::array<Rational, 2> c = unit_2(d[1] + 0.13, d[2] + 0.29); // d may be 0
      n = sum(sum({0, 0, 0}, c[0], u), c[1], v);
      p = sum(p, rounded(d[0]), axis);
    }
    return {sum(p, radius, n), n};
  }
};

inline Shape sphere()
{
  return {{Rational(1, 2), Rational(-2, 3), Rational(5, 7)}, Rational(7, 3)};
}
inline Shape sphere_at_origin()
{
  return {{0, 0, 0}, 1};
}
inline Shape cylinder()
{
  return {{Rational(-3, 4), Rational(1, 5), 2},
          Rational(4, 3),
          {Rational(1, 3), Rational(2, 3), Rational(2, 3)}};
}

// in the number type, or the interval around it
template <class FT>
FT in(const Rational& x)
{
  if constexpr (std::is_constructible_v<FT, Rational>)
    return FT(x);
  else
    return FT(CGAL::to_interval(x));
}
template <class FT>
Vector<FT> in(const Vector<Rational>& v)
{
  return {in<FT>(v[0]), in<FT>(v[1]), in<FT>(v[2])};
}

// The radial vector p - center (cylinders: without its part along the axis) is the normal times the
// radius, and the normal is a unit vector: both deviations are 0.
template <class FT>
bool is_exactly_on(const Shape& shape, const Vector<FT>& p, const Vector<FT>& n)
{
  const Vector<FT> axis = in<FT>(shape.axis);
  Vector<FT> r = sum(p, FT(-1), in<FT>(shape.center));
  r = sum(r, FT(-dot(r, axis)), axis);
  const FT radius(shape.radius);
  return dot(n, n) == FT(1) && r[0] == radius * n[0] && r[1] == radius * n[1] &&
         r[2] == radius * n[2];
}

// A control mesh of rational samples of a shape; its points say their directions.
template <class K>
struct Samples
{
  using Mesh = CGAL::Surface_mesh<typename K::Point_3>;
  using FT = typename K::FT;

  template <class Control>
  Samples(const Shape& s, const Control& control)
    : shape(s)
  {
    mesh_cases::build(control, mesh);
    std::size_t i = 0;
    for (auto v : mesh.vertices()) {
      const Sample sample = shape.sample(control.points[i++]);
      const Vector<FT> p = in<FT>(sample.point), n = in<FT>(sample.normal);
      mesh.point(v) = {p[0], p[1], p[2]};
      normals[v] = {n[0], n[1], n[2]};
    }
  }

  // what is(deviation) says, by the package's own predicates
  template <class Is>
  bool is_on_shape(const Is& is) const
  {
    using Exact = CGAL::Simple_cartesian<Rational>;
    namespace PN = CGAL::PN_subdivision_3;
    const auto np = CGAL::parameters::vertex_normal_map(normals);
    const Exact::Point_3 center(shape.center[0], shape.center[1], shape.center[2]);
    const Rational square = shape.radius * shape.radius;
    if (shape.is_sphere()) return is(PN::mesh_deviation(mesh, Exact::Sphere_3(center, square), np));
    const Exact::Line_3 axis(center, Exact::Vector_3(shape.axis[0], shape.axis[1], shape.axis[2]));
    return is(PN::mesh_deviation(mesh, PN::Cylinder_3<Exact>(axis, square), np));
  }

  Shape shape;
  Mesh mesh;
  typename Mesh::template Property_map<CGAL::SM_Vertex_index, typename K::Vector_3> normals =
    mesh.template add_property_map<CGAL::SM_Vertex_index, typename K::Vector_3>("n").first;
};

} // namespace rational_shapes

#endif // CGAL_PN_SUBDIVISION_3_TEST_RATIONAL_SHAPES_H
