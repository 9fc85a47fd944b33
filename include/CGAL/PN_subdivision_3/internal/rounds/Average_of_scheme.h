// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_AVERAGE_OF_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_AVERAGE_OF_SCHEME_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Grid_average.h>

#include <type_traits>

namespace CGAL::PN_subdivision_3::internal {

// whether points are averaged together with normals
template <class Scheme>
constexpr bool is_pn_v = !Is_linear<Scheme>::value;

// the average of rows, with normals or without
template <bool with_normals, class FT, int dimension>
using Average_of =
  std::conditional_t<with_normals, PN_average<FT, dimension>, Linear_average<FT, dimension>>;

template <class Scheme, class FT>
using Average_of_scheme = std::conditional_t<is_pn_v<Scheme> && Has_grid_rows<Scheme>::value,
                                             Grid_average<FT>, Average_of<is_pn_v<Scheme>, FT, 3>>;

// the average of values that have one roundness; of points alone it plays no part
template <class Average>
Average average_of_roundness([[maybe_unused]] const typename Average::FT& roundness)
{
  Average average{};
  if constexpr (has_normal_v<typename Average::Value>) average.roundness = roundness;
  return average;
}

// the average with the roundness of the scheme, where that is one number
template <class Average, class Scheme>
Average average_of([[maybe_unused]] const Scheme& scheme)
{
  Average average{};
  if constexpr (!std::is_null_pointer_v<Outermost<Is_with_roundness, Scheme>> &&
                has_normal_v<typename Average::Value>)
    average.roundness = outermost<Is_with_roundness>(scheme)->of_all();
  return average;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_AVERAGE_OF_SCHEME_H
