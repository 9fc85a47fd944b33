// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MAY_BE_SHARP_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MAY_BE_SHARP_H

#include <CGAL/PN_subdivision_3/internal/meshes/No_constraint_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/refuse_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_facts.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/with_border.h>
#include <CGAL/PN_subdivision_3/schemes/with_crease_tangents.h>

#include <stdexcept>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// whether a call tells of anything that may be sharp, or of normals of wedges
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
constexpr bool may_be_sharp_v =
  is_constraint_map_v<Edge_map> || is_constraint_map_v<Vertex_map> || Border_of<Scheme>::is_given ||
  has_crease_tangents_v<Scheme> || is_of_halfedges_v<Access, Normal_map>;

// whether creases are looked for; the scheme refuses what is sharp if it has no rules for it
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
constexpr bool may_have_creases_v = Has_crease_rules<Scheme>::value&&
  may_be_sharp_v<Scheme, Access, Normal_map, Edge_map, Vertex_map>;

template <class Scheme, class Access, class Normal_map>
constexpr bool check_corner_normals()
{
  constexpr bool are_taken =
    Has_crease_rules<Scheme>::value || !is_of_halfedges_v<Access, Normal_map>;
  static_assert(are_taken, "PN_subdivision_3: the scheme has no rules for creases and takes a "
                           "normal per vertex, not per half-edge");
  return are_taken;
}

// Refuses what is sharp if the scheme has no rules for it.
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
void require_crease_rules([[maybe_unused]] const Scheme& scheme,
                          [[maybe_unused]] const Access& access, const Normal_map&,
                          [[maybe_unused]] Edge_map edge_map,
                          [[maybe_unused]] Vertex_map vertex_map)
{
  if constexpr (may_be_sharp_v<Scheme, Access, Normal_map, Edge_map, Vertex_map>) {
    if (has_crease_rules(scheme)) return;
    if constexpr (is_of_halfedges_v<Access, Normal_map>)
      throw std::invalid_argument("PN_subdivision_3: " + name_in_message(scheme) +
                                  " has no rules for creases and takes a normal per vertex, not "
                                  "per half-edge");
    else
      refuse_creases(scheme, access, edge_map, vertex_map);
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MAY_BE_SHARP_H
