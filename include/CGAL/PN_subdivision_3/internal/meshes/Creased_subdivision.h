// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASED_SUBDIVISION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASED_SUBDIVISION_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Carried_through.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_refiner.h>
#include <CGAL/PN_subdivision_3/internal/creases/for_each_crease_vertex.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Creased_control.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_subdivision.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Wedge_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/tangent_maps.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>
#include <CGAL/PN_subdivision_3/schemes/with_border.h>
#include <CGAL/PN_subdivision_3/schemes/with_crease_tangents.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Subdivision of a mesh that may have creases, as Mesh_subdivision.
template <class Concurrency_tag, class Scheme, class FT>
class Creased_subdivision
{
  static constexpr bool is_pn = !Is_linear<Scheme>::value;

  using Index = Level_connectivity::Index;
  using Plain = Mesh_subdivision<Concurrency_tag, Scheme, FT>;
  using Control = Creased_control<Scheme, FT>;
  using Average = std::conditional_t<is_pn, PN_average<FT, 3>, Linear_average<FT, 3>>;
  using Value = typename Average::Value;
  using Refiner = Crease_refiner<Scheme, Average>;
  using Slot_values = std::vector<std::pair<Index, Value>>;

public:
  using Round_done = typename Plain::Round_done;

  Creased_subdivision(const Scheme& scheme, unsigned rounds, Round_done round_done)
    : scheme_(scheme)
    , plain_(scheme, rounds, round_done)
    , for_chunks_(For_chunks::with(Concurrency_tag()))
  {}

  // a linear scheme has no use for normals
  template <class Access, class Point_map, class Normal_map, class Edge_map, class Vertex_map,
            class Carry>
  void operator()(Access& access, Point_map points, Normal_map normals, Edge_map edge_map,
                  Vertex_map vertex_map, const Carry& carry) const
  {
    if constexpr (is_pn)
      subdivide(access, points, normals, edge_map, vertex_map, carry);
    else
      subdivide(access, points, No_normal_map(), edge_map, vertex_map, carry);
  }

private:
  template <class Access, class Point_map, class Normal_map, class Edge_map, class Vertex_map,
            class Carry>
  void subdivide(Access& access, Point_map points, Normal_map normals, Edge_map edge_map,
                 Vertex_map vertex_map, const Carry& carry) const
  {
    constexpr bool lists_wedges = Is_wedge_normals<Normal_map>::value;
    constexpr bool has_corner_normals = is_of_halfedges_v<Access, Normal_map> && !lists_wedges;
    using Vertex_normal_map = typename Control::template Vertex_normal_map<Access, Normal_map>;

    Level_connectivity level = checked_level(access);
    check_scheme<Scheme, Element_names>(scheme_, level, access);
    Edge_constraints<Access, Edge_map> edges(access, edge_map, level.number_of_edges());
    Vertex_constraints<Access, Vertex_map> vertices(access, vertex_map, level.number_of_vertices());
    Creases<FT> creases = Control::make_creases(scheme_, level, edges, vertices);
    typename Control::template Tangents<Access> tangents(access, level,
                                                         Control::tangent_map(scheme_));
    tangents.read(creases);
    const unsigned rounds = plain_.number_of_rounds(level);
    const Level_size size =
      checked_refined_size<typename Scheme::Host>(level.size(), rounds, Access::index_limit());

    auto values = Control::template read<Value>(scheme_, access, level, points, normals, creases);
    const bool is_near_overflow = std::any_of(values.begin(), values.end(), [](const Value& v) {
      return internal::is_near_overflow(point_of(v));
    });
    Vertex_normal_map vertex_normals = Control::template make_vertex_normal_map<Access>(normals);
    using Writer = Mesh_writer<Value, Access, Point_map, Vertex_normal_map>;
    Writer writer(access, points, vertex_normals, is_near_overflow);
    typename Control::template Corner_writer<Access, Normal_map> corners(access, level, normals);
    Carried_through<FT, typename Scheme::Host, Carry> carried(
      carry, access, level, vertices_of_extra_slots(creases, level.number_of_vertices()),
      sharpness<Carry>(level, edges, vertices), for_chunks_);
    Refiner refiner(scheme_, std::move(level), std::move(creases), {values.begin(), values.end()},
                    for_chunks_);
    std::vector<Value>().swap(values);

    plain_.template grow_and_refine<Writer>(access, size, refiner, rounds, [&] {
      carried.before_cut(refiner.level());
      auto round = refiner.next_round();
      carried.begin_creased_round(scheme_, round, refiner.creases(), false);
      refiner.refine(round, carried.rows(), carried.child());
      carried.end_round();
    });
    carried.before_cut(refiner.level());
    auto last = refiner.next_round();
    carried.begin_creased_round(scheme_, last, refiner.creases(), true);
    const Slot_values on_creases = last.crease_values(for_chunks_);
    if constexpr (has_corner_normals)
      put_corners(access, size, refiner, last, on_creases, writer, corners, carried.rows());
    else
      Plain::template put_and_grow<Writer>(access, size, refiner, [&] {
        Plain::put_values(refiner.refiner(), last.round(), writer, carried.rows());
        const Index n = last.number_of_vertices();
        if constexpr (lists_wedges) {
          for (const auto& [slot, value] : on_creases)
            if (slot < n) writer.put_values(slot, &value, 1);
          corners.list(last.refined_creases(), on_creases);
        } else
          for_each_crease_vertex<Average>(
            on_creases, n,
            [&](std::size_t, Index v, const Value& value) { writer.put_values(v, &value, 1); });
      });
    last.close();
    carried.put(refiner.refiner(), last.round());
    Control::put_constraints(last.refined_creases(), size, edges, vertices, rounds);
    tangents.put_refined(last.refined_creases(), static_cast<Index>(size.edges));
    plain_.report_last_round(rounds, size);
    plain_.put_connectivity(refiner.refiner(), last.round(), access, [&] {
      writer.keep();
      corners.keep();
      edges.keep();
      vertices.keep();
      tangents.keep();
      carried.keep();
    });
    carried.visit(access, refiner.refiner(), last.round());
  }

  // what is sharp besides the seams of attributes
  template <class Carry, class Edges, class Vertices>
  Control_sharpness sharpness([[maybe_unused]] const Level_connectivity& level,
                              [[maybe_unused]] const Edges& edges,
                              [[maybe_unused]] const Vertices& vertices) const
  {
    Control_sharpness result;
    if constexpr (!Carry::is_empty) {
      result.border = Border_of<Scheme>::get(scheme_);
      for (Index e = 0; e < level.number_of_edges(); ++e)
        result.edges.push_back(edges.sharpness(e));
      for (Index v = 0; v < level.number_of_vertices(); ++v)
        result.vertices.push_back(vertices.sharpness(v));
    }
    return result;
  }

  template <class Access, class Last, class Writer, class Corner_writer>
  void put_corners(Access& access, const Level_size& size, Refiner& refiner, Last& last,
                   const Slot_values& on_creases, Writer& writer, Corner_writer& corners,
                   const typename Refiner::Refiner::Rows_sink* rows) const
  {
    const Index n = last.number_of_vertices();
    const Creases<FT>& creases = last.refined_creases();
    boost::container::vector<Value> values(creases.number_of_slots, boost::container::default_init);
    Plain::template put_and_grow<Writer>(access, size, refiner, [&] {
      refiner.refiner().evaluate(
        last.round(), refiner.refiner().transfers(last.round()), 0, n,
        [&](Index first, const Value* new_values, Index number) {
          std::copy(new_values, new_values + number, values.begin() + first);
        },
        rows);
    });
    for (const auto& slot : on_creases) values[slot.first] = slot.second;
    writer.begin_old_vertices();
    writer.put_values(0, values.data(), n);
    last.close();
    Level_connectivity child(last.round().refined_size());
    refiner.refiner().connect(last.round(), child);
    corners.put_all(child, creases, values);
  }

  const Scheme& scheme_;
  const Plain plain_;
  For_chunks for_chunks_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CREASED_SUBDIVISION_H
