// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_BORDER_RULES_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_BORDER_RULES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes
writes the row of a border vertex, the one that the border half-edge `border` leads to: `w` for its two
neighbors on the border and 1 - 2`w` for itself.
\pre `level.is_border(border)`
*/
template <class FT, class Stencil>
void add_along_border(const Level_connectivity& level, Level_connectivity::Index border,
                      const FT& w, Stencil& s)
{
  s.add(level.source(border), w);
  s.add(level.target(level.next(border)), w);
  s.add_rest(level.target(border));
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_BORDER_RULES_H
