// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_ESTIMATED_ROW_ENTRIES_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_ESTIMATED_ROW_ENTRIES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class Scheme, class = void>
struct Has_dense_row_entries : std::false_type
{};
template <class Scheme>
struct Has_dense_row_entries<Scheme, std::void_t<decltype(Scheme::dense_row_entries(
                                       std::declval<const Level_connectivity&>(), 1u))>>
  : std::true_type
{};

template <class Scheme>
struct Dense_row_entries
{
  static double of([[maybe_unused]] const Level_connectivity& level,
                   [[maybe_unused]] unsigned round)
  {
    if constexpr (Has_dense_row_entries<Scheme>::value)
      return Scheme::dense_row_entries(level, round);
    else
      return 0;
  }
};
template <class Scheme>
struct Dense_row_entries<Linear_scheme<Scheme>> : Dense_row_entries<Scheme>
{};
template <class Scheme, class Normal_scheme>
struct Dense_row_entries<Scheme_with_normals<Scheme, Normal_scheme>>
{
  static double of(const Level_connectivity& level, unsigned round)
  {
    return Dense_row_entries<Scheme>::of(level, round) +
           Dense_row_entries<Normal_scheme>::of(level, round);
  }
};

} // namespace internal

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
\cost linear in the size of `level`
*/
template <class Scheme>
double estimated_row_entries([[maybe_unused]] const Scheme& scheme, const Level_connectivity& level,
                             unsigned rounds)
{
  constexpr double ordinary_row = 8;
  const double first = internal::Dense_row_entries<Scheme>::of(level, 1);
  const double later = rounds < 2 ? 0 : internal::Dense_row_entries<Scheme>::of(level, 2);
  double entries = 0;
  Level_size size = level.size();
  for (unsigned k = 1; k <= rounds && size.vertices < Level_connectivity::null; ++k) {
    size = Scheme::Host::refined_size(size, k);
    entries += ordinary_row * static_cast<double>(size.vertices) + (k == 1 ? first : later);
  }
  return entries;
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_ESTIMATED_ROW_ENTRIES_H
