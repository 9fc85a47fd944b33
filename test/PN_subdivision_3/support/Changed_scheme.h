// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Schemes without transfer of curvature, and schemes that begin with a later round.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_CHANGED_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_TEST_CHANGED_SCHEME_H

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

// The first round is number 1 + `rounds_before`.
template <class Host_, unsigned rounds_before>
struct Changed_host : Host_
{
  using Level = CGAL::PN_subdivision_3::Level_connectivity;
  using Size = CGAL::PN_subdivision_3::Level_size;

  Changed_host(const Level& level, unsigned round)
    : Host_(level, round + rounds_before)
  {}
  static Size refined_size(const Size& size, unsigned round)
  {
    return Host_::refined_size(size, round + rounds_before);
  }
};

template <class Scheme, unsigned rounds_before = 0>
struct Changed_scheme
{
  using Host = Changed_host<typename Scheme::Host, rounds_before>;
  using Level = CGAL::PN_subdivision_3::Level_connectivity;

  template <class FT>
  auto mask(const Level& level, unsigned round) const
  {
    return scheme.template mask<FT>(level, round + rounds_before);
  }
  template <class Element_names>
  void check(const Level& level, const Element_names& names) const
  {
    CGAL::PN_subdivision_3::internal::check_scheme(scheme, level, names);
  }

  Scheme scheme;
};

#endif // CGAL_PN_SUBDIVISION_3_TEST_CHANGED_SCHEME_H
