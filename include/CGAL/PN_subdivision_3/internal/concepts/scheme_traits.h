// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CONCEPTS_SCHEME_TRAITS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CONCEPTS_SCHEME_TRAITS_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>

#include <boost/type_traits/detected_or.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3 {

enum class Control_normal_estimate;

template <class Scheme, class Normal_scheme>
struct Scheme_with_normals;

namespace internal {

template <class Host, class FT>
class Scheme_on_host;
template <class Scheme, bool has_border, class HalfedgeVectorMap>
struct Scheme_of_call;

// What the type of a scheme says of the scheme. If the scheme is chosen at run time the type says what it may have, and
// facts_of() what it has.

template <template <class...> class Template, class T>
struct Is_instance : std::false_type
{};
template <template <class...> class Template, class... Arguments>
struct Is_instance<Template, Template<Arguments...>> : std::true_type
{};

template <class Scheme>
using Is_on_host = Is_instance<Scheme_on_host, Scheme>;

// whether the scheme says that its border rules serve along creases
template <class Scheme>
using Crease_rules_of = std::bool_constant<Scheme::has_crease_rules>;
template <class Scheme>
using Has_crease_rules = boost::detected_or_t<std::false_type, Crease_rules_of, Scheme>;

// whether the scheme says that it is a linear twin
template <class Scheme>
using Linearity_of = std::bool_constant<Scheme::is_linear>;
template <class Scheme>
using Is_linear = boost::detected_or_t<std::false_type, Linearity_of, Scheme>;
// whether points are averaged together with normals
template <class Scheme>
constexpr bool is_pn_v = !Is_linear<Scheme>::value;

// whether the scheme says that the normals have a mask of their own
template <class Scheme>
using Normal_mask_of = std::bool_constant<Scheme::has_normal_mask>;
template <class Scheme>
using Has_normal_mask = boost::detected_or_t<std::false_type, Normal_mask_of, Scheme>;

// whether the scheme transfers curvature to the normals after a round, at the vertices that its mask
// names in separated_vertices()
template <class Scheme>
using Curvature_transfer_of = std::bool_constant<Scheme::transfers_curvature>;
template <class Scheme>
using Has_curvature_transfer = boost::detected_or_t<std::false_type, Curvature_transfer_of, Scheme>;

template <class Scheme, class Element_names>
using Result_of_check = decltype(std::declval<const Scheme&>().check(
  std::declval<const Level_connectivity&>(), std::declval<const Element_names&>()));

// refuses a level that the host cannot refine, or the scheme if it has a check() of its own
template <class Scheme, class Element_names>
void check_scheme(const Scheme& scheme, const Level_connectivity& level, const Element_names& names)
{
  Scheme::Host::check(level, names);
  if constexpr (boost::is_detected<Result_of_check, Scheme, Element_names>::value)
    scheme.check(level, names);
}

template <class Scheme>
using Dense_row_entries_of = decltype(std::declval<const Scheme&>().dense_row_entries(
  std::declval<const Level_connectivity&>(), 1u));
template <class Scheme>
using Has_dense_row_entries = boost::is_detected<Dense_row_entries_of, Scheme>;

// how many rings of faces around its own a piece needs to be refined without the rest, 0 if the scheme
// does not tell
template <class Scheme>
using Ghost_rings_of = std::integral_constant<unsigned, Scheme::ghost_rings>;
template <class Scheme>
using Ghost_rings =
  boost::detected_or_t<std::integral_constant<unsigned, 0>, Ghost_rings_of, Scheme>;

template <class Scheme>
using Adapted_by = typename Scheme::Adapted_scheme;
template <class Scheme>
using Is_adaptor = boost::is_detected<Adapted_by, Scheme>;

// whether the scheme says that its rows hold grids, which Grid_average reads
template <class Scheme>
using Grid_rows_of = std::bool_constant<Scheme::has_grid_rows>;
template <class Scheme>
using Has_grid_rows = boost::detected_or_t<std::false_type, Grid_rows_of, Scheme>;

// asked by what averages rows in its own way, or takes the weights for the whole rule
template <class Scheme>
constexpr bool check_no_grid_rows()
{
  static_assert(!Has_grid_rows<Scheme>::value,
                "PN_subdivision_3: CatmullClark_scheme::Grid is a scheme of subdivide() only: it "
                "has no limits, "
                "interpolation, tessellation, pieces and other normal schemes, and no Any_scheme");
  return true;
}

template <class Scheme>
using Is_with_normals = Is_instance<Scheme_with_normals, Scheme>;
template <class Scheme>
struct Is_with_border : std::false_type
{};
template <class Scheme, class Map>
struct Is_with_border<Scheme_of_call<Scheme, true, Map>> : std::true_type
{};

// A pointer to the outermost one of nested schemes that is of a kind, or nullptr. Of the schemes of
// points and of normals the one of points is searched.
template <template <class> class Is_of_kind, class Scheme>
constexpr auto outermost(const Scheme& scheme)
{
  if constexpr (Is_of_kind<Scheme>::value)
    return &scheme;
  else if constexpr (Is_adaptor<Scheme>::value)
    return outermost<Is_of_kind>(scheme.scheme);
  else
    return nullptr;
}
template <template <class> class Is_of_kind, class Scheme>
using Outermost = decltype(outermost<Is_of_kind>(std::declval<const Scheme&>()));

// whether the rules of a scheme, or of a scheme that it adapts, are chosen at run time
template <class Scheme>
constexpr bool is_chosen_at_run_time()
{
  if constexpr (Is_with_normals<Scheme>::value)
    return is_chosen_at_run_time<typename Scheme::Adapted_scheme>() ||
           is_chosen_at_run_time<typename Scheme::Normals_scheme>();
  else if constexpr (Is_adaptor<Scheme>::value)
    return is_chosen_at_run_time<typename Scheme::Adapted_scheme>();
  else
    return Is_on_host<Scheme>::value;
}

// whether the scheme says from which round on its rules are the same in all: a modified one does
template <class Scheme>
using First_round_of = decltype(std::declval<const Scheme&>().first_round());
template <class Scheme>
using Has_first_round = boost::is_detected<First_round_of, Scheme>;

template <class Scheme>
using Limit_neighborhood_of = decltype(Scheme::limit_neighborhood);
template <class Scheme>
using Has_limit_neighborhood = boost::is_detected<Limit_neighborhood_of, Scheme>;

template <class Scheme>
using Normal_estimate_of = decltype(std::declval<const Scheme&>().normal_estimate());
template <class Scheme>
using Has_normal_estimate = boost::is_detected<Normal_estimate_of, Scheme>;

template <class Scheme>
using Name_of = decltype(std::string(std::declval<const Scheme&>().name()));
template <class Scheme>
using Has_name = boost::is_detected<Name_of, Scheme>;

// whether a mask tells what corners of faces have as such of its weights
template <class Mask>
using Face_part_of = decltype(std::declval<const Mask&>().face_part_of_edge(0u));
template <class Mask>
using Has_face_parts = boost::is_detected<Face_part_of, Mask>;

// What a scheme tells of itself, as data: the one place that asks for it. The defaults are those of a scheme that tells nothing.
struct Scheme_facts
{
  bool has_crease_rules = false; // whether the border rules serve along creases
  bool transfers_curvature = false;
  bool has_normal_mask = false;
  unsigned ghost_rings = 0;
  unsigned first_round = 1; // from which on the rules are the same in all
  Limit_neighborhood limit_neighborhood;
  std::optional<Control_normal_estimate> normal_estimate;
};

// those of the scheme that refines points by one scheme, normals by another one
inline Scheme_facts facts_of_both(const Scheme_facts& points, const Scheme_facts& normals)
{
  const Limit_neighborhood &a = points.limit_neighborhood, &b = normals.limit_neighborhood;
  Scheme_facts both;
  both.has_crease_rules = points.has_crease_rules && normals.has_crease_rules;
  both.has_normal_mask = true;
  if (points.ghost_rings != 0 && normals.ghost_rings != 0)
    both.ghost_rings = (std::max)(points.ghost_rings, normals.ghost_rings);
  both.first_round = (std::max)(points.first_round, normals.first_round);
  both.limit_neighborhood.regular_rings = (std::max)(a.regular_rings, b.regular_rings);
  both.limit_neighborhood.takes_border = a.takes_border && b.takes_border;
  both.limit_neighborhood.keeps_points = a.keeps_points && b.keeps_points;
  both.limit_neighborhood.has_tangent_planes = a.has_tangent_planes && b.has_tangent_planes;
  both.normal_estimate = normals.normal_estimate ? normals.normal_estimate : points.normal_estimate;
  return both;
}

// What the type says holds, but if the scheme is chosen at run time the type says what it may have.
template <class Scheme>
Scheme_facts facts_of([[maybe_unused]] const Scheme& scheme)
{
  Scheme_facts facts;
  if constexpr (Is_on_host<Scheme>::value)
    facts = scheme.facts();
  else if constexpr (Is_with_normals<Scheme>::value)
    facts = facts_of_both(facts_of(scheme.scheme), facts_of(scheme.normal_scheme));
  else if constexpr (Is_adaptor<Scheme>::value)
    facts = facts_of(scheme.scheme);
  constexpr bool is_known = !is_chosen_at_run_time<Scheme>();
  const auto holds = [](bool may, bool does) { return may && (is_known || does); };
  facts.has_crease_rules = holds(Has_crease_rules<Scheme>::value, facts.has_crease_rules);
  facts.transfers_curvature =
    holds(Has_curvature_transfer<Scheme>::value, facts.transfers_curvature);
  facts.has_normal_mask = holds(Has_normal_mask<Scheme>::value, facts.has_normal_mask);
  if (is_known) facts.ghost_rings = Ghost_rings<Scheme>::value;
  if constexpr (Has_first_round<Scheme>::value) facts.first_round = scheme.first_round();
  if constexpr (Has_limit_neighborhood<Scheme>::value)
    facts.limit_neighborhood = Scheme::limit_neighborhood;
  if constexpr (Has_normal_estimate<Scheme>::value)
    facts.normal_estimate = scheme.normal_estimate();
  return facts;
}

// the number that a scheme tells, see estimated_row_entries()
template <class Scheme>
double dense_row_entries([[maybe_unused]] const Scheme& scheme,
                         [[maybe_unused]] const Level_connectivity& level,
                         [[maybe_unused]] unsigned round)
{
  if constexpr (Has_dense_row_entries<Scheme>::value)
    return scheme.dense_row_entries(level, round);
  else if constexpr (Is_with_normals<Scheme>::value)
    return dense_row_entries(scheme.scheme, level, round) +
           dense_row_entries(scheme.normal_scheme, level, round);
  else if constexpr (Is_adaptor<Scheme>::value)
    return dense_row_entries(scheme.scheme, level, round);
  else
    return 0;
}

// the name of a scheme in messages
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
} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CONCEPTS_SCHEME_TRAITS_H
