// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_BORDER_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_BORDER_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

namespace CGAL {
namespace PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Schemes
/// what becomes of the border of a surface.
enum class Border {
  /// the border belongs to the surface: its points stay on a sphere or cylinder on which the data
  /// lie. A circular border does not stay a circle.
  surface,
  /// the border is a crease with the surface on one side: circles stay circles.
  curve,
  /// as `curve`, and border vertices with a single face are corners.
  corners,
  /// all border vertices stay where they are, and border edges are split in their midpoints.
  fixed
};

/*!
\ingroup PkgPNSubdivision3Schemes
A scheme with another rule for the border, made by `with_border()`.
*/
template <class Scheme>
struct Scheme_with_border
{
  using Host = typename Scheme::Host;

  static constexpr bool has_crease_rules = internal::Has_crease_rules<Scheme>::value;

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

  template <class Element_names>
  void check(const Level_connectivity& level, const Element_names& names) const
  {
    internal::check_scheme(scheme, level, names);
  }

  Scheme scheme;
  Border border;
};

/// \ingroup PkgPNSubdivision3Schemes
/// returns the scheme with this rule for the border. All but `Border::surface` need a scheme that can
/// crease.
template <class Scheme, class = typename Scheme::Host>
Scheme_with_border<Scheme> with_border(const Scheme& scheme, Border border)
{
  return {scheme, border};
}

namespace internal {

template <class Scheme>
struct Is_linear<Scheme_with_border<Scheme>> : Is_linear<Scheme>
{};
template <class Scheme>
struct Has_normal_mask<Scheme_with_border<Scheme>> : Has_normal_mask<Scheme>
{};

// The border of a scheme, which other adaptors may be around; the outermost one counts.
template <class Scheme>
struct Border_of
{
  static constexpr bool is_given = false;
  static Border get(const Scheme&) { return Border::surface; }
};
template <class Scheme>
struct Border_of<Scheme_with_border<Scheme>>
{
  static constexpr bool is_given = true;
  static Border get(const Scheme_with_border<Scheme>& s) { return s.border; }
};
template <class Scheme>
struct Border_of<Linear_scheme<Scheme>>
{
  static constexpr bool is_given = Border_of<Scheme>::is_given;
  static Border get(const Linear_scheme<Scheme>& s) { return Border_of<Scheme>::get(s.scheme); }
};
template <class Scheme, class Normal_scheme>
struct Border_of<Scheme_with_normals<Scheme, Normal_scheme>>
{
  static constexpr bool is_given = Border_of<Scheme>::is_given;
  static Border get(const Scheme_with_normals<Scheme, Normal_scheme>& s)
  {
    return Border_of<Scheme>::get(s.scheme);
  }
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_BORDER_H
