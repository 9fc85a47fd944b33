// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_COMPILED_ATTRIBUTES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_COMPILED_ATTRIBUTES_H

// The rounds of attributes of double, see meshes/compiled_levels.h.

#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_rounds.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_round.h>
#include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>

#define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, SCHEME, CREASES)                        \
  EXTERN template void Attribute_rounds<double>::begin_round(                                      \
    const compiled_once::SCHEME&,                                                                  \
    const Crease_round<compiled_once::SCHEME, compiled_once::Average<compiled_once::SCHEME>,       \
                       CREASES>&,                                                                  \
    const Level_connectivity&, const CREASES&, Kind_of_round);
#define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, SCHEME)                                \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, SCHEME, No_creases)                           \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, SCHEME, Creases<double>)
#define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_OF_ALL(EXTERN)                                            \
  EXTERN template class Rows<double, Number_values<double>>;                                       \
  EXTERN template class Rows<double, Label_values<double>>;                                        \
  EXTERN template class Attribute_rounds<double>;                                                  \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, Any_of_quads)                                \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, Any_of_triangles)                            \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, Linear_of_quads)                             \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, Linear_of_triangles)                         \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, Any_of_corners, No_creases)                   \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, Any_of_sqrt3, No_creases)                     \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, Linear_of_corners, No_creases)                \
  CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, Linear_of_sqrt3, No_creases)

#ifdef CGAL_PN_SUBDIVISION_3_DOUBLE
namespace CGAL::PN_subdivision_3::internal {

CGAL_PN_SUBDIVISION_3_ATTRIBUTES_OF_ALL(extern)

} // namespace CGAL::PN_subdivision_3::internal
#endif

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_COMPILED_ATTRIBUTES_H
