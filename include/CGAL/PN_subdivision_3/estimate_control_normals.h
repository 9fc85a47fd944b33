// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ESTIMATE_CONTROL_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_ESTIMATE_CONTROL_NORMALS_H

#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>
#include <CGAL/PN_subdivision_3/schemes/normal_estimate.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

estimates control normals from the points of a mesh. Those of `Control_normal_estimate::reciprocal`
are exact, up to rounding, for points on a sphere in any arrangement, and for points on a cylinder, a
cone or a torus at the crossings of parallels and straight or circular meridians, as quads or
triangulated; the others are those of Yang, <em>Point-Normal Subdivision Curves and Surfaces</em>,
Section 6. \ref PN_subdivision_3_control_normals "The manual" compares them.

<b>Reciprocal.</b> At an interior vertex, with its edges \f$ e_i \f$ in order and \f$ W_i =
e_i/|e_i|^2 \f$, the unit vector of \f$ \sum_i W_i \times W_{i+1} \f$ (N. Max, <em>Weights for
computing vertex normals from facet normals</em>, 1999). At a border vertex the unit vector
orthogonal to the circle through the vertex and its two neighbors on the border that best fulfils
\f$ (n + n_j) \cdot e_j = 0 \f$, the condition that an arc joins the two points, for the neighbors
whose normals are known: the interior ones, or else those on the border that have interior ones
themselves. Where this does not determine a normal (no such neighbor; a border that folds back; a
result turned by more than 73 degrees from it) it is the unit vector of \f$ \sum_i W_i \times W_{i+1}
\f$ over the faces of the vertex.

These fit a curved surface, and a box only with a ball around it. Hence let \f$ \alpha \f$ be the
largest angle between the normal and the cross product of two neighboring edges, zero ones left out;
if this is below 60 degrees, the area vector of the face between the edges counts if it is closer.
Up to 40 degrees the normal is as above; from 60 degrees on, and where the sum vanishes (is shorter
than 2<sup>12</sup> times the machine epsilon times the sum of the lengths of its terms), it is the
angle-weighted one; in between both are mixed, smoothly in \f$ \cos\alpha \f$. Edges of length zero are
left out.

<b>Angle.</b> The unit vector of the sum of the normals of the faces, weighted by the angles of the
faces at the vertex. The normal of a polygon that is not planar is that of its area vector; the angle
at a corner is the angle between its two edges. Faces without area add nothing, nor do those that
would have none but for the rounding of their coordinates.

A vertex without faces, or one at which the sum vanishes, gets the zero vector, "no control normal".

<b>Number types.</b> In exact number types the reciprocal normals of interior vertices where \f$ \alpha
\f$ is at most 40 degrees have their exact direction; in multiprecision types they are as precise as
the type, as are angle-weighted ones where the type has its own `atan2()` (`Gmpfr`, Boost's floats). Everything else (the choice
between the two, its weights, borders, angles) is computed in `double` from the differences of the points; `float` is widened to `double`.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam VertexNormalMap a model of `WritablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and a `Vector_3` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param normals the map to write; if it throws, some normals may have been written
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`
  and `geom_traits` as in `subdivide()`
\param estimate which estimate

\throws std::invalid_argument if the mesh is not an oriented 2-manifold with border or a point is
  not finite; nothing has been written then
<br><b>Cost:</b> linear in the size of the mesh
*/
template <class PolygonMesh, class VertexNormalMap,
          class NamedParameters = parameters::Default_named_parameters>
void estimate_control_normals(const PolygonMesh& mesh, VertexNormalMap normals,
                              const NamedParameters& np = parameters::default_values(),
                              Control_normal_estimate estimate = Control_normal_estimate::coherent)
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
      const auto values = internal::read_values<PN_average<FT, 3>>(
        access, level, points, internal::No_normal_map(), estimate);
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
