// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_ESTIMATED_ROW_ENTRIES_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_ESTIMATED_ROW_ENTRIES_H

#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

returns about how many (vertex, weight) entries the rows of all new vertices have in a call of
`subdivide()` with `rounds` rounds, to which the time of the call is proportional.

A new vertex has about eight entries. Some schemes have rows that are as long as a valence or the degree of
a face, and as many of them: one vertex of valence 10<sup>5</sup> then takes 10<sup>10</sup> entries a round.
Such a scheme has a static function `dense_row_entries(level, round)` that returns their number.

\param scheme a model of `PNSubdivisionScheme_3`
\param level the control mesh
\param rounds the number of rounds
<br><b>Cost:</b> linear in the size of `level`
*/
template <class Scheme>
double estimated_row_entries(const Scheme& scheme, const Level_connectivity& level, unsigned rounds)
{
  if constexpr (internal::Is_any<Scheme>::value)
    return internal::with_host<double>(
      scheme, [&](const auto& s) { return estimated_row_entries(s, level, rounds); });
  else {
    constexpr double ordinary_row = 8;
    // a transfer evaluates the rows of its rings once more
    const double times = internal::facts_of(scheme).transfers_curvature ? 2 : 1;
    const double first = times * internal::dense_row_entries(scheme, level, 1);
    const double later = rounds < 2 ? 0 : times * internal::dense_row_entries(scheme, level, 2);
    double entries = 0;
    Level_size size = level.size();
    for (unsigned k = 1; k <= rounds && size.vertices < Level_connectivity::null; ++k) {
      size = Scheme::Host::refined_size(size, k);
      entries += ordinary_row * static_cast<double>(size.vertices) + (k == 1 ? first : later);
    }
    return entries;
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_ESTIMATED_ROW_ENTRIES_H
