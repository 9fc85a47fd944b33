// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEME_PARTS_SCHEME_PARAMETER_H
#define CGAL_PN_SUBDIVISION_3_SCHEME_PARTS_SCHEME_PARAMETER_H

#include <stdexcept>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

A number that a scheme takes, such as the tension of `Kobbelt_scheme`: a `double` or a fraction. In exact number types fractions are what
they are, `Scheme_parameter(1, 20)` is 1/20, while 0.05 is the `double` next to it.
*/
class Scheme_parameter
{
public:
  /// a number that is a `double`.
  Scheme_parameter(double value)
    : value_(value)
  {}
  /// a fraction. \throws std::invalid_argument if the denominator is not positive
  Scheme_parameter(int numerator, int denominator)
    : value_(static_cast<double>(numerator) / denominator)
    , numerator_(numerator)
    , denominator_(denominator)
  {
    if (denominator <= 0)
      throw std::invalid_argument(
        "PN_subdivision_3: the denominator of a parameter of a scheme must be positive");
  }

  /// returns the number rounded to `double`.
  double to_double() const { return value_; }
  /// returns the number in the number type `FT`.
  template <class FT>
  FT value() const
  {
    return denominator_ == 0 ? FT(value_) : FT(FT(numerator_) / FT(denominator_));
  }

private:
  double value_;
  int numerator_ = 0, denominator_ = 0; // 0: none is given
};

/// \ingroup PkgPNSubdivision3Schemes
/// at which extraordinary vertices a modified scheme has rules of its own.
enum class Tuned_valences {
  /// at all.
  all,
  /// where the curvature of the linear scheme diverges: not at valence 3 of Catmull-Clark and valences
  /// 4 and 5 of Loop subdivision, where it is bounded.
  diverging
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEME_PARTS_SCHEME_PARAMETER_H
