// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_INTERNAL_REFINED_ASIDE_H
#define CGAL_PN_CERTIFICATES_3_INTERNAL_REFINED_ASIDE_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/Uncertain.h>
#include <CGAL/utils.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class FT>
struct Level_with_points
{
  Level_connectivity level;
  std::vector<Coordinates<FT, 3>> points;
  std::vector<bool> is_sharp = {}; // of edges; or empty
  // of control vertices, if their roundness varies
  std::size_t of_roundness_0 = 0, of_roundness_below_1 = 0;
};

template <class FT, class Value>
void count_roundness([[maybe_unused]] const std::vector<Value>& values,
                     [[maybe_unused]] Level_connectivity::Index number_of_vertices,
                     [[maybe_unused]] Level_with_points<FT>& result)
{
  if constexpr (has_normal_v<Value>) {
    bool varies = false;
    for (Level_connectivity::Index v = 0; v < number_of_vertices; ++v)
      varies = varies || CGAL::possibly(values[v].roundness != values[0].roundness);
    for (Level_connectivity::Index v = 0; varies && v < number_of_vertices; ++v) {
      result.of_roundness_0 += CGAL::certainly(values[v].roundness == FT(0));
      result.of_roundness_below_1 += CGAL::certainly(values[v].roundness < FT(1));
    }
  }
}

// the points of the vertices, which are the first values
template <class Average, class Values>
auto points_of(const Values& values, Level_connectivity::Index number)
{
  std::vector<Coordinates<typename Average::FT, 3>> points;
  points.reserve(number);
  for (Level_connectivity::Index v = 0; v < number; ++v) {
    const typename Average::Value value = values[v]; // may be stored in another way
    points.push_back(point_of(value));
  }
  return points;
}

// The level that the rounds of a scheme make of a mesh, as subdivide() does it; mesh and maps are only read.
template <class Concurrency_tag, class FT, class Scheme, class Access, class Point_map,
          class Normal_map, class Edge_map, class Vertex_map>
Level_with_points<FT> refined_aside(const Scheme& scheme, const Access& access, unsigned rounds,
                                    Point_map points, Normal_map normals, Edge_map edge_map,
                                    Vertex_map vertex_map)
{
  if constexpr (!is_pn_v<Scheme> && !std::is_same_v<Normal_map, No_normal_map>)
    return refined_aside<Concurrency_tag, FT>(scheme, access, rounds, points, No_normal_map(),
                                              edge_map, vertex_map);
  else if constexpr (check_corner_normals<Scheme, Access, Normal_map>()) {
    using Average = Average_of_scheme<Scheme, FT>;
    require_crease_rules(scheme, access, normals, edge_map, vertex_map);
    Level_connectivity level = checked_level(access);
    check_scheme<Scheme, Element_names>(scheme, level, access);
    const Mesh_creases_of_call<Scheme, FT, Access, Normal_map, Edge_map, Vertex_map> of_mesh(
      scheme, access, level, edge_map, vertex_map);
    auto creases = of_mesh.creases(level);
    of_mesh.read_tangents(creases);
    rounds = number_of_rounds(level, rounds);
    checked_refined_size<typename Scheme::Host>(level.size(), rounds, Level_connectivity::null);
    const auto values = of_mesh.values(level, points, normals, creases);
    Level_with_points<FT> result;
    count_roundness(values, level.number_of_vertices(), result);
    const Rules_of<Scheme>& rules = rules_of(scheme);
    Level_refiner<Rules_of<Scheme>, Average, decltype(creases)> refiner(
      rules, std::move(level), std::move(creases), {values.begin(), values.end()},
      For_chunks::with(Concurrency_tag()));
    while (refiner.rounds_done() < rounds) refiner.refine();
    result.level = refiner.level();
    result.points = points_of<Average>(refiner.values(), result.level.number_of_vertices());
    if constexpr (are_creases_v<decltype(creases)>) {
      result.is_sharp.assign(result.level.number_of_edges(), false);
      for (const auto& e : refiner.creases().edges) result.is_sharp[e.edge] = e.sharpness > 0;
    }
    for (Level_connectivity::Index v = 0; v < result.points.size(); ++v)
      check_in_range(result.points[v],
                     [&] { return "the point of the new vertex " + std::to_string(v); });
    return result;
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CERTIFICATES_3_INTERNAL_REFINED_ASIDE_H
