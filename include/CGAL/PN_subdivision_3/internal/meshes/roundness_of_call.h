// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_ROUNDNESS_OF_CALL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_ROUNDNESS_OF_CALL_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/internal/schemes/With_roundness.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class T>
constexpr bool is_given_roundness_v = !std::is_same_v<T, No_roundness>;

// whether edges may be sharp for a number of rounds: a map of bool has edges that are so for ever
template <class Edge_map>
constexpr bool may_be_semi_sharp()
{
  if constexpr (is_constraint_map_v<Edge_map>)
    return !std::is_same_v<std::decay_t<typename boost::property_traits<Edge_map>::value_type>,
                           bool>;
  else
    return false;
}

// Whether the roundness of a call may vary: where normals are estimated it does unless it is given as a number, sharp
// edges that end take it away, and it may be given as a map. A call of which its type says that it does not has no memory
// and no time for it.
template <class Scheme, class Parameters>
constexpr bool
  varies_in_roundness_v = is_pn_v<Scheme> &&
                          ((std::is_same_v<typename Parameters::Normal_map, No_normal_map> &&
                            !is_given_roundness_v<typename Parameters::Roundness>) ||
                           is_given_roundness_v<typename Parameters::Roundness_map> ||
                           (Has_crease_rules<Scheme>::value &&
                            may_be_semi_sharp<typename Parameters::Edge_constraint_map>()));

template <class Scheme, class Parameters>
constexpr bool has_roundness_of_call_v = varies_in_roundness_v<Scheme, Parameters> ||
                                         (is_pn_v<Scheme> &&
                                          is_given_roundness_v<typename Parameters::Roundness>);

// Masks with negative weights take what is from 0 to 1 a little beyond, from which a further call goes on.
template <class FT, class Name>
FT checked_roundness(const FT& w, bool may_be_refined, const Name& name)
{
  const FT beyond = may_be_refined ? FT(1) / FT(2) : FT(0);
  if (CGAL::certainly(w >= -beyond) && CGAL::certainly(w <= FT(1) + beyond)) return w;
  throw std::invalid_argument("PN_subdivision_3: the roundness of " + name() + " is " +
                              std::to_string(CGAL::to_double(w)) + ": it must be from 0 to 1");
}

template <class FT, class Parameters, class Access, class NamedParameters>
Given_roundness<FT> read_roundness(const Access& access, const NamedParameters& np)
{
  Given_roundness<FT> given;
  if constexpr (is_given_roundness_v<typename Parameters::Roundness>)
    given.of_all = checked_roundness<FT>(FT(Parameters::roundness(np)), false,
                                         [] { return std::string("all vertices"); });
  if constexpr (is_given_roundness_v<typename Parameters::Roundness_map>) {
    const auto map = Parameters::roundness_map(np);
    const auto n = static_cast<Level_connectivity::Index>(access.size().vertices);
    given.of_vertices.reserve(n);
    for (Level_connectivity::Index v = 0; v < n; ++v)
      given.of_vertices.push_back(checked_roundness<FT>(FT(get(map, access.vertex(v))), true,
                                                        [&] { return access.vertex_name(v); }));
  }
  return given;
}

// f(scheme), where the scheme has a roundness if the call needs one
template <class Parameters, class Access, class Scheme, class NamedParameters, class Function>
decltype(auto) with_roundness_of_call([[maybe_unused]] const Access& access, const Scheme& scheme,
                                      [[maybe_unused]] const NamedParameters& np, const Function& f)
{
  using FT = typename Parameters::FT;
  if constexpr (has_roundness_of_call_v<Scheme, Parameters>) {
    const auto given = read_roundness<FT, Parameters>(access, np);
    constexpr bool varies = varies_in_roundness_v<Scheme, Parameters>;
    return f(With_roundness<Scheme, FT, varies>{{scheme}, &given});
  } else
    return f(scheme);
}

// a roundness as a map of the user's stores it
template <class T, class FT>
T roundness_as(const FT& w)
{
  if constexpr (std::is_constructible_v<T, const FT&>)
    return T(w);
  else
    return T(CGAL::to_double(w));
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_ROUNDNESS_OF_CALL_H
