// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_CREASE_TANGENTS_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_CREASE_TANGENTS_H

#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes
A scheme with the tangents of creases, made by `with_crease_tangents()`.
*/
template <class Scheme, class HalfedgeVectorMap>
struct Scheme_with_crease_tangents : Scheme_adaptor<Scheme>
{
  /// the map of the tangents.
  HalfedgeVectorMap tangents;
};

/*!
\ingroup PkgPNSubdivision3Schemes
returns the scheme with a map of the tangents of creases. For both half-edges of a sharp edge, also for
the one on the border, the map holds the unit tangent of the crease at the source of the half-edge, in
the direction of the half-edge; elsewhere it holds zero.

`subdivide()` reads what is not zero and makes the tangents that are missing from the points and the
given normals. Afterwards the map, if it can be written, holds the tangents of the refined creases. A
call with k rounds is then the same, bit for bit, as k calls with one round if they are given the normals
by half-edges, too.

At a vertex on a crease (two sharp edges, no corner) both tangents have opposite directions: one that
is missing is the opposite of the other one, and if two are given that are not opposite, the crease takes
the direction of their difference. Tangents are taken as they are, whatever the normals beside them: a
tangent that is not orthogonal to these tilts them. Vectors shorter than 1 are allowed and are not
normalized, since `subdivide()` leaves such ones where the control data hardly define a tangent; where
they do not define any, or one shorter than 10<sup>-6</sup>, it leaves zero, and the next call makes it anew. With `Border::fixed` the
tangents of the border are zero. A linear scheme neither reads nor writes tangents.

The mesh is a parameter of `subdivide()`: that function refuses, with `std::invalid_argument`,
tangents that are not finite, longer than 1 by more than rounding, or shorter than 10<sup>-6</sup> but not zero:
the values of a map that has not been set are of this kind.

\tparam Scheme a scheme with rules for creases
\tparam HalfedgeVectorMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%halfedge_descriptor` as key type and `geom_traits::Vector_3` as value
  type; if it is a `ReadWritePropertyMap` the refined tangents are put
*/
template <class Scheme, class HalfedgeVectorMap, class = typename Scheme::Host>
Scheme_with_crease_tangents<Scheme, HalfedgeVectorMap>
with_crease_tangents(const Scheme& scheme, HalfedgeVectorMap tangents)
{
  return {{scheme}, tangents};
}

namespace internal {

// in the place of a map of tangents
struct No_tangent_map
{};

template <class Scheme>
struct Is_with_crease_tangents : std::false_type
{};
template <class Scheme, class Map>
struct Is_with_crease_tangents<Scheme_with_crease_tangents<Scheme, Map>> : std::true_type
{};

// the map of a scheme and of the adaptors around it
template <class Scheme>
auto crease_tangents([[maybe_unused]] const Scheme& scheme)
{
  if constexpr (std::is_null_pointer_v<Outermost<Is_with_crease_tangents, Scheme>>)
    return No_tangent_map();
  else
    return outermost<Is_with_crease_tangents>(scheme)->tangents;
}
template <class Scheme>
using Crease_tangent_map = decltype(crease_tangents(std::declval<const Scheme&>()));

template <class Scheme>
constexpr bool has_crease_tangents_v = !std::is_same_v<Crease_tangent_map<Scheme>, No_tangent_map>;

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_WITH_CREASE_TANGENTS_H
