// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_REFUSE_CREASES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_REFUSE_CREASES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_facts.h>
#include <CGAL/PN_subdivision_3/schemes/with_border.h>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class Scheme, class Access, class Edge_map, class Vertex_map, class Refuse>
void refuse_sharp_elements(const Scheme& scheme, const Access& access,
                           const Level_connectivity& level, Edge_map edge_map,
                           Vertex_map vertex_map, const Refuse& refuse)
{
  using Index = Level_connectivity::Index;
  const Edge_constraints<Access, Edge_map> edges(access, edge_map, level.number_of_edges());
  const Vertex_constraints<Access, Vertex_map> vertices(access, vertex_map,
                                                        level.number_of_vertices());
  const bool has_sharp_border = Border_of<Scheme>::get(scheme) != Border::surface;
  for (Index e = 0; e < level.number_of_edges(); ++e)
    if (edges.sharpness(e) > 0 || (has_sharp_border && level.is_border_edge(e)))
      refuse(Edge_of_mesh::name(access, e));
  for (Index v = 0; v < level.number_of_vertices(); ++v)
    if (vertices.sharpness(v) > 0) refuse(access.vertex_name(v));
}

// for a scheme that has no rules for it
template <class Scheme, class Access, class Edge_map, class Vertex_map>
void refuse_creases(const Scheme& scheme, const Access& access, Edge_map edge_map,
                    Vertex_map vertex_map)
{
  refuse_sharp_elements(
    scheme, access, checked_level(access), edge_map, vertex_map, [&](const std::string& element) {
      throw std::invalid_argument("PN_subdivision_3: " + element + " is sharp, but " +
                                  name_in_message(scheme) +
                                  " has no rules for creases: take Catmull-Clark or Loop, or their "
                                  "modified forms");
    });
}

// for what knows surfaces without creases only
template <class Scheme, class Access>
void refuse_crease_borders(const Scheme& scheme, const Access& access,
                           const Level_connectivity& level, const std::string& what)
{
  refuse_sharp_elements(scheme, access, level, No_constraint_map(), No_constraint_map(),
                        [&](const std::string& element) {
                          throw std::invalid_argument("PN_subdivision_3: with_border() makes " +
                                                      element + " a crease, for which " + what +
                                                      ": take the scheme without it");
                        });
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_REFUSE_CREASES_H
