// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CALLS_MESH_SUBDIVISION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CALLS_MESH_SUBDIVISION_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Refined_attributes.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
// declared, not included: a program that uses them has them
template <typename Point>
class Surface_mesh;
template <typename FT>
struct Simple_cartesian;
class Epick;
class SM_Vertex_index;
class SM_Edge_index;
} // namespace CGAL

namespace CGAL::PN_subdivision_3 {
struct DooSabin_scheme;
struct Sqrt3_scheme;
} // namespace CGAL::PN_subdivision_3

namespace CGAL::PN_subdivision_3::internal {

// Subdivision of a mesh, with creases or without: read, refine flat levels, write the last one. The mesh
// and its maps are untouched until everything that a user's data can make fail has been checked; what
// fails afterwards (an allocation, a map of the user's) is taken back.
template <class Concurrency_tag, class Scheme, class FT>
class Mesh_subdivision
{
  using Index = Level_connectivity::Index;
  using Host = typename Scheme::Host;
  using Average = Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Round_scheme = Scheme_of_rounds<Scheme>;
  using Plain_round = Round<Round_scheme, Average>;
  using Transfers = typename Plain_round::Transfers;
  using Rows_sink = typename Plain_round::Rows_sink;

public:
  using Round_done = Function_ref<void(unsigned, std::size_t)>;

  // round_done has to live as long
  template <class Function>
  Mesh_subdivision(const Scheme& scheme, unsigned rounds, const Function& round_done)
    : scheme_(scheme)
    , rounds_(rounds)
    , round_done_(round_done)
    , for_chunks_(For_chunks::with(Concurrency_tag()))
  {}
  template <class Function>
  Mesh_subdivision(const Scheme&, unsigned, const Function&&) = delete;

  // a linear scheme has no use for normals
  template <class Access, class Point_map, class Normal_map, class Roundness_map, class Edge_map,
            class Vertex_map, class Attributes>
  void operator()(Access& access, Point_map points, Normal_map normals, Roundness_map roundness,
                  Edge_map edge_map, Vertex_map vertex_map, const Attributes& attributes) const
  {
    if constexpr (!is_pn_v<Scheme> && (is_there_v<Normal_map> || is_there_v<Roundness_map>))
      (*this)(access, points, Not_given(), Not_given(), edge_map, vertex_map, attributes);
    else if constexpr (check_corner_normals<Scheme, Access, Normal_map>()) {
      require_crease_rules(scheme_, access, normals, edge_map, vertex_map);
      subdivide(access, points, normals, roundness, edge_map, vertex_map, attributes);
    }
  }

private:
  // Whether a mesh gets edges and faces in one thread while others put the values of the last round: the
  // maps of a Surface_mesh stay where they are when the mesh gets elements of other kinds.
  template <class Writer>
  static constexpr bool has_late_growth_v = is_parallel_v<Concurrency_tag>&& Writer::has_own_maps;

  // With several threads the mesh grows while the levels before the last one are made.
  template <class Writer, class Access, class Refiner, class Refine>
  void grow_and_refine(Access& access, const Level_size& size, const Refiner& refiner,
                       unsigned rounds, const Refine& refine) const
  {
    const auto grow = [&] {
      if constexpr (is_parallel_v<Concurrency_tag> && !has_late_growth_v<Writer>)
        access.grow(size);
      else
        access.grow_vertices(size);
    };
    run_with_precision(grow, [&] {
      for (unsigned k = 1; k < rounds; ++k) {
        refine();
        round_done_(k, static_cast<std::size_t>(refiner.level().size().faces));
      }
    });
  }

  // Puts the last values, by put(), and missing edges and faces; with one thread these come when the old values are gone.
  template <class Writer, class Access, class Refiner, class Put>
  static void put_and_grow(Access& access, const Level_size& size, Refiner& refiner, const Put& put)
  {
    if constexpr (has_late_growth_v<Writer>)
      run_with_precision([&] { access.grow(size); }, put);
    else
      put();
    refiner.release_values();
    access.grow(size);
  }

  template <class Refiner, class Writer>
  static void put_values(const Refiner& refiner, const Plain_round& last, Writer& writer,
                         const Rows_sink* rows = nullptr)
  {
    const auto new_vertices = static_cast<Index>(last.refined_size().vertices);
    const Index old_vertices = (std::min)(new_vertices, writer.number_of_old_vertices());
    const Transfers transfers = refiner.transfers(last);
    put_range(refiner, last, transfers, old_vertices, new_vertices, writer, rows);
    writer.begin_old_vertices();
    put_range(refiner, last, transfers, 0, old_vertices, writer, rows);
  }

  template <class Refiner, class Writer>
  static void put_range(const Refiner& refiner, const Plain_round& last, const Transfers& transfers,
                        Index begin, Index end, const Writer& writer, const Rows_sink* rows)
  {
    if constexpr (Writer::has_own_maps || !is_parallel_v<Concurrency_tag>)
      refiner.evaluate(
        last, transfers, begin, end,
        [&](Index first, const Value* values, Index n) { writer.put_values(first, values, n); },
        rows);
    else {
      boost::container::vector<Value> refined(end - begin, boost::container::default_init);
      refiner.evaluate(
        last, transfers, begin, end,
        [&](Index first, const Value* values, Index n) {
          std::copy(values, values + n, refined.begin() + (first - begin));
        },
        rows);
      writer.put_values(begin, refined.data(), end - begin);
    }
  }

  // f() and g(), which computes in the caller's precision
  template <class Function, class Computation>
  static void run_with_precision(const Function& f, const Computation& g)
  {
    const Caller_precision<FT> precision;
    run_together<Concurrency_tag>([&] { f(); },
                                  [&] {
                                    const typename Caller_precision<FT>::In_this_thread scope(
                                      precision);
                                    g();
                                  });
  }

  template <class Access, class Point_map, class Normal_map, class Roundness_map, class Edge_map,
            class Vertex_map, class Attributes>
  void subdivide(Access& access, Point_map points, Normal_map normals, Roundness_map roundness,
                 Edge_map edge_map, Vertex_map vertex_map, const Attributes& attributes) const
  {
    Control_mesh control(scheme_, access, normals, edge_map, vertex_map, FT());
    Level_connectivity& level = control.level;
    auto& of_mesh = control.maps;
    auto& creases = control.creases;
    of_mesh.read_tangents(creases);
    const unsigned rounds = number_of_rounds(level, rounds_);
    const Level_size size = checked_refined_size<Host>(level.size(), rounds, Access::index_limit());
    std::vector<Value> values = of_mesh.values(level, points, normals, creases);

    using Writers = Normal_writers<Access, Normal_map>;
    using Writer =
      Mesh_writer<Value, Access, Point_map, typename Writers::Vertex_map, Roundness_map>;
    const bool is_any_far_out = std::any_of(
      values.begin(), values.end(), [](const Value& v) { return is_near_overflow(point_of(v)); });
    Writer writer(access, points, Writers::vertex_map(normals), is_any_far_out, roundness);
    typename Writers::Corner_writer corners(access, level, normals);
    auto attribute_rounds =
      attribute_rounds_of_call<FT, Host>(attributes, access, level, creases, of_mesh, for_chunks_);
    const Round_scheme& round_scheme = scheme_of_rounds(scheme_);
    Level_refiner<Round_scheme, Average, typename decltype(control)::Level_creases> refiner(
      round_scheme, std::move(level), std::move(creases), {values.begin(), values.end()},
      for_chunks_);
    std::vector<Value>().swap(values);

    grow_and_refine<Writer>(access, size, refiner, rounds,
                            [&] { attribute_rounds.refine(round_scheme, refiner); });
    attribute_rounds.before_cut(refiner);
    auto last = refiner.next_round();
    attribute_rounds.begin_round(round_scheme, refiner, last, Kind_of_round::last_put_at_once);
    put_last_round(access, size, refiner, last, writer, corners, attribute_rounds.rows());
    attribute_rounds.put(refiner, last.round(), for_chunks_);
    of_mesh.put_sharpness(last.refined_creases(), size, rounds);
    of_mesh.put_tangents(last.refined_creases(), size);
    report_last_round(round_done_, rounds, rounds_, size);
    put_connectivity(last.round(), access, for_chunks_, [&] {
      writer.commit();
      corners.commit();
      of_mesh.commit();
      attribute_rounds.commit();
    });
    if constexpr (Attributes::visited.any())
      attributes.visit(access, size, attribute_rounds->rules(last.round(), refiner.level()));
    if constexpr (!Host::keeps_vertices) access.trim(size, writer.has_own_maps);
  }

  // The values of the last round and its tangents; its level is whole again afterwards.
  template <class Access, class Refiner, class Last, class Writer, class Corner_writer>
  void put_last_round(Access& access, const Level_size& size, Refiner& refiner, Last& last,
                      Writer& writer, Corner_writer& corners, const Rows_sink* rows) const
  {
    if constexpr (Corner_writer::takes_corners) {
      typename Refiner::Values values;
      put_and_grow<Writer>(access, size, refiner,
                           [&] { values = refiner.refined_values(last, rows); });
      writer.begin_old_vertices();
      writer.put_values(0, values.data(), last.number_of_vertices());
      corners.put_all(child_level(last.round(), for_chunks_), last.refined_creases(), values);
    } else {
      const auto on_creases = last.crease_values(for_chunks_);
      put_and_grow<Writer>(access, size, refiner, [&] {
        put_values(refiner, last.round(), writer, rows);
        if constexpr (Corner_writer::takes_wedges) {
          for (const auto& [slot, value] : on_creases)
            if (slot < last.number_of_vertices()) writer.put_values(slot, &value, 1);
          corners.list(last.refined_creases(), on_creases);
        } else if constexpr (are_creases_v<std::decay_t<decltype(refiner.creases())>>)
          for_each_crease_vertex<Average>(
            on_creases, last.number_of_vertices(),
            [&](std::size_t, Index v, const Value& value) { writer.put_values(v, &value, 1); });
      });
      last.close();
    }
  }

  const Scheme& scheme_;
  unsigned rounds_;
  Round_done round_done_;
  For_chunks for_chunks_;
};

// The usual calls of subdivide() are compiled once, in the library PN_subdivision_3_double
// (src/PN_subdivision_3_double). What is linked to it leaves them to it; all others are compiled where they are.
template <class Mesh>
constexpr bool is_usual_mesh_v = false;
template <class Point>
inline constexpr bool is_usual_mesh_v<Surface_mesh<Point>> =
  is_one_of_v<typename Kernel_traits<Point>::type, Simple_cartesian<double>, Epick>;

template <class Scheme>
constexpr bool is_usual_scheme_v =
  is_one_of_v<Scheme, CatmullClark_scheme, Loop_scheme, DooSabin_scheme, Sqrt3_scheme>;
template <class Host>
inline constexpr bool is_usual_scheme_v<Scheme_on_host<Host, double>> = true;

template <class Mesh>
using Usual_normal_map = typename Mesh::template Property_map<
  SM_Vertex_index, typename Kernel_traits<typename Mesh::Point>::type::Vector_3>;
template <class Mesh>
using Usual_edge_map = typename Mesh::template Property_map<SM_Edge_index, bool>;

// A scheme of CGAL's own functions or one on its host, one thread, the mesh's own points, given normals or estimated ones, edges that
// are sharp for ever or none, attributes of any kind, and nothing else.
template <class Concurrency_tag, class Mesh, class Scheme, class Parameters, class Attributes>
constexpr bool is_compiled_call()
{
  if constexpr (!is_linked_to_library || is_parallel_v<Concurrency_tag> ||
                Attributes::visited.any() || !is_usual_mesh_v<Mesh>)
    return false;
  else {
    using Edges = typename Parameters::Edge_constraint_map;
    constexpr bool has_usual_points =
      std::is_same_v<typename Parameters::FT, double> &&
      std::is_same_v<typename Parameters::Point_map,
                     typename boost::property_map<Mesh, vertex_point_t>::type>;
    constexpr bool has_usual_maps =
      is_one_of_v<Edges, Not_given, Usual_edge_map<Mesh>> &&
      is_one_of_v<typename Parameters::Normal_map, Not_given, Usual_normal_map<Mesh>> &&
      !is_there_v<typename Parameters::Vertex_constraint_map>;
    return is_usual_scheme_v<Scheme> && has_usual_points && has_usual_maps &&
           !is_there_v<typename Parameters::Roundness> &&
           !is_there_v<typename Parameters::Roundness_map>;
  }
}

template <class Access>
class Any_attributes;

template <class Mesh, class Scheme, class Point_map, class Normal_map, class Edge_map>
void compiled_call(Mesh& mesh, const Scheme& scheme, unsigned rounds,
                   Function_ref<void(unsigned, std::size_t)> round_done, Point_map points,
                   Normal_map normals, Edge_map edges,
                   const Any_attributes<Surface_mesh_access<Mesh>>& attributes);

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CALLS_MESH_SUBDIVISION_H
