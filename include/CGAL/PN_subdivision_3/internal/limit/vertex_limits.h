// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_VERTEX_LIMITS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_VERTEX_LIMITS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_writer.h>
#include <CGAL/PN_subdivision_3/internal/limit/creased_vertex_limits.h>
#include <CGAL/PN_subdivision_3/internal/limit/limit_results.h>
#include <CGAL/PN_subdivision_3/internal/limit/read_limit_level.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Creased_control.h>
#include <CGAL/PN_subdivision_3/internal/meshes/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/refuse_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>
#include <CGAL/PN_subdivision_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/limit/Limit_report.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Calls sink(results) with the limits of a mesh at its vertices.
template <class FT, class Access, class Scheme, class Point_map, class Normal_map, class Sink>
Limit_report vertex_limits(const Access& access, const Scheme& scheme, Point_map points,
                           Normal_map normals, const Limit_options& options,
                           const For_chunks& for_chunks, const Sink& sink)
{
  const auto level = read_limit_level<Scheme, FT>(access, scheme, points, normals);
  const Limit_demand demand = limit_demand<FT>(options, box_size(level));
  Limit_evaluation<Scheme, FT> evaluation(scheme, demand, for_chunks);
  const auto results = evaluation(level, options.rounds_done + 1);
  const auto name = [&](std::size_t v) {
    return access.vertex_name(static_cast<Level_connectivity::Index>(v));
  };
  check_limits<FT>(results, name);
  sink(results);
  return limit_report(results, demand);
}

// whether creases are looked for
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
constexpr bool has_creased_limits_v = Has_crease_rules<Scheme>::value&&
  may_be_creased_v<Scheme, Access, Normal_map, Edge_map, Vertex_map>;

// Refuses what is sharp if the scheme has no rules for it.
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
void require_crease_rules([[maybe_unused]] const Scheme& scheme,
                          [[maybe_unused]] const Access& access, const Normal_map&,
                          [[maybe_unused]] Edge_map edge_map,
                          [[maybe_unused]] Vertex_map vertex_map)
{
  static_assert(Has_crease_rules<Scheme>::value || !is_of_halfedges_v<Access, Normal_map>,
                "PN_subdivision_3: the scheme has no rules for creases and takes a normal per "
                "vertex, not per half-edge");
  if constexpr (!Has_crease_rules<Scheme>::value &&
                may_be_creased_v<Scheme, Access, Normal_map, Edge_map, Vertex_map>)
    refuse_creases(scheme, access, edge_map, vertex_map);
}

// The same of a mesh that may have creases. Calls sink(limits, tangents): the limits of the slots, and the
// tangents of the map.
template <class FT, class Access, class Scheme, class Point_map, class Normal_map, class Edge_map,
          class Vertex_map, class Sink>
Limit_report creased_vertex_limits(const Access& access, const Scheme& scheme, Point_map points,
                                   Normal_map normals, Edge_map edge_map, Vertex_map vertex_map,
                                   const Limit_options& options, const For_chunks& for_chunks,
                                   const Sink& sink)
{
  using Control = Creased_control<Scheme, FT>;
  Level_connectivity level = checked_level(access);
  check_scheme(scheme, level, access);
  const Edge_constraints<Access, Edge_map> edges(access, edge_map, level.number_of_edges());
  const Vertex_constraints<Access, Vertex_map> vertices(access, vertex_map,
                                                        level.number_of_vertices());
  typename Control::template Tangents<Access> tangents(access, level, Control::tangent_map(scheme));
  Creased_vertex_limits<Scheme, FT> limits(
    access, std::move(level), tangents, scheme, points, normals, edges, vertices,
    options.rounds_done, [&](double box) { return limit_demand<FT>(options, box); }, for_chunks);
  check_limits<FT>(limits.results, [&](std::size_t v) {
    return access.vertex_name(static_cast<Level_connectivity::Index>(v));
  });
  const Level_connectivity::Index n = limits.level.number_of_vertices();
  sink(limits, tangents);
  limits.results.resize(n);
  return limit_report(limits.results, limits.demand);
}

// Puts limits into the maps of a mesh with creases, and the old values back if that fails.
template <class Scheme, class FT, class Access, class Tangents, class Point_map, class Normal_map>
void put_creased_limits(const Access& access, Creased_vertex_limits<Scheme, FT>& limits,
                        Tangents& tangents, Point_map points, Normal_map normals,
                        bool surface_normals)
{
  constexpr bool has_corner_normals = is_of_halfedges_v<Access, Normal_map>;
  using Control = Creased_control<Scheme, FT>;
  typename Control::template Corner_writer<Access, Normal_map> corners(access, limits.level,
                                                                       normals);
  if constexpr (has_corner_normals) {
    if (is_pn_v<Scheme> || surface_normals)
      corners.put_all(limits.level, limits.creases,
                      slot_values<Scheme, FT>(limits.results, surface_normals));
  } else
    put_mean_normals<Scheme>(limits.creases, limits.results);
  tangents.put_refined(limits.creases, limits.level.number_of_edges());
  limits.results.resize(limits.level.number_of_vertices());
  using Vertex_normal_map = typename Control::template Vertex_normal_map<Access, Normal_map>;
  Limit_writer<Access, Scheme, Point_map, Vertex_normal_map>(
    access, points, Control::template make_vertex_normal_map<Access>(normals))
    .write(limits.results, surface_normals);
  corners.keep();
  tangents.keep();
}

template <class Concurrency_tag, class Parameters, class Mesh, class Scheme, class NamedParameters>
Limit_report move_to_limit(Mesh& mesh, const Scheme& scheme, const Limit_options& options,
                           const NamedParameters& np)
{
  static_assert(Scheme::Host::keeps_vertices,
                "the limit points of a dual scheme belong to the faces: see face_limit_points()");
  Limit_report report;
  if constexpr (check_creased_limit_arguments<Mesh, Scheme, NamedParameters>()) {
    using FT = typename Parameters::FT;
    const auto points = Parameters::point_map(mesh, np);
    const auto normals = Parameters::normal_map(np);
    using Normal_map = std::decay_t<decltype(normals)>;
    const auto for_chunks = For_chunks::with(Concurrency_tag());
    with_mesh_access(mesh, [&](const auto& access) {
      using Access = std::decay_t<decltype(access)>;
      const auto edge_map = Parameters::edge_constraint_map(np);
      const auto vertex_map = Parameters::vertex_constraint_map(np);
      require_crease_rules(scheme, access, normals, edge_map, vertex_map);
      if constexpr (has_creased_limits_v<Scheme, Access, Normal_map,
                                         std::decay_t<decltype(edge_map)>,
                                         std::decay_t<decltype(vertex_map)>>)
        report = creased_vertex_limits<FT>(access, scheme, points, normals, edge_map, vertex_map,
                                           options, for_chunks, [&](auto& limits, auto& tangents) {
                                             put_creased_limits(access, limits, tangents, points,
                                                                normals, options.surface_normals);
                                           });
      else
        report = vertex_limits<FT>(
          access, scheme, points, normals, options, for_chunks, [&](const auto& results) {
            Limit_writer<Access, Scheme, std::decay_t<decltype(points)>, Normal_map>(access, points,
                                                                                     normals)
              .write(results, options.surface_normals);
          });
    });
  }
  return report;
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_VERTEX_LIMITS_H
