// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_INTERNAL_SHAPE_MEASURE_H
#define CGAL_PN_CERTIFICATES_3_INTERNAL_SHAPE_MEASURE_H

#include <CGAL/Circle_2.h>
#include <CGAL/Circle_3.h>
#include <CGAL/Line_2.h>
#include <CGAL/Line_3.h>
#include <CGAL/PN_certificates_3/internal/measure_number.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/Plane_3.h>
#include <CGAL/Sphere_3.h>

#include <stdexcept>

namespace CGAL::PN_subdivision_3 {

template <class Kernel>
class Cylinder_3;

namespace internal {

// A point seen from a shape. Both numbers vanish on it, and only there.
template <class Number>
struct Residual
{
  Number radial;           // squared distance from the center or axis, less R^2; 0 if flat
  Number squared_distance; // from the plane or line of a flat shape, the plane of a circle in space
};

// |u|^2 |v|^2 - (u.v)^2, without cancellation
template <class Number, int dimension>
Number squared_cross_product(const Coordinates<Number, dimension>& u,
                             const Coordinates<Number, dimension>& v)
{
  Number sum(0);
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < i; ++j) sum += CGAL::square(Number(u[i] * v[j] - u[j] * v[i]));
  return sum;
}

enum class Shape_kind { sphere, cylinder, circle, hyperplane, line }; // sphere: also a circle in 2D

template <class Number_, int dimension_>
struct Shape_measure
{
  using Number = Number_;
  static constexpr int dimension = dimension_;
  using Vector = Coordinates<Number, dimension>;

  Shape_kind kind;
  Vector base;           // center, or a point of the axis or line; not of a hyperplane
  Vector direction;      // of axis, line or normal, of any length; not of a sphere
  Number squared_radius; // a hyperplane: the constant of its equation

  bool is_round() const { return kind <= Shape_kind::circle; }

  void check() const
  {
    if (kind != Shape_kind::sphere &&
        !CGAL::possibly(is_greater(dot(direction, direction), Number(0))))
      throw std::invalid_argument("PN_subdivision_3: the shape has a zero vector as its direction "
                                  "or normal: give it another one");
    if (is_round() && !CGAL::possibly(is_greater(squared_radius, Number(0))))
      throw std::invalid_argument("PN_subdivision_3: the squared radius of the shape is not "
                                  "positive: give it a positive one");
  }

  Residual<Number> residual(const Vector& p) const
  {
    Residual<Number> r{Number(0), Number(0)};
    const Vector v = from_base(p);
    if (kind == Shape_kind::sphere) {
      r.radial = squared_length(v) - squared_radius;
      return r;
    }
    const Number length = squared_length(direction);
    if (kind == Shape_kind::hyperplane || kind == Shape_kind::circle)
      r.squared_distance = CGAL::square(height(v)) / length;
    else if (kind == Shape_kind::line)
      r.squared_distance = squared_cross_product<Number, dimension>(v, direction) / length;
    if (kind == Shape_kind::circle || kind == Shape_kind::cylinder)
      r.radial = squared_cross_product<Number, dimension>(v, direction) / length - squared_radius;
    return r;
  }

  // sin^2 of the angle between n, not zero, and the shape's normal at the foot of p
  Number squared_sine(const Vector& n, const Vector& p) const
  {
    if (kind == Shape_kind::line)
      return CGAL::square(dot(n, direction)) / (squared_length(n) * squared_length(direction));
    const Vector e = normal_direction(p);
    const Number length = squared_length(e);
    if (CGAL::certainly(length == Number(0))) return Number(1);
    return squared_cross_product<Number, dimension>(n, e) / (squared_length(n) * length);
  }

  static Number squared_length(const Vector& v)
  {
    Number sum(0);
    for (const Number& x : v) sum += CGAL::square(x);
    return sum;
  }

  // radial^2 / 4 R^2 + squared_distance
  Number squared_deviation(const Residual<Number>& r) const
  {
    if (!is_round()) return r.squared_distance;
    return CGAL::square(r.radial) / (Number(4) * squared_radius) + r.squared_distance;
  }

  Scaled_interval distance(const Residual<Number>& r) const
  {
    const Scaled_interval flat = Scaled_interval::of(r.squared_distance);
    if (!is_round()) return sqrt(flat);
    const Scaled_interval sum = sqrt(Scaled_interval::of(Number(r.radial + squared_radius)));
    const Scaled_interval d = Scaled_interval::of(r.radial) / (sum + radius());
    if (kind != Shape_kind::circle) return d;
    return sqrt(square(d) + flat);
  }

  Scaled_interval radius() const { return sqrt(Scaled_interval::of(squared_radius)); }

  // whether the distance is at most t R, or t from flat shapes; no roots
  Uncertain<bool> is_near(const Residual<Number>& r, const Number& t) const
  {
    if (!is_round()) return make_uncertain(is_at_most(r.squared_distance, Number(t * t)));
    const Number t2 = t * t;
    if (kind == Shape_kind::circle) {
      // h^2 + (s - R)^2 <= t^2 R^2 with s^2 = radial + R^2: half <= s R
      const Number s2 = r.radial + squared_radius;
      const Number half = (r.squared_distance + s2 + squared_radius * (Number(1) - t2)) / Number(2);
      return make_uncertain(is_at_most(half, Number(0))) |
             make_uncertain(is_at_most(Number(half * half), Number(s2 * squared_radius)));
    }
    const Uncertain<bool> not_out =
      make_uncertain(is_at_most(r.radial, Number(squared_radius * (Number(2) * t + t2))));
    const Uncertain<bool> not_in =
      make_uncertain(is_at_most(Number(1), t)) |
      make_uncertain(is_at_most(Number(squared_radius * (t2 - Number(2) * t)), r.radial));
    return not_out & not_in;
  }

private:
  Vector from_base(const Vector& p) const
  {
    Vector v = p;
    if (kind != Shape_kind::hyperplane)
      for (int i = 0; i < dimension; ++i) v[i] -= base[i];
    return v;
  }

  Number height(const Vector& v) const
  {
    const auto h = dot(v, direction);
    return kind == Shape_kind::hyperplane ? Number(h + squared_radius) : h;
  }

  Vector normal_direction(const Vector& p) const
  {
    if (kind == Shape_kind::hyperplane) return direction;
    Vector v = from_base(p);
    if (kind == Shape_kind::sphere) return v;
    const Number along = dot(v, direction), length = squared_length(direction);
    for (int i = 0; i < dimension; ++i) v[i] = length * v[i] - along * direction[i];
    return v;
  }
};

template <class Number, int dimension, class Point_or_vector>
Coordinates<Number, dimension> measure_coordinates(const Point_or_vector& p)
{
  Coordinates<Number, dimension> c;
  for (int i = 0; i < dimension; ++i) c[i] = measure_number<Number>(p.cartesian(i));
  return c;
}

template <class Number, class K>
Shape_measure<Number, 2> shape_measure(const CGAL::Circle_2<K>& s)
{
  return {Shape_kind::sphere,
          measure_coordinates<Number, 2>(s.center()),
          {},
          measure_number<Number>(s.squared_radius())};
}
template <class Number, class K>
Shape_measure<Number, 3> shape_measure(const CGAL::Sphere_3<K>& s)
{
  return {Shape_kind::sphere,
          measure_coordinates<Number, 3>(s.center()),
          {},
          measure_number<Number>(s.squared_radius())};
}
template <class Number, class K>
Shape_measure<Number, 3> shape_measure(const CGAL::Circle_3<K>& s)
{
  return {Shape_kind::circle, measure_coordinates<Number, 3>(s.center()),
          measure_coordinates<Number, 3>(s.supporting_plane().orthogonal_vector()),
          measure_number<Number>(s.squared_radius())};
}
template <class Number, class K>
Shape_measure<Number, 3> shape_measure(const Cylinder_3<K>& s)
{
  return {Shape_kind::cylinder, measure_coordinates<Number, 3>(s.axis().point(0)),
          measure_coordinates<Number, 3>(s.axis().to_vector()),
          measure_number<Number>(s.squared_radius())};
}
template <class Number, class K>
Shape_measure<Number, 3> shape_measure(const CGAL::Line_3<K>& s)
{
  return {Shape_kind::line, measure_coordinates<Number, 3>(s.point(0)),
          measure_coordinates<Number, 3>(s.to_vector()), Number(0)};
}
template <class Number, class K>
Shape_measure<Number, 2> shape_measure(const CGAL::Line_2<K>& s)
{
  return {Shape_kind::hyperplane,
          {},
          {measure_number<Number>(s.a()), measure_number<Number>(s.b())},
          measure_number<Number>(s.c())};
}
template <class Number, class K>
Shape_measure<Number, 3> shape_measure(const CGAL::Plane_3<K>& s)
{
  return {
    Shape_kind::hyperplane,
    {},
    {measure_number<Number>(s.a()), measure_number<Number>(s.b()), measure_number<Number>(s.c())},
    measure_number<Number>(s.d())};
}

// Two deviations are compared by intervals around their roots: numbers of two vertices may lie in
// different fields, and exact comparisons of what is not zero would prove nothing.
template <class FT, class Result, class Shape>
class Deviation_of_all
{
  using Number = typename Shape::Number;
  using Vector = typename Shape::Vector;
  using Element = typename Result::Element;

public:
  explicit Deviation_of_all(const Shape& shape)
    : shape_(shape)
  {}

  void add_point(const Element& e, const Vector& p)
  {
    const bool first = d_.number_of_points++ == 0;
    if (first) d_.farthest_point = e;
    const auto r = shape_.residual(p);
    const Uncertain<bool> on =
      is_proved_zero<FT>(r.radial) & is_proved_zero<FT>(r.squared_distance);
    if (certainly(on)) return;
    d_.points_are_on_shape = d_.points_are_on_shape & on;
    if (raise(d_.distance, shape_.distance(r).interval())) {
      d_.farthest_point = e;
      d_.squared_deviation = shape_.squared_deviation(r);
    }
  }

  void add_normal(const Element& e, const Vector& p, const Vector& n)
  {
    if (certainly(Shape::squared_length(n) == Number(0))) return;
    const bool first = d_.number_of_normals++ == 0;
    if (first) d_.most_turned_normal = e;
    const Number s = shape_.squared_sine(n, p);
    const Uncertain<bool> exact = is_proved_zero<FT>(s);
    if (certainly(exact)) return;
    d_.normals_are_exact = d_.normals_are_exact & exact;
    if (raise(d_.normal_sine, sqrt(Scaled_interval::of(s)).interval())) {
      d_.most_turned_normal = e;
      d_.squared_normal_deviation = s;
    }
  }

  Result result() const
  {
    Result d = d_;
    if (is_indeterminate(d.points_are_on_shape) || is_indeterminate(d.normals_are_exact))
      d.advice = advice_for_proofs<FT>();
    return d;
  }

private:
  // the interval becomes one around the maximum; whether its upper end rises
  static bool raise(Interval_nt<>& largest, const Interval_nt<>& x)
  {
    const bool rises = !(x.sup() <= largest.sup());
    largest = Interval_nt<>((std::max)(largest.inf(), x.inf()), rises ? x.sup() : largest.sup());
    return rises;
  }

  const Shape& shape_;
  Result d_;
};

} // namespace internal
} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CERTIFICATES_3_INTERNAL_SHAPE_MEASURE_H
