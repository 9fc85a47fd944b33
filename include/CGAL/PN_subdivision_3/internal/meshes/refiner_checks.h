// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_REFINER_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_REFINER_CHECKS_H

#include <CGAL/PN_subdivision_3/internal/meshes/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// the scheme and what is read of the mesh
template <class Mesh, class Scheme, class NamedParameters>
constexpr bool check_control_arguments()
{
  if constexpr (!check_is_point_map<Mesh, NamedParameters>())
    return false;
  else {
    using Parameters = Surface_parameters<Mesh, NamedParameters>;
    constexpr bool is_scheme = Is_scheme<Scheme, typename Parameters::FT>::value;
    static_assert(is_scheme, "PN_subdivision_3: the scheme is no model of PNSubdivisionScheme_3");
    return is_scheme &&
           check_point_map<typename Parameters::Point_map, boost::readable_property_map_tag,
                           typename Parameters::FT>() &&
           check_normal_map<Mesh, typename Parameters::Normal_map, typename Parameters::Point_map,
                            typename Parameters::Geom_traits, boost::readable_property_map_tag,
                            true>() &&
           check_constraint_map<typename boost::graph_traits<Mesh>::edge_descriptor,
                                typename Parameters::Edge_constraint_map>() &&
           check_constraint_map<typename boost::graph_traits<Mesh>::vertex_descriptor,
                                typename Parameters::Vertex_constraint_map>() &&
           check_roundness<Mesh, Parameters>();
  }
}

template <class Mesh, class Scheme, class NamedParameters>
constexpr bool check_refiner_arguments()
{
  constexpr bool has_tangents = has_crease_tangents_v<Scheme>;
  static_assert(!has_tangents, "PN_subdivision_3: Surface_refiner makes the tangents of creases "
                               "from the control points: it takes no crease_tangent_map");
  if constexpr (has_tangents)
    return false;
  else
    return check_control_arguments<Mesh, Scheme, NamedParameters>();
}

template <class Mesh, class Scheme, class NamedParameters>
constexpr bool check_pieces_arguments()
{
  if constexpr (check_control_arguments<Mesh, Scheme, NamedParameters>()) {
    using Parameters = Surface_parameters<Mesh, NamedParameters>;
    return check_crease_tangents<Mesh, Scheme, typename Parameters::Point_map,
                                 typename Parameters::Geom_traits>();
  } else
    return false;
}

template <class Mesh, class NamedParameters, bool takes_corners = false>
constexpr bool check_build_arguments()
{
  if constexpr (check_mutable_mesh<Mesh>()) {
    if constexpr (check_is_point_map<Mesh, NamedParameters>()) {
      using Parameters = Surface_parameters<Mesh, NamedParameters>;
      return check_point_map<typename Parameters::Point_map, boost::writable_property_map_tag,
                             typename Parameters::FT>() &&
             check_normal_map<Mesh, typename Parameters::Normal_map, typename Parameters::Point_map,
                              typename Parameters::Geom_traits, boost::writable_property_map_tag,
                              takes_corners>();
    }
  }
  return false;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_REFINER_CHECKS_H
