// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_RECOGNIZE_SURFACES_H
#define CGAL_PN_RECOGNITION_3_RECOGNIZE_SURFACES_H

#include <CGAL/PN_recognition_3/internal/recognition.h>
#include <CGAL/PN_recognition_3/surfaces/Recognized_surface.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

struct Read_part
{
  Level_connectivity level;
  recognition::Points points;
};

template <class Mesh, class Access, class NamedParameters>
Read_part read_part(const Mesh& mesh, const Access& access, const NamedParameters& np)
{
  using Parameters = Surface_parameters<Mesh, NamedParameters>;
  using FT = typename Parameters::FT;
  Read_part result{checked_level(access), {}};
  const auto map = Parameters::const_point_map(mesh, np);
  for (Level_connectivity::Index v = 0; v < result.level.number_of_vertices(); ++v) {
    result.points.push_back(to_double_3(checked_point<FT>(access, map, v)));
    check_finite<double, 3>(result.points.back(), "point", [&] { return access.vertex_name(v); });
  }
  return result;
}

// the number of each face's surface, in the order of the mesh
template <class Access, class Patch_map>
std::vector<std::size_t> checked_patches(const Access& access, Patch_map patch_map,
                                         std::size_t faces, std::size_t surfaces)
{
  std::vector<std::size_t> result;
  for (Level_connectivity::Index f = 0; f < faces; ++f) {
    const auto number = get(patch_map, access.face_at(f));
    if (static_cast<long long>(number) < 0 || std::size_t(number) >= surfaces)
      throw std::invalid_argument("PN_subdivision_3: " + access.face_name(f) +
                                  " has the number of a surface that there is not: take those of "
                                  "recognize_surfaces() for this mesh");
    result.push_back(std::size_t(number));
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

finds the planes, cylinders, cones, spheres and tori of which a polygon mesh is a tessellation.

The vertices of a tessellated part of a CAD system are on its surfaces, up to the rounding of the file. So surfaces are guessed
from two or three facets, and grow over all facets whose vertices are on them up to a tolerance; a surface is
believed in if it is over-determined by its vertices. Faces in one plane are one facet, however they are triangulated.
Prisms and pyramids of few sides are planes, unless facets that are tangent to their neighbors, or a round on the same
axis, say that they are meant to be round. All other faces are `unknown`.

The tolerance is four times the rounding of the coordinates, and \f$ 10^{-7} \f$ times the diagonal of the bounding
box. Coordinates are taken for floats or decimals of few digits if all of them are. Other coordinates have the
rounding of planes, if many faces are off the planes of their neighbors by as little as in a file of six digits that
has been moved or scaled. Vertices at the same point are different ones: join them first, for instance those of an STL
file.

Everything is computed in `double`. The result does not depend on the numbers of the elements.

\tparam FaceGraph a model of `FaceListGraph`
\tparam FacePatchMap a model of `WritablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and
  an integer as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param patch_map the map to write: of each face the number of its surface in the result. A surface of the result is
  one connected piece of it, but what has no vertices in common may be one surface only together with another.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` and `geom_traits` as in
  `subdivide()`, `parameters::min_facets()` (default 8) and `parameters::surface_tolerance()`

\return the surfaces
\throws std::invalid_argument if the mesh is not an oriented 2-manifold with border, a point is not finite or a
  parameter out of its range. Nothing has been written then.
<br><b>Cost:</b> About linear in the size of the mesh
*/
template <class FaceGraph, class FacePatchMap,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<Recognized_surface>
recognize_surfaces(const FaceGraph& mesh, FacePatchMap patch_map,
                   const NamedParameters& np = parameters::default_values())
{
  using Number = typename boost::property_traits<FacePatchMap>::value_type;
  std::vector<Recognized_surface> result;
  internal::check_are_read<NamedParameters, internal::min_facets_t,
                           internal::surface_tolerance_t>();
  const internal::Recognition_parameters<NamedParameters> options(np);
  internal::with_mesh_access(mesh, [&](const auto& access) {
    const internal::Read_part part = internal::read_part(mesh, access, np);
    auto found = internal::recognition::find_surfaces(part.level, part.points, options.tolerance,
                                                      options.min_facets);
    for (Level_connectivity::Index f = 0; f < found.surface_of_face.size(); ++f)
      put(patch_map, access.face_at(f), static_cast<Number>(found.surface_of_face[f]));
    result = std::move(found.surfaces);
  });
  return result;
}

/*!
\ingroup PkgPNSubdivision3Functions

makes of recognized surfaces what `subdivide()` takes. It marks the edges between different surfaces, and the edges at
which faces of unknown surface meet at an angle. Maps of the named parameters get the apexes of cones, which are
corners, the normals of the surfaces at all corners of faces, and the roundness of the vertices.

Corners of faces of unknown surfaces, and apexes of cones, get zero vectors, which stand for no normal. Vertices of
unknown surfaces only get the roundness 0, all others 1. With both maps, faces that are not recognized are refined by
the linear scheme.

\tparam FaceGraph a model of `FaceListGraph`
\tparam FacePatchMap a model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and
  an integer as value type
\tparam EdgeIsCreaseMap a model of `WritablePropertyMap` with `boost::graph_traits<FaceGraph>::%edge_descriptor` as key type
  and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param patch_map the surface of each face, as `recognize_surfaces()` writes it
\param surfaces the result of `recognize_surfaces()`
\param edge_map the map to write, the `edge_is_constrained_map` of `subdivide()`; edges on the border are no creases
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of `recognize_surfaces()` and
  `parameters::sharp_angle()` (default 30 degrees). Written are the `vertex_is_constrained_map` and
  `vertex_roundness_map` of `subdivide()`, and its `vertex_normal_map` of half-edges. A half-edge gets the normal of
  the corner of its face at its target, on the side of the face's own normal; without a face it gets zero

\return the number of creases
\throws std::invalid_argument as `recognize_surfaces()`, and if a face has a number that no surface has
<br><b>Cost:</b> linear in the size of the mesh
*/
template <class FaceGraph, class FacePatchMap, class EdgeIsCreaseMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t surface_creases(const FaceGraph& mesh, FacePatchMap patch_map,
                            const std::vector<Recognized_surface>& surfaces,
                            EdgeIsCreaseMap edge_map,
                            const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::min_facets_t, internal::surface_tolerance_t,
                           internal::sharp_angle_t, internal::vertex_roundness_map_t>();
  using Parameters = internal::Surface_parameters<FaceGraph, NamedParameters>;
  using Index = Level_connectivity::Index;
  const internal::Recognition_parameters<NamedParameters> options(np);
  std::size_t number = 0;
  internal::with_mesh_access(mesh, [&](const auto& access) {
    const internal::Read_part part = internal::read_part(mesh, access, np);
    const internal::recognition::Surface_tags tags(
      part.level, part.points, options.tolerance, surfaces,
      internal::checked_patches(access, patch_map, part.level.number_of_faces(), surfaces.size()),
      internal::recognition::radians(options.sharp_angle));
    for (Index e = 0; e < part.level.number_of_edges(); ++e) {
      const bool is_crease = tags.is_crease(e);
      put(edge_map, access.edge_at(e), is_crease);
      number += is_crease;
    }
    using Corner_map = typename Parameters::Vertex_constraint_map;
    if constexpr (internal::is_there_v<Corner_map>) {
      const Corner_map corners = Parameters::vertex_constraint_map(np);
      for (Index v = 0; v < part.level.number_of_vertices(); ++v)
        put(corners, access.vertex(v), tags.is_corner(v));
    }
    if constexpr (internal::is_there_v<typename Parameters::Roundness_map>) {
      const auto roundness = Parameters::roundness_map(np);
      using Number = typename boost::property_traits<decltype(roundness)>::value_type;
      for (Index v = 0; v < part.level.number_of_vertices(); ++v)
        put(roundness, access.vertex(v), Number(tags.is_unknown(v) ? 0 : 1));
    }
    using Normal_map = typename Parameters::Normal_map;
    if constexpr (internal::is_there_v<Normal_map>) {
      static_assert(internal::has_corner_normals_v<std::decay_t<decltype(access)>, Normal_map>,
                    "PN_subdivision_3: the normals of surfaces belong to the corners of faces: "
                    "the vertex_normal_map must be one of half-edges");
      using Normal = typename boost::property_traits<Normal_map>::value_type;
      const Normal_map normals = Parameters::normal_map(np);
      for (Index h = 0; h < part.level.number_of_halfedges(); ++h) {
        const auto n = tags.normal(h);
        put(normals, access.halfedge_at(h), Normal(n[0], n[1], n[2]));
      }
    }
  });
  return number;
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_RECOGNITION_3_RECOGNIZE_SURFACES_H
