// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_BOOST_MULTIPRECISION_FLOATS_H
#define CGAL_PN_SUBDIVISION_3_BOOST_MULTIPRECISION_FLOATS_H

/*!
\file CGAL/PN_subdivision_3/boost_multiprecision_floats.h

The traits that \cgal lacks for the floating point types of Boost.Multiprecision. With this header, included before
kernels are made, `cpp_bin_float`, `mpfr_float` and `float128` serve as number types of `CGAL::Simple_cartesian`.
`mpfr_float` needs a \cgal with MPFR, `float128` g++ with `-std=gnu++17` and the library quadmath. They are fields
with square root that round; `CGAL::is_valid()` and `CGAL::is_finite()` know NaN and infinity. The umbrella header
does not include it.
*/

#include <CGAL/boost_mp.h>
#include <CGAL/number_type_basic.h>

#include <boost/config.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#ifdef CGAL_USE_MPFR
#  include <boost/multiprecision/mpfr.hpp>
#endif
#if defined(BOOST_HAS_FLOAT128) && defined(__GNUC__) && !defined(__clang__)
#  define CGAL_PN_SUBDIVISION_3_HAS_FLOAT128
#  include <boost/multiprecision/float128.hpp>
#endif

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class Number>
struct Boost_float_algebra : Algebraic_structure_traits_base<Number, Field_with_sqrt_tag>
{
  using Is_exact = Tag_false;
  using Is_numerical_sensitive = Tag_true;

  struct Sqrt : CGAL::cpp98::unary_function<Number, Number>
  {
    Number operator()(const Number& x) const { return Number(sqrt(x)); }
  };
};

template <class Number>
struct Boost_float_order : INTERN_RET::Real_embeddable_traits_base<Number, Tag_true>
{
  struct Abs : CGAL::cpp98::unary_function<Number, Number>
  {
    Number operator()(const Number& x) const { return x < 0 ? Number(-x) : x; }
  };
  struct Sgn : CGAL::cpp98::unary_function<Number, CGAL::Sign>
  {
    CGAL::Sign operator()(const Number& x) const { return CGAL::sign(x.compare(0)); }
  };
  struct Compare : CGAL::cpp98::binary_function<Number, Number, Comparison_result>
  {
    Comparison_result operator()(const Number& x, const Number& y) const
    {
      return CGAL::sign(x.compare(y));
    }
  };
  // neither infinite nor NaN
  struct Is_finite : CGAL::cpp98::unary_function<Number, bool>
  {
    bool operator()(const Number& x) const { return Number(x - x) == 0; }
  };
  struct To_double : CGAL::cpp98::unary_function<Number, double>
  {
    double operator()(const Number& x) const { return x.template convert_to<double>(); }
  };
  struct To_interval : CGAL::cpp98::unary_function<Number, std::pair<double, double>>
  {
    std::pair<double, double> operator()(const Number& x) const
    {
      const double d = To_double()(x), infinity = std::numeric_limits<double>::infinity();
      const double down = std::nextafter(d, -infinity), up = std::nextafter(d, infinity);
      if (std::isinf(d)) return d > 0 ? std::make_pair(down, d) : std::make_pair(d, up);
      return {x < d ? down : d, x > d ? up : d};
    }
  };
};

template <class Number>
struct Boost_float_validity : CGAL::cpp98::unary_function<Number, bool>
{
  bool operator()(const Number& x) const { return x == x; }
};

} // namespace internal
} // namespace PN_subdivision_3

#define CGAL_PN_SUBDIVISION_3_TRAITS(PARAMETERS, NUMBER)                                           \
  template <PARAMETERS>                                                                            \
  class Algebraic_structure_traits<NUMBER>                                                         \
    : public PN_subdivision_3::internal::Boost_float_algebra<NUMBER>                               \
  {};                                                                                              \
  template <PARAMETERS>                                                                            \
  class Real_embeddable_traits<NUMBER>                                                             \
    : public PN_subdivision_3::internal::Boost_float_order<NUMBER>                                 \
  {};                                                                                              \
  template <PARAMETERS>                                                                            \
  class Is_valid<NUMBER> : public PN_subdivision_3::internal::Boost_float_validity<NUMBER>         \
  {};

#define CGAL_PN_SUBDIVISION_3_PARAMETERS                                                           \
  unsigned digits, boost::multiprecision::backends::digit_base_type base, class Allocator,         \
    class Exponent, Exponent least, Exponent greatest,                                             \
    boost::multiprecision::expression_template_option option
#define CGAL_PN_SUBDIVISION_3_NUMBER                                                               \
  boost::multiprecision::number<                                                                   \
    boost::multiprecision::cpp_bin_float<digits, base, Allocator, Exponent, least, greatest>,      \
    option>
CGAL_PN_SUBDIVISION_3_TRAITS(CGAL_PN_SUBDIVISION_3_PARAMETERS, CGAL_PN_SUBDIVISION_3_NUMBER)
#undef CGAL_PN_SUBDIVISION_3_PARAMETERS
#undef CGAL_PN_SUBDIVISION_3_NUMBER

#ifdef CGAL_USE_MPFR
#  define CGAL_PN_SUBDIVISION_3_PARAMETERS                                                         \
    unsigned digits, boost::multiprecision::mpfr_allocation_type allocation,                       \
      boost::multiprecision::expression_template_option option
#  define CGAL_PN_SUBDIVISION_3_NUMBER                                                             \
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits, allocation>,   \
                                  option>
CGAL_PN_SUBDIVISION_3_TRAITS(CGAL_PN_SUBDIVISION_3_PARAMETERS, CGAL_PN_SUBDIVISION_3_NUMBER)
#  undef CGAL_PN_SUBDIVISION_3_PARAMETERS
#  undef CGAL_PN_SUBDIVISION_3_NUMBER
#endif

#ifdef CGAL_PN_SUBDIVISION_3_HAS_FLOAT128
#  define CGAL_PN_SUBDIVISION_3_NUMBER                                                             \
    boost::multiprecision::number<boost::multiprecision::float128_backend, option>
CGAL_PN_SUBDIVISION_3_TRAITS(boost::multiprecision::expression_template_option option,
                             CGAL_PN_SUBDIVISION_3_NUMBER)
#  undef CGAL_PN_SUBDIVISION_3_NUMBER
#endif
#undef CGAL_PN_SUBDIVISION_3_TRAITS

} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_BOOST_MULTIPRECISION_FLOATS_H
