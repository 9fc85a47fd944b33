// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMITS_AT_SLOTS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMITS_AT_SLOTS_H

#include <CGAL/Bbox_3.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Creased_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_writer.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
#  include <CGAL/PN_limit_surface_3/internal/limit/compiled_limits.h>
#endif

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The level of a mesh with points and, for PN schemes, control normals: the user's, or estimated ones
// if there is no map of them.
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

// the largest side of a box
inline double size_of(const Bbox_3& box)
{
  return (std::max)(
    {0., box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
}

// the size of the box of the points
template <class Value>
double box_size(const Valued_level<Value>& level)
{
  Bbox_3 box;
  for (const Value& value : level.values) {
    const auto p = to_double_3(point_of(value));
    box += Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
  }
  return size_of(box);
}

// Refuses what is still sharp after the rounds, but not for ever.
template <class FT, class Access>
void require_sharp_for_ever(const Access& access, const Creases<FT>& creases, unsigned rounds)
{
  const auto require = [&](double s, Function_ref<std::string()> name) {
    if (s == infinite_sharpness || s <= rounds) return;
    std::ostringstream message;
    message << "PN_subdivision_3: the sharpness of " << name() << " is " << s
            << ", and limits are known only of what is smooth or sharp forever: ";
    const double missing = std::ceil(s) - rounds;
    message << "subdivide by " << missing << (missing == 1 ? " more round" : " more rounds")
            << ", or make it infinite";
    throw std::invalid_argument(message.str());
  };
  for (const Crease_edge<FT>& e : creases.edges)
    require(e.sharpness, [&] { return Edge_of_mesh::name(access, e.edge); });
  for (const Crease_star& star : creases.stars)
    require(star.sharpness, [&] { return access.vertex_name(star.vertex); });
}
template <class FT, class Access>
void require_sharp_for_ever(const Access&, No_creases, unsigned)
{}

// Calls sink(level, creases, creases of the mesh) with a mesh as its maps tell of it. So many rounds may be made before
// anything that is sharp has to be so forever.
template <class FT, class Access, class Scheme, class Point_map, class Normal_map, class Edge_map,
          class Vertex_map, class Sink>
void with_slot_level(const Access& access, const Scheme& scheme, Point_map points,
                     Normal_map normals, Edge_map edge_map, Vertex_map vertex_map, unsigned rounds,
                     const Sink& sink)
{
  static_assert(check_no_grid_rows<Scheme>());
  if constexpr (check_corner_normals<Scheme, Access, Normal_map>()) {
    require_crease_rules(scheme, access, normals, edge_map, vertex_map);
    Valued_level<typename Average_of_scheme<Scheme, FT>::Value> level;
    level.level = checked_level(access);
    check_scheme<Scheme, Element_names>(scheme, level.level, access);
    Mesh_values_of_call<Scheme, FT, Access, Normal_map, Edge_map, Vertex_map> of_mesh(
      scheme, access, level.level, edge_map, vertex_map);
    auto creases = of_mesh.creases(level.level);
    require_sharp_for_ever<FT>(access, creases, rounds);
    of_mesh.read_tangents(creases);
    level.values = of_mesh.values(level.level, points, normals, creases);
    sink(level, creases, of_mesh);
  }
}

// The limits at the slots of a level, which are its vertices if there are no creases. These get the tangents of the
// limit. If only some vertices are asked for, which are sorted, the others have no results.
template <class FT, bool points_alone = false, class Scheme, class Level, class Level_creases>
auto limits_at_slots(const Scheme& scheme, const Limit_demand& demand, const For_chunks& for_chunks,
                     Level& level, Level_creases& creases, unsigned next_round,
                     const std::vector<Level_connectivity::Index>* some = nullptr,
                     std::shared_ptr<Ring_rules_cache<Scheme, FT>> rules_cache = nullptr)
{
  Limits_of_level<Scheme, FT, Level_creases, points_alone> limits(scheme, demand, for_chunks,
                                                                  std::move(rules_cache));
  return limits(level, creases, next_round, some);
}

// At vertices with several wedges: the mean of the normals of these.
template <class Scheme, class FT, class Result>
void put_mean_normals(const Creases<FT>& creases, std::vector<Result>& results)
{
  for (const Crease_star& star : creases.stars) {
    if (star.number_of_wedges == 1) continue;
    Result& mean = results[star.vertex];
    for (Level_connectivity::Index w = 1; w < star.number_of_wedges; ++w) {
      const Result& other = results[star.slot(w)];
      if constexpr (is_pn_v<Scheme>)
        add_multiple<FT, 3>(mean.value.normal, FT(1), other.value.normal);
      mean.has_surface_normal = mean.has_surface_normal && other.has_surface_normal;
      add_multiple<double, 3>(mean.surface_normal, 1, other.surface_normal);
    }
    if constexpr (is_pn_v<Scheme>)
      decided<FT>(
        [&] {
          mean.value.normal = unit_or_zero<FT, 3>(mean.value.normal, FT(star.number_of_wedges));
        },
        [&] { return "the mean normal of vertex " + std::to_string(star.vertex); });
    mean.surface_normal = unit_or_zero<double, 3>(mean.surface_normal, star.number_of_wedges);
  }
}
template <class Scheme, class Result>
void put_mean_normals(No_creases, std::vector<Result>&)
{}

// the normals that are asked for
template <class Scheme, class FT, class Result>
std::vector<Coordinates<FT, 3>> limit_normals(const std::vector<Result>& results,
                                              bool surface_normals)
{
  std::vector<Coordinates<FT, 3>> normals;
  normals.reserve(results.size());
  for (const Result& r : results) normals.push_back(limit_normal<Scheme>(r, surface_normals));
  return normals;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_LIMITS_AT_SLOTS_H
