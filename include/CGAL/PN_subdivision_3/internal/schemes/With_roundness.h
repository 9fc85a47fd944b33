// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_WITH_ROUNDNESS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_WITH_ROUNDNESS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_traits.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The roundness of control vertices that a call is given: one of each, one of all, or none. Where there is none it is
// that of the estimate of normals, and 1 where these are given.
template <class FT>
struct Given_roundness
{
  std::vector<FT> of_vertices;
  std::optional<FT> of_all;

  bool is_any() const { return of_all || !of_vertices.empty(); }
  // into the first values, those of the vertices
  template <class Value>
  void put(std::size_t vertices, std::vector<Value>& values) const
  {
    for (std::size_t v = 0; v < vertices; ++v)
      if (of_all)
        values[v].roundness = *of_all;
      else if (!of_vertices.empty())
        values[v].roundness = of_vertices[v];
  }
};

// A scheme with a roundness, which is put around the user's scheme as the outermost adaptor. It varies, and values have one of
// their own, in the calls that estimate normals, that are given a map, or in which sharp edges end; where it is one number,
// Given_roundness::of_all, the average has it.
template <class Scheme, class FT, bool varies = true>
struct With_roundness : Scheme_adaptor<Scheme>
{
  const Given_roundness<FT>* given = nullptr; // none is given
};

template <class Scheme>
struct Is_with_roundness : std::false_type
{};
template <class Scheme, class FT, bool varies>
struct Is_with_roundness<With_roundness<Scheme, FT, varies>> : std::true_type
{};

template <class Scheme>
struct Is_with_varying_roundness : std::false_type
{};
template <class Scheme, class FT>
struct Is_with_varying_roundness<With_roundness<Scheme, FT, true>> : std::true_type
{};

// whether values of the scheme have a roundness of their own
template <class Scheme>
constexpr bool may_vary_in_roundness_v =
  !std::is_null_pointer_v<Outermost<Is_with_varying_roundness, Scheme>>;

// puts what is given into the first values, those of the vertices
template <class Scheme, class Value>
void put_given_roundness([[maybe_unused]] const Scheme& scheme,
                         [[maybe_unused]] std::size_t vertices,
                         [[maybe_unused]] std::vector<Value>& values)
{
  if constexpr (may_vary_in_roundness_v<Scheme> && has_roundness_v<Value>)
    if (const auto* given = outermost<Is_with_roundness>(scheme)->given; given != nullptr)
      given->put(vertices, values);
}

// the wedges of a vertex have one roundness
template <class Value, class Other_value>
void share_roundness([[maybe_unused]] const Value& of_vertex,
                     [[maybe_unused]] Other_value& of_wedge)
{
  if constexpr (has_roundness_v<Value>) of_wedge.roundness = of_vertex.roundness;
}

// Of the entries of a crease average, of which of(j) is the roundness. Equal ones are not summed: here the weights come in
// another order than that in which they sum to 1.
template <class Entry, std::size_t n, class Roundness_of>
auto averaged_roundness(const std::array<Entry, n>& entries, const Roundness_of& of)
{
  const auto first = of(0);
  std::decay_t<decltype(first)> sum =
    entries[0].weight * first; // a number, not the expression of one
  bool are_equal = true;
  for (std::size_t j = 1; j < n; ++j) {
    sum += entries[j].weight * of(j);
    are_equal = are_equal && CGAL::certainly(of(j) == first);
  }
  return are_equal ? first : sum;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_WITH_ROUNDNESS_H
