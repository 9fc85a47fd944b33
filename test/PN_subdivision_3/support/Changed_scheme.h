// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Schemes with weights that are changed a little, and schemes that begin with a later round.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_CHANGED_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_TEST_CHANGED_SCHEME_H

#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

template <class Mask, class FT>
struct Changed_mask
{
  Mask mask;
  FT first, last; // what is added to the first and to the last weight of a row
};

// Copies of old vertices remain copies. The first round is number 1 + `rounds_before`.
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

  template <class Mask, class FT, class Stencil>
  void stencil(const Changed_mask<Mask, FT>& changed, Level::Index v, Stencil& s) const
  {
    CGAL::PN_subdivision_3::internal::Stencil_block<FT> row;
    Host_::stencil(changed.mask, v, row.row());
    row.close_row();
    const auto *const begin = row.begin(0), *const last = row.end(0) - 1;
    for (const auto* e = begin; e != last + 1; ++e) {
      FT weight = e->weight;
      if (begin != last && e == begin) weight += changed.first;
      if (begin != last && e == last) weight += changed.last;
      s.add(e->vertex, weight);
    }
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
    auto original = scheme.template mask<FT>(level, round + rounds_before);
    return Changed_mask<decltype(original), FT>{original, FT(first), FT(last)};
  }
  template <class Element_names>
  void check(const Level& level, const Element_names& names) const
  {
    CGAL::PN_subdivision_3::internal::check_scheme(scheme, level, names);
  }

  Scheme scheme;
  double first = 0, last = 0;
};

#endif // CGAL_PN_SUBDIVISION_3_TEST_CHANGED_SCHEME_H
