// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_FALLBACK_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_FALLBACK_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Linear_guard.h>
#include <CGAL/PN_subdivision_3/internal/recognition/recognize_part.h>
#include <CGAL/PN_subdivision_3/parameters.h>
#include <CGAL/PN_subdivision_3/recognize_surfaces.h>

#include <boost/property_map/property_map.hpp>

#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Gives up surfaces (their kind becomes unknown, the numbers of the faces stay) and normals, where refinement by Loop's scheme
// or, unless all faces are triangles, that of Catmull and Clark is worse than its linear twin; the linear one is that with sharp
// edges of more than 30 degrees. Writes the creases and the normals of all corners, those that are estimated among them: zero is
// a wedge without a normal. np: as surface_creases(), and parameters::vertex_roundness_map(), which is written as
// estimate_control_normals() does. At most ten refinements of two rounds.
template <class FaceGraph, class FacePatchMap, class EdgeIsCreaseMap, class HalfedgeNormalMap,
          class NamedParameters = parameters::Default_named_parameters>
Surface_fallback never_worse_than_linear(const FaceGraph& mesh, FacePatchMap patch_map,
                                         std::vector<Recognized_surface>& surfaces,
                                         EdgeIsCreaseMap edge_map, HalfedgeNormalMap normals,
                                         const NamedParameters& np = parameters::default_values())
{
  using Parameters = Surface_parameters<FaceGraph, NamedParameters>;
  using Normal = typename boost::property_traits<HalfedgeNormalMap>::value_type;
  using Index = Level_connectivity::Index;
  const Recognition_parameters<NamedParameters> options(np);
  Surface_fallback result;
  with_mesh_access(mesh, [&](const auto& access) {
    const Read_part read = read_part(mesh, access, np, options.tolerance);
    const auto patches =
      checked_patches(access, patch_map, read.level.number_of_faces(), surfaces.size());
    std::vector<Recognized_surface> kept = surfaces;
    recognition::Linear_guard guard(read.level, read.part, kept, patches,
                                    recognition::radians(options.sharp_angle));
    result = guard();
    for (Index e = 0; e < read.level.number_of_edges(); ++e)
      put(edge_map, access.edge_at(e), bool(guard.creases()[e]));
    for (Index h = 0; h < read.level.number_of_halfedges(); ++h) {
      const recognition::Vec3& n = guard.normals()[h];
      put(normals, access.halfedge_at(h), Normal(n.x, n.y, n.z));
    }
    if constexpr (is_given_roundness_v<typename Parameters::Roundness_map>) {
      using Number =
        typename boost::property_traits<typename Parameters::Roundness_map>::value_type;
      const auto roundness = Parameters::roundness_map(np);
      for (Index v = 0; v < read.level.number_of_vertices(); ++v)
        put(roundness, access.vertex(v), roundness_as<Number>(guard.roundness(v)));
    }
    surfaces = std::move(kept);
  });
  return result;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_FALLBACK_H
