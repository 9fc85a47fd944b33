// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Attributes of the user's whose differences are not those of their numbers: angles, as parts of a turn.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_TURNS_H
#define CGAL_PN_SUBDIVISION_3_TEST_TURNS_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>

#include <cmath>

struct Turns
{
  double part = 0; // modulo 1
};

template <class FT>
struct CGAL::PN_subdivision_3::Attribute_traits<Turns, FT>
{
  using Sum = double;
  static constexpr bool has_components = false;

  static Sum to_sum(const Turns& t) { return t.part; }
  static Turns to_value(const Sum& s) { return {s}; }
  static Sum difference(const FT& w, const Sum& v, const Sum& origin)
  {
    return w * (v - origin - std::round(v - origin));
  }
};

#endif // CGAL_PN_SUBDIVISION_3_TEST_TURNS_H
