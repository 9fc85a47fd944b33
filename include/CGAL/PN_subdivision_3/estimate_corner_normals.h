// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ESTIMATE_CORNER_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_ESTIMATE_CORNER_NORMALS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_subdivision_3/internal/average/kernel_checks.h>
#include <CGAL/PN_subdivision_3/internal/creases/Control_creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

estimates a control normal for every corner of a polygon mesh with creases: those that `subdivide()`
takes for the wedges of vertices between sharp edges where none are given.

The normals of a wedge are estimated from its faces alone, then made orthogonal to the tangents of the
creases beside it, which come from the points along the creases. Corners of one wedge get the same
normal. With all edges of a straight prism sharp but those along its sides, the normals are those of
the cylinder through its points, and of its flat ends.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam EdgeMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%edge_descriptor` as key type and `bool` or a number as value type,
  as in `subdivide()`
\tparam HalfedgeNormalMap a model of `WritablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%halfedge_descriptor` as key type and a `Vector_3` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param edge_map the sharp edges
\param normals the map to write, for all half-edges that have a face: the normal of the corner of that
  face at the target. If it throws, some normals may have been written.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`,
  `vertex_is_constrained_map` and `geom_traits` as in `subdivide()`, and `vertex_roundness_map` and `control_normal_estimate` as in
  `estimate_control_normals()`; vertices on creases and corners are round

\throws std::invalid_argument if the mesh is not an oriented 2-manifold with border, a point is not
  finite, or a sharpness is negative or not a number; nothing has been written then
<br><b>Cost:</b> linear in the size of the mesh
*/
template <class PolygonMesh, class EdgeMap, class HalfedgeNormalMap,
          class NamedParameters = parameters::Default_named_parameters>
void estimate_corner_normals(const PolygonMesh& mesh, EdgeMap edge_map, HalfedgeNormalMap normals,
                             const NamedParameters& np = parameters::default_values())
{
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  if constexpr (internal::check_kernel<typename Parameters::Geom_traits>()) {
    using FT = typename Parameters::FT;
    using Index = Level_connectivity::Index;
    using Vertex_map = typename Parameters::Vertex_constraint_map;
    using Normal = typename boost::property_traits<HalfedgeNormalMap>::value_type;
    const auto points = Parameters::const_point_map(mesh, np);
    const Control_normal_estimate estimate =
      internal::parameter_or<internal::control_normal_estimate_t>(
        np, Control_normal_estimate::coherent);
    const Vertex_map vertex_map = Parameters::vertex_constraint_map(np);
    internal::with_mesh_access(mesh, [&](const auto& access) {
      using Access = std::decay_t<decltype(access)>;
      const Level_connectivity level = internal::checked_level(access);
      const Index n = level.number_of_vertices();
      internal::Creases<FT> creases = internal::Make_creases<FT>(level, Border::surface)(
        [&](Index e) {
          return internal::checked_sharpness(
            internal::sharpness_in(edge_map, access.edge_at(e)),
            [&] { return internal::Edge_of_mesh::name(access, e); });
        },
        [&](Index v) {
          if constexpr (internal::is_constraint_map_v<Vertex_map>)
            return internal::checked_sharpness(internal::sharpness_in(vertex_map, access.vertex(v)),
                                               [&] { return access.vertex_name(v); });
          else
            return 0.;
        });
      using Value = Point_normal_roundness<FT, 3>;
      std::vector<Value> values(creases.number_of_slots);
      const std::vector<Index> extra = internal::vertices_of_extra_slots(creases, n);
      for (Index slot = 0; slot < values.size(); ++slot)
        internal::point_of(values[slot]) =
          internal::checked_point<FT>(access, points, slot < n ? slot : extra[slot - n]);
      internal::Control_creases<FT, Value>(level, creases, values,
                                           std::vector<bool>(values.size(), false), estimate)();
      const internal::Cut_level<FT> cut(level, creases);
      static_assert(internal::is_of_halfedges_v<Access, HalfedgeNormalMap>,
                    "PN_subdivision_3: the normal map is no property map of the mesh's half-edges");
      internal::for_each_corner(level, cut.connectivity(), [&](Index h, Index slot) {
        const Coordinates<FT, 3>& m = values[slot].normal;
        put(normals, access.halfedge_at(h), Normal(m[0], m[1], m[2]));
      });
      if constexpr (!std::is_same_v<typename Parameters::Roundness_map, internal::No_roundness>) {
        using Number =
          typename boost::property_traits<typename Parameters::Roundness_map>::value_type;
        const auto roundness = Parameters::roundness_map(np);
        for (Index v = 0; v < n; ++v)
          put(roundness, access.vertex(v), internal::roundness_as<Number>(values[v].roundness));
      }
    });
  }
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_ESTIMATE_CORNER_NORMALS_H
