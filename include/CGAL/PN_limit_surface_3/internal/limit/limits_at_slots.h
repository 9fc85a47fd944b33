// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMITS_AT_SLOTS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMITS_AT_SLOTS_H

#include <CGAL/PN_limit_surface_3/internal/limit/Creased_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_writer.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_planes.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules_cache.h>
#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
#  include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>
#endif

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The level of a mesh with points and, for PN schemes, control normals, which are estimated if their map is missing.
template <class Scheme, class FT, class Access, class Point_map, class Normal_map>
auto read_limit_level(const Access& access, const Scheme& scheme, Point_map points,
                      Normal_map normals)
{
  static_assert(check_no_grid_rows<Scheme>());
  using Average = Average_of_scheme<Scheme, FT>;
  Valued_level<typename Average::Value> result;
  result.level = checked_level(access);
  check_scheme(scheme, result.level, access);
  refuse_crease_borders(scheme, access, result.level, "there are no limit points");
  result.values =
    read_values<Average>(access, result.level, points, normals, normal_estimate(scheme));
  put_given_roundness(scheme, result.level.number_of_vertices(), result.values);
  return result;
}

template <class Value>
double box_size(const Valued_level<Value>& level)
{
  return box_size(level.values.size(), 3, [&](std::size_t i, std::size_t c) {
    return CGAL::to_double(point_of(level.values[i])[c]);
  });
}

// Calls sink(level, creases, values of the mesh) with the level of a mesh as its maps tell. `rounds` rounds may be made
// before every sharp element has to be infinitely sharp.
template <class FT, class Access, class Scheme, class Point_map, class Normal_map, class Edge_map,
          class Vertex_map, class Sink>
void with_slot_level(const Access& access, const Scheme& scheme, Point_map points,
                     Normal_map normals, Edge_map edge_map, Vertex_map vertex_map, unsigned rounds,
                     const Sink& sink)
{
  static_assert(check_no_grid_rows<Scheme>());
  if constexpr (check_corner_normals<Scheme, Access, Normal_map>()) {
    require_crease_rules(scheme, access, normals, edge_map, vertex_map);
    Control_mesh control(scheme, access, normals, edge_map, vertex_map, FT());
    require_sharp_for_ever<FT>(access, control.creases, rounds);
    control.maps.read_tangents(control.creases);
    Valued_level<typename Average_of_scheme<Scheme, FT>::Value> level;
    level.values = control.maps.values(control.level, points, normals, control.creases);
    level.level = std::move(control.level);
    sink(level, control.creases, control.maps);
  }
}

// The limits at the slots of a level, which are its vertices if there are no creases. The creases get the tangents of
// the limit. If only some vertices are asked for, which are sorted, other vertices have no results.
template <class FT, Limit_kinds kinds = Limit_kinds::all, class Scheme, class Level_creases>
std::vector<Limit_result<Average_of_scheme<Scheme, FT>>>
limits_at_slots(const Scheme& scheme, const Limit_demand& demand, const For_chunks& for_chunks,
                Valued_level<typename Average_of_scheme<Scheme, FT>::Value>& level,
                Level_creases& creases, unsigned next_round,
                const std::vector<Level_connectivity::Index>* some = nullptr,
                std::shared_ptr<Ring_rules_cache<Scheme, FT>> rules_cache = nullptr)
{
  Limits_of_level<Scheme, FT, Level_creases, kinds> limits(scheme, demand, for_chunks,
                                                           std::move(rules_cache));
  return limits(level, creases, next_round, some);
}

// The limits of levels of double, which the library CGAL::PN_subdivision_3_limits has, see compiled_levels.h. A function, since
// to declare it makes no class, as a member of a class template would.
#define CGAL_PN_SUBDIVISION_3_LIMITS_OF(EXTERN, SCHEME, CREASES)                                   \
  EXTERN template std::vector<Limit_result<compiled_once::Average<compiled_once::SCHEME>>>         \
  limits_at_slots<double>(const compiled_once::SCHEME&, const Limit_demand&, const For_chunks&,    \
                          Valued_level<compiled_once::Value<compiled_once::SCHEME>>&, CREASES&,    \
                          unsigned, const std::vector<Level_connectivity::Index>*,                 \
                          std::shared_ptr<Ring_rules_cache<compiled_once::SCHEME, double>>);
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
CGAL_PN_SUBDIVISION_3_OF_QUADS(CGAL_PN_SUBDIVISION_3_LIMITS_OF, extern)
CGAL_PN_SUBDIVISION_3_OF_TRIANGLES(CGAL_PN_SUBDIVISION_3_LIMITS_OF, extern)
CGAL_PN_SUBDIVISION_3_LIMITS_OF(extern, Any_of_sqrt3, No_creases)
CGAL_PN_SUBDIVISION_3_LIMITS_OF(extern, Linear_of_sqrt3, No_creases)
#endif

// Puts, at vertices with several wedges, the mean of the wedges' normals.
template <class FT, class Result>
void put_mean_normals(const Creases<FT>& creases, std::vector<Result>& results)
{
  constexpr bool is_pn = has_normal_v<decltype(Result::value)>;
  for (const Crease_star& star : creases.stars) {
    if (star.number_of_wedges == 1) continue;
    Result& mean = results[star.vertex];
    for (Level_connectivity::Index w = 1; w < star.number_of_wedges; ++w) {
      const Result& other = results[star.slot(w)];
      if constexpr (is_pn) add_multiple<FT, 3>(mean.value.normal, FT(1), other.value.normal);
      mean.has_surface_normal = mean.has_surface_normal && other.has_surface_normal;
      add_multiple<double, 3>(mean.surface_normal, 1, other.surface_normal);
    }
    if constexpr (is_pn)
      name_undecided<FT>(
        [&] {
          mean.value.normal = unit_or_zero<FT, 3>(mean.value.normal, FT(star.number_of_wedges));
        },
        [&] { return "the mean normal of vertex " + std::to_string(star.vertex); });
    mean.surface_normal = unit_or_zero<double, 3>(mean.surface_normal, star.number_of_wedges);
  }
}
template <class Result>
void put_mean_normals(No_creases, std::vector<Result>&)
{}

// the normals that are asked for
template <class FT, class Result>
std::vector<Coordinates<FT, 3>> limit_normals(const std::vector<Result>& results,
                                              bool surface_normals)
{
  std::vector<Coordinates<FT, 3>> normals;
  normals.reserve(results.size());
  for (const Result& r : results) normals.push_back(limit_normal(r, surface_normals));
  return normals;
}

// The limits at the faces of a level of a dual scheme, whose corners in a face of the next round
// depend on those of the face alone: the ring of a face is its corners.
template <class Scheme, class FT>
class Face_limits
{
public:
  using Index = Level_connectivity::Index;
  using Limits_of_rings = Ring_limits<Scheme, FT>;
  using Result = typename Limits_of_rings::Result;
  using Level = Valued_level<typename Limits_of_rings::Value>;

  Face_limits(const Scheme& scheme, const Limit_demand& demand, const For_chunks& for_chunks)
    : scheme_(scheme)
    , demand_(demand)
    , for_chunks_(for_chunks)
  {}

  std::vector<Result> operator()(const Level& level)
  {
    const Index n = level.level.number_of_faces();
    for (Index f = 0; f < n; ++f) {
      auto& ring_rules = rules_by_degree_[level.level.degree(level.level.halfedge_of_face(f))];
      if (!ring_rules) ring_rules = make(level.level.degree(level.level.halfedge_of_face(f)));
    }
    std::vector<Result> results(n);
    const Caller_precision<FT> precision;
    for_chunks_(n, [&](Index begin, Index end) {
      const typename Caller_precision<FT>::In_this_thread same(precision);
      std::map<Index, std::unique_ptr<Limits_of_rings>> limits_by_degree;
      std::vector<Index> ring;
      for (Index f = begin; f < end; ++f) {
        ring.clear();
        for_each_halfedge_of_face(level.level, f,
                                  [&](Index h) { ring.push_back(level.level.target(h)); });
        auto& limits_of_rings = limits_by_degree[static_cast<Index>(ring.size())];
        if (!limits_of_rings)
          limits_of_rings = std::make_unique<Limits_of_rings>(
            *rules_by_degree_.at(static_cast<Index>(ring.size())), demand_, false);
        limits_of_rings->add(
          [&](std::size_t p) -> const auto& { return level.values[ring[p]]; }, results[f]);
        if (limits_of_rings->is_full()) limits_of_rings->evaluate();
      }
      for (auto& entry : limits_by_degree) entry.second->evaluate();
    });
    const auto point = [&](Index v) { return to_double_3(point_of(level.values[v])); };
    if (demand_.surface_normals)
      orient_normals(results, for_chunks_, [&](Index f, const auto& normal) {
        return is_against_face(level.level, level.level.halfedge_of_face(f), point, normal);
      });
    return results;
  }

private:
  using Rules = Ring_rules<Scheme, FT>;

  // made from a level of one face: its new vertices are the corners in their order
  std::unique_ptr<Rules> make(Index degree) const
  {
    const Level_connectivity level = single_face(degree);
    const Ring_pair rings{first_indices(degree), first_indices(degree)};
    Ring_layout layout;
    layout.first = 0;
    layout.number = degree;
    layout.clockwise = false;
    return std::make_unique<Rules>(scheme_, std::vector<Ring_round>{{level, 1, rings}}, layout);
  }

  const Scheme& scheme_;
  const Limit_demand& demand_;
  For_chunks for_chunks_;
  std::map<Index, std::unique_ptr<Rules>> rules_by_degree_;
};

// Calls sink(access, level, creases with the tangents of the limit, limits at slots, maps of the mesh) with the limits of a mesh
// as a call tells of it.
template <class Concurrency_tag, class Parameters, class Mesh, class Scheme, class Point_map,
          class NamedParameters, class Sink>
Limit_report vertex_limits(Mesh& mesh, const Scheme& scheme, Point_map points,
                           const NamedParameters& np, const Sink& sink)
{
  using FT = typename Parameters::FT;
  const Limit_options options = limit_options(np);
  Limit_report report;
  with_mesh_access(mesh, [&](const auto& access) {
    with_roundness_of_call<Parameters>(access, scheme, np, [&](const auto& s) {
      const auto evaluate = [&](auto& level, auto& creases, auto& of_mesh) {
        const Limit_demand demand = limit_demand<FT>(options, box_size(level));
        auto results = limits_at_slots<FT, limit_kinds<NamedParameters>()>(
          scheme_of_rounds(s), demand, For_chunks::with(Concurrency_tag()), level, creases,
          options.rounds_done + 1);
        std::decay_t<decltype(level.values)>().swap(level.values);
        check_limits<FT>(results, [&](std::size_t v) {
          return access.vertex_name(static_cast<Level_connectivity::Index>(v));
        });
        sink(access, level.level, creases, results, of_mesh);
        results.resize(level.level.number_of_vertices());
        report = limit_report(results, demand);
      };
      with_slot_level<FT>(access, s, points, Parameters::normal_map(np),
                          Parameters::edge_constraint_map(np),
                          Parameters::vertex_constraint_map(np), 0, evaluate);
    });
  });
  return report;
}

// Puts limits into the maps of a mesh and of a call, and the old values back if that fails.
template <class Scheme, class Parameters, class Access, class Level_creases, class Results,
          class Of_mesh, class Point_map, class NamedParameters>
void put_limits(const Access& access, const Level_connectivity& level, const Level_creases& creases,
                Results& results, Of_mesh& of_mesh, Point_map points, const NamedParameters& np)
{
  const Limit_options options = limit_options(np);
  const auto normals = Parameters::normal_map(np);
  using Maps_writer = Limit_maps_writer<Access, typename Parameters::Geom_traits, NamedParameters>;
  Maps_writer of_limits(access, np);
  using Writers = Normal_writers<Access, std::decay_t<decltype(normals)>>;
  typename Writers::Corner_writer corners(access, level, normals);
  if constexpr (Writers::Corner_writer::takes_corners) {
    if (is_pn_v<Scheme> || options.surface_normals)
      corners.put_all(level, creases,
                      limit_normals<typename Parameters::FT>(results, options.surface_normals));
  }
  if constexpr (!Writers::Corner_writer::takes_corners || Maps_writer::is_any_given)
    put_mean_normals(creases, results);
  of_limits.write(results, level.number_of_vertices());
  of_mesh.put_tangents(creases, level.size());
  results.resize(level.number_of_vertices());
  write_limits<Scheme>(access, points, Writers::vertex_map(normals), results, options);
  of_limits.commit();
  corners.commit();
  of_mesh.commit();
}

template <class Concurrency_tag, class Parameters, class Mesh, class Scheme, class NamedParameters>
Limit_report move_to_limit(Mesh& mesh, const Scheme& scheme, const NamedParameters& np)
{
  static_assert(Scheme::Host::keeps_vertices,
                "the limit points of a dual scheme belong to the faces: see limit_points()");
  if constexpr (check_creased_limit_arguments<Mesh, Scheme, NamedParameters>()) {
    const auto points = Parameters::point_map(mesh, np);
    return vertex_limits<Concurrency_tag, Parameters>(
      mesh, scheme, points, np,
      [&](const auto& access, const auto& level, const auto& creases, auto& results,
          auto& of_mesh) {
        put_limits<Scheme, Parameters>(access, level, creases, results, of_mesh, points, np);
      });
  } else
    return {};
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMITS_AT_SLOTS_H
