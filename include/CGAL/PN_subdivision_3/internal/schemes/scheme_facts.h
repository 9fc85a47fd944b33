// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_FACTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_FACTS_H

#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>

#include <algorithm>
#include <string>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What a scheme tells of itself: in its type or, if it was chosen at run time, as data.

// f of what is adapted; what the schemes of points and of normals say is joined
template <class Scheme, class Function, class Join>
auto of_adapted(const Scheme& scheme, const Function& f, [[maybe_unused]] const Join& join)
{
  if constexpr (Is_with_normals<Scheme>::value)
    return join(f(scheme.scheme), f(scheme.normal_scheme));
  else
    return f(scheme.scheme);
}

// whether the border rules serve along creases
template <class Scheme>
bool has_crease_rules([[maybe_unused]] const Scheme& scheme)
{
  if constexpr (!is_chosen_at_run_time<Scheme>())
    return Has_crease_rules<Scheme>::value;
  else if constexpr (Is_on_host<Scheme>::value)
    return scheme.facts().has_crease_rules;
  else
    return of_adapted(
      scheme, [](const auto& s) { return has_crease_rules(s); },
      [](bool points, bool normals) { return points && normals; });
}

// whether a round transfers curvature to the normals
template <class Scheme>
bool transfers_curvature([[maybe_unused]] const Scheme& scheme)
{
  if constexpr (!is_chosen_at_run_time<Scheme>() || !Has_curvature_transfer<Scheme>::value)
    return Has_curvature_transfer<Scheme>::value;
  else if constexpr (Is_on_host<Scheme>::value)
    return scheme.facts().transfers_curvature;
  else
    return transfers_curvature(scheme.scheme);
}

// whether the normals have a mask of their own
template <class Scheme>
bool has_normal_mask([[maybe_unused]] const Scheme& scheme)
{
  if constexpr (!is_chosen_at_run_time<Scheme>() || !Has_normal_mask<Scheme>::value ||
                Is_with_normals<Scheme>::value)
    return Has_normal_mask<Scheme>::value;
  else if constexpr (Is_on_host<Scheme>::value)
    return scheme.facts().has_normal_mask();
  else
    return has_normal_mask(scheme.scheme);
}

// how many rings of faces around its own a piece needs to be refined without the rest, 0 if the scheme
// does not tell
template <class Scheme>
unsigned ghost_rings([[maybe_unused]] const Scheme& scheme)
{
  if constexpr (!is_chosen_at_run_time<Scheme>())
    return Ghost_rings<Scheme>::value;
  else if constexpr (Is_on_host<Scheme>::value)
    return scheme.facts().ghost_rings;
  else
    return of_adapted(
      scheme, [](const auto& s) { return ghost_rings(s); },
      [](unsigned points, unsigned normals) {
        return points == 0 || normals == 0 ? 0u : (std::max)(points, normals);
      });
}

// the first round from which on the rules are the same in all
template <class Scheme>
unsigned first_tuned_round([[maybe_unused]] const Scheme& scheme)
{
  if constexpr (Has_first_round<Scheme>::value)
    return scheme.first_round();
  else if constexpr (Is_adaptor<Scheme>::value)
    return of_adapted(
      scheme, [](const auto& s) { return first_tuned_round(s); },
      [](unsigned points, unsigned normals) { return (std::max)(points, normals); });
  else
    return 1;
}

template <class Scheme>
Limit_neighborhood limit_neighborhood([[maybe_unused]] const Scheme& scheme)
{
  if constexpr (Is_on_host<Scheme>::value)
    return scheme.facts().limit_neighborhood;
  else if constexpr (Has_limit_neighborhood<Scheme>::value)
    return Scheme::limit_neighborhood;
  else if constexpr (Is_adaptor<Scheme>::value)
    return of_adapted(
      scheme, [](const auto& s) { return limit_neighborhood(s); },
      [](const Limit_neighborhood& points, const Limit_neighborhood& normals) {
        Limit_neighborhood both;
        both.regular_rings = (std::max)(points.regular_rings, normals.regular_rings);
        both.takes_border = points.takes_border && normals.takes_border;
        both.keeps_points = points.keeps_points && normals.keeps_points;
        both.has_tangent_planes = points.has_tangent_planes && normals.has_tangent_planes;
        return both;
      });
  else
    return {};
}

// the number that a scheme tells, see estimated_row_entries()
template <class Scheme>
double dense_row_entries([[maybe_unused]] const Scheme& scheme,
                         [[maybe_unused]] const Level_connectivity& level,
                         [[maybe_unused]] unsigned round)
{
  if constexpr (Is_on_host<Scheme>::value)
    return scheme.facts().dense_row_entries(level, round);
  else if constexpr (Has_dense_row_entries<Scheme>::value)
    return Scheme::dense_row_entries(level, round);
  else if constexpr (Is_adaptor<Scheme>::value)
    return of_adapted(
      scheme, [&](const auto& s) { return dense_row_entries(s, level, round); },
      [](double points, double normals) { return points + normals; });
  else
    return 0;
}

// as it is called in messages
template <class Scheme>
std::string name_in_message([[maybe_unused]] const Scheme& scheme)
{
  if constexpr (Is_adaptor<Scheme>::value)
    return name_in_message(scheme.scheme);
  else if constexpr (Has_name<Scheme>::value)
    return "the scheme " + std::string(scheme.name());
  else
    return "this scheme";
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_SCHEME_FACTS_H
