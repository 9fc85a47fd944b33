// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_EXACT_DEVIATION_H
#define CGAL_PN_CERTIFICATES_3_EXACT_DEVIATION_H

#include <CGAL/Interval_nt.h>
#include <CGAL/PN_certificates_3/internal/measure_number.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Reproduction

A circular cylinder: the points at a given distance from a line.

\tparam Kernel a model of `Kernel`
*/
template <class Kernel>
class Cylinder_3
{
public:
  /// the number type.
  using FT = typename Kernel::FT;
  /// the type of the axis.
  using Line_3 = typename Kernel::Line_3;

  /// the cylinder of radius R about the axis, given R<sup>2</sup>.
  Cylinder_3(const Line_3& axis, const FT& squared_radius)
    : axis_(axis)
    , squared_radius_(squared_radius)
  {}

  /// the axis.
  const Line_3& axis() const { return axis_; }
  /// the squared radius.
  const FT& squared_radius() const { return squared_radius_; }

private:
  Line_3 axis_;
  FT squared_radius_;
};

/*!
\ingroup PkgPNSubdivision3Reproduction

The deviation of a mesh or curve from a shape, as `mesh_deviation()` and `curve_deviation()` return it.

\tparam Number see `Deviation_number`
\tparam Element the vertex descriptor of a mesh; the position in a curve
*/
template <class Number_, class Element_>
struct Deviation
{
  /// the number type of the deviations.
  using Number = Number_;
  /// names the vertex of a deviation.
  using Element = Element_;

  /// how many points were looked at
  std::size_t number_of_points = 0;
  /// the `squared_deviation()` of the point that is farthest from the shape
  Number squared_deviation = Number(0);
  /// that point; of several equal ones the first
  Element farthest_point = Element();
  /// an interval around the largest distance of all points from the shape
  Interval_nt<> distance = 0;
  /// whether all points are on the shape, without any tolerance
  Uncertain<bool> points_are_on_shape = true;

  /// how many normals were looked at: those that are not zero
  std::size_t number_of_normals = 0;
  /// the largest `squared_normal_deviation()`
  Number squared_normal_deviation = Number(0);
  /// the point whose normal it is
  Element most_turned_normal = Element();
  /// an interval around the largest sine of all normals
  Interval_nt<> normal_sine = 0;
  /// whether all normals are those of the shape or opposite to them
  Uncertain<bool> normals_are_exact = true;

  /// empty, or what to do where one of the two answers is indeterminate: the message names a header and a function
  const char* advice = "";
};

namespace internal {

// Two deviations are compared by intervals around their roots: numbers of two vertices may lie in
// different fields, and exact comparisons of what is not zero would prove nothing.
template <class Shape, class Element, class FT>
class Deviation_of_all
{
  using Number = typename Shape::Number;
  using Vector = typename Shape::Vector;

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

  Deviation<Number, Element> result() const
  {
    Deviation<Number, Element> d = d_;
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

  Shape shape_;
  Deviation<Number, Element> d_;
};

} // namespace internal

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CERTIFICATES_3_EXACT_DEVIATION_H
