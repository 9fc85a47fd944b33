// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_SCHEME_ADAPTORS_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_SCHEME_ADAPTORS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {

template <class Scheme>
struct Scheme_with_border;

namespace internal {

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

// the number that a scheme tells, see estimated_row_entries()
template <class Scheme>
double dense_row_entries([[maybe_unused]] const Level_connectivity& level,
                         [[maybe_unused]] unsigned round)
{
  if constexpr (Has_dense_row_entries<Scheme>::value)
    return Scheme::dense_row_entries(level, round);
  else
    return 0;
}

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

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Schemes
What the adaptors of schemes have in common: they are the scheme, but for what each of them says
itself. Adaptors can be nested in any order; of two of a kind the outer one counts.
*/
template <class Scheme>
struct Scheme_adaptor
{
  /// the scheme that is adapted.
  using Adapted_scheme = Scheme;
  /// the host of the adapted scheme.
  using Host = typename Scheme::Host;

  /// whether the rules for borders serve along creases.
  static constexpr bool has_crease_rules = internal::Has_crease_rules<Scheme>::value;
  /// whether it is a linear twin.
  static constexpr bool is_linear = internal::Is_linear<Scheme>::value;
  /// whether the normals have a mask of their own.
  static constexpr bool has_normal_mask = internal::Has_normal_mask<Scheme>::value;
  /// whether a round transfers curvature to the normals.
  static constexpr bool transfers_curvature = internal::Has_curvature_transfer<Scheme>::value;
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = internal::Ghost_rings<Scheme>::value;

  /// the mask of a round, that of the adapted scheme.
  template <class FT>
  auto mask(const Level_connectivity& level, unsigned round) const
  {
    return scheme.template mask<FT>(level, round);
  }

  /// if the normals have a mask of their own.
  template <class FT>
  auto normal_mask(const Level_connectivity& level, unsigned round) const
  {
    return scheme.template normal_mask<FT>(level, round);
  }

  /// the number of entries that long rows of a round have; see `estimated_row_entries()`.
  static double dense_row_entries(const Level_connectivity& level, unsigned round)
  {
    return internal::dense_row_entries<Scheme>(level, round);
  }

  /// refuses what the adapted scheme refuses.
  template <class Element_names>
  void check(const Level_connectivity& level, const Element_names& names) const
  {
    internal::check_scheme(scheme, level, names);
  }

  /// the scheme that is adapted.
  Scheme scheme;
};

/*!
\ingroup PkgPNSubdivision3Schemes
The linear twin of a scheme, made by `linear()`: it gives the points that the scheme gives where there
are no normals.
*/
template <class Scheme>
struct Linear_scheme : Scheme_adaptor<Scheme>
{
  /// whether it is a linear twin.
  static constexpr bool is_linear = true;
  /// whether the normals have a mask of their own.
  static constexpr bool has_normal_mask = false;
  /// whether a round transfers curvature to the normals.
  static constexpr bool transfers_curvature = false;
};

/// \ingroup PkgPNSubdivision3Schemes
/// returns the linear twin of `scheme`: normals are neither read nor written.
template <class Scheme, class = typename Scheme::Host>
Linear_scheme<Scheme> linear(const Scheme& scheme)
{
  return {{scheme}};
}

/*!
\ingroup PkgPNSubdivision3Schemes
A scheme that refines the normals by the mask of another one, made by `with_normal_scheme()`.
*/
template <class Scheme, class Normal_scheme>
struct Scheme_with_normals : Scheme_adaptor<Scheme>
{
  static_assert(std::is_same_v<typename Scheme::Host, typename Normal_scheme::Host>,
                "PN_subdivision_3: the schemes of points and normals need the same host");
  static_assert(!internal::Has_curvature_transfer<Scheme>::value &&
                  !internal::Has_curvature_transfer<Normal_scheme>::value,
                "PN_subdivision_3: a scheme that transfers curvature refines points and normals "
                "together");
  static_assert(
    std::is_null_pointer_v<internal::Outermost<internal::Is_with_border, Normal_scheme>>,
    "PN_subdivision_3: the border is that of the scheme of the points: give it to that, or to what "
    "with_normal_scheme() returns");

  /// whether the rules for borders of both schemes serve along creases.
  static constexpr bool has_crease_rules =
    internal::Has_crease_rules<Scheme>::value && internal::Has_crease_rules<Normal_scheme>::value;
  /// whether the normals have a mask of their own.
  static constexpr bool has_normal_mask = true;
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings =
    internal::Ghost_rings<Scheme>::value == 0 || internal::Ghost_rings<Normal_scheme>::value == 0
      ? 0
      : (std::max)(internal::Ghost_rings<Scheme>::value,
                   internal::Ghost_rings<Normal_scheme>::value);

  /// the mask of the normals in a round.
  template <class FT>
  auto normal_mask(const Level_connectivity& level, unsigned round) const
  {
    return normal_scheme.template mask<FT>(level, round);
  }

  /// the number of entries that long rows of a round have; see `estimated_row_entries()`.
  static double dense_row_entries(const Level_connectivity& level, unsigned round)
  {
    return internal::dense_row_entries<Scheme>(level, round) +
           internal::dense_row_entries<Normal_scheme>(level, round);
  }

  /// refuses what one of the schemes refuses.
  template <class Element_names>
  void check(const Level_connectivity& level, const Element_names& names) const
  {
    internal::check_scheme(this->scheme, level, names);
    internal::check_scheme(normal_scheme, level, names);
  }

  /// the scheme of the normals.
  Normal_scheme normal_scheme;
};

/*!
\ingroup PkgPNSubdivision3Schemes
returns the scheme that refines points as `scheme` and normals as `normal_scheme`, which has the
same host. The points keep the smoothness of the less smooth of the two (Yang, Section 4.1);
circles, spheres and cylinders are in general not reproduced.
*/
template <class Scheme, class Normal_scheme>
Scheme_with_normals<Scheme, Normal_scheme> with_normal_scheme(const Scheme& scheme,
                                                              const Normal_scheme& normal_scheme)
{
  return {{scheme}, normal_scheme};
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_SCHEME_ADAPTORS_H
