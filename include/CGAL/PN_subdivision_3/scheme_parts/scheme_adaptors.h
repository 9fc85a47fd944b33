// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEME_PARTS_SCHEME_ADAPTORS_H
#define CGAL_PN_SUBDIVISION_3_SCHEME_PARTS_SCHEME_ADAPTORS_H

#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes
The common base of the adaptors of schemes: an adaptor is the scheme, but for the members that it has itself. Adaptors
can be nested in any order; of two of a kind the outer one counts.
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
  /// whether rows are averaged by `Grid_average`.
  static constexpr bool has_grid_rows = internal::Has_grid_rows<Scheme>::value;
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
  static_assert(internal::check_no_grid_rows<Scheme>() &&
                internal::check_no_grid_rows<Normal_scheme>());
  static_assert(std::is_same_v<typename Scheme::Host, typename Normal_scheme::Host>,
                "PN_subdivision_3: the schemes of points and normals need the same host");
  static_assert(internal::is_chosen_at_run_time<Scheme>() ||
                  (!internal::Has_curvature_transfer<Scheme>::value &&
                   !internal::Has_curvature_transfer<Normal_scheme>::value),
                "PN_subdivision_3: a scheme that transfers curvature refines points and normals "
                "together");
  static_assert(
    std::is_null_pointer_v<internal::Outermost<internal::Is_with_border, Normal_scheme>>,
    "PN_subdivision_3: the border is that of the scheme of the points: give it to that, or to what "
    "with_normal_scheme() returns");

  /// the scheme of the normals.
  using Normals_scheme = Normal_scheme;

  /// whether the rules for borders of both schemes serve along creases.
  static constexpr bool has_crease_rules =
    internal::Has_crease_rules<Scheme>::value && internal::Has_crease_rules<Normal_scheme>::value;
  /// whether rows are averaged by `Grid_average`.
  static constexpr bool has_grid_rows = false;
  /// whether the normals have a mask of their own.
  static constexpr bool has_normal_mask = true;
  /// whether a round transfers curvature to the normals.
  static constexpr bool transfers_curvature = false;
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

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEME_PARTS_SCHEME_ADAPTORS_H
