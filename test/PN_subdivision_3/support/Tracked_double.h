// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A number type as a user may bring one: a double behind operators, known to CGAL by its traits.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_TRACKED_DOUBLE_H
#define CGAL_PN_SUBDIVISION_3_TEST_TRACKED_DOUBLE_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Coercion_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_utils.h>

#include <boost/operators.hpp>

#include <cmath>
#include <cstddef>
#include <iosfwd>
#include <limits>
#include <utility>

class Tracked_double : boost::ordered_field_operators<Tracked_double>
{
public:
  Tracked_double() = default;
  Tracked_double(int x)
    : value_(x)
  {}
  Tracked_double(double x)
    : value_(x)
  {}
  double value() const { return value_; }

  Tracked_double operator+() const { return *this; }
  Tracked_double operator-() const { return Tracked_double(-value_); }
  Tracked_double& operator+=(const Tracked_double& x) { return value_ += x.value_, *this; }
  Tracked_double& operator-=(const Tracked_double& x) { return value_ -= x.value_, *this; }
  Tracked_double& operator*=(const Tracked_double& x) { return value_ *= x.value_, *this; }
  Tracked_double& operator/=(const Tracked_double& x) { return value_ /= x.value_, *this; }
  friend bool operator==(const Tracked_double& a, const Tracked_double& b)
  {
    return a.value_ == b.value_;
  }
  friend bool operator<(const Tracked_double& a, const Tracked_double& b)
  {
    return a.value_ < b.value_;
  }

  static std::size_t& square_roots()
  {
    static std::size_t n = 0;
    return n;
  }

private:
  double value_ = 0;
};

namespace CGAL {

template <>
class Algebraic_structure_traits<Tracked_double>
  : public Algebraic_structure_traits_base<Tracked_double, Field_with_sqrt_tag>
{
public:
  using Is_exact = Tag_false;
  using Is_numerical_sensitive = Tag_true;
  struct Sqrt : public CGAL::cpp98::unary_function<Tracked_double, Tracked_double>
  {
    Tracked_double operator()(const Tracked_double& x) const
    {
      ++Tracked_double::square_roots();
      return Tracked_double(std::sqrt(x.value()));
    }
  };
};

template <>
class Real_embeddable_traits<Tracked_double>
  : public INTERN_RET::Real_embeddable_traits_base<Tracked_double, Tag_true>
{
public:
  struct Is_finite : public CGAL::cpp98::unary_function<Tracked_double, bool>
  {
    bool operator()(const Tracked_double& x) const { return std::isfinite(x.value()); }
  };
  struct To_double : public CGAL::cpp98::unary_function<Tracked_double, double>
  {
    double operator()(const Tracked_double& x) const { return x.value(); }
  };
  struct To_interval : public CGAL::cpp98::unary_function<Tracked_double, std::pair<double, double>>
  {
    std::pair<double, double> operator()(const Tracked_double& x) const
    {
      return {x.value(), x.value()};
    }
  };
};

CGAL_DEFINE_COERCION_TRAITS_FOR_SELF(Tracked_double)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(int, Tracked_double)

} // namespace CGAL

// it rounds as double does
namespace std {
template <>
struct numeric_limits<Tracked_double> : numeric_limits<double>
{};
} // namespace std

#endif // CGAL_PN_SUBDIVISION_3_TEST_TRACKED_DOUBLE_H
