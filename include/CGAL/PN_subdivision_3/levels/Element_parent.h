// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_LEVELS_ELEMENT_PARENT_H
#define CGAL_PN_SUBDIVISION_3_LEVELS_ELEMENT_PARENT_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes
The old element that an element of the refined level comes from. `Index` may be wider than that of a level,
to number more than one level holds.
*/
template <class Index>
struct Basic_element_parent
{
  /// A corner is given by the half-edge of its face that leads to it, a border edge by its half-edge that
  /// has a face; all other elements are given by their own index.
  enum class Kind { vertex, edge, face, corner, border_edge };

  /// the kind of the old element.
  Kind kind;
  /// its number.
  Index index;
  /// which one it is of the children of the same kind that the old element has, counted from 0.
  Index ordinal = 0;
};

/// \ingroup PkgPNSubdivision3Schemes
/// the parent of an element of a level.
using Element_parent = Basic_element_parent<Level_connectivity::Index>;

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_LEVELS_ELEMENT_PARENT_H
