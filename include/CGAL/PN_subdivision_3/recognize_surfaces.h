// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_RECOGNIZE_SURFACES_H
#define CGAL_PN_SUBDIVISION_3_RECOGNIZE_SURFACES_H

#include <CGAL/PN_subdivision_3/Recognized_surface.h>
#include <CGAL/PN_subdivision_3/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

template <class FaceGraph, class FacePatchMap,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<Recognized_surface>
recognize_surfaces(const FaceGraph& mesh, FacePatchMap patch_map,
                   const NamedParameters& = parameters::default_values())
{
  for (const auto f : faces(mesh)) put(patch_map, f, 0);
  return std::vector<Recognized_surface>(num_faces(mesh) > 0);
}

template <class FaceGraph, class FacePatchMap, class EdgeIsCreaseMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t surface_creases(const FaceGraph& mesh, FacePatchMap,
                            const std::vector<Recognized_surface>&, EdgeIsCreaseMap edge_map,
                            const NamedParameters& = parameters::default_values())
{
  for (const auto e : edges(mesh)) put(edge_map, e, false);
  return 0;
}

template <class FaceGraph, class FacePatchMap, class HalfedgeNormalMap,
          class NamedParameters = parameters::Default_named_parameters>
void surface_corner_normals(const FaceGraph& mesh, FacePatchMap,
                            const std::vector<Recognized_surface>&, HalfedgeNormalMap normals,
                            const NamedParameters& = parameters::default_values())
{
  using Normal = typename boost::property_traits<HalfedgeNormalMap>::value_type;
  for (const auto h : halfedges(mesh)) put(normals, h, Normal(0, 0, 0));
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_RECOGNIZE_SURFACES_H
