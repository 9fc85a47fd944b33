// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Numbers a + b sqrt(r) with rational a, b and r: exact, and fast enough for whole meshes. From
// rational control data, a new vertex of one round needs a single square root, that of |N|^2. Numbers
// with different roots must not meet; where they do, an exception is thrown, also under NDEBUG.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_ONE_ROOT_NUMBER_H
#define CGAL_PN_SUBDIVISION_3_TEST_ONE_ROOT_NUMBER_H

#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <CGAL/Coercion_traits.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Sqrt_extension.h>

#include <boost/operators.hpp>

#include <iosfwd>
#include <stdexcept>
#include <utility>

// two numbers with different roots have met
struct Mixed_roots : std::logic_error
{
  using std::logic_error::logic_error;
};

class One_root_number : boost::ordered_field_operators<One_root_number>
{
public:
  using Rational = CGAL::Gmpq;
  using Extension = CGAL::Sqrt_extension<Rational, Rational, CGAL::Tag_true, CGAL::Tag_true>;

  One_root_number() = default;
  One_root_number(int x)
    : value_(x)
  {}
  One_root_number(double x)
    : value_(Rational(x))
  {}
  One_root_number(const Rational& x)
    : value_(x)
  {}

  // factor * sqrt(root); a rational number if root is a square
  static One_root_number root(const Rational& factor, const Rational& root)
  {
    Rational r;
    if (CGAL::Algebraic_structure_traits<Rational>::Is_square()(root, r)) return factor * r;
    One_root_number x;
    x.value_ = Extension(Rational(0), factor, root);
    return x;
  }

  const Extension& value() const { return value_; }
  bool is_rational() const { return !value_.is_extended(); }

  One_root_number operator+() const { return *this; }
  One_root_number operator-() const
  {
    One_root_number x;
    x.value_ = -value_;
    return x;
  }
  One_root_number& operator+=(const One_root_number& x)
  {
    check(x);
    value_ += x.value_;
    return simplified();
  }
  One_root_number& operator-=(const One_root_number& x)
  {
    check(x);
    value_ -= x.value_;
    return simplified();
  }
  One_root_number& operator*=(const One_root_number& x)
  {
    check(x);
    value_ *= x.value_;
    return simplified();
  }
  One_root_number& operator/=(const One_root_number& x)
  {
    check(x);
    if (x.value_.is_zero()) throw std::domain_error("division by zero");
    value_ /= x.value_;
    return simplified();
  }
  friend bool operator==(const One_root_number& a, const One_root_number& b)
  {
    a.check(b);
    return a.value_ == b.value_;
  }
  friend bool operator<(const One_root_number& a, const One_root_number& b)
  {
    a.check(b);
    return a.value_ < b.value_;
  }

private:
  void check(const One_root_number& x) const
  {
    if (!is_rational() && !x.is_rational() && value_.root() != x.value_.root())
      throw Mixed_roots("numbers with different square roots");
  }
  One_root_number& simplified()
  {
    value_.check_if_is_extended(); // drops a root with the factor 0
    return *this;
  }

  Extension value_;
};

namespace CGAL {

template <>
class Algebraic_structure_traits<One_root_number>
  : public Algebraic_structure_traits_base<One_root_number, Field_tag>
{
public:
  using Is_exact = Tag_true;
  using Is_numerical_sensitive = Tag_false;
};

template <>
class Real_embeddable_traits<One_root_number>
  : public INTERN_RET::Real_embeddable_traits_base<One_root_number, Tag_true>
{
public:
  struct To_double : public CGAL::cpp98::unary_function<One_root_number, double>
  {
    double operator()(const One_root_number& x) const { return CGAL::to_double(x.value()); }
  };
  struct To_interval
    : public CGAL::cpp98::unary_function<One_root_number, std::pair<double, double>>
  {
    std::pair<double, double> operator()(const One_root_number& x) const
    {
      return CGAL::to_interval(x.value());
    }
  };
};

CGAL_DEFINE_COERCION_TRAITS_FOR_SELF(One_root_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(int, One_root_number)

namespace PN_subdivision_3 {

// The package's way for a number type to bring its own square root.
template <>
struct Unit_normal_traits<One_root_number>
{
  static One_root_number inverse_length(const One_root_number& squared_length)
  {
    if (!squared_length.is_rational()) throw Mixed_roots("the root of a root");
    const CGAL::Gmpq s = squared_length.value().a0();
    return One_root_number::root(1 / s, s);
  }
  static One_root_number vanishing_tolerance() { return 0; }
  static One_root_number unit_tolerance() { return 0; }
};

} // namespace PN_subdivision_3
} // namespace CGAL

inline std::ostream& operator<<(std::ostream& out, const One_root_number& x)
{
  return out << CGAL::to_double(x);
}

using One_root_kernel = CGAL::Simple_cartesian<One_root_number>;

#endif // CGAL_PN_SUBDIVISION_3_TEST_ONE_ROOT_NUMBER_H
