// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_DETECT_CREASES_H
#define CGAL_PN_SUBDIVISION_3_DETECT_CREASES_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/normals/face_normals.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// Edges are sharp from this on above the angle that is asked for: meshes have many edges at exactly 30 or 45
// degrees, and only rounding would tell on which side they are.
constexpr double margin_of_crease_angles = 0.1;

// inner edges whose faces' area vectors are more than an angle and the margin apart
template <class FT, class Values>
std::vector<bool> edges_of_greater_angle(const Level_connectivity& level, const Values& values,
                                         double degrees)
{
  using Index = Level_connectivity::Index;
  const double greatest = (degrees + margin_of_crease_angles) * std::acos(-1.) / 180;
  const Scaled_differences<FT, Values> difference(level, values);
  std::vector<Coordinates<double, 3>> direction;
  for (Index f = 0; f < level.number_of_faces(); ++f)
    direction.push_back(area_of_face(level, difference, f).unit());
  std::vector<bool> result(level.number_of_edges(), false);
  for (Index e = 0; e < level.number_of_edges(); ++e) {
    if (level.is_border_edge(e)) continue;
    const auto &m = direction[level.face(2 * e)], &n = direction[level.face(2 * e + 1)];
    const double sine = length(cross(m, n)), cosine = dot(m, n);
    result[e] = (sine != 0 || cosine != 0) && std::atan2(sine, cosine) > greatest;
  }
  return result;
}

} // namespace internal
/*!
\ingroup PkgPNSubdivision3Functions

finds the edges of a polygon mesh at which its faces meet at an angle: those that `subdivide()` may
take as creases.

An edge with two faces becomes `true` in the map if the angle between the area vectors of the faces is more than 0.1
degrees greater than the given one. So rounding does not decide about edges at exactly this angle, which are not
creases. All others, including border edges, become `false`. In a map of numbers they become infinitely sharp (of
integers: the largest number) and 0. Edges of faces without area, or with one that rounding may have made, do not count
as sharp. Choose the angle between that of the true edges of the shape and those of its approximation: the sides of a
prism of n sides, which may stand for a cylinder, differ by 360/n degrees.

Angles are computed in `double` from area vectors of polygons; `Polygon_mesh_processing::detect_sharp_edges()` takes three corners of each, and all border edges.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam EdgeMap a model of `WritablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%edge_descriptor` as key type and `bool` or a built-in number type
  as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param degrees the angle, at least 0 and at most 180
\param edge_map the map to write; if it throws, some edges may have been written
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` and
  `geom_traits` as in `subdivide()`

\return the number of edges that are sharp
\throws std::invalid_argument if the angle is out of its range, the mesh is not an oriented
  2-manifold with border, or a point is not finite. Nothing has been written then.
<br><b>Cost:</b> Linear in the size of the mesh
*/
template <class PolygonMesh, class EdgeMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t detect_creases(const PolygonMesh& mesh, double degrees, EdgeMap edge_map,
                           const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  if constexpr (!internal::check_is_point_map<PolygonMesh, NamedParameters>() ||
                !internal::Check_map<internal::Map_of_creases>::check<
                  EdgeMap, PolygonMesh, NamedParameters, internal::Writable>())
    return 0;
  else {
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    using FT = typename Parameters::FT;
    using Index = Level_connectivity::Index;
    using Value = std::decay_t<typename boost::property_traits<EdgeMap>::value_type>;
    if (!(degrees >= 0 && degrees <= 180))
      throw std::invalid_argument(
        "PN_subdivision_3: the angle of creases must be between 0 and 180 degrees");
    return internal::with_mesh_access(mesh, [&](const auto& access) {
      const Level_connectivity level = internal::checked_level(access);
      const auto values = internal::read_given_values<Linear_average<FT, 3>>(
        access, Parameters::const_point_map(mesh, np), internal::Not_given(),
        level.number_of_vertices());
      const std::vector<bool> is_sharp =
        internal::edges_of_greater_angle<FT>(level, values, degrees);
      std::size_t number = 0;
      for (Index e = 0; e < level.number_of_edges(); ++e) {
        put(edge_map, access.edge_at(e),
            is_sharp[e] ? internal::sharp_for_ever<Value>() : Value(0));
        number += is_sharp[e];
      }
      return number;
    });
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_DETECT_CREASES_H
