// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SUBDIVISION_METHODS_3_H
#define CGAL_PN_SUBDIVISION_3_SUBDIVISION_METHODS_3_H

#include <CGAL/PN_subdivision_3/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

applies point-normal Catmull-Clark subdivision, for polygons of any degree. The same as
`subdivide(mesh, CatmullClark_scheme(), np)`, which documents all parameters, guarantees and
exceptions. The order of the new vertices is that of `PQQ_host`.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void CatmullClark_subdivision(PolygonMesh& mesh,
                              const NamedParameters& np = parameters::default_values())
{
  subdivide<Concurrency_tag>(mesh, CatmullClark_scheme(), np);
}

/*!
\ingroup PkgPNSubdivision3Functions

applies point-normal Loop subdivision, for triangles. The same as `subdivide(mesh, Loop_scheme(),
np)`, which documents all parameters, guarantees and exceptions. The order of the new vertices is
that of `PTQ_host`.

\throws std::invalid_argument also if a face is not a triangle
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh,
          class NamedParameters = parameters::Default_named_parameters>
void Loop_subdivision(PolygonMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  subdivide<Concurrency_tag>(mesh, Loop_scheme(), np);
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SUBDIVISION_METHODS_3_H
