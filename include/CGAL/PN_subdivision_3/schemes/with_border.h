// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_BORDER_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_BORDER_H

#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <type_traits>

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
struct Scheme_with_border : Scheme_adaptor<Scheme>
{
  /// what the border becomes.
  Border border;
};

/// \ingroup PkgPNSubdivision3Schemes
/// returns the scheme with this rule for the border. All but `Border::surface` need a scheme that can
/// crease.
template <class Scheme, class = typename Scheme::Host>
Scheme_with_border<Scheme> with_border(const Scheme& scheme, Border border)
{
  return {{scheme}, border};
}

namespace internal {

// The border of a scheme and of the adaptors around it.
template <class Scheme>
struct Border_of
{
  static constexpr bool is_given = !std::is_null_pointer_v<Outermost<Is_with_border, Scheme>>;

  static Border get([[maybe_unused]] const Scheme& scheme)
  {
    if constexpr (is_given)
      return outermost<Is_with_border>(scheme)->border;
    else
      return Border::surface;
  }
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_BORDER_H
