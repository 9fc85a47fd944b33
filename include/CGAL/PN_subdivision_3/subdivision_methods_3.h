// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SUBDIVISION_METHODS_3_H
#define CGAL_PN_SUBDIVISION_3_SUBDIVISION_METHODS_3_H

#include <CGAL/PN_subdivision_3/schemes/Bilinear_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Grid_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Midpoint_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Transfer_schemes.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// by the scheme, or by the variant of it that the call asks for
template <class Concurrency_tag, class Scheme, class Tuned, class Transfer, class PolygonMesh,
          class NamedParameters>
void subdivide_by_variant(PolygonMesh& mesh, const NamedParameters& np)
{
  check_are_read<NamedParameters, Read_of_control_mesh, attributes_t, tuned_t,
                 curvature_transfer_t>();
  if constexpr (!are_named_parameters_v<NamedParameters>) // which it refuses
    subdivide<Concurrency_tag>(mesh, Scheme(), np);
  else if constexpr (is_given_v<curvature_transfer_t, NamedParameters> ||
                     is_given_v<tuned_t, NamedParameters>) {
    const auto shared = parameters::shared(np); // read by both
    if constexpr (is_given_v<curvature_transfer_t, NamedParameters>)
      if (parameters::get_parameter(np, curvature_transfer_t()))
        return subdivide<Concurrency_tag>(mesh, Transfer(), shared);
    if constexpr (is_given_v<tuned_t, NamedParameters>)
      if (parameters::get_parameter(np, tuned_t()))
        return subdivide<Concurrency_tag>(mesh, Tuned(), shared);
    subdivide<Concurrency_tag>(mesh, Scheme(), shared);
  } else
    subdivide<Concurrency_tag>(mesh, Scheme(), np);
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions
applies point-normal Catmull-Clark subdivision, for polygons of any degree: `subdivide(mesh, CatmullClark_scheme(), np)`,
which documents all parameters, guarantees and exceptions. With `parameters::tuned()` it is
`CatmullClark_scheme::Tuned`, with cap 1/2, and with `parameters::curvature_transfer()` it is
`CatmullClark_scheme::Transfer`; `subdivide()` takes `CatmullClark_scheme::Grid`.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void CatmullClark_subdivision(PolygonMesh& mesh,
                              const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_by_variant<Concurrency_tag, CatmullClark_scheme, CatmullClark_scheme::Tuned,
                                 CatmullClark_scheme::Transfer>(mesh, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
applies point-normal Loop subdivision, for triangles: `subdivide(mesh, Loop_scheme(), np)`. With `parameters::tuned()`
it is `Loop_scheme::Tuned`, with cap 1/2, and with `parameters::curvature_transfer()` it is `Loop_scheme::Transfer`.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void Loop_subdivision(PolygonMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_by_variant<Concurrency_tag, Loop_scheme, Loop_scheme::Tuned,
                                 Loop_scheme::Transfer>(mesh, np);
}

/*!
\ingroup PkgPNSubdivision3Functions
applies point-normal Doo-Sabin subdivision, for polygons of any degree: `subdivide(mesh, DooSabin_scheme(), np)`.

Every vertex is new. The order is that of `DQQ_host`; the vertices take the descriptors of old ones
as far as there are any, and what other vertex property maps hold for these is not touched. The
resulting mesh is compact: a `Surface_mesh` holds no removed elements. If it held some before the call,
`collect_garbage()` is called at the end, which changes the order of the elements. If a map is given that is not a
property map of the mesh, and would not follow, removed elements remain instead.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void DooSabin_subdivision(PolygonMesh& mesh,
                          const NamedParameters& np = parameters::default_values())
{
  subdivide<Concurrency_tag>(mesh, DooSabin_scheme(), np);
}

/*!
\ingroup PkgPNSubdivision3Functions
applies point-normal \f$ \sqrt{3} \f$ subdivision, for triangles: `subdivide(mesh, Sqrt3_scheme(), np)`.

\attention The border is refined in the even rounds of one call only, as in
`CGAL::Subdivision_method_3::Sqrt3_subdivision()`: k calls with one round each never refine it.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void Sqrt3_subdivision(PolygonMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  subdivide<Concurrency_tag>(mesh, Sqrt3_scheme(), np);
}

/*!
\ingroup PkgPNSubdivision3Functions
applies point-normal modified Butterfly subdivision, for triangles: `subdivide(mesh, Butterfly_scheme(), np)`. Old
vertices keep their points and normals bit for bit.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void Butterfly_subdivision(PolygonMesh& mesh,
                           const NamedParameters& np = parameters::default_values())
{
  subdivide<Concurrency_tag>(mesh, Butterfly_scheme(), np);
}

/*!
\ingroup PkgPNSubdivision3Functions
applies the point-normal form of Kobbelt's interpolatory scheme, for quadrilaterals, with tension 1/16:
`subdivide(mesh, Kobbelt_scheme(), np)`, which takes other tensions, too. Old vertices keep their points and normals
bit for bit.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void Kobbelt_subdivision(PolygonMesh& mesh,
                         const NamedParameters& np = parameters::default_values())
{
  subdivide<Concurrency_tag>(mesh, Kobbelt_scheme(), np);
}

/*!
\ingroup PkgPNSubdivision3Functions
splits triangles into four, with new vertices in the middle of edges: of the arcs that the normals tell of, or, with
roundness 0, of the straight ones. It is `subdivide(mesh, Midpoint_scheme(), np)`. Old vertices keep their points and
normals bit for bit.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void Midpoint_subdivision(PolygonMesh& mesh,
                          const NamedParameters& np = parameters::default_values())
{
  subdivide<Concurrency_tag>(mesh, Midpoint_scheme(), np);
}

/*!
\ingroup PkgPNSubdivision3Functions
splits polygons into quadrilaterals, with new vertices in the middle of edges, as `Midpoint_subdivision()`, and of
faces. It is `subdivide(mesh, Bilinear_scheme(), np)`.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void Bilinear_subdivision(PolygonMesh& mesh,
                          const NamedParameters& np = parameters::default_values())
{
  subdivide<Concurrency_tag>(mesh, Bilinear_scheme(), np);
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SUBDIVISION_METHODS_3_H
