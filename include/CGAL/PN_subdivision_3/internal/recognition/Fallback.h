// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_FALLBACK_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_FALLBACK_H

#include <CGAL/PN_subdivision_3/recognize_surfaces.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

struct Surface_fallback
{
  std::size_t segments_given_up = 0, wedges_set_back = 0;
  std::vector<std::size_t> high_faces; // positions in faces(mesh)
};

template <class FaceGraph, class FacePatchMap, class EdgeIsCreaseMap, class HalfedgeNormalMap,
          class NamedParameters = parameters::Default_named_parameters>
Surface_fallback never_worse_than_linear(const FaceGraph& mesh, FacePatchMap patch_map,
                                         std::vector<Recognized_surface>& surfaces,
                                         EdgeIsCreaseMap edge_map, HalfedgeNormalMap normals,
                                         const NamedParameters& np = parameters::default_values())
{
  surface_creases(mesh, patch_map, surfaces, edge_map, np);
  surface_corner_normals(mesh, patch_map, surfaces, normals, np);
  return {};
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_FALLBACK_H
