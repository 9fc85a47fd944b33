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

#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {

template <class Scheme, class Normal_scheme>
struct Scheme_with_normals;

namespace internal {

template <class Host, class FT>
class Scheme_on_host;
template <class Scheme>
struct Scheme_with_border;

// What the type of a scheme says of it. Of a scheme that is chosen at run time the type says what may be, and
// scheme_facts.h what is.

template <class Scheme>
struct Is_on_host : std::false_type
{};
template <class Host, class FT>
struct Is_on_host<Scheme_on_host<Host, FT>> : std::true_type
{};

// whether the scheme says that its border rules serve along creases
template <class Scheme, class = void>
struct Has_crease_rules : std::false_type
{};
template <class Scheme>
struct Has_crease_rules<Scheme, std::void_t<decltype(Scheme::has_crease_rules)>>
  : std::bool_constant<Scheme::has_crease_rules>
{};

// whether the scheme says that it is a linear twin
template <class Scheme, class = void>
struct Is_linear : std::false_type
{};
template <class Scheme>
struct Is_linear<Scheme, std::void_t<decltype(Scheme::is_linear)>>
  : std::bool_constant<Scheme::is_linear>
{};

// whether the scheme says that the normals have a mask of their own
template <class Scheme, class = void>
struct Has_normal_mask : std::false_type
{};
template <class Scheme>
struct Has_normal_mask<Scheme, std::void_t<decltype(Scheme::has_normal_mask)>>
  : std::bool_constant<Scheme::has_normal_mask>
{};

// whether the scheme transfers curvature to the normals after a round, at the vertices that its mask
// names in separated_vertices()
template <class Scheme, class = void>
struct Has_curvature_transfer : std::false_type
{};
template <class Scheme>
struct Has_curvature_transfer<Scheme, std::void_t<decltype(Scheme::transfers_curvature)>>
  : std::bool_constant<Scheme::transfers_curvature>
{};

template <class Scheme, class Element_names, class = void>
struct Has_check : std::false_type
{};
template <class Scheme, class Element_names>
struct Has_check<
  Scheme, Element_names,
  std::void_t<decltype(std::declval<const Scheme&>().check(
    std::declval<const Level_connectivity&>(), std::declval<const Element_names&>()))>>
  : std::true_type
{};

// refuses a level that the host cannot refine, or the scheme if it has a check() of its own
template <class Scheme, class Element_names>
void check_scheme(const Scheme& scheme, const Level_connectivity& level, const Element_names& names)
{
  Scheme::Host::check(level, names);
  if constexpr (Has_check<Scheme, Element_names>::value) scheme.check(level, names);
}

template <class Scheme, class = void>
struct Has_dense_row_entries : std::false_type
{};
template <class Scheme>
struct Has_dense_row_entries<Scheme, std::void_t<decltype(Scheme::dense_row_entries(
                                       std::declval<const Level_connectivity&>(), 1u))>>
  : std::true_type
{};

// how many rings of faces around its own a piece needs to be refined without the rest, 0 if the scheme
// does not tell
template <class Scheme, class = void>
struct Ghost_rings : std::integral_constant<unsigned, 0>
{};
template <class Scheme>
struct Ghost_rings<Scheme, std::void_t<decltype(Scheme::ghost_rings)>>
  : std::integral_constant<unsigned, Scheme::ghost_rings>
{};

template <class Scheme, class = void>
struct Is_adaptor : std::false_type
{};
template <class Scheme>
struct Is_adaptor<Scheme, std::void_t<typename Scheme::Adapted_scheme>> : std::true_type
{};

// whether the scheme says that its rows hold grids, which Grid_average reads
template <class Scheme, class = void>
struct Has_grid_rows : std::false_type
{};
template <class Scheme>
struct Has_grid_rows<Scheme, std::void_t<decltype(Scheme::has_grid_rows)>>
  : std::bool_constant<Scheme::has_grid_rows>
{};

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
struct Is_with_normals : std::false_type
{};
template <class Scheme, class Normal_scheme>
struct Is_with_normals<Scheme_with_normals<Scheme, Normal_scheme>> : std::true_type
{};

template <class Scheme>
struct Is_with_border : std::false_type
{};
template <class Scheme>
struct Is_with_border<Scheme_with_border<Scheme>> : std::true_type
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

// whether its rules, or those of what it adapts, are chosen at run time
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
template <class Scheme, class = void>
struct Has_first_round : std::false_type
{};
template <class Scheme>
struct Has_first_round<Scheme, std::void_t<decltype(std::declval<const Scheme&>().first_round())>>
  : std::true_type
{};

template <class Scheme, class = void>
struct Has_limit_neighborhood : std::false_type
{};
template <class Scheme>
struct Has_limit_neighborhood<Scheme, std::void_t<decltype(Scheme::limit_neighborhood)>>
  : std::true_type
{};

template <class Scheme, class = void>
struct Has_name : std::false_type
{};
template <class Scheme>
struct Has_name<Scheme, std::void_t<decltype(std::string(std::declval<const Scheme&>().name()))>>
  : std::true_type
{};

// whether a mask tells what corners of faces have as such of its weights
template <class Mask, class = void>
struct Has_face_parts : std::false_type
{};
template <class Mask>
struct Has_face_parts<Mask,
                      std::void_t<decltype(std::declval<const Mask&>().face_part_of_edge(0u))>>
  : std::true_type
{};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CONCEPTS_SCHEME_TRAITS_H
