// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_CREASED_LIMIT_SUBDIVISION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_CREASED_LIMIT_SUBDIVISION_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_refiner.h>
#include <CGAL/PN_subdivision_3/internal/limit/Creased_limits.h>
#include <CGAL/PN_subdivision_3/internal/limit/creased_vertex_limits.h>
#include <CGAL/PN_subdivision_3/internal/limit/read_limit_level.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Creased_control.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_subdivision.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/No_normal_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>
#include <CGAL/PN_subdivision_3/limit_points.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// As Limit_subdivision, of a mesh that may have creases.
template <class Concurrency_tag, class Scheme, class FT>
class Creased_limit_subdivision
{
public:
  Creased_limit_subdivision(const Scheme& scheme, unsigned rounds, const Limit_options& options)
    : scheme_(scheme)
    , options_(options)
    , plain_(scheme, rounds, no_round_done)
    , for_chunks_(For_chunks::with(Concurrency_tag()))
  {}

  template <class Access, class Point_map, class Normal_map, class Edge_map, class Vertex_map>
  Limit_report operator()(Access& access, Point_map points, Normal_map normals, Edge_map edge_map,
                          Vertex_map vertex_map) const
  {
    // with a linear scheme normals are written as surface normals only
    if constexpr (!is_pn_v<Scheme>)
      if (!options_.surface_normals)
        return subdivide(access, points, No_normal_map(), edge_map, vertex_map);
    return subdivide(access, points, normals, edge_map, vertex_map);
  }

private:
  using Index = Level_connectivity::Index;
  using Host = typename Scheme::Host;
  using Average = Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Control = Creased_control<Scheme, FT>;
  using Refiner = Crease_refiner<Scheme, Average>;
  using Last = typename Refiner::One_round;
  using Level = Valued_level<Value>;
  using Limit_value = Point_normal<FT, 3>;
  using Plain = Mesh_subdivision<Concurrency_tag, Scheme, FT>;

  template <class Access, class Point_map, class Normal_map, class Edge_map, class Vertex_map>
  Limit_report subdivide(Access& access, Point_map points, Normal_map normals, Edge_map edge_map,
                         Vertex_map vertex_map) const
  {
    constexpr bool has_corner_normals = is_of_halfedges_v<Access, Normal_map>;
    using Vertex_normal_map = typename Control::template Vertex_normal_map<Access, Normal_map>;

    Level_connectivity level = checked_level(access);
    check_scheme<Scheme, Element_names>(scheme_, level, access);
    Edge_constraints<Access, Edge_map> edges(access, edge_map, level.number_of_edges());
    Vertex_constraints<Access, Vertex_map> vertices(access, vertex_map, level.number_of_vertices());
    Creases<FT> creases = Control::make_creases(scheme_, level, edges, vertices);
    const unsigned rounds = plain_.number_of_rounds(level);
    require_sharp_for_ever(access, creases, rounds);
    typename Control::template Tangents<Access> tangents(access, level,
                                                         Control::tangent_map(scheme_));
    tangents.read(creases);
    const Level_size size = checked_refined_size<Host>(level.size(), rounds, Access::index_limit());
    auto values = control_values(access, level, points, normals, creases);
    Mesh_writer<Limit_value, Access, Point_map, Vertex_normal_map> writer(
      access, points, Control::template make_vertex_normal_map<Access>(normals), false);
    typename Control::template Corner_writer<Access, Normal_map> corners(access, level, normals);
    Refiner refiner(scheme_, std::move(level), std::move(creases), {values.begin(), values.end()},
                    for_chunks_);
    std::vector<Value>().swap(values);

    for (unsigned k = 1; k < rounds; ++k) refiner.refine();
    Last last = refiner.next_round();
    Level refined = refined_level(refiner, last);
    refiner.release_values();
    Creases<FT> limit_creases = last.refined_creases();
    const Limit_demand demand = limit_demand<FT>(options_, box_size(refined));
    auto results =
      Creased_limits<Scheme, FT>(scheme_, demand, for_chunks_)(refined, limit_creases, rounds + 1);
    check_limits<FT>(results, [](std::size_t v) { return "vertex number " + std::to_string(v); });
    if constexpr (!has_corner_normals) put_mean_normals<Scheme>(limit_creases, results);
    const std::vector<Limit_value> limits =
      slot_values<Scheme, FT>(results, options_.surface_normals);
    results.resize(size.vertices);
    const Limit_report report = limit_report(results, demand);

    access.grow(size);
    const auto n = static_cast<Index>(size.vertices);
    const Index old_vertices = (std::min)(n, writer.number_of_old_vertices());
    writer.put_values(old_vertices, limits.data() + old_vertices, n - old_vertices);
    writer.begin_old_vertices();
    writer.put_values(0, limits.data(), old_vertices);
    if constexpr (has_corner_normals) corners.put_all(refined.level, limit_creases, limits);
    Control::put_constraints(limit_creases, size, edges, vertices, rounds);
    tangents.put_refined(limit_creases, static_cast<Index>(size.edges));
    plain_.put_connectivity(refiner.refiner(), last.round(), access, [&] {
      writer.keep();
      corners.keep();
      edges.keep();
      vertices.keep();
      tangents.keep();
    });
    return report;
  }

  template <class Access, class Point_map, class Normal_map>
  std::vector<Value> control_values(const Access& access, const Level_connectivity& level,
                                    Point_map points, [[maybe_unused]] Normal_map normals,
                                    Creases<FT>& creases) const
  {
    if constexpr (is_pn_v<Scheme>)
      return Control::template read<Value>(scheme_, access, level, points, normals, creases);
    else
      return Control::template read<Value>(scheme_, access, level, points, No_normal_map(),
                                           creases);
  }

  // with the values of its slots; the level before it is whole again afterwards
  Level refined_level(const Refiner& refiner, Last& last) const
  {
    const auto on_creases = last.crease_values(for_chunks_);
    const Creases<FT>& creases = last.refined_creases();
    const auto values = refiner.refiner().refined_values(last.round(), creases.number_of_slots);
    Level refined;
    refined.values.assign(values.begin(), values.end());
    for (const auto& slot : on_creases) refined.values[slot.first] = slot.second;
    last.close();
    const Level_size size = last.round().refined_size();
    refined.level = Level_connectivity(size, Level_cut<FT>::size(size, creases));
    refined.level.set_uniform_degree(Host::refined_degree);
    refiner.refiner().connect(last.round(), refined.level);
    return refined;
  }

  const Scheme& scheme_;
  const Limit_options& options_;
  const Plain plain_;
  For_chunks for_chunks_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_CREASED_LIMIT_SUBDIVISION_H
