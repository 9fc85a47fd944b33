// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SQRT_EXTENSION_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_SQRT_EXTENSION_NORMALS_H

/*!
\file CGAL/PN_subdivision_3/sqrt_extension_normals.h

Exact unit normals in `CGAL::Sqrt_extension`: numbers a + b &radic;r with rational a, b and r. They suffice for one
round from rational points and rational unit normals, those of `rational_unit_normal()`, since a new vertex needs the
root of its own |N|<sup>2</sup> only. Included before anything of the package is called with the type, it makes
`is_on()`, `mesh_deviation()` and `curve_deviation()` proofs; without it normals of this type are rounded as those of
`Gmpq` are. A second round, and normals that have roots already, are refused. The umbrella header does not include it.
*/

#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Sqrt_extension.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// whether x is a square, and its root
template <class NT>
bool has_root(const NT& x, NT& root)
{
  using Is_square = typename Algebraic_structure_traits<NT>::Is_square;
  if constexpr (std::is_same_v<Is_square, Null_functor>) { // roots of few digits at least
    root = NT(std::sqrt(close_double(x)));
    return root * root == x;
  } else
    return Is_square()(x, root);
}

} // namespace internal

// documented with the file
#ifndef DOXYGEN_RUNNING
template <class NT, class Root, class Compares_roots, class Is_filtered>
struct Unit_normal_traits<CGAL::Sqrt_extension<NT, Root, Compares_roots, Is_filtered>>
{
  using FT = CGAL::Sqrt_extension<NT, Root, Compares_roots, Is_filtered>;
  static_assert(internal::is_exact_v<NT>, "PN_subdivision_3: roots are those of exact numbers");

  static FT inverse_length(const FT& squared_length)
  {
    // what is computed of a number with a root counts as extended, even where the root has gone
    if (squared_length.is_extended())
      throw std::domain_error(
        "PN_subdivision_3: Sqrt_extension has one square root, that of a new vertex, and these "
        "normals or tangents have roots already: do a single round, from control normals that "
        "rational_unit_normal() makes");
    const NT& square = squared_length.a0();
    NT root;
    if (internal::has_root(square, root)) return FT(NT(1) / root);
    return FT(NT(0), NT(NT(1) / square), Root(square));
  }
  static FT vanishing_tolerance() { return FT(0); }
  static FT unit_tolerance() { return FT(0); }
};
#endif

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SQRT_EXTENSION_NORMALS_H
