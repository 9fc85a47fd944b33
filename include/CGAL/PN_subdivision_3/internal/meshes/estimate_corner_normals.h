// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_ESTIMATE_CORNER_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_ESTIMATE_CORNER_NORMALS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/creases/Control_creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class Map, class Key, class FT>
void put_roundness(const Map& map, const Key& key, const FT& w)
{
  if constexpr (!std::is_same_v<Map, No_roundness>)
    put(map, key, roundness_as<std::decay_t<typename boost::property_traits<Map>::value_type>>(w));
}

// estimate_control_normals() of a map of half-edges; that of the roundness is of vertices or, as an estimate has it, of half-edges
template <class Access, class PolygonMesh, class HalfedgeNormalMap, class Roundness_map,
          class NamedParameters>
void estimate_corner_normals(const Access& access, const PolygonMesh& mesh,
                             const HalfedgeNormalMap& normals, const Roundness_map& roundness,
                             const NamedParameters& np)
{
  using Halfedge = typename boost::graph_traits<PolygonMesh>::halfedge_descriptor;
  constexpr bool is_of_corners = std::is_same_v<Key_of_map<Roundness_map>, Halfedge>;
  using Parameters = Surface_parameters<PolygonMesh, NamedParameters>;
  using FT = typename Parameters::FT;
  using Index = Level_connectivity::Index;
  using Normal = typename boost::property_traits<HalfedgeNormalMap>::value_type;
  const auto points = Parameters::const_point_map(mesh, np);
  const Control_normal_estimate estimate =
    parameter_or<control_normal_estimate_t>(np, Control_normal_estimate::coherent);
  const Level_connectivity level = checked_level(access);
  const Index n = level.number_of_vertices();
  const Edge_constraints<Access, typename Parameters::Edge_constraint_map> edges(
    access, Parameters::edge_constraint_map(np), level.number_of_edges());
  const Vertex_constraints<Access, typename Parameters::Vertex_constraint_map> vertices(
    access, Parameters::vertex_constraint_map(np), n);
  Creases<FT> creases = Make_creases<FT>(level, parameter_or<border_t>(np, Border::surface))(
    [&](Index e) { return edges.sharpness(e); }, [&](Index v) { return vertices.sharpness(v); });
  using Value = Point_normal<FT, 3>;
  std::vector<Value> values(creases.number_of_slots);
  const std::vector<Index> extra = vertices_of_extra_slots(creases, n);
  for (Index slot = 0; slot < values.size(); ++slot)
    point_of(values[slot]) = checked_point<FT>(access, points, slot < n ? slot : extra[slot - n]);
  make_control_creases<FT>(level, creases, values, std::vector<bool>(values.size(), false),
                           estimate);
  const Cut_level<FT> cut(level, creases);
  for_each_corner(level, cut.connectivity(), [&](Index h, Index slot) {
    const Coordinates<FT, 3>& m = values[slot].normal;
    put(normals, access.halfedge_at(h), Normal(m[0], m[1], m[2]));
    if constexpr (is_of_corners)
      put_roundness(roundness, access.halfedge_at(h), values[slot].roundness);
  });
  if constexpr (!is_of_corners) {
    for (Index slot = n; slot < values.size(); ++slot) {
      FT& of_vertex = values[extra[slot - n]].roundness; // no wedge is rounder than it is
      of_vertex = (CGAL::min)(of_vertex, values[slot].roundness);
    }
    for (Index v = 0; v < n; ++v) put_roundness(roundness, access.vertex(v), values[v].roundness);
  }
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_ESTIMATE_CORNER_NORMALS_H
