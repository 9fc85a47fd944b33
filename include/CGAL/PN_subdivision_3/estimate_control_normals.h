// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ESTIMATE_CONTROL_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_ESTIMATE_CONTROL_NORMALS_H

#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

estimates control normals: at each vertex the unit vector of the sum of the normals of its faces,
weighted by the angles of the faces at the vertex (Yang, <em>Point-Normal Subdivision Curves and
Surfaces</em>, Section 6). The normal of a polygon that is not planar is that of its area vector;
the angle at a corner is the angle between its two edges. Faces without area add nothing, nor do
those that would have none but for the rounding of their coordinates. A vertex without faces, or one
at which the sum vanishes, gets the zero vector, "no control normal".

The factors are rounded to `double` whatever the number type; they are irrational in any case.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam VertexNormalMap a model of `WritablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and a `Vector_3` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param normals the map to write; if it throws, some normals may have been written
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`
  and `geom_traits` as in `subdivide()`

\throws std::invalid_argument if the mesh is not an oriented 2-manifold with border or a point is
  not finite; nothing has been written then
\cost linear in the size of the mesh
*/
template <class PolygonMesh, class VertexNormalMap,
          class NamedParameters = parameters::Default_named_parameters>
void estimate_control_normals(const PolygonMesh& mesh, VertexNormalMap normals,
                              const NamedParameters& np = parameters::default_values())
{
  if constexpr (internal::check_estimation_arguments<PolygonMesh, VertexNormalMap,
                                                     NamedParameters>()) {
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    using FT = typename Parameters::FT;
    using Normal = typename boost::property_traits<VertexNormalMap>::value_type;
    using Index = Level_connectivity::Index;
    const auto points = Parameters::const_point_map(mesh, np);
    internal::with_mesh_access(mesh, [&](const auto& access) {
      const Level_connectivity level = internal::checked_level(access);
      const auto values =
        internal::read_values<PN_average<FT, 3>>(access, level, points, internal::No_normal_map());
      for (Index v = 0; v < level.number_of_vertices(); ++v) {
        const Coordinates<FT, 3>& n = values[v].normal;
        put(normals, access.vertex(v), Normal(n[0], n[1], n[2]));
      }
    });
  }
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_ESTIMATE_CONTROL_NORMALS_H
